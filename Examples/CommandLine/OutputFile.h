/**
 * A file that is there whole or not at all: written under a temporary name in the same folder and
 * renamed when it is complete.
 */
#ifndef OutputFile_h
#define OutputFile_h

#include <string>

class OutputFile
{
public:
  /// Refuses at once what could not be written after long work: a wrong extension (UsageError), a
  /// folder, a place without rights (Failure).
  OutputFile(const std::string& option, const std::string& path, const std::string& extension);

  /// Removes what was not committed.
  ~OutputFile();

  OutputFile(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  void operator=(const OutputFile&) = delete;

  const std::string& Path() const { return this->Final; }

  /// Where to write. Made at the first call, so that what is interrupted in its long work before
  /// leaves nothing behind. Throws Failure.
  const std::string& TemporaryPath();

  /// Gives the complete file its name. Throws Failure.
  void Commit();

private:
  void MakeTemporary();
  void RemoveTemporary();

  std::string Final;
  std::string Extension;
  std::string Temporary; // empty before it is made and once it is committed
};

#endif

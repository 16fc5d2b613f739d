#include "OutputFile.h"

#include "Failure.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

OutputFile::OutputFile(
  const std::string& option, const std::string& path, const std::string& extension)
  : Final(path)
  , Extension(extension)
{
  fs::path target(path);
  if (target.extension() != extension)
  {
    throw UsageError(option + " " + path + ": a name ending in " + extension + " is wanted");
  }
  std::error_code error;
  // Renaming would replace a link, not what it points to.
  if (fs::is_symlink(target, error))
  {
    target = fs::weakly_canonical(target, error);
    this->Final = target.string();
  }
  if (fs::is_directory(target, error))
  {
    throw Failure("the output is a folder", path, "give a file's name");
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
  {
    throw Failure("the output's folder does not exist", folder.string(), "make it first");
  }
  // A trial.
  this->MakeTemporary();
  this->RemoveTemporary();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
  : Final(std::move(other.Final))
  , Extension(std::move(other.Extension))
  , Temporary(std::move(other.Temporary))
{
  other.Temporary.clear();
}

OutputFile::~OutputFile()
{
  this->RemoveTemporary();
}

const std::string& OutputFile::TemporaryPath()
{
  if (this->Temporary.empty())
  {
    this->MakeTemporary();
  }
  return this->Temporary;
}

void OutputFile::MakeTemporary()
{
  const fs::path target(this->Final);
  const std::string hidden = "." + target.stem().string() + ".XXXXXX" + this->Extension;
  std::string name = (target.parent_path() / hidden).string();
  const int file = mkstemps(name.data(), static_cast<int>(this->Extension.size()));
  if (file < 0)
  {
    throw Failure("the output cannot be written (" + std::string(std::strerror(errno)) + ")",
      this->Final, "choose a place that can");
  }
  close(file);
  this->Temporary = name;
}

void OutputFile::RemoveTemporary()
{
  if (!this->Temporary.empty())
  {
    unlink(this->Temporary.c_str());
    this->Temporary.clear();
  }
}

void OutputFile::Commit()
{
  // mkstemps gives rights to the owner alone; a new file has those that the user's mask leaves.
  const mode_t mask = umask(0);
  umask(mask);
  if (chmod(this->Temporary.c_str(), 0666 & ~mask) != 0 ||
    std::rename(this->Temporary.c_str(), this->Final.c_str()) != 0)
  {
    throw Failure("the output cannot be named (" + std::string(std::strerror(errno)) + ")",
      this->Final, "choose another name");
  }
  this->Temporary.clear();
}

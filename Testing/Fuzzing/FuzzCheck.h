/**
 * @brief What a fuzz target does with a broken invariant: it says which, and aborts.
 */
#ifndef shadowtest_FuzzCheck_h
#define shadowtest_FuzzCheck_h

#include <string>

class vtkObject;

namespace shadowtest
{
/// Aborts unless `holds`, with `message` on standard error.
void require(bool holds, const std::string& message);

/// VTK prints no more: hostile input is what it complains of.
void silenceVTK();

/// Collects what an object reports by vtkErrorMacro, which is then not printed.
class ErrorWatch
{
public:
  explicit ErrorWatch(vtkObject* watched);

  /// The errors since the last call.
  std::string take();

private:
  std::string Errors;
};
}

#endif

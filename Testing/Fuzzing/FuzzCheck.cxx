#include "FuzzCheck.h"

#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace shadowtest
{
namespace
{
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
};

vtkStandardNewMacro(SilentWindow);

class ErrorCollector : public vtkCommand
{
public:
  explicit ErrorCollector(std::string& errors)
    : Errors(errors)
  {
  }

  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Errors += static_cast<const char*>(text);
  }

private:
  std::string& Errors;
};
}

void require(bool holds, const std::string& message)
{
  if (!holds)
  {
    std::fprintf(stderr, "invariant broken: %s\n", message.c_str());
    std::abort();
  }
}

void silenceVTK()
{
  static const bool once = []
  {
    vtkNew<SilentWindow> window;
    vtkOutputWindow::SetInstance(window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    return true;
  }();
  static_cast<void>(once);
}

ErrorWatch::ErrorWatch(vtkObject* watched)
{
  auto* collector = new ErrorCollector(this->Errors);
  watched->AddObserver(vtkCommand::ErrorEvent, collector);
  collector->Delete();
}

std::string ErrorWatch::take()
{
  return std::exchange(this->Errors, std::string());
}
}

#include "Progress.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <cstdio>
#include <unistd.h>

namespace
{
class ShowProgress : public vtkCommand
{
public:
  static ShowProgress* New() { return new ShowProgress; }

  void Execute(vtkObject*, unsigned long, void* fraction) override
  {
    this->Line->Show(this->Work, *static_cast<double*>(fraction));
  }

  Progress* Line = nullptr;
  std::string Work;
};
}

Progress::Progress()
  : Terminal(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
  if (this->Terminal)
  {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::Show(const std::string& work, double fraction)
{
  if (!this->Terminal)
  {
    return;
  }
  std::fprintf(stderr, "\r\033[K%s", work.c_str());
  if (fraction >= 0.0)
  {
    std::fprintf(stderr, " %3.0f%%", 100.0 * fraction);
  }
  std::fflush(stderr);
}

void Progress::Watch(vtkAlgorithm* algorithm, const std::string& work)
{
  if (!this->Terminal)
  {
    return;
  }
  ShowProgress* show = ShowProgress::New();
  show->Line = this;
  show->Work = work;
  algorithm->AddObserver(vtkCommand::ProgressEvent, show);
  show->Delete();
}

// The core's kernels on VTK's threads.
#ifndef SMPRangeLoop_h
#define SMPRangeLoop_h

#include "RangeLoop.h"

#include "vtkSMPTools.h"

inline void smpRangeLoop(std::size_t count, std::size_t grain, const shadow::RangeBody& body)
{
  if (count <= grain)
  {
    shadow::serialLoop(count, grain, body);
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), static_cast<vtkIdType>(grain),
    [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

#endif

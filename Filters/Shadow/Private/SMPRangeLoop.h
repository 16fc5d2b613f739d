// The core's kernels on VTK's threads.
#ifndef SMPRangeLoop_h
#define SMPRangeLoop_h

#include "RangeLoop.h"

#include "vtkSMPTools.h"

// Short ranges run on the calling thread: starting others would take longer.
inline void smpRangeLoop(std::size_t count, const shadow::RangeBody& body)
{
  constexpr std::size_t shortest = 4;
  if (count < shortest)
  {
    shadow::serialLoop(count, body);
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&body](vtkIdType begin, vtkIdType end)
    { body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); });
}

#endif

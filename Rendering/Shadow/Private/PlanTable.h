/**
 * What was done in a frame, step by step, and how long it took.
 */
#ifndef PlanTable_h
#define PlanTable_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkTable;

struct PlanRow
{
  int Light = -1;  ///< number of its mask; -1 for what is done once a frame
  int Caster = -1; ///< number among those that cast; -1 for what is done once a light
  std::string Decision;
  std::string Reason;
  double Milliseconds = 0.0;
};

vtkSmartPointer<vtkTable> MakePlanTable(const std::vector<PlanRow>& rows);

#endif

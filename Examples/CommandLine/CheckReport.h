/**
 * What `smoothshadow check` says of a mesh, for people and as JSON.
 */
#ifndef CheckReport_h
#define CheckReport_h

#include "Statistics.h"

#include <string>

class vtkTable;

struct CheckReport
{
  Json Statistics;
  std::string Text; ///< of several lines, as wide as the terminal; elsewhere 100 columns
};

/// Of a mesh and the table that vtkShadowMeshCheck made of it.
CheckReport DescribeCheck(const Mesh& mesh, vtkTable* found);

#endif

// Meshes with their edges, without anything else of a caster, kept while they are not modified.
#ifndef ReceiverCache_h
#define ReceiverCache_h

#include "EdgeTable.h"

#include "vtkType.h"

#include <map>
#include <memory>

class vtkPolyData;

struct PreparedReceiver
{
  shadow::TriangleMesh mesh;
  shadow::EdgeTable edges;
  std::vector<vtkIdType> cells; // of each triangle: the input's cell that it is of
};

class ReceiverCache
{
public:
  // Reads the meshes that it does not hold as they are now, and lets go of those that are not asked
  // for.
  std::vector<std::shared_ptr<const PreparedReceiver>> get(const std::vector<vtkPolyData*>& meshes);

private:
  // A mesh is known by its address and its time of modification, which is never given twice.
  std::map<std::pair<vtkPolyData*, vtkMTimeType>, std::shared_ptr<const PreparedReceiver>> Held;
};

#endif

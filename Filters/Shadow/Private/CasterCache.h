// What does not depend on the light, kept for as long as a mesh is not modified.
#ifndef CasterCache_h
#define CasterCache_h

#include "Caster.h"
#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"

class vtkPolyData;

// How a mesh is read.
struct CasterSettings
{
  bool mergePoints = true;
  double featureAngle = 60.0; // degrees

  bool operator==(const CasterSettings& o) const
  {
    return this->mergePoints == o.mergePoints && this->featureAngle == o.featureAngle;
  }
};

// A caster and what was found when its mesh was read.
struct PreparedCaster
{
  PreparedCaster(shadow::TriangleMesh mesh, double featureAngle)
    : caster(std::move(mesh), featureAngle, smpRangeLoop)
  {
  }

  shadow::Caster caster;
  ReadingDefects defects;
};

// Holds one filter's caster. Filters of one process that read the same mesh with the same settings
// share theirs: a silhouette filter and the extruder after it prepare the mesh once.
class CasterCache
{
public:
  // Prepares the mesh unless this or another filter holds it as it is now.
  PreparedCaster& get(vtkPolyData* mesh, const CasterSettings& settings);

  // What this filter's searches found last on the mesh that is held.
  shadow::LastTracked& lastTracked() { return this->Last; }

  // Bytes of what is held.
  std::size_t memory() const { return this->Held ? this->Held->caster.memory() : 0; }

private:
  std::shared_ptr<PreparedCaster> Held;
  shadow::LastTracked Last;
};

#endif

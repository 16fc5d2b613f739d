// A silhouette as vtkPolyData: written by the silhouette filter, read by the extruder.
#ifndef SilhouetteData_h
#define SilhouetteData_h

#include "CasterCache.h"
#include "LoopPolylines.h"
#include "ShadowVolume.h"

class vtkPolyData;

// What a silhouette was made with.
struct SilhouetteSettings
{
  std::array<double, 4> lightPosition; // as the user gave it
  shadow::Light light;
  shadow::SilhouetteKind kind = shadow::SilhouetteKind::Discrete;
  bool complete = true; // known to be all of it
  CasterSettings caster;
};

// Makes polylines of the loops and writes them with all arrays that vtkSmoothLightSilhouette
// documents.
void writeSilhouette(const PreparedCaster& prepared, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops, const shadow::PolylineTolerance& tolerance,
  const SilhouetteSettings& settings, vtkPolyData* output);

// False if the data lack what vtkSmoothLightSilhouette writes.
bool readSettings(vtkPolyData* data, SilhouetteSettings& settings);

// False if the data are not of this shape, or have nodes that the chain has not.
bool readSilhouette(vtkPolyData* data, const shadow::Caster& caster,
  const shadow::SilhouetteChain& chain, shadow::SilhouetteInput& silhouette);

// The silhouette of the chain itself, without a detour over vtkPolyData.
shadow::SilhouetteInput toInput(
  const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops);

#endif

// A silhouette as vtkPolyData: written by the silhouette filter, read by those after it.
#ifndef SilhouetteData_h
#define SilhouetteData_h

#include "CasterCache.h"
#include "LoopPolylines.h"
#include "ShadowVolume.h"

#include <string>

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

// What to say of data that readSettings refused, on port 1.
std::string describeUnreadableSilhouette();

// Reads and matches them; None, too, if a part is missing although they are said to be complete.
shadow::Match matchSilhouette(vtkPolyData* data, const SilhouetteSettings& settings,
  const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  shadow::SilhouetteInput& silhouette);

// What to say of a silhouette on port 1 that does not match the mesh on port 0.
std::string describeForeignSilhouette(vtkPolyData* mesh);

// The silhouette of the chain itself, without a detour over vtkPolyData.
shadow::SilhouetteInput toInput(
  const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops);

#endif

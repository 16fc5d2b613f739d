/**
 * The shadow volumes of the frame, kept as long as nothing moves.
 *
 * A volume belongs to a mesh and a light in the mesh's coordinates, not to an actor: actors or
 * glyphs that share a mesh share volumes where the light is the same for them, and an actor that is
 * moved along with its light, or along a directional light, keeps its own. The filters of a mesh
 * serve all of its lights in turn, so what they keep about the mesh is made once.
 */
#ifndef VolumeCache_h
#define VolumeCache_h

#include "VolumeBuffers.h"

#include "vtkNew.h"
#include "vtkShadowVolumeExtruder.h"
#include "vtkSmoothLightSilhouette.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <tuple>

class vtkPolyData;
class vtkRenderer;

class VolumeCache
{
public:
  /**
   * What the pass asks of the silhouettes.
   */
  struct Quality
  {
    int Kind;
    double Tolerance;
    bool WithCaps;
  };

  /**
   * To be called before and after the renderer's requests: at the end, volumes that were last
   * asked for by this renderer, but not since the beginning, are freed.
   */
  void BeginFrame()
  {
    ++this->Frame;
    this->NumberMade = 0;
  }
  void EndFrame(vtkRenderer* renderer);

  const VolumeBuffers& Get(vtkRenderer* renderer, vtkPolyData* mesh,
    const std::array<double, 4>& light, const Quality& quality, unsigned int attribute);

  /**
   * See vtkSmoothLightSilhouette::ComputeMeshDeviation; known again as long as the mesh is not modified
   * and casts.
   */
  double GetMeshDeviation(vtkPolyData* mesh);

  /**
   * Since the beginning of the frame.
   */
  int GetNumberMade() const { return this->NumberMade; }

  /**
   * Needs the context of the requests.
   */
  void Release() { this->Casters.clear(); }

private:
  // Of a mesh: its time, the light in its coordinates, kind and tolerance.
  using Key = std::tuple<vtkMTimeType, std::array<double, 4>, int, double>;

  struct Volume
  {
    vtkRenderer* Renderer = nullptr;
    vtkIdType Frame = 0;
    VolumeBuffers Buffers;
  };

  struct Caster
  {
    vtkNew<vtkSmoothLightSilhouette> Silhouette;
    vtkNew<vtkShadowVolumeExtruder> Extruder;
    std::map<Key, Volume> Volumes;
    double MeshDeviation = 0.0;
    vtkMTimeType DeviationTime = 0;
  };

  // The filters hold the mesh, so that its address stays its own.
  std::map<vtkPolyData*, Caster> Casters;
  vtkIdType Frame = 0;
  int NumberMade = 0;
};

#endif

/**
 * The shadow volumes of the frame, kept as long as nothing moves.
 *
 * A volume belongs to a mesh and a light in the mesh's coordinates, not to an actor: actors or
 * glyphs that share a mesh share volumes where the light is the same for them, and an actor that is
 * moved along with its light, or along a directional light, keeps its own. The filters of a mesh
 * serve all of its lights in turn, so what they keep about the mesh is made once, and so are its
 * points on the graphics card.
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
#include <memory>
#include <tuple>
#include <vector>

class vtkPolyData;
class vtkRenderer;

class VolumeCache
{
public:
  /**
   * What the pass asks of a volume.
   */
  struct Quality
  {
    int Kind;
    double Tolerance; // in the mesh's coordinates
    bool WithCaps; // z-pass draws none
  };

  /**
   * To be called before and after the renderer's requests: at the end, volumes that were last
   * asked for by this renderer, but not since the beginning, are freed. Their buffers serve for
   * another frame, should the light be moving.
   */
  void BeginFrame()
  {
    ++this->Frame;
    this->NumberMade = 0;
    this->UploadedBytes = 0;
  }
  void EndFrame(vtkRenderer* renderer);

  /**
   * A volume without caps may come with them; it does where the light is inside of the ball around
   * the mesh, as how deep it is cannot be told otherwise. Valid until the end of the frame.
   */
  const VolumeBuffers& Get(vtkRenderer* renderer, vtkPolyData* mesh,
    const std::array<double, 4>& light, const Quality& quality, unsigned int attribute);

  /**
   * See vtkSmoothLightSilhouette::ComputeMeshDeviation: kept while the mesh is asked for and not
   * modified.
   */
  double GetMeshDeviation(vtkRenderer* renderer, vtkPolyData* mesh);

  /**
   * Since the beginning of the frame: volumes, and bytes that went to the graphics card.
   */
  int GetNumberMade() const { return this->NumberMade; }
  std::size_t GetUploadedBytes() const { return this->UploadedBytes; }

  /**
   * Needs the context of the requests.
   */
  void Release() { this->Casters.clear(); }

private:
  // Of a mesh: its time, the light in its coordinates, kind and tolerance.
  using Key = std::tuple<vtkMTimeType, std::array<double, 4>, int, double>;

  // Who asked for something last, and when.
  struct Request
  {
    vtkRenderer* Renderer = nullptr;
    vtkIdType Frame = 0;
  };

  struct Volume
  {
    Request Last;
    bool WithCaps = false;
    std::unique_ptr<VolumeBuffers> Buffers;
  };

  struct Spare
  {
    vtkIdType Frame; // at whose end it came
    std::unique_ptr<VolumeBuffers> Buffers;
  };

  struct Caster
  {
    Request Last;
    vtkNew<vtkSmoothLightSilhouette> Silhouette;
    vtkNew<vtkShadowVolumeExtruder> Extruder;
    std::shared_ptr<const MeshBuffers> Mesh;
    vtkMTimeType MeshTime = 0;
    std::map<Key, Volume> Volumes;
    std::vector<Spare> Spares;
  };

  Caster& Find(vtkRenderer* renderer, vtkPolyData* mesh);
  bool IsUnused(const Request& last, vtkRenderer* renderer) const
  {
    return last.Renderer == renderer && last.Frame != this->Frame;
  }
  vtkPolyData* MakeNearEnd(Caster& caster, const std::array<double, 4>& light,
    const Quality& quality, bool& withCaps);

  // The filters hold the mesh, so that its address stays its own.
  std::map<vtkPolyData*, Caster> Casters;
  vtkIdType Frame = 0;
  int NumberMade = 0;
  std::size_t UploadedBytes = 0;
};

#endif

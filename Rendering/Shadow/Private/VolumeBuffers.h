/**
 * What a shadow volume begins with, on the graphics card. The vertex shader extrudes it, and knows
 * where it ends: neither walls nor far end are there as triangles.
 */
#ifndef VolumeBuffers_h
#define VolumeBuffers_h

#include "MeshBuffers.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkPolyData;

class VolumeBuffers
{
public:
  VolumeBuffers() = default;
  ~VolumeBuffers();
  VolumeBuffers(const VolumeBuffers&) = delete;
  VolumeBuffers& operator=(const VolumeBuffers&) = delete;

  /**
   * Takes the output of vtkShadowVolumeExtruder with the extent NEAR_END, in place of what was
   * there; the buffers stay. What has the multiplicity m is drawn m times: integer targets, which
   * could add m at once, cannot blend. `attribute` is where the vertex shader takes the vertices.
   * Gives the number of bytes that were uploaded.
   */
  std::size_t Upload(
    vtkPolyData* end, std::shared_ptr<const MeshBuffers> mesh, unsigned int attribute);

  /**
   * The triangles that coincide with the caster's surface.
   */
  void DrawCaps() const;

  /**
   * The gaps between these and a smooth silhouette.
   */
  void DrawGaps() const;

  /**
   * Strips of places and ends in turn; fans of ends, wound inwards, which close a far end only if
   * the light is outside.
   */
  void DrawWalls() const;
  void DrawEndFans() const;
  bool IsLightOutside() const { return this->LightOutside; }

  const MeshBuffers& GetMesh() const { return *this->Mesh; }

  /**
   * Bounds of all points but those where shadows end, in VTK's order, in the mesh's coordinates.
   */
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }

  bool IsEmpty() const { return this->RimFirst.empty() && this->CapIndices == 0; }

  /**
   * How often the volume winds around a point at most.
   */
  int GetGreatestDepth() const { return this->GreatestDepth; }

private:
  enum VertexArray
  {
    Caps,  // of the mesh's points
    Parts, // of points of the volume's own
    Walls,
    Ends,
    NumberOfVertexArrays
  };

  void PlaceRims(vtkPolyData* end, std::vector<float>& vertices);
  void PlacePoints(vtkPolyData* end, std::vector<float>& vertices);
  void Describe(VertexArray array, unsigned int vertices, unsigned int attribute, int size,
    std::size_t stride, std::size_t offset);
  void DrawTriangles(VertexArray array, int first, int count) const;

  std::shared_ptr<const MeshBuffers> Mesh;
  std::array<double, 6> Bounds{};
  int GreatestDepth = 0;
  bool LightOutside = true;

  // Of each rim, by its places; one of multiplicity m is there m times.
  std::vector<int> RimFirst;
  std::vector<int> RimCount;
  std::vector<int> StripFirst;
  std::vector<int> StripCount;

  // Behind one another: the caps' whole triangles, their parts, the gaps.
  int CapIndices = 0;
  int PartIndices = 0;
  int GapIndices = 0;

  std::array<unsigned int, NumberOfVertexArrays> VertexArrays{};
  unsigned int Vertices = 0;
  unsigned int Indices = 0;
};

#endif

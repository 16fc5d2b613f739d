/**
 * One shadow volume on the graphics card.
 */
#ifndef VolumeBuffers_h
#define VolumeBuffers_h

#include <array>

class vtkPolyData;

class VolumeBuffers
{
public:
  VolumeBuffers() = default;
  ~VolumeBuffers() { this->Release(); }
  VolumeBuffers(const VolumeBuffers&) = delete;
  VolumeBuffers& operator=(const VolumeBuffers&) = delete;

  /**
   * Takes the output of vtkShadowVolumeExtruder. A triangle of multiplicity m is there m times:
   * integer targets, which could add m at once, cannot blend. `attribute` is where the vertex
   * shader takes the homogeneous position.
   */
  void Upload(vtkPolyData* volume, unsigned int attribute);

  /**
   * Needs the context that was current on Upload.
   */
  void Release();

  /**
   * The triangles that coincide with the caster's surface, and all others.
   */
  void DrawCaps() const { this->Draw(0, this->CapIndices); }
  void DrawSides() const { this->Draw(this->CapIndices, this->SideIndices); }

  /**
   * The origin of the vertices in the mesh's coordinates. They are floats and would lose their
   * precision far from it.
   */
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }

  /**
   * How often the volume winds around a point at most.
   */
  int GetGreatestDepth() const { return this->GreatestDepth; }

private:
  void Draw(int first, int count) const;

  std::array<double, 3> Origin{};
  int GreatestDepth = 0;
  int CapIndices = 0;
  int SideIndices = 0;
  unsigned int VertexArray = 0;
  unsigned int Vertices = 0;
  unsigned int Indices = 0;
};

#endif

/**
 * One shadow volume on the graphics card, without where it ends: that is up to the vertex shader.
 */
#ifndef VolumeBuffers_h
#define VolumeBuffers_h

#include <array>
#include <vector>

class vtkPolyData;

class VolumeBuffers
{
public:
  VolumeBuffers() = default;
  ~VolumeBuffers() { this->Release(); }
  VolumeBuffers(const VolumeBuffers&) = delete;
  VolumeBuffers& operator=(const VolumeBuffers&) = delete;

  /**
   * Takes the output of vtkShadowVolumeExtruder with a LENGTH (any) as Extent. A triangle of
   * multiplicity m is there m times: integer targets, which could add m at once, cannot blend.
   * `attribute` is where the vertex shader takes the vertices. Without a far cap in the output there is
   * a fan: the light must be outside of the mesh's bounding ball then.
   */
  void Upload(vtkPolyData* volume, unsigned int attribute);

  /**
   * Needs the context that was current on Upload.
   */
  void Release();

  /**
   * The triangles that coincide with the caster's surface, walls and gaps, and the far end.
   */
  void DrawCaps() const { this->Draw(0, this->CapIndices); }
  void DrawSides() const { this->Draw(this->CapIndices, this->SideIndices); }
  void DrawFarEnd() const
  {
    this->Draw(this->CapIndices + this->SideIndices, this->FarIndices);
  }

  /**
   * Vertices are kept in coordinates of their own, as floats lose their precision far from the
   * origin, and their range in products: a place of the mesh is Scale times that plus Origin.
   */
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }
  double GetScale() const { return this->Scale; }

  /**
   * Bounds of all points but those where shadows end, in VTK's order, in the mesh's coordinates.
   */
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }

  bool IsEmpty() const { return this->VertexArray == 0; }

  /**
   * How often the volume winds around a point at most.
   */
  int GetGreatestDepth() const { return this->GreatestDepth; }

private:
  void PlaceVertices(vtkPolyData* volume, std::vector<float>& vertices);
  void Draw(int first, int count) const;

  std::array<double, 3> Origin{};
  double Scale = 1.0;
  std::array<double, 6> Bounds{};
  int GreatestDepth = 0;
  int CapIndices = 0;
  int SideIndices = 0;
  int FarIndices = 0;
  unsigned int VertexArray = 0;
  unsigned int Vertices = 0;
  unsigned int Indices = 0;
};

#endif

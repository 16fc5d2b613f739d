/**
 * The points of a mesh on the graphics card, once for all of its shadow volumes.
 */
#ifndef MeshBuffers_h
#define MeshBuffers_h

#include <array>
#include <cstddef>

class vtkPolyData;

class MeshBuffers
{
public:
  /**
   * Uploads all points, three floats each, by their numbers.
   */
  explicit MeshBuffers(vtkPolyData* mesh);
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /**
   * Floats lose their precision far from the origin, and their range in products: a place of the
   * mesh is Scale times its vertex plus Origin. Equal places give equal vertices.
   */
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }
  double GetScale() const { return this->Scale; }
  std::array<float, 3> ToVertex(const double place[3]) const;

  /**
   * Of the points that triangles use, in VTK's order, in the mesh's coordinates.
   */
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }

  unsigned int GetVertices() const { return this->Vertices; }
  std::size_t GetUploadedBytes() const { return this->UploadedBytes; }

private:
  void FindBounds(vtkPolyData* mesh);

  std::array<double, 3> Origin{};
  double Scale = 1.0;
  std::array<double, 6> Bounds{};
  unsigned int Vertices = 0;
  std::size_t UploadedBytes = 0;
};

#endif

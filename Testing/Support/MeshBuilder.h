/**
 * @brief Collects points (double), normals and triangles and makes a vtkPolyData of them.
 *
 * Either every point gets a normal or none does. Normals are stored as given: not normalised, so
 * that zero and wrong ones can be made on purpose.
 */
#ifndef shadowtest_MeshBuilder_h
#define shadowtest_MeshBuilder_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

namespace shadowtest
{
using Mesh = vtkSmartPointer<vtkPolyData>;
using Vec3 = std::array<double, 3>;

class MeshBuilder
{
public:
  vtkIdType addPoint(const Vec3& point);
  vtkIdType addPoint(const Vec3& point, const Vec3& normal);
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  /// The triangles a b c and a c d.
  void addQuad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d);
  /// One cell.
  void addPolygon(const std::vector<vtkIdType>& ids);

  /// Takes over the points and triangles of a mesh; returns the id of its first point here. The
  /// mesh must have normals if this has.
  vtkIdType append(vtkPolyData* mesh);

  vtkIdType pointCount() const { return static_cast<vtkIdType>(this->Points.size()); }

  Mesh build() const;

  // Open to makers that change a mesh in place.
  std::vector<Vec3> Points;
  std::vector<Vec3> Normals;
  std::vector<std::vector<vtkIdType>> Cells;
};

Vec3 normalized(const Vec3& v);
Vec3 cross(const Vec3& a, const Vec3& b);
double dot(const Vec3& a, const Vec3& b);
Vec3 operator+(const Vec3& a, const Vec3& b);
Vec3 operator-(const Vec3& a, const Vec3& b);
Vec3 operator*(double s, const Vec3& a);
}

#endif

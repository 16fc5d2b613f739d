/**
 * What is drawn: an animal on a chair, on the ground. Metres; z points upwards.
 */
#ifndef SketchModel_h
#define SketchModel_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

using PolyData = vtkSmartPointer<vtkPolyData>;

struct Model
{
  PolyData Chair;  ///< closed boxes, without normals: all edges are sharp
  PolyData Animal; ///< with normals, without colours
  PolyData Ground;

  std::vector<vtkPolyData*> All() const { return { this->Chair, this->Animal, this->Ground }; }
};

/// With the animal of an OBJ file whose y points upwards; without a file with a torus. Without
/// triangles if the file holds none.
Model MakeModel(const char* animal);

#endif

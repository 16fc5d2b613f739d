/**
 * Meshes from files: PLY, STL, OBJ, VTP, legacy VTK, glTF and 3DS, told apart by their extension.
 */
#ifndef MeshReader_h
#define MeshReader_h

#include "Progress.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

struct Mesh
{
  std::string File;
  vtkSmartPointer<vtkPolyData> Data;
};

/// The polygons and strips of a file, with its point normals where it has them. Points may be
/// non-finite; each cell's points exist. Throws Failure.
Mesh ReadMesh(const std::string& file, Progress& progress);

/// The same with the file's lines and vertices, which cast no shadow.
Mesh ReadMeshWithLines(const std::string& file, Progress& progress);

#endif

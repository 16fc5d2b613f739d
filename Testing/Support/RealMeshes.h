/**
 * @brief Meshes of Debian packages: glmark2's bunny and CGAL's collection. No normals.
 *
 * All throw std::runtime_error with a message that says which file, and which package to install.
 */
#ifndef shadowtest_RealMeshes_h
#define shadowtest_RealMeshes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace shadowtest
{
/// The Stanford bunny of package glmark2-data: 69,666 triangles, closed. The environment variable
/// SMOOTHSHADOW_TEST_BUNNY names another OBJ file. Points are made double.
vtkSmartPointer<vtkPolyData> bunny();

/// A mesh of package libcgal-demo by its name, without ".off", as in cgalMesh("armadillo"), but
/// with ".ply" or ".stl", as in cgalMesh("pig.stl"), whose points are floats. The build unpacks the
/// package's archive; SMOOTHSHADOW_TEST_CGAL names another folder of OFF files.
vtkSmartPointer<vtkPolyData> cgalMesh(const std::string& name);

/// Names of all of them, sorted; empty if there is no such folder.
std::vector<std::string> cgalMeshNames();

/// A copy of size 2 (the diagonal of its bounds) around the origin, turned so that the axis `up`
/// (0 to 2) of the input becomes z, with smooth normals by VTK.
vtkSmartPointer<vtkPolyData> standing(vtkPolyData* mesh, int up);
}

#endif

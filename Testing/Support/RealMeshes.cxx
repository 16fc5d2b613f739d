#include "RealMeshes.h"

#include "OffReader.h"

#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace shadowtest
{
namespace
{
std::string setting(const char* variable, const char* otherwise)
{
  const char* value = std::getenv(variable);
  return value && *value ? value : otherwise;
}

std::string cgalFolder()
{
  return setting("SMOOTHSHADOW_TEST_CGAL", SMOOTHSHADOW_TEST_CGAL_FOLDER);
}
}

vtkSmartPointer<vtkPolyData> bunny()
{
  const std::string path = setting("SMOOTHSHADOW_TEST_BUNNY", SMOOTHSHADOW_TEST_BUNNY_FILE);
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("bunny: there is no " + path +
      "; install the package glmark2-data or set SMOOTHSHADOW_TEST_BUNNY");
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("bunny: no polygons in " + path);
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(reader->GetOutput()->GetPoints());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(reader->GetOutput()->GetPolys());
  return mesh;
}

namespace
{
template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}
}

vtkSmartPointer<vtkPolyData> cgalMesh(const std::string& name)
{
  std::filesystem::path path = std::filesystem::path(cgalFolder()) / name;
  const bool isOff = path.extension() != ".ply" && path.extension() != ".stl";
  if (isOff)
  {
    path += ".off";
  }
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("cgalMesh(\"" + name + "\"): there is no " + path.string() +
      "; install the package libcgal-demo and build again, or set SMOOTHSHADOW_TEST_CGAL");
  }
  return isOff ? readOff(path.string())
    : path.extension() == ".ply" ? readWith<vtkPLYReader>(path.string())
                                 : readWith<vtkSTLReader>(path.string());
}

std::vector<std::string> cgalMeshNames()
{
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(cgalFolder(), none))
  {
    const std::filesystem::path extension = entry.path().extension();
    if (extension == ".off")
    {
      names.push_back(entry.path().stem().string());
    }
    else if (extension == ".ply" || extension == ".stl")
    {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

vtkSmartPointer<vtkPolyData> standing(vtkPolyData* mesh, int up)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const double scale = 2.0 / mesh->GetLength();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (int c = 0; c < 3; ++c)
    {
      p[c] = scale * (p[c] - 0.5 * (bounds[2 * c] + bounds[2 * c + 1]));
    }
    points->InsertNextPoint(p[(up + 1) % 3], p[(up + 2) % 3], p[up]);
  }
  vtkNew<vtkPolyData> turned;
  turned->ShallowCopy(mesh);
  turned->SetPoints(points);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(turned);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}
}

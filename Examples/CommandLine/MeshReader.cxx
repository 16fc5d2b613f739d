#include "MeshReader.h"

#include "Failure.h"
#include "FileStructure.h"
#include "Messages.h"

#include <vtk3DSImporter.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkGLTFReader.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyDataReader.h>
#include <vtkRenderer.h>
#include <vtkSTLReader.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{
std::string Extension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return extension;
}

void RequireReadable(const std::string& file)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    throw Failure("no such file", file, "check its name");
  }
  if (std::filesystem::is_directory(file, error))
  {
    throw Failure("a folder, not a mesh", file, "name a file in it");
  }
  const std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    throw Failure("cannot be opened (" + std::string(std::strerror(errno)) + ")", file,
      "check the rights to read it");
  }
  if (std::filesystem::file_size(file, error) == 0)
  {
    throw Failure("the file is empty", file, "write it again");
  }
}

template <class Reader>
vtkSmartPointer<vtkPolyData> Read(Reader* reader, const std::string& file, Progress& progress)
{
  reader->SetFileName(file.c_str());
  progress.Watch(reader, "reading " + file);
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadStl(const std::string& file, Progress& progress)
{
  vtkNew<vtkSTLReader> reader;
  // Equal points are merged later, once non-finite ones are out of the way.
  reader->MergingOff();
  return Read(reader.Get(), file, progress);
}

vtkSmartPointer<vtkPolyData> ReadGltf(const std::string& file, Progress& progress)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(file.c_str());
  progress.Watch(reader, "reading " + file);
  vtkNew<vtkCompositeDataGeometryFilter> flatten;
  flatten->SetInputConnection(reader->GetOutputPort());
  flatten->Update();
  return flatten->GetOutput();
}

// The importer makes actors; nothing is drawn.
vtkSmartPointer<vtkPolyData> Read3DS(const std::string& file)
{
  vtkNew<vtk3DSImporter> importer;
  importer->SetFileName(file.c_str());
  importer->Read();
  vtkNew<vtkAppendPolyData> append;
  if (vtkRenderer* renderer = importer->GetRenderer())
  {
    vtkActorCollection* actors = renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      vtkNew<vtkTransform> place;
      place->SetMatrix(actor->GetMatrix());
      vtkNew<vtkTransformPolyDataFilter> transform;
      transform->SetTransform(place);
      actor->GetMapper()->Update();
      transform->SetInputDataObject(actor->GetMapper()->GetInputDataObject(0, 0));
      transform->Update();
      append->AddInputData(transform->GetOutput());
    }
  }
  // The importer makes strips.
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputConnection(append->GetOutputPort());
  triangulate->Update();
  return triangulate->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadAny(const std::string& file, Progress& progress)
{
  const std::string extension = Extension(file);
  if (extension == ".ply")
  {
    return Read(vtkNew<vtkPLYReader>().Get(), file, progress);
  }
  if (extension == ".stl")
  {
    return ReadStl(file, progress);
  }
  if (extension == ".obj")
  {
    return Read(vtkNew<vtkOBJReader>().Get(), file, progress);
  }
  if (extension == ".vtp")
  {
    return Read(vtkNew<vtkXMLPolyDataReader>().Get(), file, progress);
  }
  if (extension == ".vtk")
  {
    return Read(vtkNew<vtkPolyDataReader>().Get(), file, progress);
  }
  if (extension == ".gltf" || extension == ".glb")
  {
    return ReadGltf(file, progress);
  }
  if (extension == ".3ds")
  {
    return Read3DS(file);
  }
  throw Failure("not a mesh format that is known", file,
    "give one of .ply, .stl, .obj, .vtp, .vtk, .gltf, .glb, .3ds");
}

std::string Defect(const std::string& file)
{
  const std::string extension = Extension(file);
  if (extension == ".ply")
  {
    return PlyDefect(file);
  }
  if (extension == ".stl")
  {
    return StlDefect(file);
  }
  return extension == ".obj" ? ObjDefect(file) : std::string();
}

// Readers pass on what a file says, and what follows takes ids on trust.
void RequireValidIds(vtkCellArray* cells, vtkIdType numberOfPoints, const std::string& file)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= numberOfPoints)
      {
        throw Failure(
          "a face names point " + std::to_string(ids[i]) + " of " + std::to_string(numberOfPoints),
          file, "write the mesh again");
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> ReadPolygons(const std::string& file, Progress& progress)
{
  progress.Show("reading " + file);
  RequireReadable(file);
  const std::string advice = "check that it is the mesh that its name says, and write it again";
  const std::string defect = Defect(file);
  if (!defect.empty())
  {
    throw Failure(defect, file, advice);
  }
  ClearMessages();
  const vtkSmartPointer<vtkPolyData> read = ReadAny(file, progress);
  const std::string error = FirstError();
  if (!error.empty())
  {
    throw Failure("cannot be read (" + error + ")", file, advice);
  }
  if (!read || read->GetNumberOfPolys() + read->GetNumberOfStrips() == 0)
  {
    throw Failure("the file holds no polygon", file, advice);
  }
  RequireValidIds(read->GetPolys(), read->GetNumberOfPoints(), file);
  RequireValidIds(read->GetStrips(), read->GetNumberOfPoints(), file);
  return read;
}

// Colours and texture coordinates play no part.
Mesh OnlySurface(const std::string& file, vtkPolyData* read)
{
  Mesh mesh{ file, vtkSmartPointer<vtkPolyData>::New() };
  mesh.Data->SetPoints(read->GetPoints());
  mesh.Data->SetPolys(read->GetPolys());
  mesh.Data->SetStrips(read->GetStrips());
  mesh.Data->GetPointData()->SetNormals(read->GetPointData()->GetNormals());
  return mesh;
}
}

Mesh ReadMesh(const std::string& file, Progress& progress)
{
  return OnlySurface(file, ReadPolygons(file, progress));
}

Mesh ReadMeshWithLines(const std::string& file, Progress& progress)
{
  const vtkSmartPointer<vtkPolyData> read = ReadPolygons(file, progress);
  Mesh mesh = OnlySurface(file, read);
  mesh.Data->SetLines(read->GetLines());
  mesh.Data->SetVerts(read->GetVerts());
  return mesh;
}

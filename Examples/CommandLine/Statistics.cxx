#include "Statistics.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>

#include <cmath>
#include <iostream>

Json MeshStatistics(const Mesh& mesh)
{
  Json statistics;
  statistics["file"] = mesh.File;
  statistics["points"] = mesh.Data->GetNumberOfPoints();
  statistics["polygons"] = mesh.Data->GetNumberOfPolys() + mesh.Data->GetNumberOfStrips();
  return statistics;
}

Json FieldValue(vtkDataObject* data, const std::string& array)
{
  vtkDataArray* values = data->GetFieldData()->GetArray(array.c_str());
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return nullptr;
  }
  const double value = values->GetComponent(0, 0);
  const bool real = values->GetDataType() == VTK_DOUBLE || values->GetDataType() == VTK_FLOAT;
  return real ? Json(value) : Json(static_cast<long long>(value));
}

Json MeshDefects(vtkDataObject* silhouette)
{
  Json defects;
  defects["degenerateCells"] = FieldValue(silhouette, "DegenerateCells");
  defects["nonFiniteCells"] = FieldValue(silhouette, "NonFiniteCells");
  defects["boundaryEdges"] = FieldValue(silhouette, "BoundaryEdges");
  defects["nonManifoldEdges"] = FieldValue(silhouette, "NonManifoldEdges");
  defects["inconsistentEdges"] = FieldValue(silhouette, "InconsistentEdges");
  return defects;
}

void PrintResult(bool json, const Json& statistics, const std::string& line)
{
  // A file's name may be no UTF-8: such bytes are replaced, not thrown at.
  std::cout << (json ? statistics.dump(2, ' ', false, Json::error_handler_t::replace) : line)
            << std::endl;
}

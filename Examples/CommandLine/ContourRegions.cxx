#include "ContourRegions.h"

#include "PolyDataOutput.h"

#include <vtkCastShadowContour.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkShadowedReceiver.h>

void WriteRegions(vtkCastShadowContour* contours, OutputFile& file, Json& statistics)
{
  vtkNew<vtkShadowedReceiver> regions;
  for (int port = 0; port < contours->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < contours->GetNumberOfInputConnections(port); ++i)
    {
      regions->AddInputConnection(port, contours->GetInputConnection(port, i));
    }
  }
  regions->SetBuilder(contours->GetBuilder());
  regions->Update();
  vtkPolyData* polygons = regions->GetOutput();
  const std::pair<const char*, const char*> areas[] = { { "litArea", "LitArea" },
    { "shadowedArea", "ShadowedArea" }, { "turnedAwayArea", "TurnedAwayArea" } };
  for (const auto& [name, arrayName] : areas)
  {
    vtkDataArray* array = polygons->GetFieldData()->GetArray(arrayName);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      statistics["receivers"][static_cast<std::size_t>(i)][name] = array->GetComponent(i, 0);
    }
  }
  statistics["regions"] = file.Path();
  statistics["regionPolygons"] = polygons->GetNumberOfPolys();
  WritePolyData(polygons, file);
}

#include "PlanTable.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkSmartPointer<vtkTable> MakePlanTable(const std::vector<PlanRow>& rows)
{
  vtkNew<vtkIntArray> lights;
  lights->SetName("Light");
  vtkNew<vtkIntArray> casters;
  casters->SetName("Caster");
  vtkNew<vtkStringArray> decisions;
  decisions->SetName("Decision");
  vtkNew<vtkStringArray> reasons;
  reasons->SetName("Reason");
  vtkNew<vtkDoubleArray> milliseconds;
  milliseconds->SetName("Milliseconds");
  for (const PlanRow& row : rows)
  {
    lights->InsertNextValue(row.Light);
    casters->InsertNextValue(row.Caster);
    decisions->InsertNextValue(row.Decision);
    reasons->InsertNextValue(row.Reason);
    milliseconds->InsertNextValue(row.Milliseconds);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(lights);
  table->AddColumn(casters);
  table->AddColumn(decisions);
  table->AddColumn(reasons);
  table->AddColumn(milliseconds);
  return table;
}

#include "PolyDataOutput.h"

#include "Failure.h"
#include "Messages.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

void WritePolyData(vtkPolyData* data, OutputFile& file)
{
  ClearMessages();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.TemporaryPath().c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  const bool written = writer->Write() != 0;
  if (!written || writer->GetErrorCode() != vtkErrorCode::NoError || !FirstError().empty())
  {
    throw Failure("cannot be written (" + FirstError() + ")", file.Path(), "check the room there");
  }
}

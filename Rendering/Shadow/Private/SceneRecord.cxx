#include "SceneRecord.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <cstring>

void SceneRecord::Add(double value)
{
  vtkTypeUInt64 word;
  static_assert(sizeof(word) == sizeof(value), "a double is one word");
  std::memcpy(&word, &value, sizeof(word));
  this->Words.push_back(word);
}

void SceneRecord::Add(const void* object, vtkMTimeType time)
{
  this->Words.push_back(reinterpret_cast<std::uintptr_t>(object));
  this->Words.push_back(time);
}

void SceneRecord::AddData(vtkDataObject* data)
{
  this->Add(data, data ? data->GetMTime() : 0);
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkDataObject* block = iterator->GetCurrentDataObject();
      this->Add(block, block->GetMTime());
    }
  }
}

void SceneRecord::Append(const SceneRecord& other)
{
  this->Words.insert(this->Words.end(), other.Words.begin(), other.Words.end());
  this->IsKnown = this->IsKnown && other.IsKnown;
}

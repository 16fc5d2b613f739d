/**
 * What a picture depends on, as words: as long as these are the same, so is the picture.
 */
#ifndef SceneRecord_h
#define SceneRecord_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataObject;

class SceneRecord
{
public:
  void Add(vtkTypeUInt64 number) { this->Words.push_back(number); }
  void Add(double value);

  /**
   * An object is known by its address together with a time: one that takes the address of another
   * that is gone has a later time.
   */
  void Add(const void* object, vtkMTimeType time);

  /**
   * Data, its blocks included, whose times a composite data set does not pass on.
   */
  void AddData(vtkDataObject* data);

  template <std::size_t size>
  void Add(const std::array<double, size>& values)
  {
    for (const double value : values)
    {
      this->Add(value);
    }
  }

  void Append(const SceneRecord& other);

  /**
   * Something is in the scene that may change unnoticed: the record is the same as no other, not
   * even itself. An empty record is likewise.
   */
  void AddUnknown() { this->IsKnown = false; }

  bool IsSameAs(const SceneRecord& other) const
  {
    return this->IsKnown && other.IsKnown && !this->Words.empty() && this->Words == other.Words;
  }

private:
  std::vector<vtkTypeUInt64> Words;
  bool IsKnown = true;
};

#endif

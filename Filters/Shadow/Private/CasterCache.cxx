#include "CasterCache.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
// A mesh is known by its address and its time of modification. Times are never given twice in a
// process, so a new mesh at an old address is not taken for the old one.
struct Entry
{
  vtkPolyData* mesh;
  vtkMTimeType time;
  CasterSettings settings;
  std::weak_ptr<PreparedCaster> prepared;
};

std::mutex registryGuard;

std::vector<Entry>& registry()
{
  static std::vector<Entry> entries;
  return entries;
}

std::shared_ptr<PreparedCaster> find(
  vtkPolyData* mesh, vtkMTimeType time, const CasterSettings& settings)
{
  const std::lock_guard<std::mutex> lock(registryGuard);
  const std::vector<Entry>& entries = registry();
  const auto found = std::find_if(entries.begin(), entries.end(),
    [&](const Entry& e)
    {
      return e.mesh == mesh && e.time == time && e.settings == settings && !e.prepared.expired();
    });
  return found != entries.end() ? found->prepared.lock() : nullptr;
}

void add(Entry entry)
{
  const std::lock_guard<std::mutex> lock(registryGuard);
  std::vector<Entry>& entries = registry();
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                  [](const Entry& e) { return e.prepared.expired(); }),
    entries.end());
  entries.push_back(std::move(entry));
}

std::shared_ptr<PreparedCaster> prepare(vtkPolyData* mesh, const CasterSettings& settings)
{
  BridgedMesh read = readMesh(mesh, settings.mergePoints);
  auto prepared = std::make_shared<PreparedCaster>(
    std::move(read.mesh), vtkMath::RadiansFromDegrees(settings.featureAngle));
  prepared->defects = read.defects;
  return prepared;
}
}

PreparedCaster& CasterCache::get(vtkPolyData* mesh, const CasterSettings& settings)
{
  const vtkMTimeType time = mesh->GetMTime();
  std::shared_ptr<PreparedCaster> prepared = find(mesh, time, settings);
  if (!prepared)
  {
    // Not under the lock: other meshes need not wait. If two filters come here at once with the
    // same mesh, each keeps its own.
    prepared = prepare(mesh, settings);
    add({ mesh, time, settings, prepared });
  }
  if (this->Held != prepared)
  {
    this->Held = std::move(prepared);
    this->Last = {};
  }
  return *this->Held;
}

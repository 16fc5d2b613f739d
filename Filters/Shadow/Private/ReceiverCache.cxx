#include "ReceiverCache.h"

#include "PolyDataBridge.h"

#include "vtkPolyData.h"

std::vector<std::shared_ptr<const PreparedReceiver>> ReceiverCache::get(
  const std::vector<vtkPolyData*>& meshes)
{
  decltype(this->Held) held;
  std::vector<std::shared_ptr<const PreparedReceiver>> receivers;
  for (vtkPolyData* mesh : meshes)
  {
    const std::pair key(mesh, mesh->GetMTime());
    auto& receiver = held[key];
    const auto before = this->Held.find(key);
    if (!receiver && before != this->Held.end())
    {
      receiver = before->second;
    }
    if (!receiver)
    {
      auto prepared = std::make_shared<PreparedReceiver>();
      BridgedMesh read = readMesh(mesh, true);
      prepared->mesh = std::move(read.mesh);
      prepared->cells = std::move(read.cells);
      prepared->edges = shadow::buildEdgeTable(prepared->mesh);
      receiver = prepared;
    }
    receivers.push_back(receiver);
  }
  this->Held = std::move(held);
  return receivers;
}

#include "VolumeCache.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>

VolumeCache::Caster& VolumeCache::Find(vtkRenderer* renderer, vtkPolyData* mesh)
{
  Caster& caster = this->Casters[mesh];
  caster.Last = { renderer, this->Frame };
  caster.Silhouette->SetInputData(mesh);
  return caster;
}

const VolumeBuffers& VolumeCache::Get(vtkRenderer* renderer, vtkPolyData* mesh,
  const std::array<double, 4>& light, const Quality& quality, unsigned int attribute)
{
  Caster& caster = this->Find(renderer, mesh);
  Volume& volume =
    caster.Volumes[Key(mesh->GetMTime(), light, quality.Kind, quality.Tolerance)];
  volume.Last = caster.Last;
  if (volume.Buffers && (volume.WithCaps || !quality.WithCaps))
  {
    return *volume.Buffers;
  }
  caster.Extruder->SetInputData(mesh);
  caster.Extruder->SetSilhouetteConnection(caster.Silhouette->GetOutputPort());
  caster.Extruder->SetExtentToNearEnd();
  vtkPolyData* end = this->MakeNearEnd(caster, light, quality, volume.WithCaps);

  if (!caster.Mesh || caster.MeshTime != mesh->GetMTime())
  {
    caster.Mesh = std::make_shared<MeshBuffers>(mesh);
    caster.MeshTime = mesh->GetMTime();
    this->UploadedBytes += caster.Mesh->GetUploadedBytes();
  }
  if (!volume.Buffers && !caster.Spares.empty())
  {
    volume.Buffers = std::move(caster.Spares.back().Buffers);
    caster.Spares.pop_back();
  }
  if (!volume.Buffers)
  {
    volume.Buffers = std::make_unique<VolumeBuffers>();
  }
  this->UploadedBytes += volume.Buffers->Upload(end, caster.Mesh, attribute);
  ++this->NumberMade;

  // They are on the graphics card now; what is kept about the mesh lies in the filters.
  caster.Extruder->GetOutput()->ReleaseData();
  caster.Silhouette->GetOutput()->ReleaseData();
  return *volume.Buffers;
}

vtkPolyData* VolumeCache::MakeNearEnd(Caster& caster, const std::array<double, 4>& light,
  const Quality& quality, bool& withCaps)
{
  caster.Silhouette->SetLightPosition(light.data());
  caster.Silhouette->SetKind(quality.Kind);
  caster.Silhouette->SetToleranceModeToWorld();
  caster.Silhouette->SetTolerance(quality.Tolerance);
  withCaps = quality.WithCaps;
  for (;;)
  {
    caster.Extruder->SetCaps(
      withCaps ? vtkShadowVolumeExtruder::AUTOMATIC : vtkShadowVolumeExtruder::NONE);
    caster.Extruder->Update();
    vtkPolyData* end = caster.Extruder->GetOutput();
    vtkDataArray* outside = end->GetFieldData()->GetArray("LightOutside");
    if (withCaps || !outside || outside->GetComponent(0, 0) != 0.0)
    {
      return end;
    }
    withCaps = true;
  }
}

double VolumeCache::GetMeshDeviation(vtkRenderer* renderer, vtkPolyData* mesh)
{
  return this->Find(renderer, mesh).Silhouette->ComputeMeshDeviation();
}

void VolumeCache::EndFrame(vtkRenderer* renderer)
{
  for (auto found = this->Casters.begin(); found != this->Casters.end();)
  {
    Caster& caster = found->second;
    caster.Spares.erase(std::remove_if(caster.Spares.begin(), caster.Spares.end(),
                          [&](const Spare& spare) { return spare.Frame != this->Frame; }),
      caster.Spares.end());
    for (auto volume = caster.Volumes.begin(); volume != caster.Volumes.end();)
    {
      const bool unused = this->IsUnused(volume->second.Last, renderer);
      if (unused && volume->second.Buffers)
      {
        caster.Spares.push_back({ this->Frame, std::move(volume->second.Buffers) });
      }
      volume = unused ? caster.Volumes.erase(volume) : std::next(volume);
    }
    const bool unused = caster.Volumes.empty() && this->IsUnused(caster.Last, renderer);
    found = unused ? this->Casters.erase(found) : std::next(found);
  }
}

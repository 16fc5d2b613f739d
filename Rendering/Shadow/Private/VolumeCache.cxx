#include "VolumeCache.h"

#include "vtkPolyData.h"

#include <cmath>
#include <iterator>

namespace
{
/**
 * Whether a light is outside of a ball around the mesh, with room for a smooth contour.
 */
bool IsOutsideBall(vtkPolyData* mesh, const std::array<double, 4>& light)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double offset = light[axis] - 0.5 * light[3] * (bounds[2 * axis] + bounds[2 * axis + 1]);
    squared += offset * offset;
  }
  return std::sqrt(squared) > 0.6 * light[3] * mesh->GetLength();
}
}

double VolumeCache::GetMeshDeviation(vtkPolyData* mesh)
{
  Caster& caster = this->Casters[mesh];
  if (caster.DeviationTime != mesh->GetMTime())
  {
    caster.Silhouette->SetInputData(mesh);
    caster.MeshDeviation = caster.Silhouette->ComputeMeshDeviation();
    caster.DeviationTime = mesh->GetMTime();
  }
  return caster.MeshDeviation;
}

const VolumeBuffers& VolumeCache::Get(vtkRenderer* renderer, vtkPolyData* mesh,
  const std::array<double, 4>& light, const Quality& quality, unsigned int attribute)
{
  Caster& caster = this->Casters[mesh];
  const auto [found, isNew] =
    caster.Volumes.try_emplace(Key(mesh->GetMTime(), light, quality.Kind, quality.Tolerance));
  Volume& volume = found->second;
  volume.Renderer = renderer;
  volume.Frame = this->Frame;
  if (!isNew)
  {
    return volume.Buffers;
  }

  caster.Silhouette->SetInputData(mesh);
  caster.Silhouette->SetLightPosition(light.data());
  caster.Silhouette->SetKind(quality.Kind);
  caster.Silhouette->SetToleranceModeToWorld();
  caster.Silhouette->SetTolerance(quality.Tolerance);
  caster.Extruder->SetInputData(mesh);
  caster.Extruder->SetSilhouetteConnection(caster.Silhouette->GetOutputPort());
  // Any length will do, as the vertex shader ends shadows; it gives each wall two points of its own.
  caster.Extruder->SetExtentToLength();
  caster.Extruder->SetFarCap(!IsOutsideBall(mesh, light));
  caster.Extruder->Update();

  ++this->NumberMade;
  volume.Buffers.Upload(caster.Extruder->GetOutput(), attribute);

  // They are on the graphics card now; what is kept about the mesh lies in the filters.
  caster.Extruder->GetOutput()->ReleaseData();
  caster.Silhouette->GetOutput()->ReleaseData();
  return volume.Buffers;
}

void VolumeCache::EndFrame(vtkRenderer* renderer)
{
  for (auto caster = this->Casters.begin(); caster != this->Casters.end();)
  {
    auto& volumes = caster->second.Volumes;
    for (auto volume = volumes.begin(); volume != volumes.end();)
    {
      const bool unused =
        volume->second.Renderer == renderer && volume->second.Frame != this->Frame;
      volume = unused ? volumes.erase(volume) : std::next(volume);
    }
    caster = volumes.empty() ? this->Casters.erase(caster) : std::next(caster);
  }
}

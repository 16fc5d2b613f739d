// What goes to the graphics card when a light moves, and when nothing does.

#include "ShadowPipeline.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "VolumeCache.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

namespace
{
constexpr unsigned int Attribute = 0;

/// A frame that asks for one volume; the bytes that it uploaded.
std::size_t uploadedBytes(VolumeCache& cache, vtkRenderer* renderer, vtkPolyData* mesh,
  const std::array<double, 4>& light, const VolumeCache::Quality& quality)
{
  cache.BeginFrame();
  EXPECT_FALSE(cache.Get(renderer, mesh, light, quality, Attribute).IsEmpty());
  cache.EndFrame(renderer);
  return cache.GetUploadedBytes();
}
}

TEST(VolumeUploads, AreTheSilhouetteAndTheCapsIndices)
{
  const auto window = shadowtest::MakeWindow(64, 64);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->Render();
  window->MakeCurrent();
  {
    const shadowtest::Mesh mesh = shadowtest::icosphere(5);
    const auto meshBytes = 12 * static_cast<std::size_t>(mesh->GetNumberOfPoints());
    for (const int kind : shadowtest::AllKinds)
    {
      for (const bool caps : { true, false })
      {
        VolumeCache cache;
        const VolumeCache::Quality quality{ kind, 1e-4, caps };
        EXPECT_GE(uploadedBytes(cache, renderer, mesh, { 3.0, 1.0, 2.0, 1.0 }, quality), meshBytes);
        const std::array<double, 4> moved{ 3.0, 1.2, 2.0, 1.0 };
        const std::size_t bytes = uploadedBytes(cache, renderer, mesh, moved, quality);
        EXPECT_EQ(uploadedBytes(cache, renderer, mesh, moved, quality), 0u);

        shadowtest::ShadowPipeline pipeline(mesh, moved, kind);
        const auto points =
          static_cast<std::size_t>(pipeline.silhouette()->GetNumberOfPoints());
        pipeline.Extruder->SetExtentToNearEnd();
        pipeline.Extruder->SetCaps(
          caps ? vtkShadowVolumeExtruder::AUTOMATIC : vtkShadowVolumeExtruder::NONE);
        const auto capIndices = static_cast<std::size_t>(
          pipeline.volume()->GetFieldData()->GetArray("CapTriangles")->GetNumberOfValues());
        EXPECT_GT(points, 50u);
        EXPECT_EQ(capIndices > 1000, caps);
        EXPECT_GT(bytes, 4 * capIndices);
        EXPECT_LE(bytes, 4 * capIndices + 40 * sizeof(float) * points);

        // Caps serve who wants none; who wants some gets them.
        const std::size_t other =
          uploadedBytes(cache, renderer, mesh, moved, { kind, 1e-4, !caps });
        EXPECT_EQ(other == 0, caps);

        // From inside they are always there.
        cache.BeginFrame();
        const VolumeBuffers& inside =
          cache.Get(renderer, mesh, { 0.1, 0.05, 0.02, 1.0 }, { kind, 1e-4, false }, Attribute);
        EXPECT_FALSE(inside.IsLightOutside());
        EXPECT_GE(inside.GetGreatestDepth(), 1);
        EXPECT_GT(cache.GetUploadedBytes(), 12 * 1000u);
        cache.EndFrame(renderer);
      }
    }
    VolumeCache cache;
    cache.BeginFrame();
    EXPECT_GT(cache.GetMeshDeviation(renderer, mesh), 0.0);
    cache.EndFrame(renderer);
  }
}

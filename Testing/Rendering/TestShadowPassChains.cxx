// The pass in chains of passes, around others and within them, and the state it leaves alone.

#include "ImageChecks.h"
#include "ShadowScene.h"

#include "vtkStencilShadowPass.h"

#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkOutputWindow.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTextureUnitManager.h>

#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

std::map<std::string, std::vector<int>> QueryState()
{
  static const std::vector<std::pair<const char*, GLenum>> switches = { { "blend", GL_BLEND },
    { "cull face", GL_CULL_FACE }, { "depth test", GL_DEPTH_TEST },
    { "scissor test", GL_SCISSOR_TEST }, { "stencil test", GL_STENCIL_TEST },
    { "offset fill", GL_POLYGON_OFFSET_FILL }, { "depth clamp", GL_DEPTH_CLAMP },
    { "multisample", GL_MULTISAMPLE } };
  static const std::vector<std::pair<const char*, GLenum>> integers = { { "viewport", GL_VIEWPORT },
    { "scissor", GL_SCISSOR_BOX }, { "color mask", GL_COLOR_WRITEMASK },
    { "depth mask", GL_DEPTH_WRITEMASK }, { "depth function", GL_DEPTH_FUNC },
    { "stencil mask", GL_STENCIL_WRITEMASK }, { "stencil function", GL_STENCIL_FUNC },
    { "stencil reference", GL_STENCIL_REF }, { "stencil fail", GL_STENCIL_FAIL },
    { "stencil depth fail", GL_STENCIL_PASS_DEPTH_FAIL },
    { "stencil pass", GL_STENCIL_PASS_DEPTH_PASS },
    { "back depth fail", GL_STENCIL_BACK_PASS_DEPTH_FAIL },
    { "back function", GL_STENCIL_BACK_FUNC }, { "stencil clear", GL_STENCIL_CLEAR_VALUE },
    { "front face", GL_FRONT_FACE }, { "offset factor", GL_POLYGON_OFFSET_FACTOR },
    { "offset units", GL_POLYGON_OFFSET_UNITS }, { "draw buffers", GL_DRAW_FRAMEBUFFER_BINDING },
    { "read buffers", GL_READ_FRAMEBUFFER_BINDING }, { "draw buffer", GL_DRAW_BUFFER },
    { "renderbuffer", GL_RENDERBUFFER_BINDING }, { "active texture", GL_ACTIVE_TEXTURE },
    { "array texture", GL_TEXTURE_BINDING_2D_ARRAY }, { "blend source", GL_BLEND_SRC_RGB },
    { "blend destination", GL_BLEND_DST_RGB },
    { "blend source alpha", GL_BLEND_SRC_ALPHA }, { "blend destination alpha", GL_BLEND_DST_ALPHA },
    { "blend equation", GL_BLEND_EQUATION_RGB }, { "blend equation alpha", GL_BLEND_EQUATION_ALPHA },
    { "depth clear", GL_DEPTH_CLEAR_VALUE },
    { "color clear", GL_COLOR_CLEAR_VALUE }, { "pack alignment", GL_PACK_ALIGNMENT } };
  std::map<std::string, std::vector<int>> state;
  for (const auto& query : switches)
  {
    state[query.first] = { glIsEnabled(query.second) };
  }
  for (const auto& query : integers)
  {
    GLint values[4] = { 0, 0, 0, 0 };
    glGetIntegerv(query.second, values);
    state[query.first] = { values[0], values[1], values[2], values[3] };
  }
  return state;
}

/**
 * Notes OpenGL's state before and after its delegate, and OpenGL's errors.
 */
class ProbePass : public vtkRenderPass
{
public:
  static ProbePass* New();
  vtkTypeMacro(ProbePass, vtkRenderPass)

    void Render(const vtkRenderState* state) override
  {
    while (glGetError() != GL_NO_ERROR)
    {
    }
    if (this->SetOddValues)
    {
      // Values that nobody would leave behind by chance.
      vtkOpenGLState* known =
        vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow())->GetState();
      known->vtkglDepthFunc(GL_NOTEQUAL);
      known->vtkglStencilMask(0x3c);
      known->vtkglStencilFunc(GL_ALWAYS, 5, 0x7e);
      known->vtkglStencilOp(GL_INVERT, GL_INCR, GL_REPLACE);
      known->vtkglEnable(GL_CULL_FACE);
      known->vtkglBlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA, GL_ZERO, GL_SRC_ALPHA);
      known->vtkglBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
      known->vtkglEnable(GL_STENCIL_TEST);
      glFrontFace(GL_CW);
      glPolygonOffset(0.5f, 3.0f);
      glClearStencil(9);
    }
    this->Before = QueryState();
    this->Delegate->Render(state);
    this->Error = glGetError();
    this->After = QueryState();
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  bool SetOddValues = false;
  std::map<std::string, std::vector<int>> Before;
  std::map<std::string, std::vector<int>> After;
  GLenum Error = GL_NO_ERROR;
};
vtkStandardNewMacro(ProbePass);

/**
 * Counts what VTK has to say.
 */
class CountingOutput : public vtkOutputWindow
{
public:
  static CountingOutput* New();
  vtkTypeMacro(CountingOutput, vtkOutputWindow)

    void DisplayText(const char* text) override
  {
    this->First = this->Lines++ == 0 ? text : this->First;
  }

  int Lines = 0;
  std::string First;
};
vtkStandardNewMacro(CountingOutput);

/**
 * Lights and opaque geometry, without a camera pass.
 */
vtkSmartPointer<vtkRenderPass> MakeSteps()
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(passes);
  return sequence;
}

vtkSmartPointer<vtkCameraPass> MakeCamera(vtkRenderPass* delegate)
{
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(delegate);
  return camera;
}
}

namespace
{
void expectStateIsLeftAlone(vtkPolyData* caster)
{
  Scene scene;
  scene.Add(caster);
  scene.AddLight(PointLight);
  vtkNew<ProbePass> inner;
  inner->Delegate = MakeSteps();
  vtkNew<ProbePass> outer;
  outer->SetOddValues = true;
  scene.Pass->SetDelegatePass(inner);
  vtkSmartPointer<vtkCameraPass> camera = MakeCamera(outer);
  scene.Renderer->SetPass(camera);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);

  // Without the pass first: what the mappers themselves leave behind is not the pass's.
  outer->Delegate = inner;
  window->Render();
  window->Render();
  const auto before = outer->Before;
  const auto after = outer->After;
  EXPECT_EQ(outer->Error, static_cast<GLenum>(GL_NO_ERROR));
  ASSERT_EQ(before.at("viewport"), (std::vector<int>{ 0, 0, 200, 150 }));

  outer->Delegate = scene.Pass;
  for (int frame = 0; frame < 3; ++frame)
  {
    window->Render();
    EXPECT_EQ(outer->Error, static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_FALSE(
      vtkOpenGLRenderWindow::SafeDownCast(window)->GetState()->GetTextureUnitManager()->IsAllocated(
        0));
    for (auto entry : before)
    {
      // While the delegate draws, the masks are bound to the unit that was free.
      if (entry.first == "array texture")
      {
        entry.second = inner->Before.at(entry.first);
      }
      EXPECT_EQ(inner->Before.at(entry.first), entry.second) << "shading: " << entry.first;
      EXPECT_EQ(outer->After.at(entry.first), after.at(entry.first)) << "after: " << entry.first;
    }
  }
  EXPECT_GT(before.size(), 30u);
}
}

TEST(StencilShadowPass, StateIsLeftAlone)
{
  expectStateIsLeftAlone(FloatingBox());
}

// More shadow volumes than a stencil counts: blending counts them.
TEST(StencilShadowPass, StateIsLeftAloneByCountsInFloats)
{
  const std::vector<Mesh> sheets(200, moved(ground(0.0, 0.4), 1.0, { 0.0, 0.0, 1.0 }));
  expectStateIsLeftAlone(merged(sheets));
}

TEST(StencilShadowPass, ChainsOfPasses)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image direct = Grab(window);

  // With a camera pass around, and with the delegate that the pass makes itself.
  vtkSmartPointer<vtkCameraPass> camera = MakeCamera(scene.Pass);
  scene.Renderer->SetPass(camera);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);
  scene.Pass->SetDelegatePass(MakeSteps());
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);

  // Camera inside.
  scene.Pass->SetDelegatePass(MakeCamera(MakeSteps()));
  scene.Renderer->SetPass(scene.Pass);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);

  // Supersampled, all three ways: the same picture but for edges. With the supersampling around
  // they become smooth; within, the mask keeps the window's size.
  for (const char* way : { "around", "around the camera", "within" })
  {
    SCOPED_TRACE(way);
    const bool within = std::string(way) == "within";
    vtkNew<vtkSSAAPass> supersampling;
    if (within)
    {
      supersampling->SetDelegatePass(MakeCamera(MakeSteps()));
      scene.Pass->SetDelegatePass(supersampling);
      scene.Renderer->SetPass(scene.Pass);
    }
    else
    {
      const bool bare = std::string(way) == "around";
      scene.Pass->SetDelegatePass(bare ? nullptr : MakeSteps().Get());
      supersampling->SetDelegatePass(
        bare ? static_cast<vtkRenderPass*>(scene.Pass) : static_cast<vtkRenderPass*>(camera));
      scene.Renderer->SetPass(supersampling);
    }
    window->Render();
    const Image smooth = Grab(window);
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    if (within)
    {
      EXPECT_EQ(mask->GetDimensions()[0], 200);
    }
    else
    {
      EXPECT_GT(mask->GetDimensions()[0], 300);
    }
    EXPECT_GT(blackFraction(mask), 0.05);
    long unlike = 0;
    long between = 0;
    for (int y = 2; y < 148; ++y)
    {
      for (int x = 2; x < 198; ++x)
      {
        int lowest = 255;
        int highest = 0;
        for (int i = 0; i < 25; ++i)
        {
          const int value = Byte(direct, x + i % 5 - 2, y + i / 5 - 2);
          lowest = std::min(lowest, value);
          highest = std::max(highest, value);
        }
        const int value = Byte(smooth, x, y);
        // vtkSSAAPass overshoots a little: its filter has negative weights.
        unlike += value < lowest - 10 || value > highest + 10;
        between += value > lowest + 20 && value < highest - 20;
      }
    }
    EXPECT_EQ(unlike, 0);
    EXPECT_GT(between, 200);
    scene.Renderer->SetPass(nullptr);
  }
}

TEST(StencilShadowPass, AmbientOcclusionAroundAndWithin)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(0.5);
  vtkNew<vtkRenderStepsPass> steps;
  occlusion->SetDelegatePass(steps);
  scene.Renderer->SetPass(occlusion);
  window->Render();
  const Image lit = Grab(window);
  const double intensity = light->GetIntensity();
  light->SetIntensity(0.0);
  window->Render();
  const Image unlit = Grab(window);
  light->SetIntensity(intensity);
  occlusion->ReleaseGraphicsResources(window);

  for (const bool within : { true, false })
  {
    SCOPED_TRACE(within ? "within" : "around");
    vtkNew<vtkSSAOPass> another;
    another->SetRadius(0.5);
    another->SetDelegatePass(within ? static_cast<vtkRenderPass*>(steps) : scene.Pass);
    scene.Pass->SetDelegatePass(within ? another.Get() : nullptr);
    scene.Renderer->SetPass(within ? static_cast<vtkRenderPass*>(scene.Pass) : another);
    vtkNew<CountingOutput> output;
    vtkOutputWindow::SetInstance(output);
    window->Render();
    const int references[2] = { scene.Pass->GetReferenceCount(), another->GetReferenceCount() };
    window->Render();
    vtkOutputWindow::SetInstance(nullptr);
    EXPECT_EQ(scene.Pass->GetReferenceCount(), references[0]);
    EXPECT_EQ(another->GetReferenceCount(), references[1]);
    EXPECT_EQ(output->Lines, 0) << output->First;
    const Image picture = Grab(window);
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_GT(blackFraction(mask), 0.05);
    long wrong = 0;
    for (int y = 0; y < 150; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        wrong += std::abs(Byte(picture, x, y) -
                   Byte(Byte(mask, x, y) ? lit.Get() : unlit.Get(), x, y)) > 1;
      }
    }
    EXPECT_EQ(wrong, 0);
    // vtkSSAOPass does not free its textures by itself.
    another->ReleaseGraphicsResources(window);
    scene.Renderer->SetPass(nullptr);
  }
}

// The pass against analytic ray-box tests, against the ray cast, and against VTK's own pictures
// without it: where a mask is 255 a picture must be as without the pass, and where it is 0 as with
// that light's intensity at 0.

#include "AnalyticShadow.h"
#include "ImageChecks.h"
#include "MaskComparison.h"
#include "RayCast.h"
#include "TestMeshes.h"

#include "vtkOffscreenWindows.h"
#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTextureUnitManager.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{
using namespace shadowtest;

using Image = vtkSmartPointer<vtkImageData>;

vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  // Without a name: the kind of window that this executable was made for.
  auto window = vtkSmartPointer<vtkRenderWindow>::Take(
    vtkOffscreenWindows::NewWindow(std::getenv("SMOOTHSHADOW_WINDOW")));
  if (!window)
  {
    throw std::runtime_error(vtkOffscreenWindows::GetLastReason());
  }
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

Image Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}

unsigned char Byte(vtkImageData* image, int x, int y, int component = 0)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[component];
}

long Differences(vtkImageData* a, vtkImageData* b)
{
  return compareImages(a, b).Pixels;
}

/**
 * A renderer over the ground z = 0, |x|, |y| <= 4, seen from above, with nothing on it yet.
 */
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkStencilShadowPass> Pass;
  Mesh GroundMesh = ground(0.0, 4.0, 3);
  vtkSmartPointer<vtkActor> Ground;

  Scene()
  {
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Pass->SetKindToDiscrete();
    this->Ground = this->Add(this->GroundMesh);
    this->Look(-3.0, -6.0, 5.0);
  }

  vtkSmartPointer<vtkActor> Add(vtkPolyData* mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(1.0, 0.9, 0.8);
    actor->GetProperty()->SetAmbient(0.125);
    actor->GetProperty()->SetDiffuse(0.75);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkSmartPointer<vtkLight> AddLight(const RayLight& position, double intensity = 1.0)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToSceneLight();
    light->SetPositional(position[3] != 0.0);
    light->SetConeAngle(180.0);
    light->SetPosition(position[0], position[1], position[2]);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(intensity);
    this->Renderer->AddLight(light);
    return light;
  }

  vtkSmartPointer<vtkLight> AddHeadlight(double intensity)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToHeadlight();
    light->SetIntensity(intensity);
    this->Renderer->AddLight(light);
    return light;
  }

  void Look(double x, double y, double z)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, y, z);
    camera->SetFocalPoint(0.0, 0.0, 0.5);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(0.5, 40.0);
  }

  Image Mask(vtkLight* light) { return Image::Take(this->Pass->GetMask(light)); }
};

RayView ViewOf(vtkRenderer* renderer, vtkImageData* mask)
{
  return RayView::fromCamera(
    renderer->GetActiveCamera(), mask->GetDimensions()[0], mask->GetDimensions()[1]);
}

/**
 * No pixel of the mask wrong beyond one pixel of a true edge, and some shadow at all.
 */
void ExpectMask(Scene& scene, vtkLight* light, const RayLight& position,
  const std::vector<RayObject>& objects, const char* what)
{
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask) << what;
  const MaskComparison comparison =
    compareMask(RayScene(objects), ViewOf(scene.Renderer, mask), position, mask);
  EXPECT_EQ(comparison.total().WrongBeyond, 0) << what << "\n" << comparison.describe();
  EXPECT_GT(comparison.total().Shadowed, 200) << what << "\n" << comparison.describe();
}

const RayLight PointLight = { 1.5, 1.0, 4.0, 1.0 };
const RayLight DirectionalLight = { 2.0, 1.0, 4.0, 0.0 };

//------------------------------------------------------------------------------------------------
// An oracle by hand: the ground and an axis-aligned box.

struct BoxOracle
{
  Vec3 Lower{ -0.5, -0.5, 0.5 };
  Vec3 Upper{ 0.5, 0.5, 1.3 };

  enum Seen
  {
    Background,
    GroundLit,
    GroundDark,
    Box
  };

  /// Entry of a ray into the box, as a multiple of its direction; negative if it misses.
  double Enter(const Vec3& origin, const Vec3& direction) const
  {
    double enter = 0.0;
    double leave = 1e300;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double a = (this->Lower[i] - origin[i]) / direction[i];
      const double b = (this->Upper[i] - origin[i]) / direction[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? enter : -1.0;
  }

  Seen Look(const RayView& view, double x, double y, const RayLight& light, Vec3& ground) const
  {
    Vec3 ends[2];
    for (int end = 0; end < 2; ++end)
    {
      const double clip[4] = { 2.0 * x / view.Width - 1.0, 2.0 * y / view.Height - 1.0,
        end == 0 ? -1.0 : 1.0, 1.0 };
      double world[4];
      vtkMatrix4x4::MultiplyPoint(view.ClipToWorld, clip, world);
      ends[end] = { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
    }
    const Vec3 direction = ends[1] - ends[0];
    const double toBox = this->Enter(ends[0], direction);
    const double toGround = -ends[0][2] / direction[2];
    ground = ends[0] + toGround * direction;
    const bool onGround =
      toGround > 0.0 && std::abs(ground[0]) <= 4.0 && std::abs(ground[1]) <= 4.0;
    if (toBox >= 0.0 && (!onGround || toBox < toGround))
    {
      return Box;
    }
    if (!onGround)
    {
      return Background;
    }
    const Vec3 place = { light[0], light[1], light[2] };
    const Vec3 toLight = light[3] == 0.0 ? place : place - ground;
    return this->Enter(ground, toLight) >= 0.0 ? GroundDark : GroundLit;
  }
};

/**
 * Checks the mask and the shaded colour of ground and background pixels that are farther than one
 * pixel from every edge.
 */
void CheckBox(const RayLight& light)
{
  SCOPED_TRACE(light[3] == 0.0 ? "directional" : "point");
  const BoxOracle oracle;
  Scene scene;
  scene.Add(moved(box(0.5, 0.5, 0.4), 1.0, { 0.0, 0.0, 0.9 }));
  vtkSmartPointer<vtkLight> vtk = scene.AddLight(light);
  auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image mask = scene.Mask(vtk);
  ASSERT_TRUE(mask);
  const Image picture = Grab(window);
  const RayView view = ViewOf(scene.Renderer, mask);
  const double color[3] = { 1.0, 0.9, 0.8 };

  long seen[4] = { 0, 0, 0, 0 };
  long wrongMask = 0;
  long wrongColor = 0;
  for (int y = 0; y < view.Height; ++y)
  {
    for (int x = 0; x < view.Width; ++x)
    {
      Vec3 ground;
      const auto here = oracle.Look(view, x + 0.5, y + 0.5, light, ground);
      bool edge = false;
      for (int i = 0; i < 81 && !edge; ++i)
      {
        Vec3 unused;
        edge = here !=
          oracle.Look(
            view, x + 0.5 + (i % 9 - 4) / 4.0, y + 0.5 + (i / 9 - 4) / 4.0, light, unused);
      }
      if (edge || here == BoxOracle::Box)
      {
        continue;
      }
      ++seen[here];
      wrongMask += Byte(mask, x, y) != (here == BoxOracle::GroundDark ? 0 : 255);
      if (here != BoxOracle::Background)
      {
        const Vec3 place = { light[0], light[1], light[2] };
        const Vec3 toLight = normalized(light[3] == 0.0 ? place : place - ground);
        const double lit = here == BoxOracle::GroundLit ? 0.75 * toLight[2] : 0.0;
        for (int i = 0; i < 3; ++i)
        {
          const double expected = 255.0 * color[i] * (0.125 + lit);
          wrongColor += std::abs(Byte(picture, x, y, i) - expected) > 2.0;
        }
      }
    }
  }
  EXPECT_EQ(wrongMask, 0);
  EXPECT_EQ(wrongColor, 0);
  EXPECT_GT(seen[BoxOracle::Background], 1000);
  EXPECT_GT(seen[BoxOracle::GroundLit], 10000);
  EXPECT_GT(seen[BoxOracle::GroundDark], 1000);
}

//------------------------------------------------------------------------------------------------
// The picture must be composed of those without the pass.

/**
 * `light` is the only casting light. Exact: a light times 1 or 0 rounds nothing.
 */
void ExpectComposed(Scene& scene, vtkLight* light, const char* what)
{
  SCOPED_TRACE(what);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image picture = Grab(window);
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask);

  scene.Renderer->SetPass(nullptr);
  window->Render();
  const Image lit = Grab(window);
  const double intensity = light->GetIntensity();
  light->SetIntensity(0.0);
  window->Render();
  const Image unlit = Grab(window);
  light->SetIntensity(intensity);
  scene.Renderer->SetPass(scene.Pass);

  EXPECT_GT(blackFraction(mask), 0.02);
  long wrong = 0;
  long changed = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      vtkImageData* expected = Byte(mask, x, y) ? lit.Get() : unlit.Get();
      bool same = true;
      for (int i = 0; i < 3; ++i)
      {
        same = same && Byte(picture, x, y, i) == Byte(expected, x, y, i);
        changed += Byte(lit, x, y, i) > Byte(unlit, x, y, i) + 20;
      }
      wrong += !same;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(changed, 5000);
}

//------------------------------------------------------------------------------------------------
// State.

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
    { "blend destination", GL_BLEND_DST_RGB }, { "depth clear", GL_DEPTH_CLEAR_VALUE },
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

void SetKey(vtkProp* prop, vtkInformationIntegerKey* key, int value)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  if (!keys)
  {
    vtkNew<vtkInformation> made;
    prop->SetPropertyKeys(made);
    keys = made;
  }
  keys->Set(key, value);
}

Mesh FloatingBox()
{
  return moved(box(0.5, 0.4, 0.3), 1.0, { 0.0, 0.0, 1.0 }, 7);
}
}

//------------------------------------------------------------------------------------------------
TEST(StencilShadowPass, BoxOverPlaneAgainstRayBoxTest)
{
  CheckBox(PointLight);
  CheckBox(DirectionalLight);
}

TEST(StencilShadowPass, CurvedAndConcaveCastersAgainstRayCast)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh ring = moved(torus(24, 12), 0.8, { 0.0, 0.0, 1.3 }, 3);
    const Mesh ball = moved(sphere(10, 20), 0.4, { 1.2, 0.6, 2.2 });
    const Mesh quads = moved(quadBox(), 0.3, { -1.5, -1.0, 0.8 }, 5);
    scene.Add(ring);
    scene.Add(ball);
    scene.Add(quads);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(320, 240);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { ring }, { ball }, { quads } },
      position[3] == 0.0 ? "directional" : "point");
  }
}

TEST(StencilShadowPass, OpenAndTangledMeshes)
{
  // A bowl, a sheet with a fin on it (three faces at an edge), and a ball with some faces turned
  // over: each triangle throws its shadow, whatever is next to it.
  const Mesh ball = sphere(10, 20);
  MeshBuilder bowl;
  MeshBuilder tangled;
  bowl.append(withoutNormals(ball));
  tangled.append(withoutNormals(ball));
  bowl.Cells.resize(bowl.Cells.size() / 2);
  for (std::size_t i = 0; i < tangled.Cells.size(); i += 3)
  {
    std::swap(tangled.Cells[i][0], tangled.Cells[i][1]);
  }
  MeshBuilder fin;
  for (const Vec3& point :
    std::vector<Vec3>{ { 0, -1, 0 }, { 0, 1, 0 }, { 1, 0, 0.3 }, { -1, 0, 0.2 }, { 0.3, 0, 1 } })
  {
    fin.addPoint(point);
  }
  fin.addTriangle(0, 1, 2);
  fin.addTriangle(0, 1, 3);
  fin.addTriangle(0, 1, 4);

  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    std::vector<RayObject> objects = { { scene.GroundMesh } };
    objects.push_back({ moved(bowl.build(), 0.6, { 1.2, 0.0, 1.2 }, 5) });
    objects.push_back({ moved(tangled.build(), 0.5, { -1.2, 0.3, 1.0 }) });
    objects.push_back({ moved(fin.build(), 0.7, { 0.0, -1.3, 1.0 }, 9) });
    for (std::size_t i = 1; i < objects.size(); ++i)
    {
      scene.Add(objects[i].Surface);
    }
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(320, 240);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, objects, position[3] == 0.0 ? "directional" : "point");
  }
}

TEST(StencilShadowPass, DarkSideIsInItsOwnShadow)
{
  // Interpolated normals light faces that are turned away, so the mask must not.
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh mesh = moved(sphere(10, 20), 0.8, { 0.0, 0.0, 1.2 });
    scene.Add(mesh);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    for (const auto& eye : std::vector<Vec3>{ { -3, -6, 5 }, { -5, -4, 1 }, { 2, -6, 3 } })
    {
      scene.Look(eye[0], eye[1], eye[2]);
      auto window = MakeWindow(320, 240);
      window->AddRenderer(scene.Renderer);
      window->Render();
      const Image mask = scene.Mask(light);
      ASSERT_TRUE(mask);
      const MaskComparison comparison = compareMask(RayScene({ { scene.GroundMesh }, { mesh } }),
        ViewOf(scene.Renderer, mask), position, mask, TurnedAwayPixels::Shadow);
      EXPECT_EQ(comparison.total().WrongBeyond, 0) << comparison.describe();
      EXPECT_GT(comparison.Objects[1].Shadowed, 500) << comparison.describe();
    }
  }
}

TEST(StencilShadowPass, SmoothShadowOfCoarseSphere)
{
  const double radius = 0.8;
  const Vec3 middle = { 0.0, 0.0, 1.2 };
  const double axes[3] = { radius, radius, radius };
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    scene.Add(moved(icosphere(1), radius, middle));
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(400, 300);
    window->AddRenderer(scene.Renderer);

    // Wrong pixels on the ground beyond one pixel of the sphere's true shadow.
    const auto count = [&]() {
      window->Render();
      const Image mask = scene.Mask(light);
      const RayView view = ViewOf(scene.Renderer, mask);
      const RayScene rays({ { scene.GroundMesh }, { moved(sphere(60, 120), radius, middle) } });
      const auto hidden = [&](double x, double y, bool& onGround) {
        const RaySample sample = rays.look(view, x, y, position);
        onGround = sample.Object == 0;
        RayLight moved = position;
        for (std::size_t i = 0; i < 3; ++i)
        {
          moved[i] -= position[3] * middle[i];
        }
        return onGround && ellipsoidHides(axes, sample.Point - middle, moved);
      };
      long wrong = 0;
      long dark = 0;
      for (int y = 0; y < view.Height; ++y)
      {
        for (int x = 0; x < view.Width; ++x)
        {
          bool onGround;
          const bool here = hidden(x + 0.5, y + 0.5, onGround);
          dark += here;
          if (!onGround || here == (Byte(mask, x, y) == 0))
          {
            continue;
          }
          bool edge = false;
          for (int i = 0; i < 81 && !edge; ++i)
          {
            bool groundThere;
            const bool there =
              hidden(x + 0.5 + (i % 9 - 4) / 4.0, y + 0.5 + (i / 9 - 4) / 4.0, groundThere);
            edge = there != here || !groundThere;
          }
          wrong += !edge;
        }
      }
      EXPECT_GT(dark, 2000);
      return wrong;
    };
    scene.Pass->SetKindToSmooth();
    EXPECT_EQ(count(), 0);
    scene.Pass->SetKindToDiscrete();
    EXPECT_GT(count(), 50);
  }
}

TEST(StencilShadowPass, FarFromTheOrigin)
{
  const Vec3 shift = { 3e6, -2e6, 1e6 };
  Scene scene;
  scene.Renderer->RemoveAllViewProps();
  const Mesh mesh = moved(FloatingBox(), 1.0, shift);
  const Mesh plane = moved(ground(0.0, 4.0, 3), 1.0, shift);
  for (vtkPolyData* part : { mesh.Get(), plane.Get() })
  {
    // Otherwise VTK itself draws the mesh with what precision floats have there.
    vtkActor* actor = scene.Add(part);
    vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
      ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(shift[0] - 3.0, shift[1] - 6.0, shift[2] + 5.0);
  camera->SetFocalPoint(shift[0], shift[1], shift[2] + 0.5);
  const RayLight position = { shift[0] + 1.5, shift[1] + 1.0, shift[2] + 4.0, 1.0 };
  vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  auto window = MakeWindow(320, 240);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, position, { { plane }, { mesh } }, "far away");
}

TEST(StencilShadowPass, ManyLightsEachItsMask)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  // Two layers of masks; a headlight and one that is off lie between, so that numbers of lights,
  // of lights that are on, and of masks all differ.
  const std::vector<RayLight> positions = { { 1.5, 1.0, 4.0, 1.0 }, { 2.0, 1.0, 4.0, 0.0 },
    { -2.0, 1.0, 3.0, 1.0 }, { 0.5, -2.0, 4.0, 0.0 }, { 0.1, 2.5, 3.0, 1.0 },
    { -1.0, 0.4, 5.0, 0.0 } };
  std::vector<vtkSmartPointer<vtkLight>> lights;
  vtkSmartPointer<vtkLight> headlight;
  for (const RayLight& position : positions)
  {
    lights.push_back(scene.AddLight(position, 0.03 + 0.03 * static_cast<double>(lights.size())));
    lights.back()->SetDiffuseColor(1.0, 0.2 * static_cast<double>(lights.size()) - 0.2, 0.5);
    if (lights.size() == 1)
    {
      scene.AddLight({ 0.0, 0.0, 3.0, 1.0 })->SwitchOff();
    }
    if (lights.size() == 3)
    {
      headlight = scene.AddHeadlight(0.05);
    }
  }
  auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  window->Render();

  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    ExpectMask(scene, lights[i], positions[i], { { scene.GroundMesh }, { mesh } },
      ("light " + std::to_string(i)).c_str());
  }
  EXPECT_EQ(scene.Pass->GetMask(headlight), nullptr);
  EXPECT_FALSE(scene.Pass->GetLightCasts(headlight));

  // On the ground the colour is the sum over lights of mask times Lambert.
  const Image picture = Grab(window);
  std::vector<Image> masks;
  for (const auto& light : lights)
  {
    masks.push_back(scene.Mask(light));
  }
  const RayView view = ViewOf(scene.Renderer, picture);
  const RayScene rays({ { scene.GroundMesh }, { mesh } });
  double camera[3];
  scene.Renderer->GetActiveCamera()->GetPosition(camera);
  double axis[3];
  scene.Renderer->GetActiveCamera()->GetDirectionOfProjection(axis);
  const double color[3] = { 1.0, 0.9, 0.8 };
  long checked = 0;
  long wrong = 0;
  for (int y = 0; y < view.Height; y += 2)
  {
    for (int x = 0; x < view.Width; x += 2)
    {
      const RaySample sample = rays.look(view, x + 0.5, y + 0.5, positions[0]);
      if (sample.Object != 0)
      {
        continue;
      }
      double light[3] = { -axis[2] * 0.05, -axis[2] * 0.05, -axis[2] * 0.05 };
      for (std::size_t i = 0; i < lights.size(); ++i)
      {
        const RayLight& p = positions[i];
        const Vec3 place = { p[0], p[1], p[2] };
        const Vec3 toLight = normalized(p[3] == 0.0 ? place : place - sample.Point);
        for (int c = 0; c < 3; ++c)
        {
          light[c] += Byte(masks[i], x, y) / 255.0 * toLight[2] * lights[i]->GetIntensity() *
            lights[i]->GetDiffuseColor()[c];
        }
      }
      ++checked;
      for (int c = 0; c < 3; ++c)
      {
        wrong +=
          std::abs(Byte(picture, x, y, c) - 255.0 * color[c] * (0.125 + 0.75 * light[c])) > 1.5;
      }
    }
  }
  EXPECT_GT(checked, 8000);
  EXPECT_EQ(wrong, 0);
}

TEST(StencilShadowPass, ShadingIsTheMappersOwn)
{
  struct Case
  {
    const char* Name;
    RayLight Light;
    bool Headlight;
    std::function<void(vtkActor*, vtkPolyData*)> Prepare;
  };
  const auto none = [](vtkActor*, vtkPolyData*) {};
  const auto shiny = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetSpecular(0.5);
    actor->GetProperty()->SetSpecularPower(8.0);
  };
  const auto physical = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetMetallic(0.3);
    actor->GetProperty()->SetRoughness(0.4);
  };
  const auto flat = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetInterpolationToFlat();
  };
  const auto colored = [](vtkActor*, vtkPolyData* mesh) {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    colors->SetName("Colors");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      colors->InsertNextTuple3(
        static_cast<double>(60 + 37 * i % 190), 200.0, static_cast<double>(255 - 53 * i % 200));
    }
    mesh->GetPointData()->SetScalars(colors);
  };
  for (const Case& test : std::vector<Case>{ { "point", PointLight, false, none },
         { "direction", DirectionalLight, false, none },
         { "point and headlight", PointLight, true, shiny },
         { "direction and headlight", DirectionalLight, true, shiny },
         { "flat", PointLight, false, flat }, { "colours", PointLight, false, colored },
         { "PBR point", PointLight, false, physical },
         { "PBR direction", DirectionalLight, false, physical },
         { "PBR and headlight", PointLight, true, physical } })
  {
    Scene scene;
    const Mesh mesh = moved(sphere(12, 24), 0.7, { 0.0, 0.0, 1.1 });
    vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
    test.Prepare(caster, mesh);
    test.Prepare(scene.Ground, scene.GroundMesh);
    if (test.Headlight)
    {
      scene.AddHeadlight(0.3);
    }
    vtkSmartPointer<vtkLight> light = scene.AddLight(test.Light);
    ExpectComposed(scene, light, test.Name);
  }
}

TEST(StencilShadowPass, SpotConeLimitsLightOnly)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  light->SetConeAngle(25.0);
  ExpectComposed(scene, light, "cone");
}

TEST(StencilShadowPass, EyeInShadow)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh roof = moved(box(2.0, 2.0, 0.05), 1.0, { 0.0, 0.0, 1.5 });
    scene.Add(roof);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    scene.Look(0.3, 0.2, 0.9);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(-2.0, -3.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetClippingRange(0.01, 20.0);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { roof } }, "under a roof");
    const double dark = blackFraction(scene.Mask(light));
    EXPECT_GT(dark, 0.1);
    EXPECT_LT(dark, 0.95);
  }
}

TEST(StencilShadowPass, NearAndFarPlaneThroughVolume)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(DirectionalLight);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  // Behind the caster and within reach of its shadow: the near plane cuts the walls, and the far
  // plane lies just behind what is seen.
  camera->SetPosition(-1.0, -0.3, 0.6);
  camera->SetFocalPoint(-0.4, 0.3, 0.0);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  for (const double nearest : { 0.05, 0.3, 0.5, 0.6 })
  {
    camera->SetClippingRange(nearest, 6.0);
    window->Render();
    const Image mask = scene.Mask(light);
    // The oracle looks from the near plane on, so it does not see what that plane cuts away.
    ExpectMask(scene, light, DirectionalLight, { { scene.GroundMesh }, { mesh } }, "near plane");
  }
}

TEST(StencilShadowPass, ParallelProjection)
{
  for (const RayLight& position : { PointLight, DirectionalLight, RayLight{ 3.0, 6.0, 4.5, 0.0 } })
  {
    // The last of them shines straight at the eye.
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(2.5);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "parallel");
  }
}

TEST(StencilShadowPass, Keys)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image shadowed = Grab(window);
  const Image mask = scene.Mask(light);
  EXPECT_GT(blackFraction(mask), 0.05);

  scene.Renderer->SetPass(nullptr);
  window->Render();
  const Image plain = Grab(window);
  scene.Renderer->SetPass(scene.Pass);
  EXPECT_GT(Differences(shadowed, plain), 1000);

  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
  EXPECT_EQ(Differences(Grab(window), plain), 0);

  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 1);
  SetKey(caster, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  SetKey(scene.Ground, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(Differences(scene.Mask(light), mask), 0);
  EXPECT_EQ(Differences(Grab(window), plain), 0);

  SetKey(caster, vtkStencilShadowPass::RECEIVES_SHADOW(), 1);
  SetKey(scene.Ground, vtkStencilShadowPass::RECEIVES_SHADOW(), 1);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), shadowed), 0);

  scene.Pass->SetLightCasts(light, false);
  EXPECT_FALSE(scene.Pass->GetLightCasts(light));
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
  scene.Pass->SetLightCasts(light, true);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), shadowed), 0);
}

TEST(StencilShadowPass, PropsThatShareTheirKeys)
{
  Scene scene;
  vtkSmartPointer<vtkActor> caster = scene.Add(FloatingBox());
  scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image picture = Grab(window);

  vtkNew<vtkInformation> keys;
  caster->SetPropertyKeys(keys);
  scene.Ground->SetPropertyKeys(keys);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), picture), 0);
  const int references = scene.Pass->GetReferenceCount();
  window->Render();
  EXPECT_EQ(scene.Pass->GetReferenceCount(), references);
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_GT(Differences(Grab(window), picture), 1000);
}

TEST(StencilShadowPass, TransformedActors)
{
  struct Case
  {
    const char* Name;
    std::function<void(vtkTransform*)> Apply;
  };
  for (const Case& test :
    std::vector<Case>{ { "translated", [](vtkTransform* t) { t->Translate(0.7, -0.4, 0.3); } },
      { "rotated", [](vtkTransform* t) { t->RotateWXYZ(50.0, 1.0, 2.0, 3.0); } },
      { "scaled",
        [](vtkTransform* t) {
          t->RotateX(20.0);
          t->Scale(1.6, 0.5, 0.9);
          t->RotateY(35.0);
        } },
      { "mirrored", [](vtkTransform* t) { t->Scale(-1.3, 0.8, 1.0); } } })
  {
    for (const RayLight& position : { PointLight, DirectionalLight })
    {
      Scene scene;
      const Mesh mesh = moved(torus(20, 10), 0.6, { 0.0, 0.0, 0.0 }, 3);
      vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
      // Its shadow overlaps: volumes of opposite orientation would cancel out.
      const Mesh other = moved(box(), 0.4, { 0.3, 0.2, 2.1 }, 5);
      scene.Add(other);
      vtkNew<vtkTransform> transform;
      transform->Translate(0.0, 0.0, 1.3);
      test.Apply(transform);
      caster->SetUserTransform(transform);
      vtkSmartPointer<vtkLight> light = scene.AddLight(position);
      auto window = MakeWindow(240, 180);
      window->AddRenderer(scene.Renderer);
      window->Render();
      ExpectMask(scene, light, position,
        { { scene.GroundMesh }, { mesh, caster->GetMatrix() }, { other } }, test.Name);
    }
  }
}

TEST(StencilShadowPass, PartsOfAssemblies)
{
  Scene scene;
  const Mesh mesh = moved(box(), 0.3, { 0.0, 0.0, 0.0 }, 5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> left;
  left->SetMapper(mapper);
  left->SetPosition(-0.8, 0.0, 0.0);
  vtkNew<vtkActor> right;
  right->SetMapper(mapper);
  right->SetPosition(0.8, 0.0, 0.0);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(left);
  assembly->AddPart(right);
  assembly->SetPosition(0.0, 0.0, 1.2);
  assembly->RotateZ(40.0);
  scene.Renderer->AddActor(assembly);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();

  vtkNew<vtkMatrix4x4> leftMatrix;
  vtkNew<vtkMatrix4x4> rightMatrix;
  vtkMatrix4x4::Multiply4x4(assembly->GetMatrix(), left->GetMatrix(), leftMatrix);
  vtkMatrix4x4::Multiply4x4(assembly->GetMatrix(), right->GetMatrix(), rightMatrix);
  ExpectMask(scene, light, PointLight,
    { { scene.GroundMesh }, { mesh, leftMatrix }, { mesh, rightMatrix } }, "assembly");

  SetKey(assembly, vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
  const Image plain = Grab(window);

  // The ground as a part of another assembly, which at first receives.
  SetKey(assembly, vtkStencilShadowPass::CASTS_SHADOW(), 1);
  scene.Renderer->RemoveActor(scene.Ground);
  vtkNew<vtkAssembly> base;
  base->AddPart(scene.Ground);
  scene.Renderer->AddActor(base);
  window->Render();
  EXPECT_GT(Differences(Grab(window), plain), 1000);
  SetKey(base, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  SetKey(assembly, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  window->Render();
  EXPECT_GT(blackFraction(scene.Mask(light)), 0.02);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
}

TEST(StencilShadowPass, CasterOutOfViewAndLightInView)
{
  Scene scene;
  const Mesh mesh = moved(box(), 0.4, { 1.6, 1.2, 3.2 }, 5);
  scene.Add(mesh);
  const RayLight position = { 2.6, 2.0, 5.0, 1.0 };
  vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.5, 3.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "out of view");

  camera->SetPosition(-3.0, -2.0, 3.0);
  camera->SetFocalPoint(1.6, 1.2, 2.6);
  camera->SetViewAngle(80.0);
  scene.Renderer->SetWorldPoint(position.data());
  scene.Renderer->WorldToView();
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[0]), 1.0);
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[1]), 1.0);
  window->Render();
  ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "light in view");
}

TEST(StencilShadowPass, TranslucentActorsNeitherCastNorDarken)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image mask = scene.Mask(light);

  // Over the shadow, as the eye sees it.
  vtkSmartPointer<vtkActor> pane = scene.Add(moved(ground(0.0, 1.0), 1.0, { -0.8, -1.0, 1.0 }));
  pane->GetProperty()->SetOpacity(0.5);
  window->Render();
  EXPECT_EQ(Differences(scene.Mask(light), mask), 0);
  const Image picture = Grab(window);
  SetKey(pane, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), picture), 0);
  pane->VisibilityOff();
  window->Render();
  EXPECT_GT(Differences(Grab(window), picture), 1000);
}

TEST(StencilShadowPass, NotSquareWindows)
{
  for (const auto& size :
    std::vector<std::array<int, 2>>{ { 240, 240 }, { 400, 150 }, { 130, 301 } })
  {
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
    auto window = MakeWindow(size[0], size[1]);
    window->AddRenderer(scene.Renderer);
    window->Render();
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->GetDimensions()[0], size[0]);
    EXPECT_EQ(mask->GetDimensions()[1], size[1]);
    ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, "window");
  }
}

TEST(StencilShadowPass, SeveralRenderersAsInWindowsOfTheirOwn)
{
  Scene left;
  left.Add(FloatingBox());
  left.AddLight(PointLight);
  Scene right;
  right.Add(moved(torus(20, 10), 0.6, { 0.0, 0.0, 1.2 }, 3));
  right.AddLight(DirectionalLight);
  right.Look(4.0, -5.0, 4.0);

  std::vector<Image> alone;
  for (Scene* scene : { &left, &right })
  {
    auto window = MakeWindow(150, 120);
    window->AddRenderer(scene->Renderer);
    window->Render();
    alone.push_back(Grab(window));
    window->RemoveRenderer(scene->Renderer);
  }

  auto window = MakeWindow(300, 200);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 0.6);
  right.Renderer->SetViewport(0.5, 0.4, 1.0, 1.0);
  window->AddRenderer(left.Renderer);
  window->AddRenderer(right.Renderer);
  for (int frame = 0; frame < 2; ++frame)
  {
    window->Render();
    const Image both = Grab(window);
    long wrong = 0;
    for (int y = 0; y < 120; ++y)
    {
      for (int x = 0; x < 150; ++x)
      {
        // Interpolated colours may round otherwise in another viewport; a shadow would differ more.
        for (int i = 0; i < 3; ++i)
        {
          wrong += std::abs(Byte(both, x, y, i) - Byte(alone[0], x, y, i)) > 1;
          wrong += std::abs(Byte(both, 150 + x, 80 + y, i) - Byte(alone[1], x, y, i)) > 1;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
  }
}

TEST(StencilShadowPass, ResizedWindow)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(160, 160);
  window->AddRenderer(scene.Renderer);
  for (const auto& size :
    std::vector<std::array<int, 2>>{ { 160, 160 }, { 300, 180 }, { 120, 90 } })
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->GetDimensions()[0], size[0]);
    EXPECT_EQ(mask->GetDimensions()[1], size[1]);
    ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, "resized");
  }
}

TEST(StencilShadowPass, ToggledEveryFrame)
{
  Scene scene;
  scene.Add(FloatingBox());
  scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  std::vector<Image> pictures;
  for (int frame = 0; frame < 6; ++frame)
  {
    scene.Renderer->SetPass(frame % 2 == 0 ? scene.Pass.Get() : nullptr);
    window->Render();
    pictures.push_back(Grab(window));
  }
  EXPECT_GT(Differences(pictures[0], pictures[1]), 1000);
  for (std::size_t frame = 2; frame < pictures.size(); ++frame)
  {
    EXPECT_EQ(Differences(pictures[frame], pictures[frame - 2]), 0) << frame;
  }
}

TEST(StencilShadowPass, LightsAndActorsThatMove)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  const Mesh still = moved(sphere(8, 16), 0.3, { -1.5, -0.5, 0.6 });
  vtkSmartPointer<vtkActor> mover = scene.Add(mesh);
  scene.Add(still);
  vtkSmartPointer<vtkLight> point = scene.AddLight(PointLight, 0.5);
  vtkSmartPointer<vtkLight> direction = scene.AddLight(DirectionalLight, 0.5);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  const auto check = [&](const RayLight& position, const char* what) {
    const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh, mover->GetMatrix() },
      { still } };
    ExpectMask(scene, point, position, objects, what);
    ExpectMask(scene, direction, DirectionalLight, objects, what);
  };

  // The ground casts as well: three casters, two lights.
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 6);
  check(PointLight, "first");
  scene.Look(3.0, -6.0, 5.0);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  check(PointLight, "camera moved");

  const RayLight elsewhere = { -0.5, 1.5, 3.5, 1.0 };
  point->SetPosition(elsewhere[0], elsewhere[1], elsewhere[2]);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 3);
  check(elsewhere, "light moved");

  // A translation leaves a directional light where it was.
  mover->SetPosition(0.5, 0.2, 0.1);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 1);
  check(elsewhere, "actor moved");

  direction->SwitchOff();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  EXPECT_EQ(scene.Pass->GetMask(direction), nullptr);
  direction->SwitchOn();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 3);
  check(elsewhere, "light on again");

  mesh->GetPoints()->SetPoint(0, 0.0, 0.0, 1.9);
  mesh->GetPoints()->Modified();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 2);
  scene.Pass->SetKindToSmooth();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 6);
}

TEST(StencilShadowPass, LightsThatComeAndGo)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh } };
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  std::vector<RayLight> positions;
  Image five;
  for (int i = 0; i < 6; ++i)
  {
    positions.push_back({ 1.5 - 0.6 * i, 1.0 + 0.2 * i, 4.0, i % 2 == 0 ? 1.0 : 0.0 });
    lights.push_back(scene.AddLight(positions.back(), 0.15));
    window->Render();
    for (std::size_t k = 0; k < lights.size(); ++k)
    {
      ExpectMask(scene, lights[k], positions[k], objects, "added");
    }
    five = i == 4 ? Grab(window) : five;
  }
  scene.Renderer->RemoveLight(lights.back());
  window->Render();
  EXPECT_EQ(Differences(Grab(window), five), 0);

  // The same lights shine, but masks move to other channels: only the first light's shadow goes.
  const Image firstMask = scene.Mask(lights[0]);
  scene.Pass->SetLightCasts(lights[0], false);
  window->Render();
  const Image four = Grab(window);
  EXPECT_GT(Differences(four, five), 500);
  long elsewhere = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      elsewhere += Byte(firstMask, x, y) == 255 && Byte(four, x, y) != Byte(five, x, y);
    }
  }
  EXPECT_EQ(elsewhere, 0);
  ExpectMask(scene, lights[1], positions[1], objects, "first does not cast");
  scene.Pass->SetLightCasts(lights[0], true);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), five), 0);
}

TEST(StencilShadowPass, OnePassInTwoWindows)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto first = MakeWindow(200, 150);
  first->AddRenderer(scene.Renderer);
  first->Render();
  const Image picture = Grab(first);

  Scene other;
  other.Add(FloatingBox());
  other.AddLight(PointLight);
  other.Renderer->SetPass(scene.Pass);
  auto second = MakeWindow(200, 150);
  second->AddRenderer(other.Renderer);
  for (int frame = 0; frame < 3; ++frame)
  {
    second->Render();
    EXPECT_EQ(Differences(Grab(second), picture), 0);
    first->Render();
    EXPECT_EQ(Differences(Grab(first), picture), 0);
    EXPECT_GT(blackFraction(scene.Mask(light)), 0.05);
  }
}

TEST(StencilShadowPass, StateIsLeftAlone)
{
  Scene scene;
  scene.Add(FloatingBox());
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

TEST(StencilShadowPass, ReleasedAndDrawnElsewhere)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto first = MakeWindow(200, 150);
  first->AddRenderer(scene.Renderer);
  first->Render();
  const Image picture = Grab(first);
  EXPECT_TRUE(scene.Mask(light));

  scene.Pass->ReleaseGraphicsResources(first);
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  first->Render();
  EXPECT_EQ(Differences(Grab(first), picture), 0);

  first->RemoveRenderer(scene.Renderer);
  auto second = MakeWindow(200, 150);
  second->AddRenderer(scene.Renderer);
  second->Render();
  EXPECT_EQ(Differences(Grab(second), picture), 0);

  // The window goes while the pass is in no renderer.
  scene.Renderer->SetPass(nullptr);
  second->RemoveRenderer(scene.Renderer);
  second = nullptr;
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  first->AddRenderer(scene.Renderer);
  scene.Renderer->SetPass(scene.Pass);
  first->Render();
  EXPECT_EQ(Differences(Grab(first), picture), 0);
}

TEST(StencilShadowPass, ScenesWithoutShadows)
{
  Scene scene;
  auto window = MakeWindow(100, 80);
  window->AddRenderer(scene.Renderer);
  // No light, only a headlight, a light without a direction, an empty mesh.
  window->Render();
  vtkSmartPointer<vtkLight> headlight = scene.AddHeadlight(1.0);
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(headlight), nullptr);
  vtkSmartPointer<vtkLight> light = scene.AddLight({ 0.0, 0.0, 0.0, 0.0 });
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  light->SetPosition(1.0, 1.0, 1.0);
  scene.Add(vtkNew<vtkPolyData>());
  vtkNew<vtkActor> withoutMapper;
  scene.Renderer->AddActor(withoutMapper);
  window->Render();
  ASSERT_TRUE(scene.Mask(light));
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
}

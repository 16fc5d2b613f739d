// Offscreen windows do what any vtkRenderWindow does, and say why where they cannot.
//
// The window under test is named by the environment variable SMOOTHSHADOW_WINDOW ("egl", "osmesa",
// "native"); without it, it is the one that fits the executable: OSMesa in the -osmesa twin.

#include "vtkOffscreenEGLRenderWindow.h"
#include "vtkOffscreenOSMesaRenderWindow.h"
#include "vtkOffscreenWindows.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkConeSource.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAAPass.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

namespace
{
using Colour = std::array<unsigned char, 3>;

constexpr Colour Orange = { 255, 153, 51 };
constexpr Colour Blue = { 51, 102, 204 };

std::string WindowName()
{
  const char* name = std::getenv("SMOOTHSHADOW_WINDOW");
  return name && *name ? name : vtkOffscreenWindows::GetDefaultName();
}

vtkSmartPointer<vtkRenderWindow> MakeWindow()
{
  auto window =
    vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow(WindowName().c_str()));
  EXPECT_TRUE(window) << vtkOffscreenWindows::GetLastReason();
  return window;
}

// A cone of exactly its own colour before a background of exactly its own.
vtkSmartPointer<vtkRenderer> MakeScene(const Colour& cone, const Colour& background)
{
  vtkNew<vtkConeSource> source;
  source->SetResolution(64);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(cone[0] / 255.0, cone[1] / 255.0, cone[2] / 255.0);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AddActor(actor);
  renderer->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  return renderer;
}

struct Picture
{
  int Width = 0;
  int Height = 0;
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;

  vtkIdType Count(const Colour& colour) const
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < this->Pixels->GetNumberOfTuples(); ++i)
    {
      count += this->At(i) == colour;
    }
    return count;
  }

  Colour At(vtkIdType i) const
  {
    const unsigned char* p = this->Pixels->GetPointer(3 * i);
    return { p[0], p[1], p[2] };
  }

  std::size_t CountColours() const
  {
    std::set<Colour> colours;
    for (vtkIdType i = 0; i < this->Pixels->GetNumberOfTuples(); ++i)
    {
      colours.insert(this->At(i));
    }
    return colours.size();
  }
};

Picture Read(vtkRenderWindow* window, bool front = true)
{
  const int* size = window->GetSize();
  Picture picture{ size[0], size[1], vtkSmartPointer<vtkUnsignedCharArray>::New() };
  EXPECT_EQ(window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, front, picture.Pixels), VTK_OK);
  EXPECT_EQ(picture.Pixels->GetNumberOfValues(), 3 * size[0] * size[1]);
  return picture;
}

// Both colours are there, the cone in the middle and not at the rim.
void ExpectCone(const Picture& picture, const Colour& cone, const Colour& background)
{
  const vtkIdType all = static_cast<vtkIdType>(picture.Width) * picture.Height;
  EXPECT_GT(picture.Count(cone), all / 20);
  EXPECT_GT(picture.Count(background), all / 20);
  EXPECT_EQ(picture.At(0), background);
  EXPECT_EQ(picture.At(all - 1), background);
  EXPECT_EQ(
    picture.At(static_cast<vtkIdType>(picture.Height / 2) * picture.Width + picture.Width / 2),
    cone);
}

void CountEvents(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}
}

TEST(OffscreenWindows, RendersAndReadsBackBothBuffers)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  EXPECT_EQ(vtkOffscreenWindows::GetLastReason(), "");
  window->SetMultiSamples(0);
  window->SetSize(200, 150);
  window->AddRenderer(MakeScene(Orange, Blue));
  window->Render();
  const Picture front = Read(window, true);
  const Picture back = Read(window, false);
  ExpectCone(front, Orange, Blue);
  EXPECT_EQ(front.CountColours(), 2u);
  for (vtkIdType i = 0; i < front.Pixels->GetNumberOfValues(); ++i)
  {
    ASSERT_EQ(front.Pixels->GetValue(i), back.Pixels->GetValue(i)) << "value " << i;
  }
}

TEST(OffscreenWindows, ReadsRGBA)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->SetSize(64, 48);
  window->AddRenderer(MakeScene(Orange, Blue));
  window->Render();

  vtkNew<vtkUnsignedCharArray> bytes;
  ASSERT_EQ(window->GetRGBACharPixelData(0, 0, 63, 47, 1, bytes), VTK_OK);
  ASSERT_EQ(bytes->GetNumberOfValues(), 4 * 64 * 48);
  vtkNew<vtkFloatArray> floats;
  ASSERT_EQ(window->GetRGBAPixelData(0, 0, 63, 47, 1, floats), VTK_OK);
  ASSERT_EQ(floats->GetNumberOfValues(), 4 * 64 * 48);
  for (vtkIdType i = 0; i < bytes->GetNumberOfValues(); ++i)
  {
    ASSERT_NEAR(bytes->GetValue(i), 255.0f * floats->GetValue(i), 0.51f);
  }
  EXPECT_EQ(bytes->GetValue(4 * (24 * 64 + 32)), Orange[0]);
}

TEST(OffscreenWindows, HasASizeBeforeTheFirstRender)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->AddRenderer(MakeScene(Orange, Blue));
  window->SetMultiSamples(0);
  window->Render();
  EXPECT_EQ(window->GetSize()[0], 300);
  EXPECT_EQ(window->GetSize()[1], 300);
  ExpectCone(Read(window), Orange, Blue);
}

TEST(OffscreenWindows, Resizes)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->AddRenderer(MakeScene(Orange, Blue));
  for (const auto& size :
    { std::array{ 100, 80 }, std::array{ 640, 480 }, std::array{ 37, 91 }, std::array{ 100, 80 } })
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    const Picture picture = Read(window);
    EXPECT_EQ(picture.Width, size[0]);
    EXPECT_EQ(picture.Height, size[1]);
    ExpectCone(picture, Orange, Blue);
  }
}

TEST(OffscreenWindows, ResamplesWhenTheNumberOfSamplesChanges)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetSize(200, 150);
  window->AddRenderer(MakeScene(Orange, Blue));
  for (const int samples : { 0, 4, 0, 4 })
  {
    window->SetMultiSamples(samples);
    window->Render();
    const Picture picture = Read(window);
    ExpectCone(picture, Orange, Blue);
    if (window->GetMultiSamples() > 0)
    {
      EXPECT_GT(picture.CountColours(), 2u) << samples << " samples";
    }
    else
    {
      EXPECT_EQ(picture.CountColours(), 2u) << samples << " samples";
    }
  }
}

TEST(OffscreenWindows, TwoAtATime)
{
  auto first = MakeWindow();
  auto second = MakeWindow();
  ASSERT_TRUE(first && second);
  first->SetMultiSamples(0);
  second->SetMultiSamples(0);
  first->SetSize(120, 90);
  second->SetSize(90, 140);
  first->AddRenderer(MakeScene(Orange, Blue));
  second->AddRenderer(MakeScene(Blue, Orange));
  for (int frame = 0; frame < 3; ++frame)
  {
    first->Render();
    second->Render();
    // Read in the order in which the other one is current.
    ExpectCone(Read(first), Orange, Blue);
    ExpectCone(Read(second), Blue, Orange);
    first->SetSize(120 + 10 * frame, 90);
  }
  // What is left of one window must not reach into the other's context.
  first = nullptr;
  ExpectCone(Read(second), Blue, Orange);
  second->Render();
  ExpectCone(Read(second), Blue, Orange);
}

TEST(OffscreenWindows, PopContextGivesTheOtherWindowBack)
{
  auto first = MakeWindow();
  auto second = MakeWindow();
  ASSERT_TRUE(first && second);
  auto* a = vtkOpenGLRenderWindow::SafeDownCast(first);
  auto* b = vtkOpenGLRenderWindow::SafeDownCast(second);
  a->MakeCurrent();
  EXPECT_TRUE(a->IsCurrent());
  EXPECT_FALSE(b->IsCurrent());
  b->PushContext();
  EXPECT_TRUE(b->IsCurrent());
  b->PushContext();
  b->PopContext();
  EXPECT_TRUE(b->IsCurrent());
  b->PopContext();
  EXPECT_TRUE(a->IsCurrent());
  if (WindowName() != "native") // VTK's X window leaves no context current
  {
    second = nullptr;
    EXPECT_TRUE(a->IsCurrent());
  }
}

TEST(OffscreenWindows, WindowToImageFilterMagnifies)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->SetSize(80, 60);
  window->AddRenderer(MakeScene(Orange, Blue));
  for (const bool front : { true, false })
  {
    window->Render(); // sets the camera, which the filter then takes over
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetReadFrontBuffer(front);
    filter->SetScale(2, 2);
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], 160);
    EXPECT_EQ(image->GetDimensions()[1], 120);
    Picture picture{ 160, 120,
      vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars()) };
    ExpectCone(picture, Orange, Blue);
  }
}

TEST(OffscreenWindows, DepthIsThatOfTheCamera)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetSize(50, 40);
  vtkNew<vtkPlaneSource> plane; // the unit square at z = 0
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0, 0, 3);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetParallelScale(1);
  camera->SetClippingRange(1, 9);
  for (const int samples : { 0, 4 })
  {
    window->SetMultiSamples(samples);
    window->Render();
    vtkNew<vtkFloatArray> depths;
    ASSERT_EQ(window->GetZbufferData(0, 0, 49, 39, depths), VTK_OK);
    ASSERT_EQ(depths->GetNumberOfValues(), 50 * 40);
    EXPECT_NEAR(depths->GetValue(20 * 50 + 25), (3.0 - 1.0) / (9.0 - 1.0), 1e-5);
    EXPECT_EQ(depths->GetValue(0), 1.0f);
    EXPECT_NEAR(window->GetZbufferDataAtPoint(25, 20), 0.25, 1e-5);
  }
}

TEST(OffscreenWindows, SupersamplingPass)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->SetSize(200, 150);
  auto renderer = MakeScene(Orange, Blue);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> supersampling;
  supersampling->SetDelegatePass(steps);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(supersampling);
  window->AddRenderer(renderer);
  for (const int width : { 200, 260 })
  {
    window->SetSize(width, 150);
    window->Render();
    const Picture picture = Read(window);
    ExpectCone(picture, Orange, Blue);
    EXPECT_GT(picture.CountColours(), 2u);
  }
}

TEST(OffscreenWindows, ShadowMapPass)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->SetSize(160, 120);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2, -2, 0);
  plane->SetPoint1(2, -2, 0);
  plane->SetPoint2(-2, 2, 0);
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0, 0, 1);
  for (vtkPolyDataAlgorithm* source :
    std::initializer_list<vtkPolyDataAlgorithm*>{ plane.Get(), cone.Get() })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetPosition(1, 1, 5);
  light->SetFocalPoint(0, 0, 0);
  light->SetPositional(true);
  light->SetConeAngle(60);
  renderer->AddLight(light);
  renderer->GetActiveCamera()->SetPosition(-4, -4, 4);
  renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  window->Render();
  const Picture plain = Read(window);

  vtkNew<vtkShadowMapBakerPass> baker;
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetShadowMapBakerPass(baker);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(camera);
  window->Render();
  const Picture shadowed = Read(window);

  int darker = 0, brighter = 0;
  for (vtkIdType i = 0; i < plain.Pixels->GetNumberOfTuples(); ++i)
  {
    darker += shadowed.At(i)[0] + 20 < plain.At(i)[0];
    brighter += shadowed.At(i)[0] > plain.At(i)[0] + 20;
  }
  EXPECT_GT(darker, 100);
  EXPECT_LT(brighter, darker / 10);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(nullptr);
  camera->ReleaseGraphicsResources(window);
}

TEST(OffscreenWindows, ManyInARow)
{
  for (int i = 0; i < 20; ++i)
  {
    auto window = MakeWindow();
    ASSERT_TRUE(window);
    window->SetMultiSamples(0);
    window->SetSize(50 + i, 50);
    window->AddRenderer(MakeScene(Orange, Blue));
    window->Render();
    ExpectCone(Read(window), Orange, Blue);
  }
}

TEST(OffscreenWindows, SceneOutlivesItsWindow)
{
  auto renderer = MakeScene(Orange, Blue);
  for (int i = 0; i < 3; ++i)
  {
    auto window = MakeWindow();
    ASSERT_TRUE(window);
    window->SetMultiSamples(0);
    window->SetSize(60, 50);
    window->AddRenderer(renderer);
    window->Render();
    ExpectCone(Read(window), Orange, Blue);
    window->RemoveRenderer(renderer);
  }
}

TEST(OffscreenWindows, RendersAgainAfterFinalize)
{
  auto window = MakeWindow();
  ASSERT_TRUE(window);
  window->SetMultiSamples(0);
  window->SetSize(60, 50);
  window->AddRenderer(MakeScene(Orange, Blue));
  for (int i = 0; i < 3; ++i)
  {
    window->Render();
    ExpectCone(Read(window), Orange, Blue);
    window->Finalize();
  }
}

TEST(OffscreenWindows, NeverRenderedIsHarmless)
{
  vtkNew<vtkOffscreenEGLRenderWindow> egl;
  vtkNew<vtkOffscreenOSMesaRenderWindow> osmesa;
  egl->AddRenderer(MakeScene(Orange, Blue));
  EXPECT_FALSE(egl->IsCurrent());
  egl->MakeCurrent();
  egl->Finalize();
  osmesa->Finalize();
  EXPECT_EQ(egl->GetContextDescription(), "");
}

TEST(OffscreenWindows, UnknownNameGivesAReason)
{
  EXPECT_FALSE(vtkOffscreenWindows::NewWindow("glut"));
  EXPECT_NE(vtkOffscreenWindows::GetLastReason().find("egl, osmesa and native"), std::string::npos);
}

TEST(OffscreenWindows, FailureIsReportedOnceAndRenderDoesNothing)
{
  vtkNew<vtkOffscreenEGLRenderWindow> window;
  window->SetDeviceIndex(9999);
  window->AddRenderer(MakeScene(Orange, Blue));
  int errors = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetCallback(CountEvents);
  counter->SetClientData(&errors);
  window->AddObserver(vtkCommand::ErrorEvent, counter);
  for (int i = 0; i < 3; ++i)
  {
    window->Render();
  }
  EXPECT_EQ(errors, 1);
  EXPECT_NE(window->GetFailureReason().find("Tried:"), std::string::npos);
  EXPECT_NE(window->GetFailureReason().find("libegl-mesa0"), std::string::npos);
  EXPECT_EQ(window->SupportsOpenGL(), 0);
  EXPECT_EQ(window->ReportCapabilities(), window->GetFailureReason());

  vtkNew<vtkUnsignedCharArray> pixels;
  EXPECT_EQ(window->GetPixelData(0, 0, 9, 9, 1, pixels, 0), VTK_ERROR);
  EXPECT_EQ(window->GetRGBACharPixelData(0, 0, 9, 9, 0, pixels), VTK_ERROR);
  vtkNew<vtkFloatArray> depths;
  EXPECT_EQ(window->GetZbufferData(0, 0, 9, 9, depths), VTK_ERROR);

  window->Finalize();
  EXPECT_EQ(window->GetFailureReason(), "");
}

TEST(OffscreenWindows, OSMesaNamesItsTwinInAnOrdinaryExecutable)
{
  if (std::string(vtkOffscreenWindows::GetDefaultName()) == "osmesa")
  {
    GTEST_SKIP() << "this is the twin";
  }
  EXPECT_FALSE(vtkOffscreenWindows::NewWindow("osmesa"));
  EXPECT_NE(vtkOffscreenWindows::GetLastReason().find("-osmesa"), std::string::npos);
}

TEST(OffscreenWindows, OtherWindowsAreRefusedInTheTwin)
{
  if (std::string(vtkOffscreenWindows::GetDefaultName()) != "osmesa")
  {
    GTEST_SKIP() << "this is no twin";
  }
  for (const char* name : { "egl", "native" })
  {
    EXPECT_FALSE(vtkOffscreenWindows::NewWindow(name));
    EXPECT_NE(vtkOffscreenWindows::GetLastReason().find("-osmesa"), std::string::npos);
  }
}

// The environment of these is read once in a process: each has a process of its own.
class OffscreenWindowsDeathTest : public testing::Test
{
protected:
  OffscreenWindowsDeathTest() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }

  [[noreturn]] static void ReportMissing(const char* name)
  {
    const bool made = vtkOffscreenWindows::NewWindow(name) != nullptr;
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    std::_Exit(made ? 1 : 0);
  }
};

TEST_F(OffscreenWindowsDeathTest, NativeWithoutADisplayGivesAReason)
{
  if (std::string(vtkOffscreenWindows::GetDefaultName()) == "osmesa")
  {
    GTEST_SKIP() << "the twin has no native window";
  }
  EXPECT_EXIT(
    {
      unsetenv("DISPLAY");
      ReportMissing("native");
    },
    testing::ExitedWithCode(0), "DISPLAY is not set");
  EXPECT_EXIT(
    {
      setenv("DISPLAY", ":7654", 1);
      ReportMissing("native");
    },
    testing::ExitedWithCode(0), "no X server answers at DISPLAY=:7654");
}

TEST_F(OffscreenWindowsDeathTest, EGLWithoutADriverGivesAReason)
{
  if (std::string(vtkOffscreenWindows::GetDefaultName()) == "osmesa")
  {
    GTEST_SKIP() << "the twin has no EGL window";
  }
  EXPECT_EXIT(
    {
      setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
      ReportMissing("egl");
    },
    testing::ExitedWithCode(0), "libgl1-mesa-dri");
}

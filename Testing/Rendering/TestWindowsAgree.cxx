// EGL and OSMesa draw the same: the pictures that TestShadowMasks left of both.

#include "ImageChecks.h"
#include "Tolerances.h"

#include <vtksys/Directory.hxx>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace
{
std::vector<std::string> picturesOf(const std::string& folder, const std::string& window)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> names;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    if (name.compare(0, window.size() + 1, window + "-") == 0)
    {
      names.push_back(name.substr(window.size() + 1));
    }
  }
  return names;
}
}

TEST(WindowsAgree, PicturesAndMasks)
{
  const char* folder = std::getenv("SMOOTHSHADOW_PICTURES");
  ASSERT_TRUE(folder) << "SMOOTHSHADOW_PICTURES names the folder of TestShadowMasks's pictures";
  const std::vector<std::string> names = picturesOf(folder, "egl");
  EXPECT_GE(names.size(), 14u);
  for (const std::string& name : names)
  {
    const std::string start = std::string(folder) + "/";
    const auto egl = shadowtest::readPng(start + "egl-" + name);
    const auto osmesa = shadowtest::readPng(start + "osmesa-" + name);
    const auto difference =
      shadowtest::compareImages(egl, osmesa, shadowtest::tolerance::PictureChannel);
    EXPECT_LE(difference.Fraction, shadowtest::tolerance::PictureFraction)
      << name << ": " << difference.Pixels << " pixels";
  }
}

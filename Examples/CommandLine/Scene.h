/**
 * Where ground, light and camera stand about the meshes, as far as the user leaves it open.
 */
#ifndef Scene_h
#define Scene_h

#include "Camera.h"

#include <optional>
#include <vector>

class vtkPolyData;

/// What the user fixed; the rest is chosen.
struct SceneOptions
{
  bool Ground = false;
  std::vector<Homogeneous> Lights;
  std::optional<Vector3> Eye;
  std::optional<Vector3> At;
  Vector3 Up = { 0.0, 1.0, 0.0 };
  double Angle = 30.0;
  std::array<int, 2> Size = { 1024, 768 };
};

/// A square, by one corner and the two next to it.
struct Ground
{
  Vector3 Origin;
  Vector3 Point1;
  Vector3 Point2;
};

class Scene
{
public:
  /// The meshes hold finite points only, at least one in all.
  Scene(const std::vector<vtkPolyData*>& meshes, const SceneOptions& options);

  /// The user's lights, or one at the upper left in front.
  const std::vector<Homogeneous>& Lights() const { return this->LightList; }

  /// At the meshes' lowest point along Up, wide enough to fill the picture behind them.
  Ground GroundSquare() const;

  /// The user's eye; or one in front, a little to the right and above, as near as meshes and, on a
  /// ground, their shadows fit into the picture.
  Camera View() const;

private:
  // Coordinates along right, up and front.
  Vector3 ToFrame(const Vector3& world) const;
  Vector3 ToWorld(const Vector3& frame) const;

  void AddShadows();
  Camera FittingView() const;

  SceneOptions Options;
  std::array<Vector3, 3> Axes;  // right, up, front: unit, at right angles
  std::vector<Vector3> Content; // meshes' and shadows' points, in the frame
  std::size_t MeshPoints = 0;   // how many of them are the meshes'
  Vector3 Centre;               // of the meshes' box, in the frame
  double Lowest;
  double Radius; // half of the box's diagonal
  std::vector<Homogeneous> LightList;
};

#endif

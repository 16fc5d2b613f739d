// Scenes of cast shadows and their contours as vtkPolyData: silhouettes read, lines written.
#ifndef ContourData_h
#define ContourData_h

#include "CastContour.h"
#include "ReceiverCache.h"

class vtkPolyData;

// All inputs as a scene, with where its parts come from.
struct ContourInput
{
  shadow::ContourScene scene;
  double light[4];        // as it was given
  std::vector<int> input; // of each loop: number of the silhouette
  std::vector<int> cell;  // and of its line there
  std::vector<vtkPolyData*> meshes; // the receivers
  std::vector<std::shared_ptr<const PreparedReceiver>> receivers; // which the scene refers to
  std::vector<std::shared_ptr<const PreparedReceiver>> casters;
};

// Adds the lines of a silhouette. Lines with points that do not exist or are not finite are left
// out, as are those of a single point. A line is closed if it returns to where it starts.
void addSilhouette(vtkPolyData* silhouette, int number, ContourInput& contours);

// What the light of some silhouettes is.
enum class SilhouetteLight
{
  None,     // none of them says
  Same,     // those that say agree; it is given back
  Different // they do not
};
SilhouetteLight lightOf(const std::vector<vtkPolyData*>& silhouettes, double light[4]);

// Moves points to the nearest points of a grid of that spacing. Points and lines that coincide with
// others then go.
shadow::CastContours onGrid(const shadow::CastContours& contours, double spacing);

// All arrays that vtkCastShadowContour documents.
void writeContours(const shadow::CastContours& contours, const ContourInput& input,
  const shadow::ContourReport& report, vtkPolyData* output);

#endif

/// Where the walls of a shadow volume begin, and what joins that to the mesh.
#pragma once

#include "NearEnd.h"

namespace shadow
{
/// Adds a rim for each loop of a silhouette, with gaps, further points, and the caps in front of
/// concave contours.
///
/// A smooth contour lies off the mesh; gaps fill what is between. Where it is concave (see
/// ConcaveContour) the rim stays on the mesh: lifted off it, or with a triangle in front of it that
/// faces away from the light, walls would pass over a mesh that sags, and light get in under them.
/// So it is the chord there and, around a triangle that is turned away, the lit part's other sides;
/// that part becomes cap, unless there is no cap.
void addRims(const SilhouetteInput& silhouette, NearEnd& end);
}

/**
 * Every tolerance of the tests, each with its reason. A test never widens one to pass: the cause
 * is found, and a real limit is written into the README.
 *
 * Lengths are relative to the size of what is measured (the diagonal of its bounds) unless said.
 */
#ifndef shadowtest_Tolerances_h
#define shadowtest_Tolerances_h

namespace shadowtest
{
namespace tolerance
{
/// Length of a normal against 1: a few roundings of a normalisation in double.
constexpr double UnitNormal = 1e-12;

/// Points computed twice by formulas that are equal on paper, in double: crossings on an edge, a
/// scene that was moved and moved back by less than its size.
constexpr double SamePoint = 1e-12;

/// The same in a scene that was moved by some of its sizes: its coordinates were rounded anew.
constexpr double Moved = 1e-11;

/// The same at 1e7 sizes from the origin: four roundings of a coordinate there.
constexpr double FarPlace = 4.0 * 1e7 * 0x1p-52;

/// A winding number against the nearest integer, away from the surface: sums of some 1e5 solid
/// angles in double.
constexpr double Winding = 1e-6;

/// Volume of a mesh against that of its polyhedron by another formula.
constexpr double Volume = 1e-10;

/// A point counts as too close to a surface (or a ray to a triangle's edge) for a decision in
/// double to be compared with another one.
constexpr double TooClose = 1e-9;

/// How far a light on a vertex is lifted off the surface, at most: points nearer to the plane of a
/// face there may be in shadow or not.
constexpr double LightLift = 1e-5;

/// How far from 1 the order may be at which the contour of a point light nears that of its
/// direction, from a thousand sizes on. There the smooth contour is off by 1e-4 of the size, of
/// which its subdivision of 1e-6 may be a hundredth, and over four decades that makes 3e-3.
constexpr double FarLightOrder = 5e-3;

/// Roundings, of coordinates as large as a scene is far away, by which a ray's place in a triangle
/// may be off in double: those of three corners, of both ends of the ray, and of the differences
/// between them. Times a rounding of the place, over the triangle's size, it is the least margin at
/// which two decisions about a ray there are compared.
constexpr double RoundingsOfPlace = 32.0;

/// Residual at which the Newton iterations of the analytic shadows have converged.
constexpr double Newton = 1e-13;

/// Radial curvature times the shape's size unit below which a contour point is taken to be close
/// to a cusp: there the contour turns into the line of sight and no method has an order.
constexpr double CuspRadialCurvature = 0.1;

/// The share of a contour's tangent that is seen from the light below which a point counts as close
/// to a cusp in a test of directions: pieces that meet there are seen end-on, in any direction.
constexpr double CuspSeenTangent = 0.1;

/// Radians: the kink of the shadow's boundary where two pieces of a smooth contour meet. Both are
/// seen in the same line on paper. What remains is the rounding of coordinates over the length of
/// the shortest piece, about 1e-5 of the size beside a vertex.
constexpr double JointAngle = 1e-10;

/// Slack on the bound that a silhouette reports for its own subdivision: rounding only.
constexpr double ReportedBound = 1e-9;

/// How far the smooth contour of a sphere of 5,120 triangles is from its shadow on a plane, in
/// radii: it is subdivided to 1e-6 of the size, and its curve is nearer than that.
constexpr double SphereContour = 1e-5;

/// Contours whose pieces two formulas in double cut from triangles of some hundredths of the size:
/// roundings over the sine of the angle at which wall and edge cross, of which the least are some
/// 1e-4.
constexpr double CutContour = 1e-9;

/// How much farther than a silhouette a contour moves, at most: a fine field's triangles meet rays,
/// and their edges walls, at angles down to a tenth each.
constexpr double ContourSlant = 100.0;

/// How far beside a contour rays tell whether it is visible: a few times the slack with which the
/// ray cast passes edges.
constexpr double BesideContour = 1e-6;

/// Share of contours' length that may count as visible where rays say hidden, or the other way
/// around.
constexpr double HiddenLength = 1e-4;

/// How visible contours of accurate and smooth silhouettes may differ from the border of the mesh's
/// own shadow: the share of their length that has shadow on both sides, farther than an edge is
/// long, and how much their length is off that of discrete ones.
struct OtherKinds
{
  double Extra;
  double Visible;
};
/// A smooth shape bends away from all of its silhouette, or hides it from afar.
constexpr OtherKinds SmoothShapes = { 0.0, 1e-3 };
/// Where silhouettes come to rims and borders they end off by parts of an edge, of which there are
/// some 60 around.
constexpr OtherKinds Rims = { 3e-3, 8e-3 };
/// In folds of a scan that are no larger than a triangle and those around it these truly hide, and
/// smooth silhouettes are longer there: seen are up to 2.3% and 7%.
constexpr OtherKinds Scans = { 0.025, 0.08 };

/// Of lengths that differ by roundings alone.
constexpr double SameContours = 1e-9;

/// Least share of the reported bound that the true deviation reaches somewhere: a looser bound
/// would subdivide for nothing. An arc's bound is exact, that of an S-shaped piece 2.6 times its
/// deviation.
constexpr double DeviationShare = 1.0 / 3.0;

/// Least order of convergence of the smooth contour's shadow.
constexpr double SmoothOrder = 3.5;

/// How far from 2 the order of discrete and accurate silhouettes may be: which edges or crossings
/// an irregular mesh offers differs from size to size.
constexpr double PolygonOrder = 0.35;

/// Largest error of the smooth contour's shadow on meshes of some 330,000 triangles, in radii of
/// the shape: three times the worst case, the ellipsoid under a near light; and that with estimated
/// normals.
constexpr double SmoothFinest = 1e-7;
constexpr double EstimatedFinest = 1e-6;

/// Percent of the pixels in which a coarse torus shadows itself (light at a cosine of 0.03 and
/// more) that may be lit: twice what its discrete shadow, that of the triangles, leaves. With
/// contours lifted off the mesh everywhere it is some 20 to 50.
constexpr double LeakPercent = 1.0;

/// Pixels: how far from the true shadow's edge a rasterised mask may differ from the oracle.
constexpr int MaskPixels = 1;

/// Pixels: how far a rasteriser moves a triangle's corners, on to its grid of a 256th, with room
/// for single precision.
constexpr double RasterSnap = 1.0 / 64.0;

/// Cosine between a triangle's normal and the direction to the light up to which it is edge-on: a
/// few roundings of coordinates over the height of the flattest triangles that are seen. Whether
/// something blocks a ray that runs within the triangle's own plane is not defined, and shading has
/// it black.
constexpr double EdgeOn = 1e-9;

/// The same, below which shading in 8 bits is black whatever the mask says: half a step. A wall of
/// a volume leaves such a surface at an angle that 24 bits of depth cannot tell.
constexpr double FaintLight = 0.5 / 255.0;

/// Share of a mask's pixels that may be wrong on such faint surfaces: twice the most that was found
/// on a real mesh.
constexpr double FaintPixels = 6e-3;

/// Share of pixels of masks that a rasteriser may get wrong far from any edge, each alone: of a
/// wall that the eye sees edge-on, or of the zero-width shadow of triangles that are edge-on to the
/// light, a hair's breadth may cover a pixel's middle, with a depth that single precision does not
/// tell. Up to 2 of 900,000 pixels were found.
constexpr double StrayPixels = 3e-6;

/// Window depth: the room that the plan leaves around a volume that is some ten units wide and
/// away: 16 steps of 24 bits, and roundings of single precision.
constexpr double DepthMargin = 1e-5;

/// Steps of 255: a shaded colour against the formula. Half a step for rounding, the rest for
/// normals and positions that shaders have in float.
constexpr double Shade = 2.0;

/// Share of a light's brightness: how far from the sphere's the shade of a gap may be where facets
/// turn by 30 degrees. Its normals are at right angles to the line of sight all over, those of the
/// sphere at the facets' edges turn to the eye by up to 15 degrees, whose sine is 0.26. Found were 0.06
/// under a light from the side, 0.19 under one from the eye.
constexpr double GapShade = 0.2;

/// Steps of 255: a colour that was shaded by the same formula, but rounded in another buffer or
/// viewport.
constexpr int SameShade = 1;

/// Share of pixels, and greatest difference of a channel (0 to 255), by which the pictures of two
/// rasterisers of the same scene may differ: rounding of colours, and samples on an edge.
constexpr double PictureFraction = 0.002;
constexpr int PictureChannel = 2;

/// Relative: the height of an edge's curve against that of the arc, which it is at the middle, and
/// against the size where that is flat. What is lost where a small angle's cosine is taken from 1.
constexpr double ArcRounding = 1e-12;
}
}

#endif

#include "DefectTable.h"

#include "MeshCheck.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
// By their weight.
enum class Meaning
{
  Warned,
  WellDefined,
  Exact
};

const char* nameOf(Meaning meaning)
{
  return meaning == Meaning::Warned ? "warned"
    : meaning == Meaning::WellDefined ? "well defined"
                                      : "exact";
}

struct Defect
{
  const char* name;
  shadow::Occurrences found;
  Meaning meaning;
  std::string shadow;
  std::string remedy;
};

using Defects = std::vector<Defect>;

std::string text(double value)
{
  std::ostringstream stream;
  stream.precision(3);
  stream << value;
  return stream.str();
}

// To the same number of digits, but not to less than the value.
std::string textRoundedUp(double value)
{
  const std::string nearest = text(value);
  if (std::stod(nearest) >= value)
  {
    return nearest;
  }
  const double lastDigit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return text(value + 0.5 * lastDigit);
}

// Without a place of their own.
shadow::Occurrences counted(std::size_t count)
{
  shadow::Occurrences found;
  found.count = count;
  return found;
}

void addCellDefects(const CheckedMesh& checked, Defects& list)
{
  const ReadingDefects& read = checked.prepared.defects;
  list.push_back({ "no triangles", counted(checked.prepared.caster.mesh().triangles.empty()),
    Meaning::Warned, "The mesh casts nothing.", "" });
  list.push_back({ "non-finite cells", read.nonFiniteCells, Meaning::Warned,
    "Cells with a point that is not finite or does not exist are left out: their shadow is "
    "missing.",
    "Repair their points, or remove the cells if they are not meant." });
  list.push_back({ "lines and vertices", checked.input.linesAndVertices, Meaning::WellDefined,
    "Cells that are lines or vertices cast nothing.",
    "Make surfaces of them (vtkTubeFilter, vtkGlyph3D) if they are to cast." });
  list.push_back({ "crossed polygons", read.crossedPolygons, Meaning::WellDefined,
    "Polygons that cross themselves or have no area become fans around their first corner, which "
    "cast instead.",
    "Take them apart into triangles as they are meant." });
  list.push_back({ "degenerate cells", read.degenerateCells, Meaning::Exact,
    "Cells and triangles with fewer than three different corners cast nothing, as they have no "
    "area.",
    "" });
}

void addPointDefects(const CheckedMesh& checked, Defects& list)
{
  const ReadingDefects& read = checked.prepared.defects;
  const double step = checked.input.coarsestStep;
  const double share = step / checked.diagonal;
  list.push_back({ "coarse coordinates", checked.input.coarsePoints, Meaning::Warned,
    "So far from the origin the coordinates' type has steps of " + text(step) + ", " + text(share) +
      " of the mesh's size: surface and shadow are stepped.",
    "Move the mesh to the origin, or keep it in double (VTP), before it is rounded." });
  list.push_back({ "extreme coordinates", checked.input.extremePoints, Meaning::Warned,
    "Products of lengths leave the range of doubles on meshes smaller than " + text(leastSize) +
      " and at coordinates above " + text(largestSize) + ": shadows can be missing or wrong.",
    "Give the mesh and its lights in another unit." });
  list.push_back({ "repeated points", read.repeatedPoints, Meaning::Exact,
    "Points with equal coordinates, and equal normals if there are any, are welded, so that parts "
    "close.",
    "" });
  list.push_back({ "unused points", checked.input.unusedPoints, Meaning::Exact,
    "Points of no cell play no part.", "" });
}

void addNormalDefects(const CheckedMesh& checked, Defects& list)
{
  const shadow::NormalCounts& normals = checked.prepared.caster.normalCounts();
  list.push_back({ "estimated normals", counted(normals.estimated), Meaning::WellDefined,
    "The mesh has no point normals: smooth and accurate shadows follow estimated ones, discrete "
    "ones need none.",
    "Give the surface's own normals where they are known." });
  list.push_back({ "averaged normals", counted(normals.fallback), Meaning::WellDefined,
    "No fit is possible there, and the estimate is the mean of the triangles around: on curved "
    "surfaces smooth shadows are of order 2 instead of 4.",
    "Refine the mesh where it is curved and coarse." });
  list.push_back({ "unusable normals", checked.prepared.defects.unusableNormals,
    Meaning::WellDefined,
    "They are zero or not finite: smooth and accurate shadows follow the mean of the triangles "
    "around, discrete ones need none.",
    "Compute the normals anew, or remove all of them: better ones are then fitted." });
  list.push_back({ "contrary normals", checked.mesh.contraryNormals, Meaning::WellDefined,
    "Triangles whose normals point to the other side than their part's: smooth and accurate "
    "shadows follow the normals and can be off there, discrete ones are not.",
    "Compute the normals anew." });
  list.push_back({ "turned normals", checked.mesh.turnedNormals, Meaning::Exact,
    "Triangles whose normals are against the winding: their signs are turned, which gives the same "
    "shadow.",
    "" });
}

void addEdgeDefects(const CheckedMesh& checked, Defects& list)
{
  const std::string reach = textRoundedUp(checked.reach);
  list.push_back({ "near seams", checked.gaps.nearSeams, Meaning::WellDefined,
    "Border points within " + reach +
      " of one another are not welded: light falls through the gap, and both sides of the part "
      "cast.",
    "Weld them with vtkCleanPolyData, with that as its absolute tolerance." });
  list.push_back({ "T-junctions", checked.gaps.tJunctions, Meaning::WellDefined,
    "A border point lies within " + reach +
      " of the inside of another border edge: rounding can let a hairline of light through.",
    "Split the edge at the point." });
  list.push_back({ "border edges", checked.mesh.borderEdges, Meaning::Exact,
    "Light falls through the holes; both sides of the part cast, each triangle its exact shadow, "
    "which costs more than a closed part.",
    "Close the holes (vtkFillHolesFilter) if the surface is meant to be closed." });
  list.push_back({ "non-manifold edges", checked.mesh.nonManifoldEdges, Meaning::Exact,
    "More than two triangles meet there, and each casts its exact shadow.", "" });
  list.push_back({ "inconsistent edges", checked.mesh.inconsistentEdges, Meaning::Exact,
    "Neighbours are wound in opposite ways; both sides of the part cast, each triangle its exact "
    "shadow, which costs more than a closed part.",
    "Wind them alike (vtkPolyDataNormals with ConsistencyOn); a Moebius strip cannot be." });
}

void addTriangleDefects(const CheckedMesh& checked, Defects& list)
{
  const shadow::MeshDefects& mesh = checked.mesh;
  list.push_back({ "duplicate triangles", mesh.duplicateTriangles, Meaning::Exact,
    "A triangle given again casts the same shadow once more, which changes nothing.",
    "Remove them (vtkRemoveDuplicatePolys): they cost time, and can keep a part from being "
    "closed." });
  list.push_back({ "zero-area triangles", mesh.flatTriangles, Meaning::Exact,
    "They cast nothing themselves; they keep closed what they close.", "" });
  list.push_back({ "slivers", mesh.slivers, Meaning::Exact,
    "Triangles at least " + std::to_string(std::lround(shadow::sliverAspect)) +
      " times as long as high cast exactly; normals that are estimated around them are less sure.",
    "" });
  list.push_back({ "inside-out parts", mesh.insideOutParts, Meaning::Exact,
    "Closed parts that are wound inwards: which side is dark follows from their volume, so the "
    "shadow is the same.",
    "Turn them over (vtkReverseSense) for the shading's sake, unless they bound a cavity." });
  const bool someAreClosed = mesh.closedParts > 0;
  list.push_back({ "pierced triangles", checked.pierced,
    someAreClosed ? Meaning::WellDefined : Meaning::Exact,
    someAreClosed
      ? "Triangles pierce each other: with the light outside of closed parts the shadow is exact "
        "outside of them; what lies inside of one may be lit."
      : "Triangles pierce each other, and each casts its exact shadow.",
    "" });
}

Defects listDefects(const CheckedMesh& checked)
{
  Defects list;
  addCellDefects(checked, list);
  addPointDefects(checked, list);
  addEdgeDefects(checked, list);
  addTriangleDefects(checked, list);
  addNormalDefects(checked, list);
  list.erase(std::remove_if(list.begin(), list.end(),
               [](const Defect& defect) { return defect.found.count == 0; }),
    list.end());
  std::stable_sort(list.begin(), list.end(),
    [](const Defect& l, const Defect& r) { return l.meaning < r.meaning; });
  return list;
}

template <class Array, class Get>
void addColumn(vtkTable* output, const char* name, const Defects& list, const Get& get)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const Defect& defect : list)
  {
    column->InsertNextValue(get(defect));
  }
  output->AddColumn(column);
}

void addField(vtkTable* output, const char* name, std::size_t value)
{
  vtkNew<vtkIdTypeArray> field;
  field->SetName(name);
  field->InsertNextValue(static_cast<vtkIdType>(value));
  output->GetFieldData()->AddArray(field);
}
}

void writeDefects(const CheckedMesh& checked, vtkTable* output)
{
  const Defects list = listDefects(checked);
  addColumn<vtkStringArray>(output, "Defect", list, [](const Defect& d) { return d.name; });
  addColumn<vtkIdTypeArray>(output, "Count", list,
    [](const Defect& d) { return static_cast<vtkIdType>(d.found.count); });
  addColumn<vtkStringArray>(
    output, "Meaning", list, [](const Defect& d) { return nameOf(d.meaning); });
  addColumn<vtkStringArray>(output, "Shadow", list, [](const Defect& d) { return d.shadow; });
  addColumn<vtkStringArray>(output, "Remedy", list, [](const Defect& d) { return d.remedy; });
  addColumn<vtkDoubleArray>(output, "X", list, [](const Defect& d) { return d.found.place.x; });
  addColumn<vtkDoubleArray>(output, "Y", list, [](const Defect& d) { return d.found.place.y; });
  addColumn<vtkDoubleArray>(output, "Z", list, [](const Defect& d) { return d.found.place.z; });

  const shadow::Caster& caster = checked.prepared.caster;
  addField(output, "Triangles", caster.mesh().triangles.size());
  addField(output, "Points", caster.mesh().points.size());
  addField(output, "Parts", caster.weights().parts.size());
  addField(output, "ClosedParts", checked.mesh.closedParts);
  addField(output, "TwoSidedTriangles", checked.mesh.twoSidedTriangles);
}

#include "SilhouetteData.h"

#include "FieldArrays.h"
#include "PolyDataBridge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
enum LoopKind
{
  Contour = 0,
  Crease = 1,
  Border = 2,
  Mixed = 3
};

static_assert(sizeof(shadow::Vec3) == 3 * sizeof(double), "written as an array of doubles");

vtkSmartPointer<vtkDoubleArray> vectorArray(const char* name, std::size_t count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

shadow::Vec3* vectorsOf(vtkDoubleArray* array)
{
  return reinterpret_cast<shadow::Vec3*>(array->GetPointer(0));
}

vtkSmartPointer<vtkIntArray> intArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  return array;
}

int pieceKind(const shadow::Caster& caster, const shadow::Piece& piece)
{
  if (piece.isChord)
  {
    return Contour;
  }
  switch (caster.edgeKind(piece.source))
  {
    case shadow::EdgeKind::Crease:
      return Crease;
    case shadow::EdgeKind::Border:
      return Border;
    default:
      return Contour;
  }
}

int loopKind(const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops, std::size_t loop)
{
  if (caster.hasPlainEdgesOnly())
  {
    return Contour;
  }
  int kind = pieceKind(caster, chain.pieces[loops.pieces[loops.first[loop]]]);
  for (std::size_t i = loops.first[loop] + 1; i < loops.first[loop + 1] && kind != Mixed; ++i)
  {
    kind = kind == pieceKind(caster, chain.pieces[loops.pieces[i]]) ? kind : Mixed;
  }
  return kind;
}

void writeLoops(const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops, const shadow::LoopPolylines& lines, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(loops.count());
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(lines.nodes.size()) + count);
  const auto kinds = intArray("Kind", count);
  const auto closed = intArray("Closed", count);
  const auto multiplicities = intArray("Multiplicity", count);
  vtkIdType* next = connectivity->GetPointer(0);
  for (std::size_t loop = 0; loop < loops.count(); ++loop)
  {
    const vtkIdType begin = static_cast<vtkIdType>(lines.first[loop]);
    const vtkIdType end = static_cast<vtkIdType>(lines.first[loop + 1]);
    const vtkIdType cell = static_cast<vtkIdType>(loop);
    offsets->SetValue(cell, begin + cell); // each loop before has one id more than points
    std::iota(next, next + (end - begin), begin);
    next += end - begin;
    *next++ = begin;
    kinds->SetValue(cell, loopKind(caster, chain, loops, loop));
    closed->SetValue(cell, 1);
    multiplicities->SetValue(cell, loops.multiplicity[loop]);
  }
  offsets->SetValue(count, connectivity->GetNumberOfValues());
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetLines(cells);
  output->GetCellData()->AddArray(kinds);
  output->GetCellData()->AddArray(closed);
  output->GetCellData()->AddArray(multiplicities);
}

void writeDiagnosis(const PreparedCaster& prepared, vtkPolyData* output)
{
  const shadow::EdgeDefects& defects = prepared.caster.defects();
  addCount(output, "DegenerateCells", prepared.defects.degenerateCells.count);
  addCount(output, "NonFiniteCells", prepared.defects.nonFiniteCells.count);
  addCount(output, "BoundaryEdges", defects.boundary);
  addCount(output, "NonManifoldEdges", defects.nonManifold);
  addCount(output, "InconsistentEdges", defects.inconsistent);
  addCount(output, "EstimatedNormals", prepared.caster.normalCounts().estimated);
  addCount(output, "FallbackNormals", prepared.caster.normalCounts().fallback);
}

// As often as the triangles of a mesh may meet at an edge.
constexpr double mostTimes = 2147483647.0;

bool hasShape(vtkDataArray* array, int components, vtkIdType tuples)
{
  return array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == tuples;
}

double fieldValue(vtkPolyData* data, const char* name, int component, bool& found)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() * array->GetNumberOfComponents() <= component)
  {
    found = false;
    return 0.0;
  }
  return array->GetVariantValue(component).ToDouble();
}
}

void writeSilhouette(const PreparedCaster& prepared, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops, const shadow::PolylineTolerance& tolerance,
  const SilhouetteSettings& settings, vtkPolyData* output)
{
  vtkSmartPointer<vtkDoubleArray> points;
  vtkSmartPointer<vtkDoubleArray> meshPoints;
  vtkSmartPointer<vtkDoubleArray> normals;
  const bool smooth = settings.kind == shadow::SilhouetteKind::Smooth;
  const shadow::LoopPolylines lines = shadow::makePolylines(prepared.caster, chain, loops,
    tolerance, smpRangeLoop,
    [&](std::size_t count)
    {
      points = vectorArray("Points", count);
      meshPoints = vectorArray("MeshPoints", smooth ? count : 0);
      normals = vectorArray("Normals", count);
      return shadow::PolylineArrays{ vectorsOf(points), smooth ? vectorsOf(meshPoints) : nullptr,
        vectorsOf(normals) };
    });
  if (!smooth)
  {
    meshPoints->ShallowCopy(points); // the silhouette is on the mesh
    meshPoints->SetName("MeshPoints");
  }
  vtkNew<vtkPoints> places;
  places->SetData(points);
  output->SetPoints(places);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(meshPoints);
  vtkNew<vtkIdTypeArray> nodes;
  nodes->SetName("MeshNodes");
  nodes->SetNumberOfValues(static_cast<vtkIdType>(lines.nodes.size()));
  std::transform(lines.nodes.begin(), lines.nodes.end(), nodes->GetPointer(0),
    [&](shadow::Index node)
    {
      return node == shadow::None
        ? vtkIdType(-1)
        : static_cast<vtkIdType>(shadow::nodeNumber(prepared.caster, chain, node));
    });
  output->GetPointData()->AddArray(nodes);
  writeLoops(prepared.caster, chain, loops, lines, output);

  addLightPosition(output, settings.lightPosition.data());
  addField<vtkDoubleArray>(output, "MaximumDeviation", { lines.deviation.world });
  if (tolerance.receiver)
  {
    addField<vtkDoubleArray>(output, "MaximumShadowDeviation", { lines.deviation.seen });
  }
  addField<vtkIntArray>(output, "SilhouetteKind", { static_cast<int>(settings.kind) });
  addField<vtkIntArray>(output, "SearchComplete", { settings.complete ? 1 : 0 });
  addCount(output, "EdgesTested", chain.itemsTested);
  addField<vtkIntArray>(output, "MergePoints", { static_cast<int>(settings.caster.mergePoints) });
  addField<vtkDoubleArray>(output, "FeatureAngle", { settings.caster.featureAngle });
  writeDiagnosis(prepared, output);
}

bool readSettings(vtkPolyData* data, SilhouetteSettings& settings)
{
  bool found = true;
  for (int i = 0; i < 4; ++i)
  {
    settings.lightPosition[static_cast<std::size_t>(i)] =
      fieldValue(data, "LightPosition", i, found);
  }
  const int kind = static_cast<int>(fieldValue(data, "SilhouetteKind", 0, found));
  settings.caster.mergePoints = fieldValue(data, "MergePoints", 0, found) != 0.0;
  settings.caster.featureAngle = fieldValue(data, "FeatureAngle", 0, found);
  settings.complete = fieldValue(data, "SearchComplete", 0, found) != 0.0;
  settings.kind = static_cast<shadow::SilhouetteKind>(kind);
  return found && kind >= 0 && kind <= static_cast<int>(shadow::SilhouetteKind::Smooth) &&
    std::isfinite(settings.caster.featureAngle) &&
    readLight(settings.lightPosition.data(), settings.light);
}

bool readSilhouette(vtkPolyData* data, const shadow::Caster& caster,
  const shadow::SilhouetteChain& chain, shadow::SilhouetteInput& silhouette)
{
  silhouette.first.push_back(0);
  const vtkIdType count = data->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkDataArray* nodes = data->GetPointData()->GetArray("MeshNodes");
  vtkDataArray* meshPoints = data->GetPointData()->GetArray("MeshPoints");
  vtkDataArray* multiplicity = data->GetCellData()->GetArray("Multiplicity");
  if (!hasShape(nodes, 1, count) || !hasShape(meshPoints, 3, count) ||
    !hasShape(multiplicity, 1, data->GetLines()->GetNumberOfCells()))
  {
    return false;
  }
  silhouette.points.resize(static_cast<std::size_t>(count));
  silhouette.meshPoints.resize(silhouette.points.size());
  silhouette.nodes.resize(silhouette.points.size());
  for (std::size_t i = 0; i < silhouette.points.size(); ++i)
  {
    const vtkIdType id = static_cast<vtkIdType>(i);
    data->GetPoint(id, &silhouette.points[i].x);
    meshPoints->GetTuple(id, &silhouette.meshPoints[i].x);
    const double node = nodes->GetComponent(id, 0);
    if (!(node < static_cast<double>(shadow::None)))
    {
      return false;
    }
    silhouette.nodes[i] = node < 0.0
      ? shadow::None
      : shadow::nodeOfNumber(caster, chain, static_cast<shadow::Index>(node));
    if (node >= 0.0 && silhouette.nodes[i] == shadow::None)
    {
      return false;
    }
  }
  for (vtkIdType cell = 0; cell < data->GetLines()->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    data->GetLines()->GetCellAtId(cell, size, ids);
    const double times = multiplicity->GetComponent(cell, 0);
    if (size < 3 || ids[0] != ids[size - 1] || !(times >= 1.0 && times <= mostTimes))
    {
      return false;
    }
    for (vtkIdType i = 0; i + 1 < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= count)
      {
        return false;
      }
      silhouette.loopPoints.push_back(static_cast<shadow::Index>(ids[i]));
    }
    silhouette.first.push_back(silhouette.loopPoints.size());
    silhouette.multiplicity.push_back(static_cast<int>(times));
  }
  return true;
}

std::string describeUnreadableSilhouette()
{
  return "The silhouette on port 1 lacks its field data or its light: give it the output of "
         "vtkSmoothLightSilhouette.";
}

shadow::Match matchSilhouette(vtkPolyData* data, const SilhouetteSettings& settings,
  const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  shadow::SilhouetteInput& silhouette)
{
  if (!readSilhouette(data, caster, chain, silhouette))
  {
    return shadow::Match::None;
  }
  const shadow::Match match = shadow::match(silhouette, caster, chain);
  // Only a search that says so may have left some of it out.
  return match == shadow::Match::Part && settings.complete ? shadow::Match::None : match;
}

std::string describeForeignSilhouette(vtkPolyData* mesh)
{
  return "The silhouette on port 1 is not that of the mesh on port 0, which has " +
    std::to_string(mesh->GetNumberOfCells()) +
    " cells: connect vtkSmoothLightSilhouette to the same mesh and leave its output as it is.";
}

shadow::SilhouetteInput toInput(const shadow::Caster& caster, const shadow::SilhouetteChain& chain,
  const shadow::SilhouetteLoops& loops)
{
  shadow::SilhouetteInput input;
  shadow::LoopPolylines lines = shadow::makePolylines(caster, chain, loops, {}, smpRangeLoop,
    [&](std::size_t count)
    {
      input.points.resize(count);
      input.meshPoints.resize(count);
      return shadow::PolylineArrays{ input.points.data(), input.meshPoints.data(), nullptr };
    });
  input.nodes = std::move(lines.nodes);
  input.first = std::move(lines.first);
  input.multiplicity = loops.multiplicity;
  input.loopPoints.resize(input.points.size());
  std::iota(input.loopPoints.begin(), input.loopPoints.end(), shadow::Index(0));
  return input;
}

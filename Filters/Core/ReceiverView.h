/// A receiver in the light's frame and charts.
#pragma once

#include "EdgeTable.h"
#include "LightCharts.h"
#include "LightFrame.h"
#include "RangeLoop.h"

namespace shadow
{
/// A surface that shadows fall on.
struct ContourReceiver
{
  const TriangleMesh* mesh;
  const EdgeTable* edges;
};

/// A receiver as the light sees it.
class ReceiverView
{
public:
  ReceiverView(const ContourReceiver& receiver, const LightFrame& frame, const RangeLoop& loop);

  const TriangleMesh& mesh() const { return *this->Receiver.mesh; }
  const EdgeTable& edges() const { return *this->Receiver.edges; }
  const LightFrame& frame() const { return this->Frame; }
  const Vec3& view(Index vertex) const { return this->Views[vertex]; }
  Vec3 place(Index vertex) const { return this->Frame.place(this->mesh().points[vertex]); }

  /// Triangles that face the light, edge-on ones included.
  const std::vector<Index>& lit() const { return this->Lit; }
  bool isLit(Index triangle) const;
  /// Whether light falls on it where nothing is in between: it faces the light and is not edge-on.
  bool isReceiving(Index triangle) const { return this->facing(triangle) > 0.0; }

  /// The box of a triangle in a chart.
  Box2 box(std::size_t chart, Index triangle) const;

private:
  double facing(Index triangle) const;

  ContourReceiver Receiver;
  const LightFrame& Frame;
  std::vector<Vec3> Views;
  std::vector<Box2> Boxes; ///< of each vertex, where there is one chart
  std::vector<Index> Lit;
};
}

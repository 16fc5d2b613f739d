#include "ReceiverView.h"

#include "ExactSum.h"

namespace shadow
{
ReceiverView::ReceiverView(
  const ContourReceiver& receiver, const LightFrame& frame, const RangeLoop& loop)
  : Receiver(receiver)
  , Frame(frame)
  , Views(receiver.mesh->points.size())
  , Boxes(frame.hasOneChart() ? receiver.mesh->points.size() : 0)
{
  loop(this->Views.size(), lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Views[i] = frame.viewOf(receiver.mesh->points[i]);
        if (frame.hasOneChart())
        {
          this->Boxes[i] = LightCharts::boxOf(this->Views[i]);
        }
      }
    });
  this->Lit = selectIndices(
    receiver.mesh->triangles.size(), loop, [&](Index triangle) { return this->isLit(triangle); });
}

double ReceiverView::facing(Index triangle) const
{
  const Triangle& t = this->mesh().triangles[triangle];
  return determinant(this->Views[t[0]], this->Views[t[1]], this->Views[t[2]]);
}

bool ReceiverView::isLit(Index triangle) const
{
  return shadow::isLit(this->facing(triangle));
}

Box2 ReceiverView::box(std::size_t chart, Index triangle) const
{
  const Triangle& t = this->mesh().triangles[triangle];
  if (this->Frame.hasOneChart())
  {
    Box2 box = this->Boxes[t[0]];
    box.add(this->Boxes[t[1]]);
    box.add(this->Boxes[t[2]]);
    return box;
  }
  const std::array<Vec3, 3> views{ this->Views[t[0]], this->Views[t[1]], this->Views[t[2]] };
  return LightCharts::boxIn(chart, views.data(), 3);
}
}

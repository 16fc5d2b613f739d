#include "VolumeRims.h"

#include "ConcaveContour.h"
#include "VolumeCaps.h"

#include <algorithm>

namespace shadow
{
namespace
{
class RimBuilder
{
public:
  RimBuilder(const SilhouetteInput& silhouette, NearEnd& end)
    : TheCaster(end.caster)
    , Chain(end.chain)
    , Silhouette(silhouette)
    , Concave(end.caster, end.chain)
    , VertexCount(end.caster.mesh().points.size())
    , End(end)
  {
  }

  void build()
  {
    this->placePoints();
    std::vector<VolumeRim>& rims = this->End.rims;
    for (std::size_t loop = 0; loop < this->Silhouette.multiplicity.size(); ++loop)
    {
      rims.push_back({ {}, this->Silhouette.multiplicity[loop] });
      forEachStretch(
        this->Silhouette, loop, [&](const Stretch& s) { this->addStretch(s, rims.back()); });
      closeRim(rims.back().points);
      if (rims.back().points.empty())
      {
        rims.pop_back();
      }
    }
  }

private:
  Index nodeAt(std::size_t place) const
  {
    return this->Silhouette.nodes[this->Silhouette.loopPoints[place]];
  }

  bool isOnMesh(Index node) const
  {
    return node < this->VertexCount || this->Chain.kind != SilhouetteKind::Smooth ||
      this->Concave.isEnd(node);
  }

  /// Vertices and crossings on the mesh keep their node numbers. One off the mesh, and each
  /// point between nodes, gets a point of its own.
  void placePoints()
  {
    std::vector<Index> smoothCrossing(this->Chain.crossings.size(), None);
    this->Placed.resize(this->Silhouette.points.size());
    for (std::size_t i = 0; i < this->Silhouette.points.size(); ++i)
    {
      const Index node = this->Silhouette.nodes[i];
      if (node != None && this->isOnMesh(node))
      {
        this->Placed[i] = node;
        continue;
      }
      Index* known = node != None ? &smoothCrossing[node - this->VertexCount] : nullptr;
      if (known && *known != None)
      {
        this->Placed[i] = *known;
        continue;
      }
      this->Placed[i] = static_cast<Index>(
        this->VertexCount + this->Chain.crossings.size() + this->End.points.size());
      this->End.points.push_back(this->Silhouette.points[i]);
      this->End.origins.push_back(static_cast<Index>(i));
      if (known)
      {
        *known = this->Placed[i];
      }
    }
  }

  Index placed(std::size_t place) const
  {
    return this->Placed[this->Silhouette.loopPoints[place]];
  }

  /// Going back the way one came leaves no trace.
  static void append(Index point, std::vector<Index>& rim)
  {
    if (rim.size() >= 2 && rim[rim.size() - 2] == point)
    {
      rim.pop_back();
    }
    else if (rim.empty() || rim.back() != point)
    {
      rim.push_back(point);
    }
  }

  static void closeRim(std::vector<Index>& rim)
  {
    std::size_t begin = 0;
    std::size_t end = rim.size();
    while (end - begin >= 2 && (rim[begin] == rim[end - 1] || rim[begin + 1] == rim[end - 1]))
    {
      begin += rim[begin] != rim[end - 1];
      --end;
    }
    end = end - begin < 2 ? begin : end;
    rim.assign(rim.begin() + static_cast<std::ptrdiff_t>(begin),
      rim.begin() + static_cast<std::ptrdiff_t>(end));
  }

  void addStretch(const Stretch& s, VolumeRim& rim)
  {
    const ConcaveChord* concave = this->Concave.find(this->nodeAt(s.begin), this->nodeAt(s.end));
    if (concave)
    {
      append(concave->from, rim.points);
      if (concave->turnedAway)
      {
        this->goAround(*concave, rim);
      }
      append(concave->to, rim.points);
      return;
    }
    this->addGap(s, rim.multiplicity);
    for (std::size_t i = s.begin; i < s.innerEnd; ++i)
    {
      append(this->placed(i), rim.points);
    }
    append(this->placed(s.end), rim.points);
  }

  /// Along the other sides of the part that the field calls lit.
  void goAround(const ConcaveChord& chord, VolumeRim& rim)
  {
    const bool lit = this->TheCaster.weights().cornersPointOutward(chord.triangle);
    std::vector<Index> part = partOfTriangle(this->TheCaster, this->Chain, chord.triangle, lit);
    std::rotate(part.begin(), std::find(part.begin(), part.end(), chord.from), part.end());
    if (part[1] == chord.to)
    {
      // The chord is the polygon's first side: take the way back.
      std::reverse(part.begin() + 1, part.end());
    }
    for (std::size_t i = 1; i + 1 < part.size(); ++i)
    {
      append(part[i], rim.points);
      if (this->End.cap)
      {
        this->add(part[0], part[i], part[i + 1], VolumePart::Cap, rim.multiplicity);
      }
    }
  }

  /// Two fans, from the mesh's points of the stretch's ends, which meet at its middle point: no
  /// T-junctions with the neighbours.
  void addGap(const Stretch& s, int multiplicity)
  {
    const Index meshFrom = this->nodeAt(s.begin);
    const Index meshTo = this->nodeAt(s.end);
    const std::size_t segments = s.innerEnd - s.begin;
    const auto at = [&](std::size_t i)
    { return i < segments ? this->placed(s.begin + i) : this->placed(s.end); };
    const std::size_t middle = (segments + 1) / 2;
    for (std::size_t i = 0; i < segments; ++i)
    {
      this->add(i < middle ? meshFrom : meshTo, at(i), at(i + 1), VolumePart::Gap, multiplicity);
    }
    this->add(meshFrom, at(middle), meshTo, VolumePart::Gap, multiplicity);
  }

  void add(Index p, Index q, Index r, VolumePart part, int multiplicity)
  {
    if (p != q && q != r && r != p)
    {
      this->End.triangles.push_back({ { p, q, r }, part, multiplicity });
    }
  }

  const Caster& TheCaster;
  const SilhouetteChain& Chain;
  const SilhouetteInput& Silhouette;
  const ConcaveContour Concave;
  const std::size_t VertexCount;
  NearEnd& End;
  std::vector<Index> Placed; ///< the rims' point for each point of the silhouette
};
}

void addRims(const SilhouetteInput& silhouette, NearEnd& end)
{
  RimBuilder(silhouette, end).build();
}
}

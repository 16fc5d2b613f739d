#include "SilhouetteLoops.h"

#include <algorithm>

namespace shadow
{
namespace
{
class LoopTracer
{
public:
  explicit LoopTracer(const std::vector<Piece>& pieces)
    : Pieces(pieces)
  {
    this->compactNodes();
    this->sortByStart();
  }

  SilhouetteLoops trace()
  {
    this->Loops.first.push_back(0);
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      while (this->Remaining[p] > 0 && this->Loops.balanced)
      {
        this->walkFrom(this->From[p]);
      }
    }
    return std::move(this->Loops);
  }

private:
  /// Gives the nodes numbers without large gaps. Crossings have them already; vertices are few of
  /// many.
  void compactNodes()
  {
    Index least = None;
    Index most = 0;
    for (const Piece& p : this->Pieces)
    {
      least = std::min(least, std::min(p.from, p.to));
      most = std::max(most, std::max(p.from, p.to));
    }
    this->From.resize(this->Pieces.size());
    this->To.resize(this->Pieces.size());
    this->Remaining.resize(this->Pieces.size());
    const auto number = [&](const auto& numberOf)
    {
      for (std::size_t p = 0; p < this->Pieces.size(); ++p)
      {
        this->From[p] = numberOf(this->Pieces[p].from);
        this->To[p] = numberOf(this->Pieces[p].to);
        this->Remaining[p] = this->Pieces[p].multiplicity;
      }
    };
    if (!this->Pieces.empty() && most - least < 2 * this->Pieces.size())
    {
      number([&](Index node) { return node - least; });
      this->NodeCount = std::size_t(most - least) + 1;
      return;
    }
    IndexTable table;
    // A node has a piece that starts there, unless the chain is open.
    table.reset(this->Pieces.size());
    number([&](Index node) { return table.placeOf(node); });
    this->NodeCount = table.count();
  }

  void sortByStart()
  {
    this->FirstOut.assign(this->NodeCount + 1, 0);
    for (const Index slot : this->From)
    {
      ++this->FirstOut[slot + 1];
    }
    for (std::size_t i = 1; i < this->FirstOut.size(); ++i)
    {
      this->FirstOut[i] += this->FirstOut[i - 1];
    }
    this->Out.resize(this->Pieces.size());
    this->Cursor.assign(this->FirstOut.begin(), this->FirstOut.end() - 1);
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      this->Out[this->Cursor[this->From[p]]++] = static_cast<Index>(p);
    }
    this->Cursor.assign(this->FirstOut.begin(), this->FirstOut.end() - 1);
    this->PlaceOnPath.assign(this->NodeCount, None);
  }

  /// A piece that leaves a node and is not yet used up, or None.
  Index nextPiece(Index slot)
  {
    Index& cursor = this->Cursor[slot];
    while (cursor < this->FirstOut[slot + 1] && this->Remaining[this->Out[cursor]] == 0)
    {
      ++cursor;
    }
    return cursor < this->FirstOut[slot + 1] ? this->Out[cursor] : None;
  }

  /// Walks until the path is used up, cutting off a loop whenever the walk meets itself.
  void walkFrom(Index slot)
  {
    do
    {
      const Index piece = this->nextPiece(slot);
      if (piece == None)
      {
        this->Loops.balanced = false;
        return;
      }
      this->PlaceOnPath[slot] = static_cast<Index>(this->Path.size());
      this->Path.push_back(piece);
      slot = this->To[piece];
      if (this->PlaceOnPath[slot] != None)
      {
        this->cutLoop(this->PlaceOnPath[slot]);
      }
    } while (!this->Path.empty());
  }

  void cutLoop(Index begin)
  {
    int multiplicity = this->Remaining[this->Path[begin]];
    for (std::size_t i = begin; i < this->Path.size(); ++i)
    {
      multiplicity = std::min(multiplicity, this->Remaining[this->Path[i]]);
    }
    for (std::size_t i = begin; i < this->Path.size(); ++i)
    {
      const Index piece = this->Path[i];
      this->Remaining[piece] -= multiplicity;
      this->PlaceOnPath[this->From[piece]] = None;
      this->Loops.pieces.push_back(piece);
    }
    this->Path.resize(begin);
    this->Loops.first.push_back(this->Loops.pieces.size());
    this->Loops.multiplicity.push_back(multiplicity);
  }

  const std::vector<Piece>& Pieces;
  std::size_t NodeCount = 0;
  std::vector<Index> From, To;  ///< of each piece, compact numbers of nodes
  std::vector<int> Remaining;   ///< multiplicity of each piece that no loop has taken yet
  std::vector<Index> FirstOut, Out, Cursor;
  std::vector<Index> Path;
  std::vector<Index> PlaceOnPath;
  SilhouetteLoops Loops;
};
}

SilhouetteLoops traceLoops(const std::vector<Piece>& pieces)
{
  return LoopTracer(pieces).trace();
}
}

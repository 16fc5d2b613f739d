#include "SilhouetteLoops.h"

#include <algorithm>

namespace shadow
{
namespace
{
class LoopTracer
{
public:
  LoopTracer(const std::vector<Piece>& pieces, std::size_t vertexCount)
    : Pieces(pieces)
  {
    this->compactNodes(vertexCount);
    this->Loops.first.push_back(0);
    this->Loops.pieces.reserve(pieces.size());
  }

  SilhouetteLoops trace()
  {
    if (this->followSingles())
    {
      return std::move(this->Loops);
    }
    this->sortByStart();
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
  /// Gives the nodes numbers without gaps: the crossings as they are, then the vertices.
  void compactNodes(std::size_t vertexCount)
  {
    const Index firstCrossing = static_cast<Index>(vertexCount);
    std::size_t vertices = 0;
    for (const Piece& p : this->Pieces)
    {
      const Index node = std::max(p.from, p.to);
      vertices += p.from < firstCrossing;
      this->NodeCount = node < firstCrossing
        ? this->NodeCount
        : std::max(this->NodeCount, std::size_t(node - firstCrossing) + 1);
    }
    IndexSet numbers;
    numbers.reserve(vertices);
    const auto numberOf = [&](Index node) {
      return node >= firstCrossing
        ? node - firstCrossing
        : static_cast<Index>(this->NodeCount) + numbers.insert(node).place;
    };
    this->From.reserve(this->Pieces.size());
    this->To.reserve(this->Pieces.size());
    this->Remaining.reserve(this->Pieces.size());
    for (const Piece& p : this->Pieces)
    {
      this->From.push_back(numberOf(p.from));
      this->To.push_back(numberOf(p.to));
      this->Remaining.push_back(p.multiplicity);
    }
    this->NodeCount += numbers.size();
  }

  /// Where one piece leaves each node the loops are what comes after what. False where that is not
  /// so, nothing being done then.
  bool followSingles()
  {
    std::vector<Index> following(this->NodeCount, None);
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      if (following[this->From[p]] != None)
      {
        return false;
      }
      following[this->From[p]] = static_cast<Index>(p);
    }
    for (std::size_t p = 0; p < this->Pieces.size() && this->Loops.balanced; ++p)
    {
      const int multiplicity = this->Remaining[p];
      if (multiplicity > 0)
      {
        Index piece = static_cast<Index>(p);
        // A loop comes back to its first piece, all of it with one multiplicity.
        while (piece != None && this->Remaining[piece] == multiplicity)
        {
          this->Remaining[piece] = 0;
          this->Loops.pieces.push_back(piece);
          piece = following[this->To[piece]];
        }
        this->Loops.balanced = piece == p;
        this->Loops.first.push_back(this->Loops.pieces.size());
        this->Loops.multiplicity.push_back(multiplicity);
      }
    }
    return true;
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

SilhouetteLoops traceLoops(const std::vector<Piece>& pieces, std::size_t vertexCount)
{
  return LoopTracer(pieces, vertexCount).trace();
}
}

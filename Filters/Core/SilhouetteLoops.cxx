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
  /// Numbers the nodes at which pieces start in order of appearance, through a hash table.
  void compactNodes()
  {
    unsigned bits = 4;
    while ((std::size_t(1) << bits) < 2 * this->Pieces.size())
    {
      ++bits;
    }
    std::vector<Index> table(std::size_t(1) << bits, None);
    const auto place = [&](Index node)
    {
      // The golden ratio in 32 bits spreads neighbouring numbers.
      std::size_t slot = std::uint32_t(node * 2654435769u) >> (32 - std::min(bits, 32u));
      while (table[slot] != None && this->Nodes[table[slot]] != node)
      {
        slot = (slot + 1) & (table.size() - 1);
      }
      return slot;
    };
    this->From.reserve(this->Pieces.size());
    this->Remaining.reserve(this->Pieces.size());
    for (const Piece& p : this->Pieces)
    {
      Index& number = table[place(p.from)];
      if (number == None)
      {
        number = static_cast<Index>(this->Nodes.size());
        this->Nodes.push_back(p.from);
      }
      this->From.push_back(number);
      this->Remaining.push_back(p.multiplicity);
    }
    this->To.reserve(this->Pieces.size());
    for (const Piece& p : this->Pieces)
    {
      this->To.push_back(table[place(p.to)]);
    }
  }

  void sortByStart()
  {
    this->FirstOut.assign(this->Nodes.size() + 1, 0);
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
    this->PlaceOnPath.assign(this->Nodes.size(), None);
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
      if (piece == None || this->To[piece] == None)
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
  std::vector<Index> Nodes;     ///< distinct starts; the others refer to their places
  std::vector<Index> From, To;  ///< of each piece
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

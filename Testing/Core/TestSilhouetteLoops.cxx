#include "SilhouetteLoops.h"

#include <gtest/gtest.h>

using namespace shadow;

namespace
{
Piece piece(Index from, Index to, int multiplicity = 1)
{
  return { from, to, 0, false, multiplicity };
}

/// Loops run from piece to piece, and together count each as often as it is there.
void expectDecomposition(const std::vector<Piece>& pieces, const SilhouetteLoops& loops)
{
  std::vector<int> counted(pieces.size(), 0);
  for (std::size_t loop = 0; loop < loops.count(); ++loop)
  {
    for (std::size_t i = loops.first[loop]; i < loops.first[loop + 1]; ++i)
    {
      const std::size_t after = i + 1 < loops.first[loop + 1] ? i + 1 : loops.first[loop];
      EXPECT_EQ(pieces[loops.pieces[i]].to, pieces[loops.pieces[after]].from);
      counted[loops.pieces[i]] += loops.multiplicity[loop];
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    EXPECT_EQ(counted[i], pieces[i].multiplicity);
  }
}
}

/// However many of the nodes are vertices.
constexpr std::size_t vertexCounts[] = { 0, 3, 5, 100 };

TEST(SilhouetteLoops, LoopsThatMeetAtANode)
{
  const std::vector<Piece> pieces = { piece(9, 4), piece(4, 7), piece(4, 1), piece(1, 4),
    piece(7, 9) };
  for (const std::size_t vertexCount : vertexCounts)
  {
    const SilhouetteLoops loops = traceLoops(pieces, vertexCount);
    EXPECT_TRUE(loops.balanced);
    EXPECT_EQ(loops.count(), 2u);
    expectDecomposition(pieces, loops);
  }
}

TEST(SilhouetteLoops, LoopsApart)
{
  const std::vector<Piece> pieces = { piece(9, 4), piece(2, 7, 3), piece(4, 1), piece(7, 2, 3),
    piece(1, 9) };
  for (const std::size_t vertexCount : vertexCounts)
  {
    const SilhouetteLoops loops = traceLoops(pieces, vertexCount);
    EXPECT_TRUE(loops.balanced);
    ASSERT_EQ(loops.count(), 2u);
    EXPECT_EQ(loops.multiplicity[0], 1);
    EXPECT_EQ(loops.multiplicity[1], 3);
    expectDecomposition(pieces, loops);
  }
}

TEST(SilhouetteLoops, MultiplicitiesAreShared)
{
  const std::vector<Piece> pieces = { piece(0, 1, 2), piece(1, 0, 1), piece(1, 2), piece(2, 0) };
  const std::vector<Piece> twice = { piece(0, 1, 2), piece(1, 2, 2), piece(2, 0, 2) };
  for (const std::size_t vertexCount : vertexCounts)
  {
    const SilhouetteLoops loops = traceLoops(pieces, vertexCount);
    EXPECT_TRUE(loops.balanced);
    expectDecomposition(pieces, loops);
    EXPECT_EQ(traceLoops(twice, vertexCount).count(), 1u);
    EXPECT_EQ(traceLoops(twice, vertexCount).multiplicity[0], 2);
  }
}

TEST(SilhouetteLoops, OpenChainsAreSeen)
{
  for (const std::size_t vertexCount : vertexCounts)
  {
    EXPECT_FALSE(traceLoops({ piece(0, 1), piece(1, 2) }, vertexCount).balanced);
    EXPECT_FALSE(traceLoops({ piece(0, 1, 2), piece(1, 0) }, vertexCount).balanced);
    EXPECT_FALSE(traceLoops({ piece(0, 1), piece(1, 2), piece(2, 1) }, vertexCount).balanced);
    EXPECT_TRUE(traceLoops({}, vertexCount).balanced);
  }
}

/// Union-find over the numbers below a count.
#pragma once

#include "Geometry.h"

#include <numeric>

namespace shadow
{
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Index(0));
  }

  Index find(Index i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }

  /// The smaller root becomes the common one, so the result does not depend on the order.
  void unite(Index i, Index j)
  {
    i = this->find(i);
    j = this->find(j);
    this->Parent[std::max(i, j)] = std::min(i, j);
  }

  /// Numbers the sets in order of their smallest member; gives each item's set and their count.
  std::vector<Index> number(Index& count)
  {
    std::vector<Index> set(this->Parent.size());
    count = 0;
    for (std::size_t i = 0; i < set.size(); ++i)
    {
      const Index root = this->find(static_cast<Index>(i));
      set[i] = root == i ? count++ : set[root];
    }
    return set;
  }

private:
  std::vector<Index> Parent;
};
}

// Levels of a directed graph: how long the longest chain before each node is. Nodes on a cycle, or
// of a component that something else makes unorderable, share a level.
// Strongly connected components: Tarjan 1972. The number of levels of an acyclic graph is the
// length of its longest chain, the least number of antichains that cover it (Mirsky 1971).
#pragma once

#include <cstdint>
#include <vector>

namespace sb {

struct GraphLevels {
  uint32_t count = 0;           ///< levels: 0 without nodes
  std::vector<uint32_t> level;  ///< of each node, from 0; greater than that of every node before it
  std::vector<uint32_t> component;  ///< of each node: strongly connected component
  std::vector<uint8_t> cyclic;      ///< of each node: others share its component
};

/// `successors[a]` lists every b with an edge a -> b.
GraphLevels graphLevels(const std::vector<std::vector<uint32_t>>& successors);

}  // namespace sb

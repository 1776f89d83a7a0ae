#include "techniques/partition/light_levels.h"

#include <algorithm>

namespace sb {
namespace {

void place(LightLevels& out, const LightNode& node, uint32_t level, bool peeled) {
  if (out.casters.size() <= level) {
    out.casters.resize(level + 1);
    out.peeled.resize(level + 1);
  }
  if (node.casts) {
    out.casters[level].push_back(node.instance);
    if (peeled) out.peeled[level].push_back(node.instance);
  }
  out.receivers.push_back({node.instance, level, peeled});
}

}  // namespace

LightLevels lightLevels(const LightOverlap& overlap, uint32_t cap) {
  const GraphLevels graph = graphLevels(overlap.successors);
  LightLevels out;
  for (size_t i = 0; i < overlap.nodes.size(); ++i) {
    const bool beyond = graph.count > cap && graph.level[i] >= cap - 1;
    const bool peeled = graph.cyclic[i] || overlap.nodes[i].mayShadowItself() || beyond;
    place(out, overlap.nodes[i], std::min(graph.level[i], cap - 1), peeled);
  }
  // A level that only receives ends the list: nothing is drawn for it.
  while (!out.casters.empty() && out.casters.back().empty()) {
    out.casters.pop_back();
    out.peeled.pop_back();
  }
  return out;
}

LightLevels onePeeledLevel(const LightOverlap& overlap) {
  LightLevels out;
  for (const LightNode& node : overlap.nodes) place(out, node, 0, true);
  return out;
}

}  // namespace sb

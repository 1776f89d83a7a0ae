// Levels of graphs against brute force, outlines, and the rule of batches against its definition.
#include "techniques/partition/graph_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "techniques/partition/light_batches.h"
#include "techniques/partition/light_levels.h"
#include "techniques/scene/geometry/hull2.h"

namespace sb {
namespace {

using Edges = std::vector<std::vector<uint32_t>>;

/// Interval orders: a lies before b when their footprints overlap and a is nearer.
Edges randomIntervals(std::mt19937& random, uint32_t n) {
  std::vector<std::pair<int, int>> spans;
  for (uint32_t i = 0; i < n; ++i) {
    const int low = int(random() % 50);
    spans.emplace_back(low, low + 1 + int(random() % 12));
  }
  Edges edges(n);
  for (uint32_t a = 0; a < n; ++a)  // the number is the depth
    for (uint32_t b = a + 1; b < n; ++b)
      if (spans[a].first < spans[b].second && spans[b].first < spans[a].second)
        edges[a].push_back(b);
  return edges;
}

/// Renames nodes, so that numbers say nothing.
Edges shuffled(const Edges& edges, std::mt19937& random) {
  std::vector<uint32_t> to(edges.size());
  for (uint32_t i = 0; i < to.size(); ++i) to[i] = i;
  std::ranges::shuffle(to, random);
  Edges out(edges.size());
  for (uint32_t a = 0; a < edges.size(); ++a)
    for (const uint32_t b : edges[a]) out[to[a]].push_back(to[b]);
  return out;
}

uint32_t longestFrom(const Edges& edges, uint32_t a, std::vector<uint32_t>& known) {
  if (known[a]) return known[a];
  uint32_t best = 1;
  for (const uint32_t b : edges[a]) best = std::max(best, 1 + longestFrom(edges, b, known));
  return known[a] = best;
}

bool reaches(const Edges& edges, uint32_t from, uint32_t to) {
  std::vector<uint8_t> seen(edges.size());
  std::vector<uint32_t> open = {from};
  while (!open.empty()) {
    const uint32_t a = open.back();
    open.pop_back();
    for (const uint32_t b : edges[a]) {
      if (b == to) return true;
      if (!seen[b]) seen[b] = 1, open.push_back(b);
    }
  }
  return false;
}

TEST(GraphLevels, CountIsTheLongestChain) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const Edges edges = shuffled(randomIntervals(random, 1 + random() % 40), random);
    const GraphLevels levels = graphLevels(edges);
    std::vector<uint32_t> known(edges.size());
    uint32_t longest = 0;
    for (uint32_t a = 0; a < edges.size(); ++a) {
      longest = std::max(longest, longestFrom(edges, a, known));
      EXPECT_FALSE(levels.cyclic[a]);
      for (const uint32_t b : edges[a]) EXPECT_LT(levels.level[a], levels.level[b]);
    }
    EXPECT_EQ(levels.count, longest);
  }
}

TEST(GraphLevels, CyclesShareALevelAndAreMarked) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const uint32_t n = 2 + random() % 12;
    Edges edges(n);
    for (uint32_t e = 0; e < 2 * n; ++e) {
      const uint32_t a = uint32_t(random() % n), b = uint32_t(random() % n);
      if (a != b) edges[a].push_back(b);
    }
    const GraphLevels levels = graphLevels(edges);
    for (uint32_t a = 0; a < n; ++a) {
      bool cyclic = false;
      for (uint32_t b = 0; b < n; ++b) {
        const bool both = a != b && reaches(edges, a, b) && reaches(edges, b, a);
        EXPECT_EQ(both, a != b && levels.component[a] == levels.component[b]);
        cyclic |= both;
        if (both) EXPECT_EQ(levels.level[a], levels.level[b]);
        if (!both && a != b && reaches(edges, a, b)) EXPECT_LT(levels.level[a], levels.level[b]);
      }
      EXPECT_EQ(levels.cyclic[a] != 0, cyclic);
    }
  }
}

TEST(GraphLevels, ALongChainNeedsNoDeepStack) {
  Edges edges(300000);
  for (uint32_t i = 0; i + 1 < edges.size(); ++i) edges[i].push_back(i + 1);
  EXPECT_EQ(graphLevels(edges).count, 300000u);
  EXPECT_EQ(graphLevels({}).count, 0u);
}

TEST(Hull, OverlapIsOfInteriors) {
  const auto square = [](double x, double y, double r) {
    return convexHull({{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}, {x, y}});
  };
  EXPECT_EQ(square(0, 0, 1).size(), 4u);
  EXPECT_TRUE(overlap(square(0, 0, 1), square(1.5, 0, 1)));
  EXPECT_FALSE(overlap(square(0, 0, 1), square(2, 0, 1)));  // they touch
  EXPECT_TRUE(overlap(square(0, 0, 3), square(0.5, 0.5, 1)));
  // Boxes overlap, outlines do not.
  EXPECT_FALSE(overlap(convexHull({{0, 0}, {4, 0}, {0, 4}}), convexHull({{4, 4}, {4, 1}, {1, 4}})));
  EXPECT_FALSE(overlap(convexHull({{0, 0}, {1, 1}, {2, 2}}), square(1, 1, 1)));  // no area
}

/// A graph as one view shows it; every node casts and receives.
LightOverlap view(Edges edges) {
  LightOverlap out;
  for (uint32_t i = 0; i < edges.size(); ++i) {
    out.nodes.push_back({.instance = i, .casts = true, .receives = true});
    out.nodes.back().plane = Plane{};
  }
  out.successors = std::move(edges);
  return out;
}

TEST(LightBatches, TheTrapIsSeen) {
  // m1 = 0, A' = 1, k = 2: k before m1, A' before k; m1 and A' apart (spec 05, worked example).
  const auto batches = lightBatches(std::vector<uint32_t>{0, 1}, {view({{}, {2}, {0}})});
  EXPECT_EQ(batches.size(), 2u);
  EXPECT_EQ(lightBatches(std::vector<uint32_t>{0, 1}, {view({{}, {}, {0}})}).size(), 1u);
}

TEST(LightBatches, EveryBatchIsLegalAndNoneIsShortOfNeed) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const uint32_t n = 2 + random() % 14;
    const LightOverlap graph = view(shuffled(randomIntervals(random, n), random));
    const auto edge = [&](uint32_t a, uint32_t b) {
      return std::ranges::find(graph.successors[a], b) != graph.successors[a].end();
    };
    const auto legal = [&](const std::vector<uint32_t>& batch) {
      for (const uint32_t m : batch) {
        // What darkens m in the map of the batch must be what lies before m, where both are.
        for (const uint32_t k : castersBefore(graph, batch))
          if (edge(m, k)) return false;
        for (const uint32_t other : batch)
          if (edge(m, other)) return false;
      }
      return true;
    };
    std::vector<uint32_t> order(n);
    for (uint32_t i = 0; i < n; ++i) order[i] = i;
    std::ranges::shuffle(order, random);
    const auto batches = lightBatches(order, {graph});
    std::vector<uint32_t> all;
    for (size_t b = 0; b < batches.size(); ++b) {
      EXPECT_TRUE(legal(batches[b]));
      all.insert(all.end(), batches[b].begin(), batches[b].end());
      if (b + 1 == batches.size()) break;
      std::vector<uint32_t> longer = batches[b];
      longer.push_back(batches[b + 1].front());
      EXPECT_FALSE(legal(longer));
    }
    EXPECT_EQ(all, order);
  }
}

TEST(LightLevels, ACapKeepsTheNumberOfMaps) {
  const LightOverlap chain = view({{1}, {2}, {3}, {4}, {}});
  const LightLevels all = lightLevels(chain, 8), capped = lightLevels(chain, 3);
  EXPECT_EQ(all.casters.size(), 5u);
  for (const auto& peeled : all.peeled) EXPECT_TRUE(peeled.empty());
  ASSERT_EQ(capped.casters.size(), 3u);
  EXPECT_EQ(capped.casters[2], (std::vector<uint32_t>{2, 3, 4}));
  EXPECT_EQ(capped.peeled[2], (std::vector<uint32_t>{2, 3, 4}));
  EXPECT_TRUE(capped.peeled[1].empty());
}

}  // namespace
}  // namespace sb

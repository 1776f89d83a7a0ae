#include "techniques/partition/graph_levels.h"

#include <algorithm>

namespace sb {
namespace {

constexpr uint32_t kUnseen = ~0u;

/// Tarjan's algorithm with its recursion on a stack of our own: chains are as long as scenes are
/// deep. Components come in an order in which every edge leads to the same or an earlier one.
class Components {
 public:
  explicit Components(const std::vector<std::vector<uint32_t>>& successors)
      : m_successors(successors),
        of(successors.size(), kUnseen),
        m_index(successors.size(), kUnseen),
        m_low(successors.size()) {
    for (uint32_t i = 0; i < successors.size(); ++i)
      if (m_index[i] == kUnseen) visit(i);
  }

 private:
  struct Call {
    uint32_t node;
    size_t next = 0;  ///< successor to look at
  };
  const std::vector<std::vector<uint32_t>>& m_successors;

 public:
  std::vector<uint32_t> of;
  uint32_t count = 0;

 private:
  void enter(uint32_t node) {
    m_index[node] = m_low[node] = m_next++;
    m_open.push_back(node);
    m_calls.push_back({node});
  }

  void visit(uint32_t root) {
    enter(root);
    while (!m_calls.empty()) {
      Call& call = m_calls.back();
      const uint32_t a = call.node;
      if (call.next < m_successors[a].size()) {
        const uint32_t b = m_successors[a][call.next++];
        if (m_index[b] == kUnseen)
          enter(b);
        else if (of[b] == kUnseen)
          m_low[a] = std::min(m_low[a], m_index[b]);
        continue;
      }
      m_calls.pop_back();
      if (!m_calls.empty()) {
        uint32_t& parent = m_low[m_calls.back().node];
        parent = std::min(parent, m_low[a]);
      }
      if (m_low[a] == m_index[a]) close(a);
    }
  }

  void close(uint32_t root) {
    for (uint32_t node = kUnseen; node != root;) {
      node = m_open.back();
      m_open.pop_back();
      of[node] = count;
    }
    ++count;
  }

  std::vector<uint32_t> m_index, m_low, m_open;
  std::vector<Call> m_calls;
  uint32_t m_next = 0;
};

}  // namespace

GraphLevels graphLevels(const std::vector<std::vector<uint32_t>>& successors) {
  const Components components(successors);
  const size_t n = successors.size();
  std::vector<std::vector<uint32_t>> members(components.count);
  for (uint32_t i = 0; i < n; ++i) members[components.of[i]].push_back(i);
  GraphLevels out{.level = std::vector<uint32_t>(n),
                  .component = components.of,
                  .cyclic = std::vector<uint8_t>(n)};
  std::vector<uint32_t> level(components.count);
  for (uint32_t c = components.count; c-- > 0;) {  // what comes before is known by now
    for (const uint32_t a : members[c]) {
      out.level[a] = level[c];
      out.cyclic[a] = members[c].size() > 1;
      for (const uint32_t b : successors[a])
        if (components.of[b] != c)
          level[components.of[b]] = std::max(level[components.of[b]], level[c] + 1);
    }
    out.count = std::max(out.count, level[c] + 1);
  }
  return out;
}

}  // namespace sb

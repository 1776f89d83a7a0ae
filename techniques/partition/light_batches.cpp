#include "techniques/partition/light_batches.h"

#include <algorithm>
#include <map>
#include <set>

namespace sb {
namespace {

/// The graph of one view both ways, by instance, and what the batch under way has gathered.
class ViewState {
 public:
  explicit ViewState(const LightOverlap& view) {
    for (uint32_t a = 0; a < view.nodes.size(); ++a)
      for (const uint32_t b : view.successors[a]) {
        const uint32_t from = view.nodes[a].instance, to = view.nodes[b].instance;
        m_behind[from].insert(to);
        m_before[to].insert(from);
      }
  }

  void clear() {
    m_members.clear();
    m_allBefore.clear();
    m_allBehind.clear();
  }

  bool accepts(uint32_t i) const {
    const auto &before = at(m_before, i), &behind = at(m_behind, i);
    const auto clashes = [](const std::set<uint32_t>& a, const std::set<uint32_t>& b) {
      return std::ranges::any_of(a, [&](uint32_t x) { return b.contains(x); });
    };
    return !clashes(before, m_members) && !clashes(behind, m_members) &&
           !clashes(before, m_allBehind) && !clashes(behind, m_allBefore);
  }

  void add(uint32_t i) {
    m_members.insert(i);
    m_allBefore.insert(at(m_before, i).begin(), at(m_before, i).end());
    m_allBehind.insert(at(m_behind, i).begin(), at(m_behind, i).end());
  }

 private:
  using Sets = std::map<uint32_t, std::set<uint32_t>>;
  static const std::set<uint32_t>& at(const Sets& sets, uint32_t i) {
    static const std::set<uint32_t> kNone;
    const auto it = sets.find(i);
    return it == sets.end() ? kNone : it->second;
  }
  Sets m_before, m_behind;
  std::set<uint32_t> m_members, m_allBefore, m_allBehind;
};

}  // namespace

std::vector<std::vector<uint32_t>> lightBatches(std::span<const uint32_t> order,
                                                const std::vector<LightOverlap>& views) {
  std::vector<ViewState> states(views.begin(), views.end());
  std::vector<std::vector<uint32_t>> batches;
  for (const uint32_t i : order) {
    const auto accepts = [&](const ViewState& s) { return s.accepts(i); };
    if (batches.empty() || !std::ranges::all_of(states, accepts)) {
      batches.emplace_back();
      for (ViewState& s : states) s.clear();
    }
    batches.back().push_back(i);
    for (ViewState& s : states) s.add(i);
  }
  return batches;
}

std::vector<uint32_t> castersBefore(const LightOverlap& view, std::span<const uint32_t> members) {
  std::vector<uint32_t> out;
  for (size_t a = 0; a < view.nodes.size(); ++a)
    if (view.nodes[a].casts && std::ranges::any_of(view.successors[a], [&](uint32_t b) {
          return std::ranges::find(members, view.nodes[b].instance) != members.end();
        }))
      out.push_back(view.nodes[a].instance);
  return out;
}

}  // namespace sb

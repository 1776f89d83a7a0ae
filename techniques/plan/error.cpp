#include "techniques/plan/error.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace sb {
namespace {

size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t(0));
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const bool same = std::tolower((unsigned char)a[i - 1]) == std::tolower((unsigned char)b[j - 1]);
      const size_t substitute = diagonal + (same ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row.back();
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = char(std::tolower((unsigned char)c));
  return out;
}

}  // namespace

std::vector<std::string> nearestNames(std::string_view name, std::span<const std::string> names,
                                      size_t count) {
  std::vector<std::pair<size_t, std::string>> ranked;
  for (const std::string& candidate : names) {
    // What holds the word as it is, but for its case, comes before what resembles it.
    const auto at = name.empty() ? std::string::npos : lower(candidate).find(lower(name));
    const size_t rank = at == 0 ? 0 : at != std::string::npos ? 1 : 2 + editDistance(name, candidate);
    ranked.emplace_back(rank, candidate);
  }
  std::ranges::sort(ranked);
  std::vector<std::string> nearest;
  for (const auto& [distance, candidate] : ranked)
    if (nearest.size() < count) nearest.push_back(candidate);
  return nearest;
}

std::string unknownName(std::string_view kind, std::string_view name,
                        std::span<const std::string> names) {
  std::string text = "unknown " + std::string(kind) + " '" + std::string(name) + "'";
  const auto nearest = nearestNames(name, names);
  if (nearest.empty()) return text + "; there are none";
  text += "; did you mean ";
  for (size_t i = 0; i < nearest.size(); ++i)
    text += (i == 0 ? "" : i + 1 == nearest.size() ? " or " : ", ") + nearest[i];
  return text + "?";
}

}  // namespace sb

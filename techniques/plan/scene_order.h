// Lists of parts of a scene (instances, media), in scene order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace sb {

/// Adds what `to` lacks of `from`; both are in scene order.
inline void addAll(std::vector<uint32_t>& to, const std::vector<uint32_t>& from) {
  std::vector<uint32_t> both;
  std::ranges::set_union(to, from, std::back_inserter(both));
  to = std::move(both);
}

/// Those of `list` that are in `all` too; both are in scene order.
inline void keepCommon(std::vector<uint32_t>& list, const std::vector<uint32_t>& all) {
  std::vector<uint32_t> common;
  std::ranges::set_intersection(list, all, std::back_inserter(common));
  list = std::move(common);
}

}  // namespace sb

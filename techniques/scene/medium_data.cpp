#include "techniques/scene/medium_data.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sb {

using glm::dvec3;

double greatestDensity(const Medium& medium) {
  if (medium.kind != MediumKind::Grid) return 1;
  return double(*std::ranges::max_element(medium.density));
}

double greatestDepth(const Medium& medium) {
  const glm::dmat3 edges(medium.boxToWorld);
  double longest = 0;
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      longest = std::max(longest, glm::length(edges * dvec3(1, y, z)));
  const glm::vec3& k = medium.extinction;
  return double(std::max({k.r, k.g, k.b})) * greatestDensity(medium) * longest;
}

glm::dmat4 toBox(const Medium& medium, const dvec3& eye) {
  glm::dmat4 toRelative = medium.boxToWorld;
  toRelative[3] -= glm::dvec4(eye, 0);
  return glm::inverse(toRelative);
}

gpu::SmokeShape smokeShape(const Medium& medium) {
  // Each seed begins elsewhere in its sway; noise rises by two cells a second (spec 14).
  const double start = gpu::latticeValue(glm::uvec3(0), medium.seed);
  const double risen = 2 * medium.time, cells = std::floor(risen);
  const double turns = start + medium.time / 6.283185307179586;
  return {.turn = turns - std::floor(turns),
          .shift = risen - cells,
          .drift = uint32_t(int64_t(cells)),
          .seed = medium.seed};
}

double gridDensity(const Medium& medium, const dvec3& place) {
  const dvec3 last(medium.size - 1u);
  const dvec3 at = glm::clamp(place * dvec3(medium.size) - 0.5, dvec3(0), last);
  const glm::uvec3 low(at);
  const glm::uvec3 high = glm::min(low + 1u, medium.size - 1u);
  const dvec3 f = at - dvec3(low);
  const auto value = [&](uint32_t x, uint32_t y, uint32_t z) {
    return double(medium.density[(size_t(z) * medium.size.y + y) * medium.size.x + x]);
  };
  const auto row = [&](uint32_t y, uint32_t z) {
    return glm::mix(value(low.x, y, z), value(high.x, y, z), f.x);
  };
  return glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), f.y),
                  glm::mix(row(low.y, high.z), row(high.y, high.z), f.y), f.z);
}

gpu::MediumData mediumData(const Medium& medium, const dvec3& eye) {
  const glm::dmat4 rows = glm::transpose(toBox(medium, eye));
  const gpu::SmokeShape smoke = smokeShape(medium);
  return {.toBox0 = glm::vec4(rows[0]),
          .toBox1 = glm::vec4(rows[1]),
          .toBox2 = glm::vec4(rows[2]),
          .extinction = glm::vec4(medium.extinction, medium.anisotropy),
          .albedo = glm::vec4(medium.albedo, 0),
          .smoke = glm::vec4(float(smoke.turn), float(smoke.shift), 0, 0),
          .ids = {uint32_t(medium.kind), smoke.seed, smoke.drift, 0}};
}

gpu::MediaBlock mediaBlock(std::span<const Medium> media, const dvec3& eye) {
  assert(media.size() <= kMaxMedia);
  gpu::MediaBlock block{};
  block.count.x = uint32_t(media.size());
  for (size_t i = 0; i < media.size(); ++i) block.media[i] = mediumData(media[i], eye);
  return block;
}

}  // namespace sb

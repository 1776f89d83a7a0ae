#include "suites/truth/lights/scrambles.h"

#include "techniques/scene/light_area.h"

namespace sb {
namespace {

uint32_t reversed(uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

/// The finalizer of MurmurHash3: numbers that are unrelated to one another.
uint32_t mixed(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85ebca6bu;
  x = (x ^ (x >> 13)) * 0xc2b2ae35u;
  return x ^ (x >> 16);
}

/// Each bit is flipped or not by a hash of those above it.
uint32_t scrambled(uint32_t x, uint32_t seed) {
  x = reversed(x);
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return reversed(x);
}

ScrambledPlaces makePlaces(glm::dvec2 (*place)(const glm::dvec2&)) {
  ScrambledPlaces places;
  for (uint32_t k = 0; k < kScrambles; ++k)
    for (uint32_t i = 0; i < kScrambledPoints; ++i) {
      const glm::uvec2 p = sequencePoint(i);
      const glm::uvec2 q(scrambled(p.x, mixed(2 * k + 1)), scrambled(p.y, mixed(2 * k + 2)));
      places[k].push_back(place((glm::dvec2(q) + 0.5) * 0x1p-32));
    }
  return places;
}

}  // namespace

const ScrambledPlaces& scrambledSquare() {
  static const ScrambledPlaces places = makePlaces(onSquare);
  return places;
}

const ScrambledPlaces& scrambledDisc() {
  static const ScrambledPlaces places = makePlaces(onDisc);
  return places;
}

}  // namespace sb

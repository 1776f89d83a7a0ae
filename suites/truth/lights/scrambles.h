// Places on lights that the truth samples: 16 scrambles of the (0,2)-sequence, each a
// (0,2)-sequence again. Digits are permuted depending on those before (Owen, "Randomly Permuted
// (t,m,s)-Nets and (t,s)-Sequences", 1995; by hashing, Burley, "Practical Hash-based Owen
// Scrambling", JCGT 2020): bits that are merely flipped leave diagonals that shadows' edges meet in
// one phase in all scrambles, so that their spread tells less than the error. Fixed numbers: the
// same on every machine.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace sb {

constexpr uint32_t kScrambles = 16;
constexpr uint32_t kScrambledPoints = 4096;  ///< of each

using ScrambledPlaces = std::array<std::vector<glm::dvec2>, kScrambles>;
/// Uniform in [-1, 1]^2; made when first asked for.
const ScrambledPlaces& scrambledSquare();
/// Uniform in the unit disc.
const ScrambledPlaces& scrambledDisc();

}  // namespace sb

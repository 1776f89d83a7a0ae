// Tiles of noise that shaders read instead of hashing. Contents follow from our hash alone; each is
// made once a process, when it is first asked for.
#pragma once

#include <cstdint>
#include <vector>

namespace sb {

/// Width of whiteTile and blueTile; powers of two.
constexpr uint32_t kWhiteWidth = 256;
constexpr uint32_t kBlueWidth = 64;
constexpr uint32_t kSourceWidth = 2048;

/// One number of each of W^2 equal parts of [0,1), 24 bits each, in random order: over all places
/// exactly uniform, at any two places as good as independent.
const std::vector<float>& whiteTile();

/// Ranks 0 .. W^2 - 1 over W^2 by void and cluster (Ulichney 1993): the texels below any threshold
/// are spread evenly over the tile, which repeats without seams.
const std::vector<float>& blueTile();

/// Four channels of 8 bits, as Modisett's program reads them.
const std::vector<uint8_t>& sourceTile();

}  // namespace sb

// The loops of a silhouette (thesis of the third source document, section 4.4): the outline of each
// connected piece of what casts. A piece with a hole has one loop for both of its outlines.
#pragma once

#include "techniques/volumes/silhouette.h"

namespace sb {

/// Which items of each part are a loop's.
struct ItemRange {
  uint32_t first = 0, count = 0;
};
using SilhouetteLoop = std::array<ItemRange, VOLUME_PARTS>;

/// Sorts items so that those of a loop follow one another. `silhouette`: with both kinds of caps.
std::vector<SilhouetteLoop> sortByLoops(const Mesh& mesh, const EdgeMesh& edges,
                                        Silhouette& silhouette);

}  // namespace sb

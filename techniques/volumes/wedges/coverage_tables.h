// The source's tables of the share of a disc beyond an edge (spec 08, E3; the thesis,
// section 4.2.2): by the distance of the edge's line from the centre and those of its ends from the
// foot of the centre, all in 0..1 and without sign; one table for edges whose ends lie on one side
// of the foot, one for others. Between the nodes they are filtered, across a jump at (0, 0) too:
// off by up to .135 at 32 nodes.
#pragma once

#include "techniques/draw/context.h"

namespace sb {

struct CoverageTables {
  rhi::Texture oneSide, bothSides;  ///< R16F
  rhi::Sampler sampler;
};
/// `size`: nodes along each axis.
CoverageTables coverageTables(rhi::Device& device, uint32_t size);

}  // namespace sb

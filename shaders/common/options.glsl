// Branches that exist only when the scene calls for them (specialization constants 0..15; a shadow
// technique's own are 16..31, a transparency technique's 32..47, a light technique's 48..63).
layout(constant_id = 0) const bool kTextured = false;       // any material has a texture
layout(constant_id = 1) const bool kNormalMaps = false;     // a visible material has a normal map
layout(constant_id = 2) const bool kMasked = false;         // this pipeline discards by alpha mask
layout(constant_id = 3) const bool kTriangleOrder = false;  // triangles come in an order of their own
layout(constant_id = 4) const bool kCoplanar = false;       // surfaces lie over others in one plane

// Every light that touches the view, at every point: no passes, no memory, one step a light and
// point. What other loops must give the same picture as.
#include "techniques/render/registry.h"

namespace sb {
namespace {

class AllLights final : public LightTechnique {};

REGISTER_TECHNIQUE(LightTechnique, AllLights,
                   (TechniqueInfo{.name = "AllLights",
                                  .folder = "all_lights",
                                  .title = "Every light at every point",
                                  .paper = "the loop that others are compared with",
                                  .represents = {},
                                  .error = "it leaves out no light"}));

}  // namespace
}  // namespace sb

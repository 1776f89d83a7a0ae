// No shadows at all: the baseline that every cost is compared with. Costs the shading alone; wrong
// wherever anything casts a shadow.
#include "techniques/maps/shadow_maps.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class NoShadows final : public ShadowTechnique {
 public:
  void prepare(const Context&) override {}
  void record(Frame&) override {}
  VisibilityInputs inputs() const override { return {}; }
};

REGISTER_TECHNIQUE(ShadowTechnique, NoShadows,
                   (TechniqueInfo{.name = "none",
                                  .folder = "none",
                                  .title = "No shadows",
                                  .paper = "the baseline of every cost",
                                  .represents = kShadingEffects,
                                  .error = "everything a shadow would darken is lit",
                                  .baseline = true}));

}  // namespace
}  // namespace sb

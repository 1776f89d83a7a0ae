// Colour maps of translucent casters for CompositedTranslucent (spec 05): how casters are spread
// over maps, and which of them each receiver reads. Two ways, each with two partitions:
//   LevelMaps  maps that serve every receiver of a frame: levels of the overlap graph, or layers
//              peeled from the light
//   PartMaps   one map, made anew between the camera's draws: for batches of receivers, or for each
#pragma once

#include <memory>

#include "techniques/maps/opaque_casters.h"
#include "techniques/maps/translucent_maps.h"

namespace sb {

class ColourMaps {
 public:
  virtual ~ColourMaps() = default;
  /// The view has moved to another step of its path.
  virtual void moved() = 0;
  /// Passes of one light view, after its opaque depth; and those after all views.
  virtual void record(Frame& frame, size_t view) = 0;
  virtual void recordLast(Frame&) {}
  /// See ShadowTechnique.
  virtual std::span<const std::vector<uint32_t>> parts() const { return {}; }
  virtual void recordPart(Frame&, size_t) {}

  /// What a receiver reads: 1 + layer of the colour map (0: none), first peeled layer, their number
  /// (shaders/composited_translucent/visibility.glsl). Of one that lies behind every caster before
  /// the first opaque surface:
  virtual glm::uvec4 behindAll(size_t view) const = 0;
  /// Sets those of a view's others, by instance.
  virtual void addReceivers(size_t, std::span<glm::uvec4>) const {}

  /// Maps that shaders read; null: none of that kind.
  struct Maps {
    rhi::TextureId colour, nearest, peeledDepth, peeledColour;
  };
  virtual Maps maps() const = 0;
  /// Some step has peeled layers.
  virtual bool peels() const { return false; }
};

/// What the two kinds are made of; all of it must outlive them.
struct ColourMapInputs {
  const Context& context;
  ShadowMaps& maps;
  OpaqueCasters& opaque;
};

/// Knob `partition`: levels, peeled. Knob `levels`: most of either.
std::unique_ptr<ColourMaps> makeLevelMaps(const ColourMapInputs& inputs);
/// Knob `partition`: batches, source.
std::unique_ptr<ColourMaps> makePartMaps(const ColourMapInputs& inputs);

}  // namespace sb

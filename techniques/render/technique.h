// What a technique is. Three kinds of plug-in answer three questions:
//   ShadowTechnique        which fraction of a light's RGB radiance arrives at a receiver
//   TransparencyTechnique  in which order translucent surfaces meet the camera
//   LightTechnique         which lights may reach a point in view
// Each is one .cpp with a REGISTER_ line at its end and one folder of shaders; nothing else in the
// program names it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "techniques/draw/context.h"
#include "techniques/draw/frame/frame.h"
#include "techniques/plan/lookup_reach.h"

namespace sb {

class CameraPass;

/// Effects that shading represents whatever the technique.
constexpr EffectSet kShadingEffects = {Effect::MultipleLights, Effect::LocalLights,
                                       Effect::NormalMaps, Effect::Emission};

/// What a technique says of itself: read by the matrix, the help text, the README and the reports.
struct TechniqueInfo {
  std::string name;    ///< as users type it: "CSSM2"
  std::string folder;  ///< of its shaders: "cssm2"
  std::string title;   ///< one line for people
  std::string paper;   ///< authors, year, section
  EffectSet represents;
  std::vector<rhi::Feature> requires_;
  /// What a device must have besides where the scene calls for an effect.
  std::map<Effect, rhi::Feature> requiresFor;
  std::vector<KnobInfo> knobs;
  std::string error;  ///< what its error is by construction (spec 16's table)
  bool stochastic = false;
  bool baseline =
      false;            ///< of shadow techniques one: without shadows, what costs are told against
  bool tracer = false;  ///< the truth's own, which draws on no device and is in no registry
  /// Hard cases (suites/stability) that it does not pass by construction, and why: by id, or by
  /// "id knob:value" for one variant.
  std::map<std::string, std::string> breaksIn;
  /// Shadow techniques: with these knobs maps change between translucent surfaces, so that the
  /// transparency technique must be able to draw them part by part. Null: never.
  std::function<bool(const Knobs&)> drawsInParts;
  /// Why these knobs do not go together, or "". Null: any do.
  std::function<std::string(const Knobs&)> refuses;
  /// Transparency techniques: with these knobs parts can be drawn one after another. Null: never.
  std::function<bool(const Knobs&)> drawsParts;
  /// Shadow techniques that answer in screen space, for one layer of receivers at a time:
  /// recordReceivers is called for each layer that is shaded.
  bool receiversByLayer = false;
  /// Transparency techniques that shade layer by layer, each with its depth known beforehand
  /// (CameraPass::recordLayer). With others, translucent surfaces show no shadow of a technique that
  /// answers by layers: Effect::TranslucentReceivers is unrepresented.
  bool handsOutLayers = false;
};

/// The plug-ins that draw a cell together, one of each kind. None may be null.
struct TechniqueSet {
  const TechniqueInfo* shadow = nullptr;
  const TechniqueInfo* transparency = nullptr;
  const TechniqueInfo* lights = nullptr;
  std::array<const TechniqueInfo*, 3> all() const { return {shadow, transparency, lights}; }
};

/// What they represent together.
EffectSet representedBy(const TechniqueSet& set);

/// Knobs of all three: names are unique across them.
std::vector<KnobInfo> knobsOf(const TechniqueSet& set);

/// Why a device cannot run them with these knobs on a scene that calls for `present`, or nothing.
std::optional<rhi::Skip> unsupported(const rhi::Device& device, const TechniqueSet& set,
                                     const Knobs& knobs, EffectSet present);

/// Receivers of which a pixel holds one at most.
struct ReceiverLayer {
  /// D32FloatS8, as large as the picture: the depth of its surfaces (1 near .. 0 far), 0 where
  /// there is none. Read only; the stencil holds nothing, and is the technique's until it returns.
  rhi::TextureId depth;
  /// 0: the first opaque surface; 1, 2, ..: from the eye.
  uint32_t index = 0;
};

/// What the shaders that ask `lightVisibility` need from the technique.
struct VisibilityInputs {
  std::vector<rhi::Binding> bindings;
  std::vector<rhi::ResourceUse> reads;
  std::vector<rhi::SpecConstant> constants;  ///< ids 16..31
  /// Of the shaders, where it is not the technique's own: lookups into other kinds of texture.
  std::string folder = {};
};

class ShadowTechnique {
 public:
  virtual ~ShadowTechnique() = default;
  /// Creates pipelines, maps and buffers for one scene view; runs once, outside timed regions.
  virtual void prepare(const Context& context) = 0;
  /// Within a frame, before `record`: what moves (SceneView::moving) is at its next step.
  /// Context::view shows it and has refitted its light views; recompute what else depends on where
  /// camera, instances and lights are, and write it through the frame's commands. Buffers and
  /// layers made in `prepare` must serve every step of the path.
  virtual void moved(Frame&) {}
  /// Records the passes before the camera's (none when the plan calls for none).
  virtual void record(Frame& frame) = 0;
  /// Records the passes that answer for one layer of receivers; its surfaces ask next. After
  /// `record`, and only with TechniqueInfo::receiversByLayer.
  virtual void recordReceivers(Frame&, const ReceiverLayer&) {}
  virtual VisibilityInputs inputs() const = 0;
  /// Groups of translucent instances that need maps of their own, in the order of drawing; empty
  /// when the maps of `record` serve every receiver. Only with TechniqueInfo::drawsInParts.
  virtual std::span<const std::vector<uint32_t>> parts() const { return {}; }
  /// Records the passes that make the maps of one part, after those of `record` and of all parts
  /// before it.
  virtual void recordPart(Frame&, size_t) {}
  /// Textures that tests may look at: label and texture of each map.
  virtual std::vector<std::pair<std::string, rhi::TextureId>> maps() const { return {}; }
  /// What the last frame came to, by names that records keep: volumes drawn, casters left out.
  virtual std::vector<std::pair<std::string, uint64_t>> counts() const { return {}; }
  /// How far lookups for a light (index into Scene::lights) reach: errors within that distance of a
  /// shadow's edge are blamed on resolution. Nothing for techniques without maps.
  virtual LookupReach reach(uint32_t) const { return {}; }
};

class TransparencyTechnique {
 public:
  virtual ~TransparencyTechnique() = default;
  /// Runs once, and only when the plan has Effect::CameraTransparency.
  virtual void prepare(const Context& context, CameraPass& camera) = 0;
  /// Within a frame, before anything is recorded, see ShadowTechnique.
  virtual void moved(Frame&, CameraPass&) {}
  /// Records the translucent surfaces over the opaque picture.
  virtual void record(Frame& frame, CameraPass& camera) = 0;
  /// The same for some of them, after all parts behind these. Only with TechniqueInfo::drawsParts.
  virtual void recordPart(Frame&, CameraPass&, std::span<const uint32_t>) {}
  /// What the last frame left out (lists that overflowed, layers beyond the last one): for people,
  /// one line each. Called between frames.
  virtual std::vector<std::string> warnings() { return {}; }
};

/// A loop over the lights that may reach a point: a superset of those that do. It changes what a
/// picture costs, never the picture. Shaders: FOLDER/lights.glsl defines
///   struct LightLoop { uint light; ... };     the light at hand, an index into lights[]
///   LightLoop beginLights(Receiver r)
///   bool nextLight(inout LightLoop loop)      goes to the next; false: there is none
class LightTechnique {
 public:
  virtual ~LightTechnique() = default;
  /// Runs once, outside timed regions.
  virtual void prepare(const Context&) {}
  /// See ShadowTechnique.
  virtual void moved(Frame&) {}
  /// Records what the loop reads; before any surface is shaded.
  virtual void record(Frame&) {}
  /// Constants: ids 48..63.
  virtual VisibilityInputs inputs() const { return {}; }
};

}  // namespace sb

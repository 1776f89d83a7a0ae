// What a technique is. Two kinds of plug-in answer two questions:
//   ShadowTechnique        which fraction of a light's RGB radiance arrives at a receiver
//   TransparencyTechnique  in which order translucent surfaces meet the camera
// Each is one .cpp with a REGISTER_ line at its end and one folder of shaders; nothing else in the
// program names it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "techniques/common/frame.h"
#include "techniques/common/knobs.h"
#include "techniques/common/lookup_reach.h"
#include "techniques/common/pipeline_cache.h"
#include "techniques/common/plan.h"
#include "techniques/common/scene_view.h"

namespace sb {

class CameraPass;

/// What a technique says of itself: read by the matrix, the help text, the README and the reports.
struct TechniqueInfo {
  std::string name;    ///< as users type it: "CSSM2"
  std::string folder;  ///< of its shaders: "cssm2"
  std::string title;   ///< one line for people
  std::string paper;   ///< authors, year, section
  EffectSet represents;
  std::vector<rhi::Feature> requires_;
  std::vector<KnobInfo> knobs;
  std::string error;   ///< what its error is by construction (spec 16's table)
  bool stochastic = false;
  /// Replaces the camera pass by its own; no transparency technique goes with it.
  bool ownsCameraPass = false;
};

/// Everything a technique may use while it prepares.
struct Context {
  rhi::Device& device;
  const rhi::ShaderLibrary& shaders;
  PipelineCache& pipelines;
  SceneView& view;
  const Plan& plan;
  const Knobs& knobs;
};

/// What the shaders that ask `lightVisibility` need from the technique.
struct VisibilityInputs {
  std::vector<rhi::Binding> bindings;
  std::vector<rhi::ResourceUse> reads;
  std::vector<rhi::SpecConstant> constants;  ///< ids 16..31
};

class ShadowTechnique {
 public:
  virtual ~ShadowTechnique() = default;
  /// Creates pipelines, maps and buffers for one scene view; runs once, outside timed regions.
  virtual void prepare(const Context& context) = 0;
  /// Records the passes before the camera's (none when the plan calls for none).
  virtual void record(Frame& frame) = 0;
  virtual VisibilityInputs inputs() const = 0;
  /// The camera's passes; only techniques that declare ownsCameraPass replace this.
  virtual void recordCamera(Frame& frame, CameraPass& camera);
  /// Textures that tests and `bench render` may look at: label and texture of each map.
  virtual std::vector<std::pair<std::string, rhi::TextureId>> maps() const { return {}; }
  /// How far lookups for a light (index into Scene::lights) reach: errors within that distance of a
  /// shadow's edge are blamed on resolution. Nothing for techniques without maps.
  virtual LookupReach reach(uint32_t) const { return {}; }
};

class TransparencyTechnique {
 public:
  virtual ~TransparencyTechnique() = default;
  /// Runs once, and only when the plan has Effect::CameraTransparency.
  virtual void prepare(const Context& context, CameraPass& camera) = 0;
  /// Records the translucent surfaces over the opaque picture.
  virtual void record(Frame& frame, CameraPass& camera) = 0;
  /// What the last frame left out (lists that overflowed, layers beyond the last one): for people,
  /// one line each. Called between frames.
  virtual std::vector<std::string> warnings() { return {}; }
};

}  // namespace sb

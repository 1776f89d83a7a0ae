// A GpuScene seen by its camera: instance transforms relative to the eye, lights, light views,
// per-draw data. Uploaded when it is made: a frame of a standing scene uploads nothing. What moves
// does so within each frame, and what depends on it is written through the frame's own commands;
// while techniques prepare, the view shows the whole path at once: effects() and lightViews() hold
// what any step has, so that pipelines and buffers are made for all of them. A camera that is set
// freely (Effects::overview) is such a path of one place that sees everything: what is prepared
// there serves every camera that follows.
#pragma once

#include <algorithm>
#include <functional>

#include "techniques/draw/fit/view_fit.h"
#include "techniques/draw/views/view_buffers.h"
#include "techniques/draw/views/view_instances.h"
#include "techniques/plan/effects.h"
#include "techniques/scene/camera.h"

namespace sb {

/// Index of a light among those that touch the view, which are the ones that shaders know; all
/// others are indices into Scene::lights.
enum class ViewLight : uint32_t {};

/// Where a camera that is set freely stands.
struct Look {
  Camera camera;
  /// What it shows there: its own analysis, or that of all cameras, which shows it too at a higher
  /// cost. Lists nothing that the analysis of all cameras lacks.
  ViewEffects shown;
  uint32_t step = 0;  ///< of Scene::path, which the world follows all the same
};

class SceneView {
 public:
  /// `effects` is the analysis of scene and camera; both must outlive the view.
  SceneView(rhi::Device& device, const GpuScene& gpuScene, const Effects& effects,
            rhi::Extent2D size, uint32_t seed);

  const Scene& scene() const { return m_gpu.scene(); }
  const GpuScene& gpu() const { return m_gpu; }
  /// Where everything is now.
  const PlacedScene& placed() const { return m_placed; }
  /// What the camera shows now.
  const ViewEffects& effects() const { return *m_shown; }
  rhi::Extent2D size() const { return m_size; }
  double aspect() const { return double(m_size.width) / double(m_size.height); }
  uint32_t seed() const { return m_seed; }
  const CameraMatrices& camera() const { return m_camera; }

  /// What moves along the path.
  const Moving& moving() const { return m_moving; }
  /// Frames of a loop of the path; 1: everything stands, or the camera is set freely.
  uint32_t steps() const { return isFree() ? 1 : pathSteps(); }
  /// Which step of the path this is; 0 without one.
  uint32_t step() const { return m_step; }
  /// The camera is set freely, by look().
  bool isFree() const { return m_effects.overview.has_value(); }
  /// Every frame shows the same.
  bool stands() const { return steps() == 1 && !isFree(); }
  /// Goes to a step: camera, transforms, lights, and the fit of every light. Writes what moves and
  /// what depends on it.
  void moveTo(rhi::CommandList& commands, uint32_t step);
  /// The same for a camera that is set freely.
  void look(rhi::CommandList& commands, Look look);
  /// Calls `visit` at every step in turn (once where nothing moves), uploading in between.
  /// For preparing: what differs between steps. Of a camera that is set freely each step is seen
  /// from the overview, with every caster that any camera may meet there.
  void alongPath(rhi::Device& device, const std::function<void()>& visit);

  /// Fits the lights, now and in every step to come, and tells the shaders which light views belong
  /// to which light. Lights without views are lit.
  void fitLightViews(rhi::Device& device, const LightFitSettings& settings);
  /// Empty when nothing asked for them. Each view keeps its place along a path.
  const std::vector<LightView>& lightViews() const { return m_fit.views(); }
  const ViewFit& fit() const { return m_fit; }
  /// Other random numbers from the next frame on. Call between frames.
  void setSeed(rhi::Device& device, uint32_t seed);

  /// Slots common to every pass: frame, lights, shadow views, triangles.
  const std::vector<rhi::Binding>& bindings() const { return m_bindings; }
  /// A vertex buffer of the instances' records, `copies` of each in turn, numbered.
  rhi::BufferId instances(uint32_t copies = 1) const { return m_instances.buffer(copies); }
  /// Makes one with that many copies, now and in every step to come.
  void copyInstances(rhi::Device& device, uint32_t copies) { m_instances.copy(device, copies); }
  /// An instance's record as it is now.
  const gpu::InstanceData& instance(uint32_t index) const { return m_instances[index]; }
  /// What every pipeline that draws the scene is specialized for: shaders/common/scene.glsl.
  std::vector<rhi::SpecConstant> constants() const { return m_buffers.constants(); }

 private:
  uint32_t pathSteps() const { return std::max<uint32_t>(1, uint32_t(m_effects.steps.size())); }
  /// A step of the path as it is prepared for.
  ViewFit::Step stepOf(uint32_t step) const;
  size_t coplanarWords() const;
  void bind();
  /// Where everything is and what the camera shows; the light views are set by the caller.
  void show(PlacedScene placed, const ViewEffects& shown);
  /// All steps at once.
  void showAll();
  void writeAll(const BufferWrite& write);

  const GpuScene& m_gpu;
  const Effects& m_effects;
  const Moving m_moving;
  PlacedScene m_placed;
  const ViewEffects* m_shown;
  ViewEffects m_looked;  ///< of a camera that is set freely
  rhi::Extent2D m_size;
  uint32_t m_seed;
  uint32_t m_step = 0;
  CameraMatrices m_camera;
  ViewFit m_fit;
  ViewInstances m_instances;
  ViewBuffers m_buffers;
  std::vector<rhi::Binding> m_bindings;
};

}  // namespace sb

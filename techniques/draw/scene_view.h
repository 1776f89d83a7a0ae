// A GpuScene seen by its camera: instance transforms relative to the eye, lights, light views,
// per-draw data. Uploaded when it is made: a frame of a standing scene uploads nothing. What moves
// does so within each frame, and what depends on it is written through the frame's own commands;
// while techniques prepare, the view shows the whole path at once: effects() and lightViews() hold
// what any step has, so that pipelines and buffers are made for all of them.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "shaders/common/shared_types.h"
#include "techniques/draw/gpu_scene.h"
#include "techniques/draw/light_views.h"
#include "techniques/plan/effects.h"
#include "techniques/scene/camera.h"

namespace sb {

/// Index of a light among those that touch the view, which are the ones that shaders know; all
/// others are indices into Scene::lights.
enum class ViewLight : uint32_t {};

class SceneView {
 public:
  /// Lists of lights that are longer are read from storage: what hardware keeps for constants.
  static constexpr uint64_t kMostUniformBytes = 64 * 1024;

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
  /// Frames of a loop of the path; 1: everything stands.
  uint32_t steps() const { return std::max<uint32_t>(1, uint32_t(m_effects.steps.size())); }
  /// Which of them this is; 0 without a path.
  uint32_t step() const { return m_step; }
  /// Goes to a step: camera, transforms, lights, and the fit of every light. Writes what moves and
  /// what depends on it.
  void moveTo(rhi::CommandList& commands, uint32_t step);
  /// Calls `visit` at every step in turn (once where nothing moves), uploading in between.
  /// For preparing: what differs between steps.
  void alongPath(rhi::Device& device, const std::function<void()>& visit);

  /// Fits the lights, now and in every step to come, and tells the shaders which light views belong
  /// to which light. Lights without views are lit.
  void fitLightViews(rhi::Device& device, const LightFitSettings& settings);
  /// Empty when nothing asked for them. Each view keeps its place along a path.
  const std::vector<LightView>& lightViews() const { return m_lightViews; }
  /// Every light view that ever has casters has some at the first step too: its frame writes all
  /// layers of a shadow map.
  bool firstStepHasAllViews() const { return m_firstHasAll; }
  /// Other random numbers from the next frame on. Call between frames.
  void setSeed(rhi::Device& device, uint32_t seed);

  /// Slots common to every pass: frame, lights, shadow views, triangles.
  const std::vector<rhi::Binding>& bindings() const { return m_bindings; }
  /// A vertex buffer of the instances' records, `copies` of each in turn, numbered.
  rhi::BufferId instances(uint32_t copies = 1) const { return m_instances.at(copies); }
  /// Makes one with that many copies, now and in every step to come.
  void copyInstances(rhi::Device& device, uint32_t copies);
  /// An instance's record as it is now.
  const gpu::InstanceData& instance(uint32_t index) const { return m_instanceData[index]; }
  /// What every pipeline that draws the scene is specialized for: shaders/common/scene.glsl.
  std::vector<rhi::SpecConstant> constants() const;

 private:
  /// Of a buffer from a byte on.
  using Write = std::function<void(rhi::BufferId, uint64_t, std::span<const std::byte>)>;
  void createBuffers(rhi::Device& device);
  /// Lights and views that there is room for.
  uint32_t lightCount() const;
  uint32_t viewCount() const;
  bool lightsInStorage() const;
  void bind();
  /// Where everything is and what the camera shows; the light views are set by the caller.
  void look(PlacedScene placed, const ViewEffects& shown);
  void look(uint32_t step);
  /// Of any light view, as it is now.
  bool casterRises() const;
  void writeAll(const Write& write);
  void writeFrame(const Write& write) const;
  void writeLights(const Write& write) const;
  void writeCoplanar(const Write& write) const;
  /// So many from the first on.
  void writeInstances(const Write& write, uint32_t first, uint32_t count) const;
  static Write uploadsTo(rhi::Device& device);

  const GpuScene& m_gpu;
  const Effects& m_effects;
  const Moving m_moving;
  PlacedScene m_placed;
  const ViewEffects* m_shown;
  rhi::Extent2D m_size;
  uint32_t m_seed;
  uint32_t m_step = 0;
  CameraMatrices m_camera;
  CameraRays m_rays;
  std::optional<LightFitSettings> m_fit;
  std::vector<LightView> m_united;  ///< views of all steps
  bool m_firstHasAll = true;
  std::vector<LightView> m_lightViews;
  std::vector<gpu::InstanceData> m_instanceData;
  uint64_t m_mostUniform;                       ///< bytes of a list in a uniform block
  std::map<uint32_t, rhi::Buffer> m_instances;  ///< by copies
  rhi::Buffer m_frame, m_lights, m_shadowViews, m_coplanar;
  std::vector<rhi::Binding> m_bindings;
};

}  // namespace sb

// One cell of the matrix, ready to render: a technique of each kind on a scene view of a device.
// Made outside timed regions; `frame` is what is measured.
#pragma once

#include <map>
#include <optional>

#include "techniques/draw/frame_stream.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/visibility_buffer.h"

namespace sb {

/// What a device keeps for all its cells.
struct DeviceContext {
  rhi::Device& device;
  const rhi::ShaderLibrary& shaders;
  PipelineCache& pipelines;
  FrameQueries& queries;
};

struct RendererDesc {
  const ShadowEntry* technique = nullptr;
  const TransparencyEntry* transparency = nullptr;
  const LightsEntry* lights = nullptr;
  Knobs knobs;  ///< of the three together
  rhi::Extent2D size;
  uint32_t seed = 0;
  EffectSet forced;  ///< tests only, see makePlan
  TechniqueSet set() const { return {&technique->info, &transparency->info, &lights->info}; }
};

class Renderer {
 public:
  /// `effects` and `gpuScene` must outlive the renderer. Throws rhi::Error when the device refuses.
  Renderer(const DeviceContext& device, const GpuScene& gpuScene, const Effects& effects,
           RendererDesc desc);

  /// What moves advances by one step of its path, from the first to the last and again; moving, and
  /// all that follows from it, is part of the frame.
  FrameResult frame(FrameMode mode = FrameMode::Plain);
  /// From the next frame on the scene is seen in this way. Only with the effects of a camera that
  /// is set freely (Effects::overview), through which the scene is seen until then.
  void look(Look look) { m_look = std::move(look); }
  /// Does something with the picture at the end of its frame: presents it, copies it.
  using Present = std::function<void(rhi::CommandList&, rhi::TextureId color)>;
  /// Draws the same as frame(), but waits for nothing and measures nothing: the next frame may be
  /// shown while the device is at work on this one.
  rhi::Ticket show(const Present& present);
  /// Frames of a loop; 1: everything stands.
  uint32_t steps() const { return m_view->steps(); }
  /// From the next frame on everything stands at a step of its path: where it is anyway costs
  /// nothing.
  void standAt(uint32_t step) { m_standing = step; }
  /// At the last step, which is that of the truth.
  void standStill() { standAt(steps() - 1); }

  /// The last frame's picture, linear RGBA, row 0 = bottom row (clip y = -1).
  std::vector<float> readImage();
  /// Lights that touch the view. Here and below lights are indices into Scene::lights.
  std::vector<uint32_t> lights() const;
  /// Visibility of one of them, see VisibilityBuffer::render.
  std::vector<VisibilityImage> readVisibility(uint32_t light);
  /// Around a receiver of a light, how far lookups of the technique go.
  LookupReach reach(uint32_t light) const;
  /// Why visibility does not depend on the seed, or "".
  std::string whyNotRandom() const;
  /// readVisibility at the step of the truth, drawn with a seed. Call after everything
  /// timed.
  std::vector<VisibilityImage> visibilityAtEnd(uint32_t light, uint32_t seed);
  /// Frames from now on draw other random numbers. Call between frames.
  void setSeed(uint32_t seed);

  /// What the last frame left out, for people. Call between frames.
  std::vector<std::string> warnings() { return m_camera->warnings(); }

  /// ShadowTechnique::counts().
  std::vector<std::pair<std::string, uint64_t>> counts() const {
    return m_technique ? m_technique->counts() : std::vector<std::pair<std::string, uint64_t>>();
  }

  const Plan& plan() const { return m_plan; }
  const SceneView& view() const { return *m_view; }
  ShadowTechnique* technique() { return m_technique.get(); }  ///< null: the plan needs no shadows
  /// What this cell alone keeps on the device, bytes by label.
  const std::map<std::string, uint64_t>& bytesByLabel() const { return m_bytes; }

 private:
  using Record = std::function<void(Frame&)>;
  Context context();
  /// Goes to where the next frame is.
  Record nextMove();
  /// `move` the view, and whatever depends on it.
  Record moved(std::function<void(rhi::CommandList&)> move);
  void record(Frame& frame);

  DeviceContext m_device;
  RendererDesc m_desc;
  Plan m_plan;
  std::unique_ptr<SceneView> m_view;
  std::unique_ptr<ShadowTechnique> m_technique;
  std::unique_ptr<LightTechnique> m_lights;
  std::unique_ptr<CameraPass> m_camera;
  std::unique_ptr<VisibilityBuffer> m_visibility;
  FrameRunner m_runner;
  FrameStream m_stream;
  std::map<std::string, uint64_t> m_bytes;
  std::optional<uint32_t> m_at;        ///< step of the last frame
  std::optional<uint32_t> m_standing;  ///< step that frames stay at
  std::optional<Look> m_look;          ///< of the next frame
};

}  // namespace sb

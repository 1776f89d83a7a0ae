// A cell of the matrix in a test: a scene rendered on a device through the Renderer, its picture,
// visibility buffer and maps as floats. Pipelines and queries are kept per device for the process,
// since the first draw of each pipeline costs 0.4 s on software drivers.
#pragma once

#include <functional>
#include <optional>

#include "reports/picture.h"
#include "suites/harness/stage.h"

namespace sb::test {

/// The program's own shaders, and those of techniques that only tests know.
const rhi::ShaderLibrary& productionShaders();

/// Pipelines and queries of a device.
struct CellDevice {
  explicit CellDevice(rhi::Device& d) : device(d), pipelines(d), queries(d) {}
  DeviceContext context() { return {device, productionShaders(), pipelines, queries}; }
  rhi::Device& device;
  PipelineCache pipelines;
  FrameQueries queries;
};

/// A shadow technique, by name, has a knob.
bool hasKnob(const std::string& technique, const std::string& knob);

struct CellOptions {
  std::string technique = "ShadowMap";
  std::map<std::string, std::string> knobs = {};  ///< the rest are defaults, but for size: 256
  rhi::Extent2D size = {64, 64};
  uint32_t seed = 0;
  EffectSet forced = {};
  std::string transparency = "Sorted";
  /// In place of `technique`: one that is not registered.
  const ShadowEntry* entry = nullptr;
};

/// The techniques and knobs that they name.
RendererDesc rendererDescOf(const CellOptions& options);

/// For a light: the first that touches the view.
inline constexpr uint32_t kFirstInView = UINT32_MAX;

class Cell {
 public:
  /// Renders one frame.
  Cell(CellDevice& device, Scene scene, const CellOptions& options = {});
  Cell(const Cell&) = delete;

  Renderer& renderer() { return *m_renderer; }
  const FrameResult& result() const { return m_result; }
  const Scene& scene() const { return m_scene; }
  const Effects& effects() const { return m_stage->effects(); }
  rhi::Extent2D size() const { return m_options.size; }

  /// Renders from now on one step of the scene's path.
  void standAt(uint32_t step) {
    m_renderer->standAt(step);
    m_visibility.clear();
    renderAgain();
  }
  void renderAgain() { m_result = m_renderer->frame(); }
  report::Picture picture();
  /// Element 0: first opaque surface; 1..: layers from the eye. RGB and 1 where a surface is.
  const std::vector<VisibilityImage>& visibility(uint32_t light = kFirstInView);

  bool hasMap(const std::string& label);
  /// A map's layer as floats, `channels` per texel: 1 of depth maps, 4 of colour maps. Row 0 is v =
  /// 0.
  std::vector<float> map(const std::string& label, uint32_t layer = 0);
  uint32_t mapSize() const;
  /// The light views that the technique uses (fitted again from the same inputs).
  std::vector<LightView> lightViews() const;

 private:
  CellDevice& m_device;
  Scene m_scene;
  CellOptions m_options;
  Knobs m_knobs;
  std::optional<Stage> m_stage;
  std::unique_ptr<Renderer> m_renderer;
  FrameResult m_result;
  std::map<uint32_t, std::vector<VisibilityImage>> m_visibility;
};

}  // namespace sb::test

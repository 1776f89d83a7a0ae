// One frame of a technique on a scene, and what cases compare of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "reports/picture.h"
#include "suites/harness/stage.h"
#include "suites/truth/tracer.h"
#include "techniques/render/registry.h"

namespace sb {

/// What every case of one technique shares.
struct CaseContext {
  DeviceContext device;
  const DeviceContext* other = nullptr;  ///< of another API; null: there is none
  std::string technique;
  std::string transparency;
  std::string lights = kDefaultLights;
  std::map<std::string, std::string> knobs = {};  ///< of the variant; what a case fixes wins
  uint32_t seeds = 1;  ///< over which means of stochastic techniques are taken
  bool quick = false;  ///< fewer and smaller points
  const Scene* scene = nullptr;  ///< the user's, which a property is asked of; null: the case's own
  rhi::Extent2D size = {96, 64};  ///< of pictures of that scene
  const TechniqueInfo& info() const { return shadowTechnique(technique).info; }
  const TechniqueInfo& transparencyInfo() const { return transparencyTechnique(transparency).info; }
  bool represents(Effect effect) const { return info().represents.has(effect); }
  bool is(const std::string& knob, const std::string& value) const {
    const auto it = knobs.find(knob);
    return it != knobs.end() && it->second == value;
  }
};

/// The device lacks what the techniques need for a scene.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// For a light: the first that touches the view.
inline constexpr uint32_t kFirstInView = UINT32_MAX;

struct ProbeOptions {
  /// Those that the technique has; in scenes of cases, size: 256.
  std::map<std::string, std::string> knobs = {};
  rhi::Extent2D size = {96, 64};
  uint32_t seed = 0;
  bool onOther = false;  ///< on the other API's device
};

class Probe {
 public:
  /// Renders one frame. Throws Unsupported, and rhi::Error when the device refuses.
  Probe(const CaseContext& context, Scene scene, const ProbeOptions& options = {});
  Probe(const Probe&) = delete;

  const Scene& scene() const { return m_scene; }
  const Effects& effects() const { return m_stage->effects(); }
  rhi::Extent2D size() const { return m_options.size; }
  Renderer& renderer() { return *m_renderer; }
  report::Picture picture();
  /// Of a light (index into Scene::lights) that touches the view: first opaque surface, then layers
  /// from the eye.
  const std::vector<VisibilityImage>& visibility(uint32_t light = kFirstInView);
  /// Mean over the middle half of a layer, where a surface is, and over the context's seeds.
  glm::dvec3 meanVisibility(uint32_t layer, uint32_t light = kFirstInView);

 private:
  glm::dvec3 middleMean(const VisibilityImage& image) const;

  Scene m_scene;
  ProbeOptions m_options;
  uint32_t m_seeds = 1;
  std::optional<Stage> m_stage;
  std::unique_ptr<Renderer> m_renderer;
  std::map<uint32_t, std::vector<VisibilityImage>> m_visibility;
};

/// What was found over compared values: the largest excess, or how many are wrong.
class Compared {
 public:
  void worst(double excess) {
    m_any = true;
    // Not a number stays: std::max would lose it.
    if (!std::isnan(m_value) && !(excess <= m_value)) m_value = excess;
  }
  void count(bool wrong) {
    m_any = true;
    m_value += wrong ? 1 : 0;
  }
  /// Not a number, which is within no tolerance, where nothing was compared.
  double value() const { return m_any ? m_value : std::numeric_limits<double>::quiet_NaN(); }

 private:
  double m_value = 0;
  bool m_any = false;
};

/// Largest difference of a channel, in 1/255, of the pictures as they are shown: exposed as the
/// first asks for.
double pictureDifference(Probe& a, Probe& b);

/// Whether the truth takes this value somewhere within the reach of lookups around a point, and
/// another one elsewhere: there resolution decides.
bool explained(const Tracer& tracer, uint32_t light, const Tracer::Point& point,
               const LookupReach& reach, const float* value);
/// Cosine of the angle at which a light of the scene meets a surface; 0 behind it.
double cosine(const Scene& scene, uint32_t light, const Tracer::Point& point);

/// Visibility against the ray-traced truth over all lights and layers, at pixels away from the
/// picture's edges. A value that the truth takes somewhere within the reach of the technique's
/// lookups is no difference: there resolution alone decides. All are not a number where no value
/// was compared.
struct TruthDifference {
  double worst = 0;          ///< largest difference of a channel
  double mean = 0;           ///< signed, lookups at edges included
  size_t compared = 0;       ///< values
  double badlyLitShare = 0;  ///< of values that differ by more than 1/10 when multiplied by N.L
};
TruthDifference truthDifference(Probe& probe);

}  // namespace sb

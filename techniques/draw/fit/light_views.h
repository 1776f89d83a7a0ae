// Light frusta fitted to the view: one projection for a directional or spot light, six for a point
// light. Everything is computed in double relative to the eye, and uploaded as floats.
//   directional  orthographic around the visible receivers, snapped to texels of a grid anchored at
//                the scene (decision D4), casters before the near plane kept by depth clamp
//   spot         perspective over the part of the outer cone in which the camera sees receivers
//   point        six 90-degree faces, of each the same part, wider by the filter's radius so that a
//                kernel never leaves its face
// Depth is reversed, 1 near the light to 0 far from it. Local lights use perspective depth per face
// with far at infinity (spec 01, P6): n / z, which a float holds to the same relative precision at
// every distance (spec 17, N3), so that near may lie as near as casters do.
#pragma once

#include <vector>

#include "shaders/common/shared_types.h"
#include "techniques/plan/effects.h"
#include "techniques/scene/camera.h"

namespace sb {

enum class LightFit : uint8_t {
  Tight,   ///< the smallest square around the visible receivers: best resolution for this view
  /// Directional: a square of constant size around the frustum; local: the whole cone or face.
  /// Texels do not shimmer in motion.
  Stable,
};

struct LightFitSettings {
  uint32_t mapSize = 1024;   ///< texels
  uint32_t guardTexels = 2;  ///< margin for the filter: its radius plus one
  LightFit fit = LightFit::Tight;
  float depthStep = 0;     ///< of the map's format at depth 1
  bool depthClamp = true;  ///< Feature::DepthClamp; without it near reaches to the casters
  /// Translucent casters keep depths of their own: near reaches to them, for what is clamped to it
  /// has one depth, and peels as one layer.
  bool reachTranslucent = false;
};

/// One layer to render and to look up.
struct LightView {
  uint32_t light = 0;  ///< index into Scene::lights
  uint32_t face = 0;   ///< 0..5, point lights
  /// Of the map; -1: nothing to draw.
  int layer = -1;
  /// Persistent, of light and face: part of every random number.
  uint32_t key = 0;
  glm::mat4 toClip = glm::mat4(1);       ///< (relative to the eye - origin) -> clip
  glm::mat4 planeToClip = glm::mat4(1);  ///< takes planes there
  glm::vec3 origin = glm::vec3(0);       ///< relative to the eye
  bool perspective = false;              ///< of a local light
  /// Width of a texel, world units: anywhere, or at distance 1 of a perspective view.
  float texelWidth = 0;
  /// Casters that touch this view's volume, indices into Scene::instances, in scene order.
  std::vector<uint32_t> opaque, perforated, translucent;
  bool empty() const { return opaque.empty() && perforated.empty() && translucent.empty(); }
};

/// As shaders see it. `rises`: a caster of any view rises before itself.
gpu::ShadowViewData shadowViewData(const LightView& view, const LightFitSettings& settings,
                                   bool rises);
/// Numbers the layers of the views that have casters.
void numberLayers(std::vector<LightView>& views);

/// Views of every light that casts into the picture. Lights that cast nothing have none; views that
/// no caster touches have layer -1: no pass, no memory, everything lit.
/// `effects`: what the camera of `placed` shows.
std::vector<LightView> fitLights(const PlacedScene& placed, const ViewEffects& effects,
                                 double aspect, const LightFitSettings& settings);

}  // namespace sb

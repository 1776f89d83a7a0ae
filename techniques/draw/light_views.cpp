#include "techniques/draw/light_views.h"

#include <algorithm>
#include <cmath>

#include "techniques/draw/light_fit.h"
#include "techniques/scene/light_data.h"

namespace sb {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;

/// Rotated world -> clip of a box of a width around the axis, depth from 1 at the light's side to 0
/// at `range`.
dmat4 reversedOrthographic(double width, double range) {
  dmat4 m(1);
  m[0][0] = m[1][1] = 2 / width;
  m[2][2] = 1 / range;
  m[3][2] = 1;
  return m;
}

/// Light-space box of what the camera sees: receivers cut by the frustum's own box.
Box receiverBox(const FitInput& in, const dmat3& axes) {
  Box frustum, receivers;
  for (const dvec3& corner : frustumCorners(in.camera, in.aspect, farthestReceiver(in)))
    frustum.add(axes * corner);
  for (uint32_t i : in.receivers)
    receivers.add(instanceBounds(in.placed, i, in.camera.eye(), axes));
  receivers.min = glm::max(receivers.min, frustum.min);
  receivers.max = glm::min(receivers.max, frustum.max);
  return receivers;
}

/// Corner of the whole scene's light-space box: moves with the scene, stands still under the
/// camera.
dvec3 snapAnchor(const FitInput& in, const dmat3& axes) {
  Box all;
  for (uint32_t i = 0; i < in.placed.scene().instances.size(); ++i)
    all.add(instanceBounds(in.placed, i, in.camera.eye(), axes));
  return all.min;
}

void fitDirectional(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out) {
  const Light& light = in.placed.light(effects.light);
  const dmat3 axes = lightAxes(light.direction);
  Box box = receiverBox(in, axes);
  double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  dvec3 center = (box.min + box.max) * 0.5;
  if (in.settings.fit == LightFit::Stable) {
    // The sphere around the frustum does not change while the camera turns or moves, to the last
    // bit: it is that of the lens alone, and the scene's is measured from within the scene.
    Camera lens = in.camera;
    lens.toWorld = dmat4(1);
    const auto corners = frustumCorners(lens, in.aspect, in.camera.farPlane);
    dvec3 middle(0);
    for (const dvec3& c : corners) middle += c / 8.0;
    double radius = 0;
    for (const dvec3& c : corners) radius = std::max(radius, glm::length(c - middle));
    const dvec3 within(in.placed.toWorld(0)[3]);
    Box scene;
    for (uint32_t i = 0; i < in.placed.scene().instances.size(); ++i)
      scene.add(instanceBounds(in.placed, i, within));
    const double sceneRadius = glm::length(scene.max - scene.min) / 2;
    extent = 2 * std::min(radius, sceneRadius);
    center =
        axes * (radius <= sceneRadius ? dmat3(in.camera.toWorld) * middle
                                      : (scene.min + scene.max) * 0.5 + (within - in.camera.eye()));
  }
  if (!(extent > 0)) extent = glm::length(center) > 0 ? glm::length(center) * 1e-6 : 1.0;
  // One texel more than the guard: snapping moves the window by up to one.
  const double inner = double(in.settings.mapSize) - 2.0 * in.settings.guardTexels - 1.0;
  const double texel = extent / std::max(1.0, inner);
  const double width = texel * in.settings.mapSize;
  const dvec3 anchor = snapAnchor(in, axes);
  auto snapped = [&](double low, double a) { return a + std::floor((low - a) / texel) * texel; };
  const double left = snapped(center.x - width / 2 + texel / 2, anchor.x);
  const double bottom = snapped(center.y - width / 2 + texel / 2, anchor.y);

  // Depth: receivers decide; casters nearer to the light are clamped to the near plane.
  double top = box.max.z, low = box.min.z;
  const auto reach = [&](const std::vector<uint32_t>& casters) {
    for (uint32_t i : casters)
      top = std::max(top, instanceBounds(in.placed, i, in.camera.eye(), axes).max.z);
  };
  if (!in.settings.depthClamp) {
    reach(effects.opaqueCasters);
    reach(effects.perforatedCasters);
  }
  if (!in.settings.depthClamp || in.settings.reachTranslucent) reach(effects.translucentCasters);
  const double margin = (top - low) * 0.01 + texel;
  top += margin;
  low -= margin;
  const dvec3 origin = glm::transpose(axes) * dvec3(left + width / 2, bottom + width / 2, top);
  const dmat4 toClip = reversedOrthographic(width, top - low) * dmat4(axes);
  LightView& view = out.emplace_back();
  view.light = effects.light;
  view.data = viewData(toClip, origin, in.settings, texel, false, 8 * light.key);
  assignCasters(view, effects, [&](uint32_t i) {
    const Box b = instanceBounds(in.placed, i, in.camera.eye(), axes);
    return b.max.x >= left && b.min.x <= left + width && b.max.y >= bottom &&
           b.min.y <= bottom + width && b.max.z >= low;
  });
}

}  // namespace

gpu::ShadowViewData viewData(const dmat4& toClip, const dvec3& origin, const LightFitSettings& s,
                             double texelWidth, bool perspectiveDepth, uint32_t key) {
  gpu::ShadowViewData d{};
  d.toClip = glm::mat4(toClip);
  d.planeToClip = glm::mat4(glm::transpose(glm::inverse(toClip)));
  d.origin = glm::vec4(glm::vec3(origin), 0);
  d.texel = glm::vec4(1.0 / s.mapSize, s.depthStep, texelWidth, perspectiveDepth ? 1 : 0);
  d.ids.x = key;
  return d;
}

double farthestReceiver(const FitInput& in) {
  double farthest = 0;
  for (uint32_t i : in.receivers) {
    const Box b = instanceBounds(in.placed, i, in.camera.eye());
    farthest = std::max(farthest, glm::length(glm::max(glm::abs(b.min), glm::abs(b.max))));
  }
  return farthest;
}

std::vector<LightView> fitLights(const PlacedScene& placed, const ViewEffects& effects,
                                 double aspect, const LightFitSettings& settings) {
  FitInput in{placed, placed.camera(), aspect, settings, effects.visibleOpaque, {}};
  in.receivers.insert(in.receivers.end(), effects.visibleTranslucent.begin(),
                      effects.visibleTranslucent.end());
  std::vector<LightView> views;
  if (in.receivers.empty()) return views;
  const bool anyLocal = std::ranges::any_of(effects.lights, [&](const LightEffects& light) {
    return light.casts() && placed.light(light.light).type != LightType::Directional;
  });
  if (anyLocal && settings.fit == LightFit::Tight) findSeen(in);
  for (const LightEffects& light : effects.lights) {
    if (!light.casts()) continue;
    if (placed.light(light.light).type == LightType::Directional)
      fitDirectional(in, light, views);
    else
      fitLocal(in, light, views);
  }
  float layer = 0;
  for (LightView& view : views) view.data.origin.w = view.empty() ? -1.0f : layer++;
  return views;
}

}  // namespace sb

#include "techniques/draw/fit/light_views.h"

#include <algorithm>
#include <cmath>

#include "techniques/draw/fit/light_fit.h"
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
  for (uint32_t i : in.receivers) receivers.add(instanceBox(in.placed, i, in.camera.eye(), axes));
  return receivers.clippedTo(frustum);
}

/// Corner of the whole scene's light-space box: moves with the scene, stands still under the
/// camera.
dvec3 snapAnchor(const FitInput& in, const dmat3& axes) {
  Box all;
  for (uint32_t i = 0; i < in.placed.scene().instances.size(); ++i)
    all.add(instanceBox(in.placed, i, in.camera.eye(), axes));
  return all.low;
}

void fitDirectional(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out) {
  const Light& light = in.placed.light(effects.light);
  const dmat3 axes = lightAxes(light.direction);
  Box box = receiverBox(in, axes);
  double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  dvec3 center = box.center();
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
      scene.add(instanceBox(in.placed, i, within));
    const double sceneRadius = scene.radius();
    extent = 2 * std::min(radius, sceneRadius);
    center = axes * (radius <= sceneRadius ? dmat3(in.camera.toWorld) * middle
                                           : scene.center() + (within - in.camera.eye()));
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
  double top = box.high.z, low = box.low.z;
  const auto reach = [&](const std::vector<uint32_t>& casters) {
    for (uint32_t i : casters)
      top = std::max(top, instanceBox(in.placed, i, in.camera.eye(), axes).high.z);
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
  LightView& view = out.emplace_back(viewThrough(toClip, origin, texel, light, effects.light, 0));
  assignCasters(view, effects, [&](uint32_t i) {
    const Box b = instanceBox(in.placed, i, in.camera.eye(), axes);
    return b.high.x >= left && b.low.x <= left + width && b.high.y >= bottom &&
           b.low.y <= bottom + width && b.high.z >= low;
  });
}

}  // namespace

LightView viewThrough(const dmat4& toClip, const dvec3& origin, double texelWidth,
                      const Light& light, uint32_t lightIndex, uint32_t face) {
  return {.light = lightIndex,
          .face = face,
          .key = 8 * light.key + face,
          .toClip = glm::mat4(toClip),
          .planeToClip = glm::mat4(glm::transpose(glm::inverse(toClip))),
          .origin = glm::vec3(origin),
          .perspective = light.type != LightType::Directional,
          .texelWidth = float(texelWidth)};
}

gpu::ShadowViewData shadowViewData(const LightView& view, const LightFitSettings& settings,
                                   bool rises) {
  return {.toClip = view.toClip,
          .planeToClip = view.planeToClip,
          .origin = glm::vec4(view.origin, view.layer),
          .texel = glm::vec4(1.0 / settings.mapSize, settings.depthStep, view.texelWidth,
                             view.perspective ? 1 : 0),
          .ids = {view.key, rises ? 1 : 0, 0, 0}};
}

void numberLayers(std::vector<LightView>& views) {
  int layer = 0;
  for (LightView& view : views) view.layer = view.empty() ? -1 : layer++;
}

double farthestReceiver(const FitInput& in) {
  double farthest = 0;
  for (uint32_t i : in.receivers) {
    const Box b = instanceBox(in.placed, i, in.camera.eye());
    farthest = std::max(farthest, glm::length(glm::max(glm::abs(b.low), glm::abs(b.high))));
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
  numberLayers(views);
  return views;
}

}  // namespace sb

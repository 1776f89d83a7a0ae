#include "techniques/draw/light_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "techniques/scene/light_data.h"

namespace sb {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

struct FitInput {
  const Scene& scene;
  const Camera& camera;
  double aspect;
  const LightFitSettings& settings;
  std::vector<uint32_t> receivers;  ///< instances in the view
};

/// A square window in the plane one unit before a light.
struct Window {
  dvec2 center = dvec2(0);
  double half = 0;
};

/// Rotated world -> clip, depth from 1 at the near plane to 0 at infinity.
dmat4 reversedPerspective(const Window& window, double nearPlane) {
  dmat4 m(0);
  m[0][0] = m[1][1] = 1 / window.half;
  m[2][0] = window.center.x / window.half;
  m[2][1] = window.center.y / window.half;
  m[2][3] = -1;
  m[3][2] = nearPlane;
  return m;
}

/// The same for a box of a width around the axis, depth from 1 at the light's side to 0 at `range`.
dmat4 reversedOrthographic(double width, double range) {
  dmat4 m(1);
  m[0][0] = m[1][1] = 2 / width;
  m[2][2] = 1 / range;
  m[3][2] = 1;
  return m;
}

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

/// Splits the light's casters into the lists of one view by a test of their bounds.
template <class Test>
void assignCasters(LightView& view, const LightEffects& light, const Test& touches) {
  auto filter = [&](const std::vector<uint32_t>& from, std::vector<uint32_t>& to) {
    std::ranges::copy_if(from, std::back_inserter(to), touches);
  };
  filter(light.opaqueCasters, view.opaque);
  filter(light.perforatedCasters, view.perforated);
  filter(light.translucentCasters, view.translucent);
}

/// Distance from the eye beyond which the picture holds no surface.
double farthestReceiver(const FitInput& in) {
  double farthest = 0;
  for (uint32_t i : in.receivers) {
    const Box b = instanceBounds(in.scene, i, in.camera.eye());
    farthest = std::max(farthest, glm::length(glm::max(glm::abs(b.min), glm::abs(b.max))));
  }
  return farthest;
}

/// Light-space box of what the camera sees: receivers cut by the frustum's own box.
Box receiverBox(const FitInput& in, const dmat3& axes) {
  Box frustum, receivers;
  for (const dvec3& corner : frustumCorners(in.camera, in.aspect, farthestReceiver(in)))
    frustum.add(axes * corner);
  for (uint32_t i : in.receivers) receivers.add(instanceBounds(in.scene, i, in.camera.eye(), axes));
  receivers.min = glm::max(receivers.min, frustum.min);
  receivers.max = glm::min(receivers.max, frustum.max);
  return receivers;
}

/// Corner of the whole scene's light-space box: moves with the scene, stands still under the
/// camera.
dvec3 snapAnchor(const FitInput& in, const dmat3& axes) {
  Box all;
  for (uint32_t i = 0; i < in.scene.instances.size(); ++i)
    all.add(instanceBounds(in.scene, i, in.camera.eye(), axes));
  return all.min;
}

void fitDirectional(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out) {
  const Light& light = in.scene.lights[effects.light];
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
    const dvec3 within(in.scene.instances.front().toWorld[3]);
    Box scene;
    for (uint32_t i = 0; i < in.scene.instances.size(); ++i)
      scene.add(instanceBounds(in.scene, i, within));
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
      top = std::max(top, instanceBounds(in.scene, i, in.camera.eye(), axes).max.z);
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
    const Box b = instanceBounds(in.scene, i, in.camera.eye(), axes);
    return b.max.x >= left && b.min.x <= left + width && b.max.y >= bottom &&
           b.min.y <= bottom + width && b.max.z >= low;
  });
}

double distanceToBox(const Box& b) {
  const dvec3 d = glm::max(glm::max(b.min, -b.max), dvec3(0));
  return glm::length(d);
}

struct DepthRange {
  double nearPlane;
  double farPlane;
};

/// Near as far out as the casters allow, far no farther than the last receiver in range (for
/// culling; the projection has none).
DepthRange localDepthRange(const FitInput& in, const LightEffects& effects, const Light& light) {
  double nearest = 1e300, farthest = 0;
  auto consider = [&](uint32_t i, bool caster) {
    const Box b = instanceBounds(in.scene, i, light.position);
    if (caster) nearest = std::min(nearest, distanceToBox(b));
    farthest = std::max(farthest, glm::length(glm::max(glm::abs(b.min), glm::abs(b.max))));
  };
  for (const auto* list :
       {&effects.opaqueCasters, &effects.perforatedCasters, &effects.translucentCasters})
    for (uint32_t i : *list) consider(i, true);
  for (uint32_t i : in.receivers) consider(i, false);
  if (light.range > 0) farthest = std::min(farthest, light.range);
  // The bounds of a caster may reach around the light although its surface does not. Integer
  // formats cannot afford a near plane there: what lies nearer is then kept by depth clamp. Radial
  // distances bound axial depths by sqrt(3).
  const double least = farthest * (in.settings.depthStep > 0 ? 1e-4 : 1e-12);
  const double nearPlane = std::max(nearest / std::numbers::sqrt3 * 0.999, least);
  return {std::min(nearPlane, farthest * 0.5), farthest * 1.001};
}

/// Are the bounds inside or across the pyramid from the light through a window?
bool touchesPyramid(const Box& b, const Window& window, double farPlane) {
  if (-b.max.z > farPlane || -b.min.z < 0) return false;
  for (int axis = 0; axis < 2; ++axis) {
    // A side x = t (-z): the box lies beyond it if each of its corners does.
    const double high = window.center[axis] + window.half, low = window.center[axis] - window.half;
    const auto lowest = [&](double t) { return t * (t < 0 ? b.max.z : b.min.z); };
    const auto highest = [&](double t) { return t * (t < 0 ? b.min.z : b.max.z); };
    if (b.min[axis] + lowest(high) > 0 || b.max[axis] + highest(low) < 0) return false;
  }
  return true;
}

/// Bounds of a box as the light sees it in the plane one unit before it; all of `most` where the
/// box reaches around the light.
void addSeen(const Box& b, double most, dvec2& low, dvec2& high) {
  const double near = -b.max.z, far = -b.min.z;
  if (far <= 0) return;
  const auto seen = [&](double x, bool highest) {
    const double z = (x > 0) == highest ? near : far;
    return z > 0 ? std::clamp(x / z, -most, most) : (x > 0 ? most : -most);
  };
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = std::min(low[axis], seen(b.min[axis], false));
    high[axis] = std::max(high[axis], seen(b.max[axis], true));
  }
}

/// The part of a face of the light, `most` wide to each side, in which the camera sees receivers.
/// Nothing: it sees none there.
std::optional<Window> seenWindow(const FitInput& in, const Light& light, const dmat3& axes,
                                 double most) {
  if (in.settings.fit == LightFit::Stable) return Window{.half = most};
  const dvec3 toEye = in.camera.eye() - light.position;
  Box frustum;
  for (const dvec3& corner : frustumCorners(in.camera, in.aspect, farthestReceiver(in)))
    frustum.add(axes * (corner + toEye));
  dvec2 low(most), high(-most);
  for (const uint32_t i : in.receivers) {
    Box b = instanceBounds(in.scene, i, light.position, axes);
    b.min = glm::max(b.min, frustum.min);
    b.max = glm::min(b.max, frustum.max);
    if (glm::all(glm::lessThanEqual(b.min, b.max))) addSeen(b, most, low, high);
  }
  if (low.x > high.x || low.y > high.y) return {};
  const double half = std::max(high.x - low.x, high.y - low.y) / 2;
  // A receiver that is seen as a point still has a neighbourhood.
  return Window{.center = (low + high) / 2.0, .half = std::max(half * (1 + 1e-6), most * 1e-6)};
}

void addLocalView(const FitInput& in, const LightEffects& effects, const dmat3& axes,
                  double tangent, const DepthRange& range, uint32_t face,
                  std::vector<LightView>& out) {
  const Light& light = in.scene.lights[effects.light];
  const double size = in.settings.mapSize;
  const std::optional<Window> seen = seenWindow(in, light, axes, tangent);
  Window wide = seen.value_or(Window{.half = tangent});
  // Widen so that what is seen lies guardTexels inside the border.
  wide.half *= size / std::max(1.0, size - 2.0 * in.settings.guardTexels);
  const dmat4 toClip = reversedPerspective(wide, range.nearPlane) * dmat4(axes);
  LightView& view = out.emplace_back();
  view.light = effects.light;
  view.face = face;
  view.data = viewData(toClip, light.position - in.camera.eye(), in.settings, 2 * wide.half / size,
                       true, 8 * light.key + face);
  if (!seen) return;
  assignCasters(view, effects, [&](uint32_t i) {
    return touchesPyramid(instanceBounds(in.scene, i, light.position, axes), wide, range.farPlane);
  });
}

void fitLocal(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out) {
  const Light& light = in.scene.lights[effects.light];
  const DepthRange range = localDepthRange(in, effects, light);
  if (light.type == LightType::Spot) {
    const double half = std::clamp(light.outerCone, 1e-3, 1.55);
    addLocalView(in, effects, lightAxes(light.direction), std::tan(half), range, 0, out);
    return;
  }
  for (uint32_t face = 0; face < 6; ++face)
    addLocalView(in, effects, lightAxes(cubeFaceDirection(face)), 1.0, range, face, out);
}

}  // namespace

std::vector<LightView> fitLights(const Scene& scene, const ViewEffects& effects,
                                 const Camera& camera, double aspect,
                                 const LightFitSettings& settings) {
  FitInput in{scene, camera, aspect, settings, effects.visibleOpaque};
  in.receivers.insert(in.receivers.end(), effects.visibleTranslucent.begin(),
                      effects.visibleTranslucent.end());
  std::vector<LightView> views;
  if (in.receivers.empty()) return views;
  for (const LightEffects& light : effects.lights) {
    if (!light.casts()) continue;
    if (scene.lights[light.light].type == LightType::Directional)
      fitDirectional(in, light, views);
    else
      fitLocal(in, light, views);
  }
  float layer = 0;
  for (LightView& view : views) view.data.origin.w = view.empty() ? -1.0f : layer++;
  return views;
}

}  // namespace sb

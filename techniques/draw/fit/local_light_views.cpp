#include <cmath>
#include <numbers>
#include <optional>

#include "techniques/draw/fit/light_fit.h"
#include "techniques/scene/light_data.h"

namespace sb {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

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

double distanceToBox(const Box& b) {
  const dvec3 d = glm::max(glm::max(b.low, -b.high), dvec3(0));
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
    const Box b = instanceBox(in.placed, i, light.position);
    if (caster) nearest = std::min(nearest, distanceToBox(b));
    farthest = std::max(farthest, glm::length(glm::max(glm::abs(b.low), glm::abs(b.high))));
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
  if (-b.high.z > farPlane || -b.low.z < 0) return false;
  for (int axis = 0; axis < 2; ++axis) {
    // A side x = t (-z): the box lies beyond it if each of its corners does.
    const double high = window.center[axis] + window.half, low = window.center[axis] - window.half;
    const auto lowest = [&](double t) { return t * (t < 0 ? b.high.z : b.low.z); };
    const auto highest = [&](double t) { return t * (t < 0 ? b.low.z : b.high.z); };
    if (b.low[axis] + lowest(high) > 0 || b.high[axis] + highest(low) < 0) return false;
  }
  return true;
}

/// The part of a face of the light, `most` wide to each side, in which the camera sees receivers.
/// Nothing: it sees none there.
std::optional<Window> seenWindow(const FitInput& in, const Light& light, const dmat3& axes,
                                 double most) {
  if (in.settings.fit == LightFit::Stable) return Window{.center = dvec2(0), .half = most};
  const dvec3 toEye = in.camera.eye() - light.position;
  const double slope = std::sqrt(1 + most * most);
  const HalfSpace inFace[] = {{dvec3(1, 0, -most) / slope, 0},
                              {dvec3(-1, 0, -most) / slope, 0},
                              {dvec3(0, 1, -most) / slope, 0},
                              {dvec3(0, -1, -most) / slope, 0}};
  dvec2 low(most), high(-most);
  for (const Polygon& part : in.seen) {
    Polygon face;
    for (const dvec3& p : part) face.push_back(axes * (p + toEye));
    for (const dvec3& p : clipped(std::move(face), inFace)) {
      // What touches the light is seen from it in every direction.
      const bool touches = !(p.z < 0);
      const dvec2 at = touches ? dvec2(0) : dvec2(p) / -p.z;
      low = glm::min(low, touches ? dvec2(-most) : glm::max(at, -most));
      high = glm::max(high, touches ? dvec2(most) : glm::min(at, most));
    }
  }
  if (low.x > high.x || low.y > high.y) return {};
  const double half = std::max(high.x - low.x, high.y - low.y) / 2;
  // A receiver that is seen as a point still has a neighbourhood.
  return Window{.center = (low + high) / 2.0, .half = std::max(half * (1 + 1e-6), most * 1e-6)};
}

void addLocalView(const FitInput& in, const LightEffects& effects, const dmat3& axes,
                  double tangent, const DepthRange& range, uint32_t face,
                  std::vector<LightView>& out) {
  const Light& light = in.placed.light(effects.light);
  const double size = in.settings.mapSize;
  const std::optional<Window> seen = seenWindow(in, light, axes, tangent);
  Window wide = seen.value_or(Window{.half = tangent});
  // Widen so that what is seen lies guardTexels inside the border.
  wide.half *= size / std::max(1.0, size - 2.0 * in.settings.guardTexels);
  const dmat4 toClip = reversedPerspective(wide, range.nearPlane) * dmat4(axes);
  LightView& view = out.emplace_back(viewThrough(toClip, light.position - in.camera.eye(),
                                                 2 * wide.half / size, light, effects.light, face));
  if (!seen) return;
  assignCasters(view, effects, [&](uint32_t i) {
    return touchesPyramid(instanceBox(in.placed, i, light.position, axes), wide, range.farPlane);
  });
}

}  // namespace

void fitLocal(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out) {
  const Light& light = in.placed.light(effects.light);
  const DepthRange range = localDepthRange(in, effects, light);
  if (light.type == LightType::Spot) {
    const double half = std::clamp(light.outerCone, 1e-3, 1.55);
    addLocalView(in, effects, lightAxes(light.direction), std::tan(half), range, 0, out);
    return;
  }
  for (uint32_t face = 0; face < 6; ++face)
    addLocalView(in, effects, lightAxes(cubeFaceDirection(face)), 1.0, range, face, out);
}

void findSeen(FitInput& in) {
  const Frustum frustum(frustumCorners(in.camera, in.aspect, farthestReceiver(in)));
  for (const uint32_t i : in.receivers)
    for (Polygon& face : frustum.seenPart(instanceBox(in.placed, i, in.camera.eye())))
      in.seen.push_back(std::move(face));
}

}  // namespace sb

// Occluders with one outline each over a floor, under a light with an extent, and the light that
// they leave: the outline's area within the light as the receiver sees it, scanned line by line.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/worst.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/tracer.h"
#include "techniques/scene/light_area.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/scanned_share.h"

namespace sb::test {

/// What hides light: corners in the world, around an outline, or of a solid that is convex.
struct Occluder {
  std::vector<glm::dvec3> corners;
  bool convex = false;
};

struct PenumbraScene {
  Scene scene;  ///< instance 0: the floor
  std::vector<Occluder> occluders;
};

inline Light ball(double radius, const glm::dvec3& position = {0.5, 4, 0.25}) {
  Light light = pointLight(position);
  makeSphere(light, radius);
  return light;
}

inline PenumbraScene penumbraFloor(Light light, const glm::dvec3& eye = {2, 5, 6}) {
  PenumbraScene s{.scene = floorScene(false), .occluders = {}};
  light.intensity = 20;
  addLight(s.scene, std::move(light));
  s.scene.cameras[0] = lookAt(eye, {0.25, 0, 0}, 0.75);
  return s;
}

/// A sheet around its middle: `radii` of corners in turn.
inline void addSheet(PenumbraScene& s, const glm::dvec3& middle, const glm::dvec3& x,
                     const glm::dvec3& y, const std::vector<double>& radii) {
  Material thin = matte();
  thin.doubleSided = true;
  Mesh mesh;
  mesh.material = add(s.scene, thin);
  mesh.positions.push_back(middle);
  Occluder occluder;
  for (size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2 * std::numbers::pi * double(i) / double(radii.size());
    mesh.positions.emplace_back(middle + radii[i] * (std::cos(angle) * x + std::sin(angle) * y));
    occluder.corners.emplace_back(mesh.positions.back());
    const auto n = uint32_t(radii.size());
    for (const uint32_t corner : {0u, uint32_t(i + 1), uint32_t(i + 1) % n + 1})
      mesh.indices.push_back(corner);
  }
  mesh.normals.assign(mesh.positions.size(), glm::normalize(glm::cross(x, y)));
  place(s.scene, add(s.scene, mesh));
  s.occluders.push_back(occluder);
}

/// A box, turned about.
inline void addTurnedBox(PenumbraScene& s, const glm::dvec3& middle, const glm::dvec3& half) {
  const glm::dmat4 turn = glm::dmat4(glm::dmat3(glm::normalize(glm::dvec3(2, 1, -1)),
                                                glm::normalize(glm::dvec3(-1, 4, 2)),
                                                glm::normalize(glm::dvec3(2, -1, 3))));
  Scene& scene = s.scene;
  addBox(scene, 0, -glm::vec3(half), glm::vec3(half));
  scene.instances.back().toWorld = translation(middle) * turn;
  Occluder occluder{.corners = {}, .convex = true};
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    occluder.corners.emplace_back(scene.instances.back().toWorld *
                                  glm::dvec4(sign * glm::dvec3(glm::vec3(half)), 1));
  }
  s.occluders.push_back(occluder);
}

inline std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
  std::ranges::sort(
      points, [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half) {
    const size_t first = hull.size();
    for (const glm::dvec2& p : points) {
      while (hull.size() >= first + 2) {
        const glm::dvec2 a = hull[hull.size() - 2], b = hull.back();
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

/// Share of the light that one occluder hides from a point; none if it reaches beside or behind it.
inline double hiddenShare(const Light& light, const Occluder& occluder, const glm::dvec3& p) {
  const LightPatch patch = lightPatch(light, light.position - p);
  const glm::dmat3 toPatch = glm::inverse(glm::dmat3(patch.u, patch.v, patch.centre));
  std::vector<glm::dvec2> outline;
  for (const glm::dvec3& corner : occluder.corners) {
    const glm::dvec3 seen = toPatch * (corner - p);
    if (seen.z <= 0) return 0;
    outline.push_back(glm::dvec2(seen) / seen.z);
  }
  if (occluder.convex) outline = convexHull(outline);
  return scannedShare(outline, patch.round, 1000);
}

/// Of a layer of surfaces whose points `asked` wants, against 1 less all shares, at least 0.
struct PenumbraErrors {
  double worst = 0, lighter = 0, squares = 0;
  size_t compared = 0, partly = 0;  ///< pixels; those in penumbrae
  size_t wrong = 0;                 ///< wrong by more than a quarter
  std::string where;                ///< the worst
  double rmse() const { return std::sqrt(squares / double(std::max<size_t>(1, compared))); }
};

inline PenumbraErrors penumbraErrors(
    Cell& cell, const PenumbraScene& s, uint32_t layer = 0, uint32_t light = 0,
    const std::function<bool(const sb::Tracer::Point&)>& asked = [](const sb::Tracer::Point& p) {
      return p.instance == 0;
    }) {
  const auto [width, height] = cell.size();
  const sb::Tracer tracer(cell.scene(), width, height);
  const glm::dvec3 eye = cell.scene().camera().eye();
  const VisibilityImage& found = cell.visibility(light)[layer];
  // Away from the picture's edges, where a pixel may show another surface than the ray.
  const auto isAsked = [&](uint32_t x, uint32_t y) {
    const auto point = tracer.pointAt(x, y, layer);
    return point && found[4 * (size_t(y) * width + x) + 3] != 0 && asked(*point);
  };
  PenumbraErrors e;
  for (uint32_t y = 1; y + 1 < height; ++y)
    for (uint32_t x = 1; x + 1 < width; ++x) {
      const size_t i = 4 * (size_t(y) * width + x);
      if (!isAsked(x, y) || !isAsked(x - 1, y) || !isAsked(x + 1, y) || !isAsked(x, y - 1) ||
          !isAsked(x, y + 1))
        continue;
      const auto point = tracer.pointAt(x, y, layer);
      double hidden = 0;
      for (const Occluder& occluder : s.occluders)
        hidden += hiddenShare(cell.scene().lights[light], occluder, point->position + eye);
      const double expected = 1 - std::min(hidden, 1.0), error = found[i] - expected;
      ++e.compared;
      e.partly += expected > 0.02 && expected < 0.98;
      e.wrong += !(std::abs(error) <= 0.25);
      e.squares += error * error;
      e.lighter = base::worse(e.lighter, error);
      if (std::isnan(e.worst) || std::abs(error) <= e.worst) continue;
      e.worst = std::abs(error);
      e.where = std::to_string(x) + ", " + std::to_string(y) + ": " + std::to_string(found[i]) +
                ", not " + std::to_string(expected);
    }
  return e;
}

/// Goals of spec 08's technique; R16F and 1000 lines are a part of 1e-3.
inline void expectPenumbra(Cell& cell, const PenumbraScene& s, const std::string& what,
                           size_t leastPartly = 60, uint32_t layer = 0) {
  const PenumbraErrors e = penumbraErrors(cell, s, layer);
  EXPECT_LE(e.worst, 1e-3) << what << ", " << e.where;
  EXPECT_GE(e.partly, leastPartly) << what;
  EXPECT_GE(e.compared, 2 * leastPartly) << what;
}

}  // namespace sb::test

// Scenes of the hard cases of wedges, and the errors of shares on their floors.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"
#include "techniques/scene/light_area.h"

namespace sb {

/// What 1024 rays a light leave, and a share's last bits.
inline constexpr double kTolerance = 0.02;

inline constexpr double kNever = std::numeric_limits<double>::infinity();

inline constexpr const char* kNoLighter =
    "visibility is no lighter than the truth's (largest excess)";
inline constexpr const char* kFiniteShares =
    "visibility is finite and in [0, 1] (values that are not)";

inline std::string withoutAreaLights(const CaseContext& context) {
  return context.represents(Effect::AreaLights) ? "" : "its lights have no extent";
}

/// A floor under a ball of light.
inline Scene lamp(double radius = 0.5, const glm::dvec3& eye = {1.5, 4, 5}) {
  Scene scene = floorScene(false);
  scene.cameras[0] = lookAt(eye, {0, 0, 0}, 0.75);
  Light light = pointLight({0, 4, 0}, 20);
  makeSphere(light, radius);
  addLight(scene, light);
  return scene;
}

/// With so many corners at this distance of its middle.
inline void addDisc(Scene& scene, const glm::dvec3& middle, double radius, uint32_t corners) {
  Mesh mesh;
  mesh.material = 0;
  mesh.positions.emplace_back(middle);
  for (uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    mesh.positions.emplace_back(middle + radius * glm::dvec3(std::cos(angle), 0, -std::sin(angle)));
    for (const uint32_t corner : {0u, i + 1, (i + 1) % corners + 1}) mesh.indices.push_back(corner);
  }
  mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
  place(scene, add(scene, mesh));
}

struct ShareErrors {
  Compared worst;    ///< from the truth
  Compared lighter;  ///< than it
};

/// On the floor, away from the picture's edges of surfaces.
inline ShareErrors shareErrors(const CaseContext& context, Scene scene) {
  Probe probe(context, std::move(scene), {.size = {48, 36}});
  const Tracer tracer(probe.scene(), 48, 36);
  const VisibilityImage& found = probe.visibility(0)[0];
  ShareErrors e;
  const uint32_t step = context.quick ? 5 : 2;
  for (uint32_t y = 1; y < 35; y += step)
    for (uint32_t x = 1; x < 47; x += step) {
      bool floor = true;
      for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const auto near = tracer.pointAt(uint32_t(int(x) + dx), uint32_t(int(y) + dy), 0);
        floor &= near && near->instance == 0;
      }
      if (!floor) continue;
      const double expected = tracer.visibility(0, *tracer.pointAt(x, y, 0), {.pattern = 1024}).x;
      const double error = found[4 * (size_t(y) * 48 + x)] - expected;
      e.worst.worst(std::abs(error));
      e.lighter.worst(error);
    }
  return e;
}

/// One curve of the largest error.
inline Found worstAlong(const CaseContext& context, std::initializer_list<double> values,
                        const std::function<Scene(double)>& make) {
  Found found;
  for (const double value : values)
    found.curve.push_back({value, shareErrors(context, make(value)).worst.value(), kTolerance});
  return found;
}

/// One that asks for the truth's visibility, of techniques that know lights with an extent.
inline StabilityCase wedgeCase(std::string id, std::string title, std::string parameter,
                               Found (*run)(const CaseContext&)) {
  return {.id = std::move(id),
          .title = std::move(title),
          .property = "visibility is the truth's (largest difference)",
          .reason = "1024 rays a light",
          .parameter = std::move(parameter),
          .leavesOut = withoutAreaLights,
          .run = run};
}

}  // namespace sb

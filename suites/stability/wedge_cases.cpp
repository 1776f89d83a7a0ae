// Lights with an extent driven to where penumbra wedges break (spec 17, rows of 08): receivers at
// edges, edges that point at the light, reach into it or lie on its axis, eyes within penumbrae,
// many edges at once, casters that overlap.
#include <cmath>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

/// What 1024 rays a light leave, and a share's last bits.
constexpr double kTolerance = 0.02;

std::string withoutAreaLights(const CaseContext& context) {
  return context.represents(Effect::AreaLights) ? "" : "its lights have no extent";
}

/// A floor under a ball of light.
Scene lamp(double radius = 0.5, const glm::dvec3& eye = {1.5, 4, 5}) {
  Scene scene = floorScene(false);
  scene.cameras[0] = lookAt(eye, {0, 0, 0}, 0.75);
  Light light = pointLight({0, 4, 0}, 20);
  makeSphere(light, radius);
  addLight(scene, light);
  return scene;
}

/// With so many corners at this distance of its middle.
void addDisc(Scene& scene, const glm::dvec3& middle, double radius, uint32_t corners) {
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
  double worst = 0;    ///< from the truth
  double lighter = 0;  ///< than it
};

/// On the floor, away from the picture's edges of surfaces.
ShareErrors shareErrors(const CaseContext& context, Scene scene) {
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
      e.worst = std::max(e.worst, std::abs(error));
      e.lighter = std::max(e.lighter, error);
    }
  return e;
}

/// One curve of the largest error.
Found worstAlong(const CaseContext& context, std::initializer_list<double> values,
                 const std::function<Scene(double)>& make) {
  Found found;
  for (const double value : values)
    found.curve.push_back({value, shareErrors(context, make(value)).worst, kTolerance});
  return found;
}

Found contact(const CaseContext& context) {
  return worstAlong(context, {0, 1e-6, 1e-4, 1e-2}, [](double gap) {
    Scene scene = lamp();
    addBox(scene, 0, {-0.75f, float(gap), -0.5f}, {0.5f, 0.75f, 0.5f});
    return scene;
  });
}

Found edgeAtLight(const CaseContext& context) {
  // A sheet and walls of a column whose edges point at the light's centre, or nearly: they have
  // their side to it, so that what its other points see of them is not in the silhouette.
  Found found;
  for (const double aside : {0.0, 1e-7, 1e-5, 1e-3}) {
    Scene scene = lamp();
    addQuad(scene, 0, {0.5f, 2, float(aside)}, {0.25f, -1, 0}, {0.125f, -0.5f, 0.25f});
    addBox(scene, 0, {float(aside), 1, -1}, {0.5f, 2, 0});
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({aside, badValues(probe), 0});
  }
  return found;
}

Found edgeThroughCentre(const CaseContext& context) {
  // Seen from the middle column, the light's centre is on an edge or at a corner.
  return worstAlong(context, {-1e-3, -1e-6, 0, 1e-6, 1e-3}, [](double aside) {
    Scene scene = lamp(0.5, {0, 4, 5});
    addHorizontal(scene, 0, {1 + float(aside), 1, 0}, 1, 0.5f);
    return scene;
  });
}

Found eyeInPenumbra(const CaseContext& context) {
  // The eye goes from the light's side of a sheet through the penumbra to the floor.
  return worstAlong(context, {0.1, 0.5, 1.5, 3.5}, [](double height) {
    Scene scene = lamp(0.5, {-1.25, height, 1});
    addHorizontal(scene, 0, {0, 1, 0}, 1, 0.5f);
    return scene;
  });
}

Found manyEdges(const CaseContext& context) {
  return worstAlong(context, {8, 64, 500}, [](double corners) {
    Scene scene = lamp();
    addDisc(scene, {0.125, 1, 0}, 0.25, uint32_t(corners));
    return scene;
  });
}

Found beyondLight(const CaseContext& context) {
  // A wall beside the light that ends so far above its plane, and a lid over it.
  return worstAlong(context, {-1.5, 0, 1, 10}, [](double above) {
    Scene scene = lamp();
    addQuad(scene, 0, {1.5f, float(2.5 + 0.5 * above), 0}, {0, float(1.5 + 0.5 * above), 0},
            {0, 0, 1});
    addHorizontal(scene, 0, {0, 5, 0}, 1, 1);
    return scene;
  });
}

Found overlapping(const CaseContext& context) {
  // Where they overlap, shares add up: darker, not lighter.
  Found found;
  for (const double apart : {2.0, 0.75, 0.25, 0.0}) {
    Scene scene = lamp();
    addHorizontal(scene, 0, {-0.5, 1, 0}, 0.5f, 0.5f);
    addHorizontal(scene, 0, {-0.5 + apart, 1.5, 0.125}, 0.375f, 0.5f);
    found.curve.push_back({apart, shareErrors(context, std::move(scene)).lighter, kTolerance});
  }
  return found;
}

Found reachingIn(const CaseContext& context) {
  // Sheets before, at and in the light, a box around its centre: nothing can be said but that
  // shares are shares.
  Found found;
  for (const double distance : {0.75, 0.5, 0.25, 0.0}) {
    Scene scene = lamp();
    addHorizontal(scene, 0, {0.25, 4 - float(distance), 0}, 0.5f, 0.5f);
    if (distance == 0) addBox(scene, 0, {-0.25f, 3.75f, -0.25f}, {0.25f, 4.25f, 0.25f});
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({distance, badValues(probe), 0});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> wedgeCases() {
  const std::string property = "visibility is the truth's (largest difference)";
  const std::string reason = "1024 rays a light";
  const auto made = [&](std::string id, std::string title, std::string parameter,
                        Found (*run)(const CaseContext&)) {
    return StabilityCase{.id = std::move(id),
                         .title = std::move(title),
                         .property = property,
                         .reason = reason,
                         .parameter = std::move(parameter),
                         .leavesOut = withoutAreaLights,
                         .run = run};
  };
  std::vector<StabilityCase> cases = {
      made("penumbra contact", "A box that touches the floor, or nearly", "gap, world units",
           contact),
      made("edge at light", "Edges that point at a light's centre", "aside, world units",
           edgeAtLight),
      made("edge through centre", "A light's centre on an edge or a corner", "aside, world units",
           edgeThroughCentre),
      made("eye in penumbra", "An eye before, in and behind a penumbra", "height of the eye",
           eyeInPenumbra),
      made("many edges", "Many edges before a light at once", "edges", manyEdges),
      made("beyond light", "Casters that reach beyond a light's plane", "above it, world units",
           beyondLight),
      made("overlapping", "Casters that overlap before a light", "apart, world units", overlapping),
      made("reaching in", "Casters that reach into a light", "distance, world units", reachingIn)};
  cases[6].property = "visibility is no lighter than the truth's (largest excess)";
  for (const size_t i : {1, 7}) {
    cases[i].property = "visibility is finite and in [0, 1] (values that are not)";
    cases[i].reason = "exact";
  }
  return cases;
}

}  // namespace sb

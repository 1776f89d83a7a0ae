// Opaque casters driven to where shadow volumes break (spec 17, rows of 07): eyes within volumes,
// near planes across them, lights in the planes of triangles and of the picture, many layers,
// meshes that are not closed.
#include <cmath>

#include "base/worst.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

const ProbeOptions kOptions = {.knobs = {{"kernel", "1"}, {"size", "1024"}, {"compare", "manual"}},
                               .size = {96, 64}};

/// Values beyond a tenth of the illumination, away from edges.
double wrongShare(const CaseContext& context, Scene scene) {
  Probe probe(context, std::move(scene), kOptions);
  return truthDifference(probe).badlyLitShare;
}

Scene floorAndBox(glm::dvec3 eye, glm::dvec3 target) {
  Scene scene = floorScene(false);
  addBox(scene, 0, {0.5f, 0, -1}, {1.25f, 0.75f, 0});
  scene.cameras[0] = lookAt(eye, target);
  return scene;
}

Found eyeInVolumes(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const int layers : {0, 1, 3, 10}) {
    // The eye below so many boards, the floor lit beyond them.
    Scene scene = floorAndBox({-1.5, 0.5, 0.25}, {1.5, 0, 0});
    for (int i = 0; i < layers; ++i)
      addBox(scene, 0, {-2.5f, 1 + 0.25f * float(i), -1},
             {-1 - 0.125f * float(i), 1.125f + 0.25f * float(i), 1});
    addLight(scene, sun({0.125, -1, 0.0625}));
    found.curve.push_back({double(layers), wrongShare(context, std::move(scene)), 0.001});
  }
  return found;
}

Found nearPlaneAcross(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double near : {1e-3, 0.1, 0.4, 0.8}) {
    Scene scene = floorAndBox({-1.5, 0.75, 0.25}, {1.5, 0, 0});
    addBox(scene, 0, {-1.5f, 1.25f, -0.5f}, {-0.875f, 1.5f, 0.25f});
    addLight(scene, sun({0.125, -1, 0.0625}));
    scene.cameras[0].nearPlane = near;
    found.curve.push_back({near, wrongShare(context, std::move(scene)), 0.001});
  }
  return found;
}

Found farPlaneAcross(const CaseContext& context) {
  // Parallel eyes too, whose near plane cuts the floor.
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double far : {6.0, 12.0, 50.0, 1e4}) {
    double wrong = 0;
    for (const bool parallel : {false, true}) {
      Scene scene = floorAndBox({0.5, 1.5, 4}, {0.75, 0.25, -0.5});
      addHorizontal(scene, 0, {0, -0.5f, 0}, 50, 50);
      addLight(scene, pointLight({0.5, 3, 0.25}, 20));
      Camera& camera = scene.cameras[0];
      camera.farPlane = far;
      camera.nearPlane = 2;
      camera.orthographic = parallel;
      camera.halfHeight = 2;
      wrong = base::worse(wrong, wrongShare(context, std::move(scene)));
    }
    found.curve.push_back({far, wrong, 0.001});
  }
  return found;
}

Found lightNearEye(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double ahead : {-1.0, -1e-3, 0.0, 0.1, 0.5}) {
    const glm::dvec3 eye(-2, 1.5, 1), target(0.75, 0.25, -0.5);
    Scene scene = floorAndBox(eye, target);
    // 0.1 is the near plane.
    addLight(scene,
             pointLight(eye + ahead * glm::normalize(target - eye) + glm::dvec3(0, 0.125, 0), 4));
    scene.cameras[0].nearPlane = 0.1;
    found.curve.push_back({ahead, wrongShare(context, std::move(scene)), 0.001});
  }
  return found;
}

Found lightInPlane(const CaseContext& context) {
  // Walls along the light, and a fan of triangles about it.
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double tilt : {0.0, 1e-7, 1e-5, 1e-3}) {
    Scene scene = floorAndBox({2.5, 3, 4}, {0, 0.25, 0});
    addLight(scene, sun({0, -1, 0}));
    for (int i = 0; i < 4; ++i)
      addQuad(scene, 0, {-2 + 0.5f * float(i), 0.75f, 0.5f}, {float(tilt), 0.5f, 0},
              {0.125f * float(i), 0, 0.5f});
    found.curve.push_back({tilt, wrongShare(context, std::move(scene)), 0.001});
  }
  return found;
}

/// So many sheets over the middle of the floor.
Found overlaps(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const uint32_t layers : {255u, 256u, 257u, 512u}) {
    Scene scene = floorScene();
    const uint32_t mesh = add(scene, quadMesh(0, {0, 1, 0}, {3.5f, 0, 0}, {0, 0, -3.5f}));
    for (uint32_t i = 0; i < layers; ++i) place(scene, mesh, translation({0, i / 256.0, 0}));
    Probe probe(context, std::move(scene), kOptions);
    found.curve.push_back({double(layers), probe.meanVisibility(0).x, 0});
  }
  return found;
}

Found notClosed(const CaseContext& context) {
  // Boxes that lack a wall, have one twice or one more inside, and one that stands apart by 1e-6.
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (int form = 0; form < 4; ++form) {
    Scene scene = floorAndBox({2.5, 3, 4}, {0, 0.25, 0});
    addLight(scene, sun({0.375, -1, -0.25}));
    addLight(scene, pointLight({-1.5, 2.25, 0.5}, 4));
    Mesh& mesh = scene.meshes[scene.instances[1].mesh];
    const auto extra = [&](std::initializer_list<uint32_t> corners) {
      for (const uint32_t i : corners) mesh.indices.push_back(i);
      mesh.triangleKeys.resize(mesh.indices.size() / 3, 1000u + uint32_t(form));
    };
    if (form == 0) mesh.indices.resize(mesh.indices.size() - 6);
    if (form == 1) extra({0, 1, 2, 8, 10, 9});
    if (form == 2) extra({0, 2, 16, 0, 16, 20});
    if (form == 3)
      for (uint32_t i = 0; i < 4; ++i) mesh.positions[i] += glm::vec3(1e-6f, 0, 1e-6f);
    mesh.triangleKeys.resize(mesh.indices.size() / 3);
    found.curve.push_back({double(form), wrongShare(context, std::move(scene)), 0.001});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> volumeCases() {
  const std::string property =
      "visibility times N.L is the truth's away from edges (share of values beyond .1)";
  const std::string reason = "one in a thousand: vertices snap to 1/256 pixel (N2)";
  return {
      {.id = "eye in shadow",
       .title = "An eye within the shadow of casters",
       .property = property,
       .reason = reason,
       .parameter = "casters above the eye",
       .run = eyeInVolumes},
      {.id = "near across",
       .title = "A near plane across a shadow's boundary",
       .property = property,
       .reason = reason,
       .parameter = "near plane, world units",
       .logarithmic = true,
       .run = nearPlaneAcross},
      {.id = "planes across",
       .title = "Near and far plane across a floor",
       .property = property,
       .reason = reason,
       .parameter = "far plane, world units",
       .logarithmic = true,
       .run = farPlaneAcross},
      {.id = "light at eye",
       .title = "A light behind the eye, on the near plane, before it",
       .property = property,
       .reason = reason,
       .parameter = "before the eye, world units",
       .run = lightNearEye},
      {.id = "edge on",
       .title = "Casters in a plane with the light",
       .property = property,
       .reason = reason,
       .parameter = "tilt",
       .run = lightInPlane},
      {.id = "overlaps",
       .title = "Hundreds of opaque casters over one another",
       .property = "no light passes (light that arrives)",
       .reason = "exact",
       .parameter = "layers",
       .run = overlaps},
      {.id = "not closed",
       .title = "Meshes with holes, walls within, walls twice and gaps of 1e-6",
       .property = property,
       .reason = reason,
       .run = notClosed},
  };
}

}  // namespace sb

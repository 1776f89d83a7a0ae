// ShadowMap under point and spot lights: seams of the faces, casters that enclose the light or
// stand before its near plane, receivers behind a spot, large ranges (spec 17, rows of 01).
#include <cmath>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/tracer.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions options(std::map<std::string, std::string> knobs = {{"compare", "manual"}}) {
  return {.knobs = std::move(knobs), .size = {96, 96}};
}

const glm::dvec3 kLight(0.25, 0.125, -0.125);

/// A closed room around a point light; the camera looks from one corner to the opposite one.
Scene room() {
  Scene scene;
  scene.name = "room";
  addBox(scene, add(scene, matte()), {-2, -2, -2}, {2, 2, 2});
  addLight(scene, pointLight(kLight));
  scene.cameras.push_back(lookAt({1.75, 1.5, 1.75}, {-1, -0.5, -1}, 1.9));
  return scene;
}

void expectShadows(Cell& cell, uint32_t light, size_t lit, size_t dark, double texels = 1.0) {
  const ShadowCounts c = compareShadows(cell, light, texels);
  EXPECT_EQ(c.wrong, 0u) << c.firstWrong;
  EXPECT_GE(c.lit, lit);
  EXPECT_GE(c.dark, dark);
}

}  // namespace

GPU_TEST(ShadowPoint, NoSeamsAcrossFaces) {
  // Inside a closed caster everything is lit, on all six faces and across their edges. Where the
  // filter reaches from one wall to the next, the next stands before the first one's plane and the
  // answer is open: the bundle is as wide as the filter.
  struct Case {
    std::map<std::string, std::string> knobs;
    double texels;
  };
  const Case cases[] = {{{{"compare", "manual"}}, 1},
                        {{{"compare", "hardware"}, {"kernel", "3"}}, 2 * std::sqrt(2.0)},
                        {{{"compare", "manual"}, {"kernel", "9"}}, 4.75 * std::sqrt(2.0)}};
  for (const glm::dvec3 eye : {glm::dvec3(1.75, 1.5, 1.75), glm::dvec3(-1.75, -1.5, -1.75)})
    for (const Case& c : cases) {
      Scene scene = room();
      scene.cameras[0] = lookAt(eye, -eye, 1.9);
      Cell cell(cellDevice(device()), scene, options(c.knobs));
      expectShadows(cell, 0, 7000, 0, c.texels);
    }
}

GPU_TEST(ShadowPoint, ShadowsCrossTheEdgesOfFaces) {
  // Quads across the edge between two faces and across a corner of three.
  Scene scene = room();
  addQuad(scene, 0, glm::vec3(kLight) + glm::vec3(-0.5f, 0, -0.5f), {0.2f, 0, -0.2f},
          {0, 0.25f, 0});
  addQuad(scene, 0, glm::vec3(kLight) + glm::vec3(-0.4f, -0.4f, -0.4f), {0.15f, 0, -0.15f},
          {-0.1f, 0.2f, -0.1f});
  Cell cell(cellDevice(device()), scene, options());
  expectShadows(cell, 0, 4000, 200);
}

GPU_TEST(ShadowPoint, LightInsideAClosedCaster) {
  Scene scene = room();
  const glm::vec3 light(kLight), half(0.1875f);
  addBox(scene, 0, light - half, light + half);
  Cell outside(cellDevice(device()), scene, options());
  expectShadows(outside, 0, 0, 8000);
  scene.cameras[0] = lookAt(kLight + glm::dvec3(0.125, 0.125, 0.125), kLight - 0.1, 1.9);
  scene.cameras[0].nearPlane = 1.0 / 256;
  Cell inside(cellDevice(device()), scene, options());
  expectShadows(inside, 0, 8000, 0);
}

GPU_TEST(ShadowPoint, CasterNextToTheLight) {
  // Nearer than the near plane that the room's size allows (farthest / 10^4).
  Scene scene = room();
  addQuad(scene, 0, glm::vec3(kLight) + glm::vec3(0, -0x1p-12f, 0), {0, 0, 0x1p-13f},
          {0x1p-13f, 0, 0});
  Cell cell(cellDevice(device()), scene, options());
  expectShadows(cell, 0, 3000, 100);
}

GPU_TEST(ShadowPoint, LargeRangeWithoutAcneAndWithContact) {
  // A wall square to the light at z, a small caster next to the light: the depth step at z is
  // z^2 (f - n) / (n f) 2^-24 (N3). No acne; a quad before the wall casts from two steps on, or
  // where the range is so small that those are finer, from 112 half-ulps of its distance on: depth
  // and receiver are floats, and up to 1.42 times as far from the eye 64 are allowed for.
  const std::pair<double, double> ranges[] = {
      {1, 4}, {1, 100}, {1, 1e4}, {1e-3, 1}, {1e-3, 100}, {1e-3, 1e4}, {1e-3, 1e6}};
  for (const auto& [nearest, z] : ranges) {
    SCOPED_TRACE("z = " + std::to_string(z));
    Scene scene;
    const uint32_t grey = add(scene, matte());
    addLight(scene, pointLight({0, 0, 0}, 1e6f));
    const float n = float(nearest), wall = float(z);
    addQuad(scene, grey, {0, 0, -wall}, {wall, 0, 0}, {0, wall, 0});
    addQuad(scene, grey, {0.4f * n, 0, -n}, {0.125f * n, 0, 0}, {0, 0.125f * n, 0});
    // From beside the light, looking past the small caster.
    scene.cameras.push_back(lookAt({0, 0, -1.5 * nearest}, {0, 0, -z}, 1.4, 4 * z));
    scene.cameras[0].nearPlane = std::max(nearest / 4, z / 1e4);
    Cell lit(cellDevice(device()), scene, options());
    expectShadows(lit, 0, 4000, 50);

    // The view through the wall from behind, where the quad is not seen. Positions are floats
    // relative to the eye, so that the small caster has to grow with the distance.
    const float near2 = std::max(n, wall * 1e-4f);
    scene.instances[1].toWorld = glm::dmat4(glm::dmat3(double(near2 / n)));
    scene.cameras[0] = lookAt({0, 0, -2 * z}, {0, 0, 0}, 1.4, 4 * z);
    scene.cameras[0].nearPlane = z / 4;
    const Cell probe(cellDevice(device()), scene, options());
    const glm::dmat4 m(probe.lightViews().at(5).toClip);
    const double nearPlane = m[3].z, farPlane = z * std::numbers::sqrt2;
    const double step = z * z * (farPlane - nearPlane) / (nearPlane * farPlane) * 0x1p-24;
    const double gap = std::max(2 * step, 112 * z * 0x1p-24);
    addQuad(scene, grey, {-wall / 4, 0, float(-(z - gap))}, {wall / 4, 0, 0}, {0, wall / 4, 0});
    Cell contact(cellDevice(device()), scene, options());
    expectShadows(contact, 0, 2000, 500);
  }
}

GPU_TEST(ShadowSpot, InsideTheConeAndBehindIt) {
  Scene scene;
  const uint32_t grey = add(scene, matte());
  addHorizontal(scene, grey, {0, 0, 0}, 3, 3);
  addHorizontal(scene, grey, {0.1f, 1, 0.05f}, 0.6f, 0.5f);      // casts inside the cone
  addQuad(scene, grey, {0, 4.5f, -2}, {2, 0, 0}, {0, 0.5f, 0});  // behind the light: w <= 0
  scene.cameras.push_back(lookAt({0, 3, 9}, {0, 2, 0}, 0.9));
  Scene dark = scene;
  addLight(scene, spotLight({0, 3, 0}, {0, -1, 0}, 0.7));
  Cell cell(cellDevice(device()), scene, options());
  expectShadows(cell, 0, 1500, 60);
  // Behind the cone the lookup says lit and the cone says dark: ambient light alone.
  Cell without(cellDevice(device()), dark, options());
  const auto a = cell.picture().rgba, b = without.picture().rgba;
  const VisibilityImage& v = cell.visibility()[0];
  const Tracer tracer(cell.scene());
  size_t behind = 0, lighter = 0;
  for (uint32_t y = 0; y < 96; ++y)
    for (uint32_t x = 0; x < 96; ++x) {
      const size_t i = 4 * (size_t(y) * 96 + x);
      lighter += a[i] > b[i] + 0.01f;
      const auto point = tracer.pixel(x, y, cell.size());
      if (!point || point->position.y < 3.1) continue;
      ++behind;
      EXPECT_EQ(v[i], 1);
      EXPECT_EQ(a[i], b[i]);
    }
  EXPECT_GT(behind, 200u);
  EXPECT_GT(lighter, 300u);
}

GPU_TEST(ShadowLights, SeveralLightsEachWithItsOwnShadow) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0.03f, 1, 0.05f}, 0.5f, 0.5f);
  addLight(scene, pointLight({1, 3, 1}));
  addLight(scene, spotLight({-1, 3, -0.5}, {0.3, -1, 0.2}, 0.9));
  Cell cell(cellDevice(device()), scene, options());
  ASSERT_EQ(cell.renderer().lights().size(), 3u);
  for (uint32_t light = 0; light < 2; ++light) expectShadows(cell, light, 4000, 80);
  // Outside the spot's cone the visibility is 1 by definition.
  const ShadowCounts spot = compareShadows(cell, 2, 1.0);
  EXPECT_EQ(spot.wrong, 0u) << spot.firstWrong;
  EXPECT_GT(spot.dark, 80u);
}

GPU_TEST(ManyLights, MoreThanAUniformBlockHolds) {
  // One light in as many parts as no uniform block holds, the last as large as all others together:
  // the same light, from storage.
  Scene scene = room();
  const Light whole = scene.lights[0];
  Cell one(cellDevice(device()), scene, {.technique = "none", .size = {16, 16}});
  const size_t parts = ViewBuffers::kMostUniformBytes / sizeof(gpu::LightData) + 1;
  Light part = whole;
  part.intensity = 0.5f * whole.intensity / float(parts - 1);
  scene.lights.assign(parts, part);
  scene.lights.back().intensity = 0.5f * whole.intensity;
  for (uint32_t i = 0; i < parts; ++i) scene.lights[i].key = i;
  Cell many(cellDevice(device()), scene, {.technique = "none", .size = {16, 16}});
  const report::Picture a = one.picture(), b = many.picture();
  double brightest = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) {
    EXPECT_NEAR(b.rgba[i], a.rgba[i], 0x1p-10 * a.rgba[i]) << i;  // a step of half floats
    if (i % 4 < 3) brightest = std::max<double>(brightest, a.rgba[i]);
  }
  EXPECT_GT(brightest, 0.01);
}

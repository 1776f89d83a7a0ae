// Torture scenes (spec 17, section 3). H4, 300 stacked quads, is the end of the curve of case
// `layers`.
#include <cmath>
#include <random>

#include "suites/harness/checks/verify.h"
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

/// H2: random triangles with duplicates and some without area; corners on a grid of 1/64.
Scene soup(int triangles) {
  std::mt19937 random(3);
  const auto corner = [&] {
    const auto c = [&] { return float(int(random() % 257) - 128) / 64; };
    return glm::vec3(c(), c(), c());
  };
  Scene scene = floorScene();
  scene.cameras[0] = lookAt({2, 5, 6}, {0, 1, 0});
  scene.lights[0] = sun({0.25, -1, 0.125});
  const uint32_t grey = add(scene, matte({0.75f, 0.5f, 0.25f}));
  const uint32_t blue = add(scene, glass(0.5f, {0.25f, 0.5f, 1}));
  for (const uint32_t material : {grey, blue}) {
    Mesh mesh = quadMesh(material, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.positions.clear();
    mesh.normals.clear();
    mesh.indices.clear();
    mesh.triangleKeys.clear();
    for (int t = 0; t < triangles / 2; ++t) {
      const glm::vec3 a = corner(), b = corner(), c = corner();
      const glm::vec3 n = glm::cross(b - a, c - a);
      for (const glm::vec3& p : {a, b, c}) {
        mesh.positions.push_back(p + glm::vec3(0, 2, 0));
        mesh.normals.push_back(glm::length(n) > 0 ? glm::normalize(n) : glm::vec3(0, 1, 0));
        mesh.indices.push_back(uint32_t(mesh.indices.size()));
      }
      mesh.triangleKeys.push_back(uint32_t(t));
    }
    mesh.boundsMin = glm::vec3(-2, 0, -2);
    mesh.boundsMax = glm::vec3(2, 4, 2);
    place(scene, add(scene, mesh));
  }
  duplicateOpaque(scene);
  insertDegenerate(scene);
  return scene;
}

Found soupFarAway(const CaseContext& context) {
  const int triangles = context.quick ? 60 : 400;
  const ProbeOptions options{.knobs = {{"kernel", "3"}, {"compare", "manual"}}};
  Probe before(context, soup(triangles), options);
  Scene moved = soup(triangles);
  scaleScene(moved, 0x1p-10);
  translateScene(moved, {1e7, 1e7, 1e7});
  Probe after(context, std::move(moved), options);
  return {.curve = {{1e7, pictureDifference(before, after), 0},
                    {1e7, double(countNonFinite(after.picture())), 0}},
          .expected = ""};
}

/// H3: a corridor with a light at each end, seen from near 1e-3 to far 1e6.
Found corridor(const CaseContext& context) {
  Scene scene;
  const uint32_t grey = add(scene, matte());
  constexpr float kHalf = 500;
  addQuad(scene, grey, {0, 0, -kHalf}, {2, 0, 0}, {0, 0, -kHalf});
  addQuad(scene, grey, {0, 4, -kHalf}, {2, 0, 0}, {0, 0, kHalf});
  addQuad(scene, grey, {-2, 2, -kHalf}, {0, 2, 0}, {0, 0, -kHalf});
  addQuad(scene, grey, {2, 2, -kHalf}, {0, 2, 0}, {0, 0, kHalf});
  for (const float z : {-3.0f, -30.0f, -300.0f, -900.0f})
    addBox(scene, grey, {-1.5f, 0, z - 0.5f}, {-0.5f, 2.5f, z + 0.5f});
  addLight(scene, pointLight({0.5, 3, -1}, 20));
  addLight(scene, pointLight({0.5, 3, -990}, 2000));
  scene.cameras.push_back(lookAt({0, 1.5, 0}, {0, 1.4, -10}, 1.2, 1e6));
  scene.cameras[0].nearPlane = 1e-3;
  Probe probe(
      context, std::move(scene),
      {.knobs = {{"kernel", "1"}, {"size", "1024"}, {"compare", "manual"}}, .size = {128, 96}});
  return {.curve = {{1, truthDifference(probe).badlyLitShare, 0.001}},
          .expected = missing(context, Effect::OpaqueCasters)};
}

/// H7: every pair of alpha and t in {0, 1}, side by side and in pairs behind one another.
Found allCorners(const CaseContext& context) {
  Scene scene = floorScene();
  for (int first = 0; first < 4; ++first)
    for (int second = 0; second < 4; ++second) {
      const glm::vec3 at(-3 + 2 * float(first), 1, -3 + 2 * float(second));
      addHorizontal(scene, add(scene, glass(float(first & 1), glm::vec3(float(first >> 1)))), at,
                    0.75f, 0.75f);
      addHorizontal(scene, add(scene, glass(float(second & 1), glm::vec3(float(second >> 1)))),
                    at + glm::vec3(0, 1, 0), 0.75f, 0.75f);
    }
  scene.lights[0] = sun({0.0625, -1, 0.03125});
  Probe probe(
      context, std::move(scene),
      {.knobs = {{"kernel", "1"}, {"size", "1024"}, {"compare", "manual"}}, .size = {128, 128}});
  return {.curve = {{1, truthDifference(probe).worst, 0}},
          .expected = missing(context, Effect::TranslucentCasters)};
}

/// H8: the sun low over a fractal terrain (midpoint displacement).
Scene terrain(int levels, double elevationDegrees) {
  const int n = (1 << levels) + 1;
  std::mt19937 random(5);
  std::vector<float> height(size_t(n) * size_t(n));
  const auto at = [&](int x, int y) -> float& { return height[size_t(y * n + x)]; };
  for (int step = n - 1; step > 1; step /= 2) {
    const float scale = 0.35f * float(step) / float(n - 1);
    const auto noise = [&] { return scale * (float(random() % 2001) / 1000 - 1); };
    const int half = step / 2;
    for (int y = half; y < n; y += step)
      for (int x = half; x < n; x += step)
        at(x, y) = 0.25f * (at(x - half, y - half) + at(x + half, y - half) +
                            at(x - half, y + half) + at(x + half, y + half)) +
                   noise();
    for (int y = 0; y < n; y += half)
      for (int x = (y / half) % 2 ? 0 : half; x < n; x += step) {
        float sum = 0, count = 0;
        const auto take = [&](int u, int v) {
          if (u >= 0 && v >= 0 && u < n && v < n) sum += at(u, v), ++count;
        };
        take(x - half, y), take(x + half, y), take(x, y - half), take(x, y + half);
        at(x, y) = sum / count + noise();
      }
  }
  Scene scene;
  Mesh mesh = quadMesh(add(scene, matte()), {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.positions.clear();
  mesh.normals.clear();
  mesh.indices.clear();
  mesh.triangleKeys.clear();
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      mesh.positions.emplace_back(4 * float(x) / float(n - 1) - 2, at(x, y),
                                  2 - 4 * float(y) / float(n - 1));
      mesh.normals.emplace_back(0, 1, 0);
    }
  for (int y = 0; y + 1 < n; ++y)
    for (int x = 0; x + 1 < n; ++x) {
      const uint32_t i = uint32_t(y * n + x), up = i + uint32_t(n);
      for (const uint32_t k : {i, i + 1, up + 1, i, up + 1, up}) mesh.indices.push_back(k);
      mesh.triangleKeys.push_back(uint32_t(mesh.triangleKeys.size()));
      mesh.triangleKeys.push_back(uint32_t(mesh.triangleKeys.size()));
    }
  mesh.boundsMin = glm::vec3(-2, -2, -2);
  mesh.boundsMax = glm::vec3(2, 2, 2);
  place(scene, add(scene, mesh));
  const double e = elevationDegrees * 3.14159265358979323846 / 180;
  addLight(scene, sun({std::cos(e) * 0.8, -std::sin(e), std::cos(e) * 0.6}));
  scene.cameras.push_back(lookAt({0.5, 2.5, 3}, {0, 0, 0}));
  return scene;
}

Found lowSun(const CaseContext& context) {
  Found found{.curve = {},
              .expected =
                  "a texel that spans a crease holds the facet nearer to the light, which "
                  "darkens the other within half a texel"};
  for (const double elevation : {30.0, 10.0, 3.0, 1.0, 0.1}) {
    if (context.quick && elevation != 10 && elevation != 0.1) continue;
    Probe probe(
        context, terrain(context.quick ? 4 : 6, elevation),
        {.knobs = {{"kernel", "1"}, {"size", "1024"}, {"compare", "manual"}}, .size = {128, 96}});
    found.curve.push_back({elevation, truthDifference(probe).badlyLitShare, 0.001});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> tortureCases() {
  return {
      {.id = "H2",
       .title = "Triangle soup, small and 1e7 away",
       .property = "the picture stays, all finite (largest difference, 1/255; values)",
       .reason = "exact",
       .run = soupFarAway},
      {.id = "H3",
       .title = "A corridor seen from 1e-3 to 1e6, a light at each end",
       .property =
           "visibility times N.L is the truth's away from edges (share of values beyond .1)",
       .reason = "one in a thousand: vertices snap to 1/256 texel (N2)",
       .run = corridor},
      {.id = "H7",
       .title = "All pairs of materials with alpha and t 0 or 1",
       .property = "visibility is the truth's away from its edges (largest difference)",
       .reason = "exact",
       .run = allCorners},
      {.id = "H8",
       .title = "A low sun over a fractal terrain",
       .property =
           "visibility times N.L is the truth's away from edges (share of values beyond .1)",
       .reason = "one in a thousand; a tenth of the illumination is allowed, as in G11",
       .parameter = "elevation, degrees",
       .logarithmic = true,
       .run = lowSun},
  };
}

}  // namespace sb

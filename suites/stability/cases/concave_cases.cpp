// Surfaces that rise before themselves (specs 01 and 17, G11): bowls seen from the light, where a
// filter's texels lie on facets that stand above the receiver's plane. Every point that the light
// sees is lit, so that no truth needs tracing: it suffices to look along the light.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"
#include "suites/truth/tracer.h"

namespace sb {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr uint32_t kPixels = 96;  ///< of the picture, along either side
constexpr double kHalfHeight = 1.15;
/// Shells that light sees through lose none at the first surface.
const glm::vec3 kTransmission = {0.25f, 0.5f, 0.75f};

enum class Bowl { OpenOpaque, OpenGlass, ClosedGlass };

/// A hemisphere below y = 0 of `n` meridians and n / 4 parallels; the closed one has an inner shell
/// 0.02 within, joined at the rim.
Mesh bowlMesh(uint32_t material, uint32_t n, bool closed) {
  Mesh mesh;
  mesh.material = material;
  const uint32_t rings = std::max(2u, n / 4);
  std::vector<std::pair<double, double>> profile;  // radius, angle from the rim down
  for (uint32_t i = 0; i <= rings; ++i) profile.emplace_back(1, 0.5 * kPi * i / rings);
  if (closed)
    for (uint32_t i = 0; i <= rings; ++i)
      profile.insert(profile.begin(), {0.98, 0.5 * kPi * i / rings});
  for (const auto& [radius, down] : profile)
    for (uint32_t k = 0; k < n; ++k) {
      const double around = 2 * kPi * k / n;
      const glm::dvec3 d(std::cos(down) * std::cos(around), -std::sin(down),
                         std::cos(down) * std::sin(around));
      mesh.positions.push_back(glm::vec3(radius * d));
      mesh.normals.push_back(glm::vec3(d));
    }
  for (uint32_t i = 0; i + 1 < profile.size(); ++i)
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = i * n + k, b = i * n + (k + 1) % n;
      for (const uint32_t v : {a, b, a + n, b, b + n, a + n}) mesh.indices.push_back(v);
    }
  return mesh;
}

/// A bowl and a sun `degrees` off its axis, seen from there.
Scene bowlScene(Bowl kind, uint32_t tessellation, double degrees) {
  Scene scene;
  const bool opaque = kind == Bowl::OpenOpaque;
  const uint32_t material = add(scene, opaque ? matte() : glass(0.5f, kTransmission));
  place(scene, add(scene, bowlMesh(material, tessellation, kind == Bowl::ClosedGlass)));
  const double angle = degrees * kPi / 180;
  // Off the axes of the mesh and of the map.
  const glm::dvec3 toLight(std::sin(angle) * 0.8, std::cos(angle), std::sin(angle) * 0.6);
  addLight(scene, sun(-toLight));
  Camera camera = lookAt(glm::dvec3(0, -0.4, 0) + 4.0 * toLight, {0, -0.4, 0});
  camera.orthographic = true;
  camera.halfHeight = kHalfHeight;
  scene.cameras = {camera};
  return scene;
}

/// The first surface at each pixel, and whether it is the bowl's inside.
struct Seen {
  std::vector<std::optional<Tracer::Point>> points;
  std::vector<bool> inside;
  explicit Seen(const Scene& scene, uint32_t layer) {
    const Tracer tracer(scene, kPixels, kPixels);
    for (uint32_t p = 0; p < kPixels * kPixels; ++p) {
      points.push_back(tracer.pointAt(p % kPixels, p / kPixels, layer));
      const auto& point = points.back();
      // The bowl's centre is the origin; the side that the light sees is the one that is seen.
      inside.push_back(point && glm::dot(point->normal, point->position + scene.camera().eye()) *
                                        glm::dot(point->normal, scene.lights[0].direction) >
                                    0);
    }
  }
  /// No edge of the inside, and so none of a shadow, within `reach` pixels.
  bool away(uint32_t x, uint32_t y, uint32_t reach) const {
    if (x < reach || y < reach || x + reach >= kPixels || y + reach >= kPixels) return false;
    for (uint32_t j = y - reach; j <= y + reach; ++j)
      for (uint32_t i = x - reach; i <= x + reach; ++i)
        if (!inside[j * kPixels + i]) return false;
    return true;
  }
};

struct Speckles {
  size_t pixels = 0, compared = 0;
};

/// Pixels of the inside that lose light, steeper ones than are biased for left out (G11).
Speckles speckles(const CaseContext& context, const Scene& scene, const Seen& seen,
                  const std::string& kernel, uint32_t layer) {
  Probe probe(context, scene, {.knobs = {{"kernel", kernel}}, .size = {kPixels, kPixels}});
  const double pixel = 2 * kHalfHeight / kPixels;
  // The map may be turned against the picture.
  const double diagonal = std::sqrt(2.0) * probe.renderer().reach(0).constant;
  const auto reach = uint32_t(std::ceil(diagonal / pixel)) + 2;
  const VisibilityImage& image = probe.visibility()[layer];
  const glm::dvec3 toLight = -scene.lights[0].direction;
  Speckles found;
  for (uint32_t y = 0; y < kPixels; ++y)
    for (uint32_t x = 0; x < kPixels; ++x) {
      const size_t p = size_t(y) * kPixels + x;
      if (!seen.away(x, y, reach) || image[4 * p + 3] == 0) continue;
      if (std::abs(glm::dot(seen.points[p]->normal, toLight)) < 0.1) continue;
      ++found.compared;
      found.pixels += std::min({image[4 * p], image[4 * p + 1], image[4 * p + 2]}) < 1;
    }
  return found;
}

/// Of all kinds of bowl and all kernels.
double allSpeckles(const CaseContext& context, uint32_t tessellation, double degrees) {
  const bool translucent = context.represents(Effect::TranslucentCasters);
  std::vector<std::string> kernels = {"1", "3", "5", "9", "15"};
  if (context.quick) kernels = {"1", "9"};
  Speckles sum;
  for (const Bowl kind : {Bowl::OpenOpaque, Bowl::OpenGlass, Bowl::ClosedGlass}) {
    if (kind != Bowl::OpenOpaque && !translucent) continue;
    if (kind == Bowl::OpenGlass && context.quick) continue;
    const uint32_t layer = kind == Bowl::OpenOpaque ? 0 : 1;
    const Scene scene = bowlScene(kind, tessellation, degrees);
    const Seen seen(scene, layer);
    for (const std::string& kernel : kernels) {
      const Speckles found = speckles(context, scene, seen, kernel, layer);
      sum.pixels += found.pixels;
      sum.compared += found.compared;
    }
  }
  // Where nothing could be compared nothing was shown.
  return sum.compared > 0 ? double(sum.pixels) : kPixels * kPixels;
}

Found concaveMesh(const CaseContext& context) {
  Found found;
  for (const uint32_t n : {8u, 16u, 32u, 64u, 128u, 256u, 512u})
    if (!context.quick || n == 8 || n == 64)
      found.curve.push_back({double(n), allSpeckles(context, n, 30), 0});
  return found;
}

Found concaveLight(const CaseContext& context) {
  Found found;
  for (const double degrees : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0})
    if (!context.quick || degrees == 0 || degrees == 60)
      found.curve.push_back({degrees, allSpeckles(context, 32, degrees), 0});
  return found;
}

/// Two sheets folded along z, each seen by the light (straight above) from its hollow side. The
/// lower one is the floor, the upper hovers over it. Whether the upper one darkens all of what it
/// covers, pixels within the filter's reach of its edges left out.
bool covers(const CaseContext& context, const std::string& kernel, double gap, double& allowed) {
  Scene scene;
  Mesh fold;
  fold.material = add(scene, matte());
  fold.positions = {{-1, 1, -1}, {-1, 1, 1}, {0, 0, 1}, {0, 0, -1}, {1, 1, -1}, {1, 1, 1}};
  fold.normals.assign(6, {0, 1, 0});
  fold.indices = {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4};
  const uint32_t mesh = add(scene, std::move(fold));
  place(scene, mesh);
  glm::dmat4 smaller = translation({0, gap, 0});
  for (int c = 0; c < 3; ++c) smaller[c][c] = 0.75;
  place(scene, mesh, smaller);
  addLight(scene, sun({0, -1, 0}));
  // From below, against the light.
  Camera camera = lookAt({0, -3, 0.01}, {0, 0, 0});
  camera.orthographic = true;
  camera.halfHeight = 1;
  scene.cameras = {camera};
  Probe probe(context, scene, {.knobs = {{"kernel", kernel}}, .size = {kPixels, kPixels}});
  const double texel = 2 * probe.renderer().reach(0).constant / (std::stoi(kernel) + 1);
  allowed = (std::stoi(kernel) + 1) * texel;  // 2 b, tan 1
  const VisibilityImage& image = probe.visibility()[0];
  const double inner = 0.75 - 2 * probe.renderer().reach(0).constant;
  const auto half = uint32_t(inner * kPixels / 2);
  for (uint32_t y = kPixels / 2 - half; y < kPixels / 2 + half; ++y)
    for (uint32_t x = kPixels / 2 - half; x < kPixels / 2 + half; ++x)
      if (image[4 * (size_t(y) * kPixels + x)] > 0) return false;
  return true;
}

Found concaveContact(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const char* kernel : {"1", "3", "5", "9", "15"}) {
    if (context.quick && kernel != std::string("1") && kernel != std::string("9")) continue;
    double allowed = 0, share = 1.0 / 16;
    covers(context, kernel, 0.5, allowed);
    while (share < 2 && !covers(context, kernel, share * allowed, allowed)) share += 1.0 / 16;
    found.curve.push_back({std::stod(kernel), share, 1});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> concaveCases() {
  return {
      {.id = "concave",
       .title = "The inside of bowls, opaque and of glass, over all kernels",
       .property = "no acne (pixels of the lit inside that lose light)",
       .reason = "exact: a hollow facet recedes by what it rises over the filter",
       .parameter = "tessellation, meridians",
       .logarithmic = true,
       .run = concaveMesh},
      {.id = "concave light",
       .title = "The inside of bowls under a slanting light, over all kernels",
       .property = "no acne (pixels of the lit inside that lose light)",
       .reason = "exact: a hollow facet recedes by what it rises over the filter",
       .parameter = "incidence on the bowl's opening, degrees",
       .run = concaveLight},
      {.id = "concave contact",
       .title = "A folded sheet just above another, both hollow toward the light",
       .property = "it casts its whole shadow (smallest gap that does, over what is allowed)",
       .reason = "twice the slope of (N + 1) / 2 texels (spec 01)",
       .parameter = "kernel, texels",
       .run = concaveContact},
  };
}

}  // namespace sb

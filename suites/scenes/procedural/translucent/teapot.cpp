// The Utah teapot from its Bezier patches, opaque, on a white floor, with coloured translucent
// panes between the light and the pot. The lid is widened by 1.4 / 1.3 so that it meets the rim.
#include <cmath>
#include <tuple>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/scenes.h"
#include "suites/scenes/procedural/translucent/teapot_data.h"

namespace sb {
namespace {

constexpr size_t kFirstLidPatch = 20, kFirstBottomPatch = 28;

struct SurfacePoint {
  glm::dvec3 position, normal;
};

// Weights and derivatives of the cubic Bernstein polynomials.
std::array<double, 4> weights(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
std::array<double, 4> slopes(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

glm::dvec3 controlPoint(size_t patch, size_t i) {
  const auto& p = kTeapotControlPoints[kTeapotPatchPoints[patch][i]];
  const bool lid = patch >= kFirstLidPatch && patch < kFirstBottomPatch;
  const double widen = lid ? 1.4 / 1.3 : 1.0;
  return {p[0] * widen, p[1] * widen, p[2]};
}

glm::dvec3 sum(size_t patch, const std::array<double, 4>& a, const std::array<double, 4>& b) {
  glm::dvec3 total(0);
  for (size_t i = 0; i < 16; ++i) total += a[i / 4] * b[i % 4] * controlPoint(patch, i);
  return total;
}

SurfacePoint evaluate(size_t patch, double u, double v) {
  const auto normalAt = [&](double a, double b) {
    return glm::cross(sum(patch, weights(a), slopes(b)), sum(patch, slopes(a), weights(b)));
  };
  glm::dvec3 normal = normalAt(u, v);
  // At the poles of lid and bottom a whole side of the patch is one point: its normal is the limit.
  if (glm::length(normal) < 1e-9) {
    const auto inward = [](double t) { return t + 1e-4 * (0.5 - t); };
    normal = normalAt(inward(u), inward(v));
  }
  return {sum(patch, weights(u), weights(v)), glm::normalize(normal)};
}

// Collects vertices so that what lies at one place shares one position, and one vertex too where
// the surface is smooth there: patches meet without cracks.
class Welder {
 public:
  explicit Welder(Mesh& mesh) : m_mesh(mesh) {}
  uint32_t add(const SurfacePoint& point) {
    const glm::dvec3 cell = glm::round(point.position * 1e4);
    auto& here = m_vertices[{int(cell.x), int(cell.y), int(cell.z)}];
    for (const uint32_t v : here)
      if (glm::dot(glm::dvec3(glm::normalize(m_mesh.normals[v])), point.normal) > 0.7) {
        m_mesh.normals[v] += glm::vec3(point.normal);
        return v;
      }
    m_mesh.positions.push_back(here.empty() ? glm::vec3(point.position)
                                            : m_mesh.positions[here.front()]);
    m_mesh.normals.push_back(glm::vec3(point.normal));
    here.push_back(uint32_t(m_mesh.positions.size() - 1));
    return here.back();
  }

 private:
  Mesh& m_mesh;
  std::map<std::tuple<int, int, int>, std::vector<uint32_t>> m_vertices;
};

Mesh teapotMesh(uint32_t material, uint32_t segments) {
  Mesh mesh;
  mesh.name = "teapot";
  mesh.material = material;
  Welder welder(mesh);
  for (size_t patch = 0; patch < kTeapotPatches; ++patch) {
    std::vector<uint32_t> grid;
    for (uint32_t i = 0; i <= segments; ++i)
      for (uint32_t j = 0; j <= segments; ++j)
        grid.push_back(welder.add(evaluate(patch, double(i) / segments, double(j) / segments)));
    const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
      const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
      if (p != q && q != r && r != p) mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (uint32_t i = 0; i < segments; ++i)
      for (uint32_t j = 0; j < segments; ++j) {
        const uint32_t at = i * (segments + 1) + j;
        const uint32_t a = grid[at], b = grid[at + 1], c = grid[at + segments + 2],
                       d = grid[at + segments + 1];
        triangle(a, b, c);
        triangle(a, c, d);
      }
  }
  for (glm::vec3& normal : mesh.normals) normal = glm::normalize(normal);
  return mesh;
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t white = addMaterial(scene, matteMaterial("floor", glm::vec3(0.85f)));
  Material china = matteMaterial("china", glm::vec3(0.8f, 0.78f, 0.72f));
  china.roughness = 0.4f;
  china.doubleSided = true;  // one sheet: its inside shows through the spout
  const uint32_t pot = addMaterial(scene, china);
  const float alpha = float(p.find("alpha")->second);
  const uint32_t red = addMaterial(scene, paneMaterial("red", {0.95f, 0.08f, 0.06f}, alpha));
  const uint32_t green = addMaterial(scene, paneMaterial("green", {0.1f, 0.8f, 0.15f}, alpha));
  const uint32_t blue = addMaterial(scene, paneMaterial("blue", {0.08f, 0.2f, 0.95f}, alpha));

  // Patches are z up; the world is y up.
  const glm::dmat4 upright(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                           glm::dvec4(0, 0, 0, 1));
  addInstance(scene, "floor", addMesh(scene, quadMesh("floor", white, glm::vec2(9.0f))), upright);
  addInstance(scene, "teapot",
              addMesh(scene, teapotMesh(pot, uint32_t(p.find("segments")->second))), upright);
  // The panes stand on the floor in a row across the light's way.
  const uint32_t panes[] = {addMesh(scene, quadMesh("red", red, {1.0f, 2.2f})),
                            addMesh(scene, quadMesh("green", green, {1.0f, 2.2f})),
                            addMesh(scene, quadMesh("blue", blue, {1.0f, 2.2f}))};
  const char* names[] = {"red pane", "green pane", "blue pane"};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 at(-4.2 + 0.6 * (i - 1), 2.2, 1.7 + 1.4 * (i - 1));
    addInstance(scene, names[i], panes[i], lookFrom(at, at - glm::dvec3(-1, 0, 0.25 * (i + 1))));
  }
  scene.lights.push_back(chosenLight(p, {1, -0.75, -0.55}, {0, 1, 0}, 14));

  addView(scene, {2.6, 7.8, 14.2}, {-0.6, 1.1, 0}, 0.8, 2, 40);
  return scene;
}

}  // namespace

ProceduralScene teapot() {
  return {{"teapot", "the Utah teapot behind coloured panes",
           withLight({countParam("segments", 10, 1, 100,
                                 "tessellation: each of the 32 patches has 2 segments^2 triangles"),
                      {.name = "alpha",
                       .fallback = 0.6,
                       .low = 0,
                       .high = 1,
                       .help = "opacity of the panes"}})},
          make};
}

}  // namespace sb

// Which triangles hide light where shares are added up (spec 08: one side of closed casters, never
// both): whatever the eye or the light's centre stand in, and triangles that a mesh holds twice.
#include "tests/techniques/penumbra_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions combined(const char* combine) {
  return {.technique = "PenumbraWedge", .knobs = {{"combine", combine}}, .size = {48, 36}};
}

/// Two walls and what joins them, one closed mesh: its box is mostly empty.
Mesh archMesh() {
  Scene scene;
  const uint32_t material = add(scene, matte());
  // An outline in the xy plane, counter-clockwise, as convex pieces of its front.
  const std::vector<glm::vec2> outline = {{-1, 0},   {-0.75, 0}, {-0.75, 1}, {0.75, 1},
                                          {0.75, 0}, {1, 0},     {1, 1.25},  {-1, 1.25}};
  const uint32_t pieces[][4] = {{0, 1, 2, 7}, {2, 3, 6, 7}, {3, 4, 5, 6}};
  Mesh mesh;
  mesh.material = material;
  const auto quad = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d) {
    const auto first = uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    mesh.normals.insert(mesh.normals.end(), 4, glm::normalize(glm::cross(b - a, c - a)));
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
  };
  const auto at = [&](uint32_t i, float z) { return glm::vec3(outline[i], z); };
  for (const auto& p : pieces) {
    quad(at(p[0], 0.25f), at(p[1], 0.25f), at(p[2], 0.25f), at(p[3], 0.25f));
    quad(at(p[3], -0.25f), at(p[2], -0.25f), at(p[1], -0.25f), at(p[0], -0.25f));
  }
  for (uint32_t i = 0; i < outline.size(); ++i) {
    const uint32_t next = (i + 1) % uint32_t(outline.size());
    quad(at(i, -0.25f), at(next, -0.25f), at(next, 0.25f), at(i, 0.25f));
  }
  return mesh;
}

struct FloorErrors {
  double squares = 0, worst = 0;
  size_t pixels = 0, partly = 0;
  double rmse() const { return std::sqrt(squares / double(std::max<size_t>(1, pixels))); }
};

/// On the floor, against rays.
FloorErrors floorErrors(Cell& cell) {
  const auto [width, height] = cell.size();
  const sb::Tracer tracer(cell.scene(), width, height);
  const VisibilityImage& found = cell.visibility(0)[0];
  FloorErrors e;
  for (uint32_t y = 1; y + 1 < height; y += 2)
    for (uint32_t x = 1; x + 1 < width; x += 2) {
      bool floor = true;
      for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const auto near = tracer.pointAt(uint32_t(int(x) + dx), uint32_t(int(y) + dy), 0);
        floor &= near && near->instance == 0;
      }
      if (!floor) continue;
      const double expected = tracer.visibility(0, *tracer.pointAt(x, y, 0), {.pattern = 256}).x;
      const double error = found[4 * (size_t(y) * width + x)] - expected;
      e.squares += error * error;
      e.worst = error > e.worst || -error > e.worst || error != error ? std::abs(error) : e.worst;
      ++e.pixels;
      e.partly += expected > 0.05 && expected < 0.95;
    }
  return e;
}

/// Errors on the floor, seen from `within`, are as small as those of eyes far from all casters.
void expectRight(rhi::Device& device, Scene scene, const glm::dvec3& within,
                 const glm::dvec3& target, const std::string& what, size_t leastPartly = 15) {
  scene.cameras[0] = lookAt(within, target, 1.25);
  for (const char* combine : {"shader", "float", "exact"}) {
    Cell cell(cellDevice(device), scene, combined(combine));
    const FloorErrors e = floorErrors(cell);
    EXPECT_LE(e.rmse(), 0.02) << what << " " << combine << ", worst " << e.worst;
    EXPECT_GE(e.partly, leastPartly) << what;
    EXPECT_GE(e.pixels, 60u) << what;
  }
}

}  // namespace

GPU_TEST(PenumbraSides, AnEyeInTheBoxOfAClosedCasterSeesItsPenumbraOnce) {
  Scene scene = penumbraFloor(ball(0.3, {1.5, 4, 2})).scene;
  place(scene, add(scene, archMesh()));
  expectRight(device(), scene, {0, 0.5, 0}, {-1.5, -0.5, -1.25}, "under an arch");
  // In a corner of the box of a tetrahedron.
  Scene convex = penumbraFloor(ball(0.3, {-2.5, 2.5, -2.5})).scene;
  Mesh mesh;
  mesh.material = 0;
  mesh.positions = {{-1, 0.01f, -1}, {1, 0.01f, -1}, {-1, 0.01f, 1}, {-1, 1.5f, -1}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.indices = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
  place(convex, add(convex, mesh));
  expectRight(device(), convex, {0.75, 1.25, 0.9}, {0.9, 0, 1}, "beside a tetrahedron");
  // Mirrored, wound to be closed outward where it stands, and inside out.
  for (const bool inward : {false, true}) {
    Mesh turned = mesh;
    if (!inward)
      for (size_t i = 0; i < turned.indices.size(); i += 3)
        std::swap(turned.indices[i], turned.indices[i + 1]);
    Scene mirrored = penumbraFloor(ball(0.3, {-2.5, 2.5, 2.5})).scene;
    Material both = matte();
    both.doubleSided = true;
    turned.material = add(mirrored, both);
    place(mirrored, add(mirrored, turned), glm::dmat4(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1)));
    expectRight(device(), mirrored, {0.75, 1.25, -0.9}, {0.9, 0, -1},
                inward ? "mirrored inside out" : "mirrored");
  }
}

GPU_TEST(PenumbraSides, ALightInTheBoxOfAClosedCasterButNotInItsBody) {
  Scene scene = penumbraFloor(ball(0.25, {0, 1.5, 0})).scene;
  place(scene, add(scene, archMesh()), glm::dmat4(glm::dmat3(2)));
  Scene solid = scene;
  expectRight(device(), scene, {3, 4, 3}, {2, 0, 0}, "under an arch", 5);
  // Within its leg: nothing outside is lit.
  solid.lights[0].position = {1.75, 1.5, 0};
  solid.cameras[0] = lookAt({3, 4, 3}, {2, 0, 0}, 0.75);
  Cell cell(cellDevice(device()), solid, combined("shader"));
  const FloorErrors e = floorErrors(cell);
  EXPECT_LE(e.worst, 1e-3);
  EXPECT_GE(e.pixels, 60u);
}

GPU_TEST(PenumbraSides, TrianglesThatAMeshHoldsTwiceHideOnce) {
  const auto sheet = [](bool twice, bool turned) {
    PenumbraScene s = penumbraFloor(ball(0.5, {0.5, 4, 0.25}));
    addSheet(s, {0.25, 1.25, 0}, {1, 0.25, 0}, {0, 0.25, 0.875}, {1, 0.25, 0.875, 0.25, 1.125});
    Mesh& mesh = s.scene.meshes.back();
    const std::vector<uint32_t> once = mesh.indices;
    for (size_t i = 0; twice && i < once.size(); i += 3) {
      const uint32_t a = once[i], b = once[i + 1], c = once[i + 2];
      mesh.indices.insert(mesh.indices.end(), {a, turned ? c : b, turned ? b : c});
    }
    return s;
  };
  for (const char* combine : {"shader", "exact"}) {
    const auto shares = [&](const PenumbraScene& s) {
      Cell cell(cellDevice(device()), s.scene, combined(combine));
      expectPenumbra(cell, s, combine, 40);
      return cell.visibility(0)[0];
    };
    const VisibilityImage once = shares(sheet(false, false));
    EXPECT_EQ(shares(sheet(true, false)), once) << combine;
    EXPECT_EQ(shares(sheet(true, true)), once) << combine;
  }
}

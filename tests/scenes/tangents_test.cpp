// Generated tangents (MikkTSpace's convention, which glTF asks for): the shading normal that a normal
// map gives, also where the picture or the mesh is mirrored.
#include <gtest/gtest.h>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/procedural/parts/shapes.h"

namespace sb::test {
namespace {

/// A quad in x, y, normal +z; v is 0 at its top, u runs along +x or, mirrored, along -x.
Mesh quad(bool mirroredUv) {
  Mesh mesh = quadMesh(0, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const glm::vec3& p : mesh.positions)
    mesh.uv0.push_back({(mirroredUv ? -p.x : p.x) * 0.5f + 0.5f, 0.5f - p.y * 0.5f});
  return mesh;
}

/// The way +Y of a normal map points: bitangent as shaders take it.
glm::vec3 upOf(const Mesh& mesh, size_t vertex) {
  return glm::cross(mesh.normals[vertex], glm::vec3(mesh.tangents[vertex])) *
         mesh.tangents[vertex].w;
}

TEST(Tangents, UpOfTheMapIsUpOfThePicture) {
  for (const bool mirrored : {false, true}) {
    Mesh mesh = quad(mirrored);
    makeTangents(mesh, 0);
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(glm::vec3(mesh.tangents[i]), glm::vec3(mirrored ? -1 : 1, 0, 0));
      EXPECT_EQ(mesh.tangents[i].w, mirrored ? -1 : 1);
      EXPECT_EQ(upOf(mesh, i), glm::vec3(0, 1, 0));
    }
    // Placed by a mirror, x to -x: what was up stays up.
    const Mesh other = mirroredMesh(mesh);
    for (size_t i = 0; i < 4; ++i) {
      const glm::vec3 tangent = glm::vec3(other.tangents[i]) * glm::vec3(-1, 1, 1);
      EXPECT_EQ(glm::cross(other.normals[i], tangent) * other.tangents[i].w, glm::vec3(0, 1, 0));
    }
  }
}

TEST(Tangents, ASeamOfAMirroredPictureIsSplit) {
  // Two quads side by side share the two vertices between them; u rises toward the seam from both
  // sides.
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.uv0 = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
  mesh.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {1, 0, 1, 1}};
  mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  numberTriangles(mesh);
  const Mesh before = mesh;
  makeTangents(mesh, 0);
  EXPECT_EQ(mesh.positions.size(), 8u);
  for (size_t k = 0; k < mesh.indices.size(); ++k) {
    const uint32_t i = mesh.indices[k], was = before.indices[k];
    EXPECT_EQ(mesh.positions[i], before.positions[was]);
    EXPECT_EQ(mesh.uv0[i], before.uv0[was]);
    EXPECT_EQ(mesh.colors[i], before.colors[was]);
    EXPECT_EQ(glm::vec3(mesh.tangents[i]), glm::vec3(k < 6 ? 1 : -1, 0, 0)) << k;
    EXPECT_EQ(upOf(mesh, i), glm::vec3(0, 1, 0)) << k;
  }
}

TEST(Tangents, WithoutCoordinatesAnyPerpendicularOneWillDo) {
  Mesh mesh = quadMesh(0, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  makeTangents(mesh, 0);
  for (const glm::vec4& t : mesh.tangents) {
    EXPECT_NEAR(glm::length(glm::vec3(t)), 1, 1e-6);
    EXPECT_EQ(t.z, 0);
  }
}

}  // namespace
}  // namespace sb::test

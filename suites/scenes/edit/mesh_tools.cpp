#include "suites/scenes/edit/mesh_tools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sb {
namespace {

// Not normalized: its length is twice the area. Differences of floats are taken in double.
glm::dvec3 faceCross(const Mesh& mesh, size_t triangle) {
  const uint32_t* i = mesh.indices.data() + 3 * triangle;
  const glm::dvec3 a = mesh.positions[i[0]], b = mesh.positions[i[1]], c = mesh.positions[i[2]];
  return glm::cross(b - a, c - a);
}

double longestEdgeSquared(const Mesh& mesh, size_t triangle) {
  const uint32_t* i = mesh.indices.data() + 3 * triangle;
  const glm::dvec3 a = mesh.positions[i[0]], b = mesh.positions[i[1]], c = mesh.positions[i[2]];
  return std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
}

template <typename T>
void unshare(std::vector<T>& attribute, const std::vector<uint32_t>& indices) {
  if (attribute.empty()) return;
  std::vector<T> own(indices.size());
  for (size_t i = 0; i < indices.size(); ++i) own[i] = attribute[indices[i]];
  attribute = std::move(own);
}

/// Unit, or 0 where nothing is left.
glm::dvec3 perpendicularTo(const glm::dvec3& n, const glm::dvec3& v) {
  const glm::dvec3 p = v - n * glm::dot(n, v);
  const double length = glm::length(p);
  return length > 0 && std::isfinite(length) ? p / length : glm::dvec3(0);
}

double areaOfUv(const Mesh& mesh, const std::vector<glm::vec2>& uv, size_t triangle) {
  const uint32_t* i = mesh.indices.data() + 3 * triangle;
  const glm::dvec2 a = uv[i[0]], d1 = glm::dvec2(uv[i[1]]) - a, d2 = glm::dvec2(uv[i[2]]) - a;
  return d1.x * d2.y - d2.x * d1.y;
}

/// 1: the bitangent cross(N, T) points to where v falls, as +Y of a normal map does (glTF's v runs
/// down its pictures); -1: the picture is mirrored on this triangle; 0: uv says nothing.
int sideOfUv(const Mesh& mesh, const std::vector<glm::vec2>& uv, size_t triangle) {
  const double area = areaOfUv(mesh, uv, triangle);
  if (!(area != 0 && std::isfinite(area))) return 0;
  return area < 0 ? 1 : -1;
}

/// The way u runs in space, of any length; 0 where uv says nothing.
glm::dvec3 alongU(const Mesh& mesh, const std::vector<glm::vec2>& uv, size_t triangle) {
  const uint32_t* i = mesh.indices.data() + 3 * triangle;
  const glm::dvec3 p = mesh.positions[i[0]];
  const glm::dvec3 e1 = glm::dvec3(mesh.positions[i[1]]) - p;
  const glm::dvec3 e2 = glm::dvec3(mesh.positions[i[2]]) - p;
  const glm::dvec2 a = uv[i[0]], d1 = glm::dvec2(uv[i[1]]) - a, d2 = glm::dvec2(uv[i[2]]) - a;
  const double area = d1.x * d2.y - d2.x * d1.y;
  return area != 0 && std::isfinite(area) ? (e1 * d2.y - e2 * d1.y) / area : glm::dvec3(0);
}

template <typename T>
void duplicate(std::vector<T>& attribute, const std::vector<uint32_t>& vertices) {
  if (attribute.empty()) return;
  for (const uint32_t v : vertices) attribute.push_back(T(attribute[v]));
}

/// Gives triangles on which the picture is mirrored vertices of their own where they share some with
/// others: along the seam of a mirrored texture u runs both ways.
void splitMirrored(Mesh& mesh, uint32_t uvSet) {
  const std::vector<glm::vec2>& uv = uvSet == 0 ? mesh.uv0 : mesh.uv1;
  if (uv.empty()) return;
  std::vector<uint8_t> upright(mesh.positions.size(), 0);
  std::vector<uint32_t> copyOf(mesh.positions.size(), kNone), copied;
  for (size_t t = 0; t < mesh.triangleCount(); ++t)
    if (sideOfUv(mesh, uv, t) > 0)
      for (size_t c = 0; c < 3; ++c) upright[mesh.indices[3 * t + c]] = 1;
  for (size_t t = 0; t < mesh.triangleCount(); ++t) {
    if (sideOfUv(mesh, uv, t) >= 0) continue;
    for (size_t c = 0; c < 3; ++c) {
      uint32_t& index = mesh.indices[3 * t + c];
      if (!upright[index]) continue;
      if (copyOf[index] == kNone) {
        copyOf[index] = uint32_t(upright.size() + copied.size());
        copied.push_back(index);
      }
      index = copyOf[index];
    }
  }
  duplicate(mesh.positions, copied);
  duplicate(mesh.normals, copied);
  duplicate(mesh.uv0, copied);
  duplicate(mesh.uv1, copied);
  duplicate(mesh.colors, copied);
}

glm::vec3 anyPerpendicular(glm::vec3 n) {
  const glm::vec3 axis = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(axis - n * glm::dot(n, axis));
}

}  // namespace

void computeBounds(Mesh& mesh) {
  mesh.boundsMin = mesh.boundsMax = glm::vec3(0);
  if (mesh.indices.empty()) return;
  mesh.boundsMin = mesh.boundsMax = mesh.positions[mesh.indices[0]];
  for (const uint32_t i : mesh.indices) {
    mesh.boundsMin = glm::min(mesh.boundsMin, mesh.positions[i]);
    mesh.boundsMax = glm::max(mesh.boundsMax, mesh.positions[i]);
  }
}

void numberTriangles(Mesh& mesh) {
  mesh.triangleKeys.resize(mesh.triangleCount());
  std::iota(mesh.triangleKeys.begin(), mesh.triangleKeys.end(), 0u);
}

size_t dropDegenerate(Mesh& mesh) {
  size_t kept = 0;
  const size_t count = mesh.triangleCount();
  for (size_t t = 0; t < count; ++t) {
    // Written so that NaN counts as degenerate.
    if (!(glm::length(faceCross(mesh, t)) > 1e-12 * longestEdgeSquared(mesh, t))) continue;
    for (size_t c = 0; c < 3; ++c) mesh.indices[3 * kept + c] = mesh.indices[3 * t + c];
    mesh.triangleKeys[kept++] = mesh.triangleKeys[t];
  }
  mesh.indices.resize(3 * kept);
  mesh.triangleKeys.resize(kept);
  return count - kept;
}

void makeFlatNormals(Mesh& mesh) {
  mesh.normals.clear();
  mesh.tangents.clear();
  unshare(mesh.positions, mesh.indices);
  unshare(mesh.uv0, mesh.indices);
  unshare(mesh.uv1, mesh.indices);
  unshare(mesh.colors, mesh.indices);
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  mesh.normals.resize(mesh.indices.size());
  for (size_t t = 0; t < mesh.triangleCount(); ++t) {
    const glm::vec3 n = glm::normalize(faceCross(mesh, t));
    for (size_t c = 0; c < 3; ++c) mesh.normals[3 * t + c] = n;
  }
}

size_t repairNormals(Mesh& mesh) {
  size_t repaired = 0;
  std::vector<uint8_t> broken(mesh.normals.size());
  for (size_t i = 0; i < mesh.normals.size(); ++i) {
    const double length = glm::length(glm::dvec3(mesh.normals[i]));
    broken[i] = !(length > 1e-6 && std::isfinite(length));
    if (broken[i])
      mesh.normals[i] = glm::vec3(0, 0, 1);
    else if (std::abs(length - 1) > 1e-6)  // those of a file that was written here stay as they are
      mesh.normals[i] = glm::vec3(glm::dvec3(mesh.normals[i]) / length);
  }
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    if (!broken[mesh.indices[i]]) continue;
    mesh.normals[mesh.indices[i]] = glm::normalize(faceCross(mesh, i / 3));
    broken[mesh.indices[i]] = 0;
    ++repaired;
  }
  return repaired;
}

void makeTangents(Mesh& mesh, uint32_t uvSet) {
  splitMirrored(mesh, uvSet);
  const std::vector<glm::vec2>& uv = uvSet == 0 ? mesh.uv0 : mesh.uv1;
  std::vector<glm::dvec3> along(mesh.positions.size(), glm::dvec3(0));
  std::vector<int8_t> sides(mesh.positions.size(), 0);
  for (size_t t = 0; !uv.empty() && t < mesh.triangleCount(); ++t) {
    const uint32_t* i = mesh.indices.data() + 3 * t;
    const int side = sideOfUv(mesh, uv, t);
    const glm::dvec3 u = alongU(mesh, uv, t);
    if (side == 0 || u == glm::dvec3(0)) continue;
    for (size_t c = 0; c < 3; ++c) {
      const glm::dvec3 n = mesh.normals[i[c]], p = mesh.positions[i[c]];
      const glm::dvec3 next = perpendicularTo(n, glm::dvec3(mesh.positions[i[(c + 1) % 3]]) - p);
      const glm::dvec3 last = perpendicularTo(n, glm::dvec3(mesh.positions[i[(c + 2) % 3]]) - p);
      const double angle = std::acos(std::clamp(glm::dot(next, last), -1.0, 1.0));
      along[i[c]] += angle * perpendicularTo(n, u);
      sides[i[c]] = int8_t(side);
    }
  }
  mesh.tangents.resize(mesh.positions.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const double length = glm::length(along[i]);
    const bool usable = length > 1e-9 && std::isfinite(length);
    const glm::vec3 tangent =
        usable ? glm::vec3(along[i] / length) : anyPerpendicular(mesh.normals[i]);
    mesh.tangents[i] = glm::vec4(tangent, sides[i] < 0 ? -1.0f : 1.0f);
  }
}

Mesh mirroredMesh(const Mesh& mesh) {
  Mesh mirrored = mesh;
  for (size_t i = 0; i < mirrored.indices.size(); i += 3)
    std::swap(mirrored.indices[i + 1], mirrored.indices[i + 2]);
  for (glm::vec4& tangent : mirrored.tangents) tangent.w = -tangent.w;
  return mirrored;
}

}  // namespace sb

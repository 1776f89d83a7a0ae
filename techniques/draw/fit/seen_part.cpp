#include "techniques/draw/fit/seen_part.h"

#include <algorithm>

namespace sb {
namespace {

using glm::dvec3;

/// Corners of each face of a solid whose corners go through x first, then y, then z.
constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 2, 6, 4},
                              {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}};

std::array<Polygon, 6> facesOf(const std::array<dvec3, 8>& corners) {
  std::array<Polygon, 6> faces;
  for (size_t f = 0; f < 6; ++f)
    for (const int corner : kFaces[f]) faces[f].push_back(corners[size_t(corner)]);
  return faces;
}

std::array<dvec3, 8> cornersOf(const Box& box) {
  std::array<dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[size_t(i)] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                          i & 4 ? box.high.z : box.low.z};
  return corners;
}

std::array<HalfSpace, 6> insideOf(const Box& box) {
  return {{{{1, 0, 0}, -box.low.x},
           {{-1, 0, 0}, box.high.x},
           {{0, 1, 0}, -box.low.y},
           {{0, -1, 0}, box.high.y},
           {{0, 0, 1}, -box.low.z},
           {{0, 0, -1}, box.high.z}}};
}

double height(const HalfSpace& h, const dvec3& p) { return glm::dot(h.normal, p) + h.offset; }

/// That side of a face's plane on which `within` lies. The diagonals tell its normal: the edges of
/// a near face may be next to nothing.
HalfSpace sideOf(const Polygon& face, const dvec3& within) {
  const dvec3 n = glm::cross(face[2] - face[0], face[3] - face[1]);
  const double length = glm::length(n);
  if (!(length > 0)) return {};  // a face without area cuts nothing
  HalfSpace side{n / length, -glm::dot(n / length, face[2])};
  if (height(side, within) < 0) side = {-side.normal, -side.offset};
  return side;
}

}  // namespace

Polygon clipped(Polygon polygon, std::span<const HalfSpace> inside) {
  for (const HalfSpace& h : inside) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double ha = height(h, a), hb = height(h, b);
      if (ha >= 0) kept.push_back(a);
      if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

Frustum::Frustum(const std::array<dvec3, 8>& corners) : m_faces(facesOf(corners)) {
  dvec3 middle(0);
  for (const dvec3& c : corners) middle += c / 8.0;
  for (size_t f = 0; f < 6; ++f) m_inside[f] = sideOf(m_faces[f], middle);
}

std::vector<Polygon> Frustum::seenPart(const Box& box) const {
  const std::array<dvec3, 8> corners = cornersOf(box);
  const std::array<Polygon, 6> faces = facesOf(corners);
  const auto holds = [&](const HalfSpace& h) {
    return std::ranges::all_of(corners, [&](const dvec3& c) { return height(h, c) >= 0; });
  };
  if (std::ranges::all_of(m_inside, holds)) return {faces.begin(), faces.end()};
  std::vector<Polygon> seen;
  const auto add = [&](const Polygon& face, std::span<const HalfSpace> inside) {
    if (Polygon part = clipped(face, inside); !part.empty()) seen.push_back(std::move(part));
  };
  for (const Polygon& face : faces) add(face, m_inside);
  const std::array<HalfSpace, 6> inBox = insideOf(box);
  for (const Polygon& face : m_faces) add(face, inBox);
  return seen;
}

}  // namespace sb

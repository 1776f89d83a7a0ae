#include "techniques/scene/geometry/coplanar_surfaces.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "techniques/scene/optics.h"

namespace sb {
namespace {

using glm::dvec3;

struct Candidate {
  Facet facet;
  dvec3 low, high;
  uint32_t instance, triangle;
  bool translucent;
};

/// In the plane: does an edge of `a` have all of `b` on its outer side, or on itself?
bool separates(const Facet& a, const Facet& b, double slack) {
  for (size_t c = 0; c < 3; ++c) {
    const dvec3 edge = a.corners[(c + 1) % 3] - a.corners[c];
    const double length = glm::length(edge);
    if (length == 0) continue;
    const dvec3 inward = glm::cross(a.normal, edge / length);
    double most = -1e300;
    for (const dvec3& p : b.corners) most = std::max(most, glm::dot(inward, p - a.corners[c]));
    if (most <= slack) return true;
  }
  return false;
}

bool overlap(const Candidate& a, const Candidate& b) {
  for (int i = 0; i < 3; ++i)
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  if (!coplanar(a.facet, b.facet)) return false;
  const dvec3 ulp = a.facet.ulp + b.facet.ulp;
  const double slack = 4 * (ulp.x + ulp.y + ulp.z);
  return !separates(a.facet, b.facet, slack) && !separates(b.facet, a.facet, slack);
}

std::vector<Candidate> candidatesOf(const PlacedScene& placed) {
  const Scene& scene = placed.scene();
  std::vector<uint8_t> translucent;
  for (const Material& m : scene.materials)
    translucent.push_back(materialTraits(scene, m).cameraTranslucent);
  std::vector<Candidate> list;
  // Next to nothing is worth a search where the camera sees through nothing.
  if (std::ranges::count(translucent, 1) == 0) return list;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      Candidate c{.facet = facetOf(placed, i, t, dvec3(0)),
                  .low = {},
                  .high = {},
                  .instance = i,
                  .triangle = t,
                  .translucent = translucent[mesh.material] != 0};
      if (c.facet.normal == dvec3(0)) continue;
      c.low = glm::min(glm::min(c.facet.corners[0], c.facet.corners[1]), c.facet.corners[2]) -
              4.0 * c.facet.ulp;
      c.high = glm::max(glm::max(c.facet.corners[0], c.facet.corners[1]), c.facet.corners[2]) +
               4.0 * c.facet.ulp;
      list.push_back(c);
    }
  }
  return list;
}

/// Pairs that overlap, by a sweep along the longest axis of the scene.
std::vector<std::pair<uint32_t, uint32_t>> pairsOf(const std::vector<Candidate>& all) {
  dvec3 low(1e300), high(-1e300);
  for (const Candidate& c : all) low = glm::min(low, c.low), high = glm::max(high, c.high);
  const dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](uint32_t i) { return all[i].low[axis]; });
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  std::vector<uint32_t> active[2];  // opaque, translucent
  for (const uint32_t i : order) {
    for (const int kind : {0, 1}) {
      if (kind == 0 && !all[i].translucent) continue;
      std::erase_if(active[kind],
                    [&](uint32_t j) { return all[j].high[axis] < all[i].low[axis]; });
      for (const uint32_t j : active[kind])
        if (overlap(all[i], all[j])) pairs.emplace_back(i, j);
    }
    active[all[i].translucent].push_back(i);
  }
  return pairs;
}

double areaOf(const Facet& f) {
  return glm::length(glm::cross(f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]));
}

}  // namespace

CoplanarSurfaces::CoplanarSurfaces(const PlacedScene& placed) : m_scene(&placed.scene()) {
  const Scene& scene = *m_scene;
  const std::vector<Candidate> all = candidatesOf(placed);
  const auto pairs = pairsOf(all);
  if (pairs.empty()) return;

  // Groups of those that hang together; the plane of each is that of its largest triangle.
  std::vector<uint32_t> parent(all.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<std::vector<uint32_t>> beside(all.size());
  for (const auto& [i, j] : pairs) {
    beside[i].push_back(j);
    beside[j].push_back(i);
    parent[root(i)] = root(j);
  }
  std::vector<uint32_t> members, largest(all.size(), kNone);
  for (uint32_t i = 0; i < all.size(); ++i) {
    if (beside[i].empty()) continue;
    members.push_back(i);
    uint32_t& best = largest[root(i)];
    if (best == kNone || areaOf(all[i].facet) > areaOf(all[best].facet)) best = i;
  }
  std::ranges::sort(members, {}, [&](uint32_t i) {
    return std::pair(all[i].translucent,
                     surfaceOrder(scene, all[i].instance, all[i].triangle));
  });
  std::vector<uint32_t> rank(all.size(), kNone);
  for (const uint32_t i : members) {
    rank[i] = 0;
    for (const uint32_t j : beside[i])
      if (rank[j] != kNone && j != i) rank[i] = std::max(rank[i], rank[j] + 1);
    const Facet& plane = all[largest[root(i)]].facet;
    const bool inOpaque =
        std::ranges::any_of(beside[i], [&](uint32_t j) { return !all[j].translucent; });
    // Beyond so many surfaces in one place they share a layer.
    m_members.push_back({all[i].instance, all[i].triangle, std::min(rank[i], 0xFFFFu),
                         all[i].translucent && inOpaque, plane.normal, plane.corners[0]});
  }
}

std::vector<uint32_t> CoplanarSurfaces::words(const CameraMatrices& camera, uint32_t width,
                                              uint32_t height) const {
  std::vector<uint32_t> words(m_scene->instances.size(), 0);
  for (const Member& m : m_members) {
    if (words[m.instance] != 0) continue;
    words[m.instance] = uint32_t(words.size());
    words.resize(words.size() + m_scene->meshes[m_scene->instances[m.instance].mesh].triangleCount());
  }
  const glm::dmat4 fromClip = glm::inverse(camera.viewProjection);
  for (const Member& m : m_members) {
    const uint32_t entry = words[m.instance] + m.triangle;
    const dvec3 point = m.point - camera.eye;
    const glm::dvec4 plane = glm::dvec4(m.normal, -glm::dot(m.normal, point)) * fromClip;
    const double a = -2 * plane.x / (plane.z * width), b = -2 * plane.y / (plane.z * height);
    const double c = (plane.x + plane.y - plane.w) / plane.z;
    const uint32_t record = uint32_t(words.size());
    words.insert(words.end(), {std::bit_cast<uint32_t>(float(a)), std::bit_cast<uint32_t>(float(b)),
                               std::bit_cast<uint32_t>(float(c)),
                               m.rank | (m.inOpaque ? 0x10000u : 0u)});
    // Seen edge-on it covers no pixel.
    const bool seen = std::isfinite(a) && std::isfinite(b) && std::isfinite(c);
    words[entry] = seen ? record : 0;
  }
  return words;
}

}  // namespace sb

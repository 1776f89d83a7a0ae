#include "techniques/draw/views/view_order.h"

#include <algorithm>
#include <tuple>

#include "techniques/scene/box.h"

namespace sb {

double viewDepth(const SceneView& view, const glm::dvec3& relative) {
  return -(view.camera().view * glm::dvec4(relative, 1)).z;
}

std::vector<uint32_t> backToFront(const SceneView& view, std::span<const uint32_t> instances) {
  struct Entry {
    double depth;
    uint32_t meshKey, key, instance;
  };
  std::vector<Entry> order;
  for (const uint32_t i : instances) {
    const Box box = instanceBox(view.placed(), i, view.camera().eye);
    const Instance& instance = view.scene().instances[i];
    order.push_back({-viewDepth(view, (box.low + box.high) * 0.5),
                     view.scene().meshes[instance.mesh].key, instance.key, i});
  }
  // Of surfaces in one place the first by its keys is the nearest layer, drawn last.
  std::ranges::sort(order, [](const Entry& a, const Entry& b) {
    return std::tie(a.depth, b.meshKey, b.key) < std::tie(b.depth, a.meshKey, a.key);
  });
  std::vector<uint32_t> out;
  for (const Entry& e : order) out.push_back(e.instance);
  return out;
}

}  // namespace sb

#include "techniques/scene/tree/scene_tree.h"

#include "techniques/scene/tree/box_hierarchy.h"
#include "techniques/scene/tree/quad_tree.h"

namespace sb {
namespace {

class List final : public SceneTree {
 public:
  explicit List(std::span<const Box> boxes) : m_boxes(boxes.begin(), boxes.end()) {}
  void place(uint32_t object, const Box& box) override { m_boxes[object] = box; }
  void remove(uint32_t object) override { m_boxes[object] = Box(); }
  uint64_t query(const ConvexRegion& region, std::vector<uint32_t>& found) const override {
    for (uint32_t i = 0; i < m_boxes.size(); ++i)
      if (region.lies(m_boxes[i]) != Lies::Outside) found.push_back(i);
    return m_boxes.size();
  }

 private:
  std::vector<Box> m_boxes;
};

}  // namespace

std::unique_ptr<SceneTree> makeSceneTree(TreeKind kind, std::span<const Box> boxes) {
  switch (kind) {
    case TreeKind::QuadTree:
      return std::make_unique<QuadTree>(boxes);
    case TreeKind::Boxes:
      return std::make_unique<BoxHierarchy>(boxes);
    case TreeKind::List:
      break;
  }
  return std::make_unique<List>(boxes);
}

}  // namespace sb

// The chosen scene and the transforms of its nodes.
#include "suites/scenes/gltf/nodes/roots.h"

#include <cmath>
#include <limits>

#include "base/number.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

constexpr size_t kNoParent = size_t(-1);
/// Squares and products of world coordinates must fit into a float.
constexpr double kFarthest = 1e18;

glm::dmat4 localTransform(GltfContext& context, size_t index) {
  const tinygltf::Node& node = context.model.nodes[index];
  const std::string field = fieldAt("nodes", index);
  const auto posed = context.poses.find(int(index));
  const NodePose pose = posed == context.poses.end() ? NodePose() : posed->second;
  const bool moved = !pose.translation.empty() || !pose.rotation.empty() || !pose.scale.empty();
  if (!node.matrix.empty()) {
    if (!node.translation.empty() || !node.rotation.empty() || !node.scale.empty())
      context.warn(field + " has a matrix and other transforms: the matrix is used");
    if (moved) context.warn(field + " has a matrix and is animated: the matrix is used");
    glm::dmat4 m(1);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[size_t(i)];
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
      context.fail(field + ".matrix", "has a last row other than 0, 0, 0, 1");
    return m;
  }
  const auto part = [](const std::vector<double>& animated, const std::vector<double>& own) {
    return !animated.empty() ? animated.data() : !own.empty() ? own.data() : nullptr;
  };
  return composed(context, field, part(pose.translation, node.translation),
                  part(pose.rotation, node.rotation), part(pose.scale, node.scale));
}

}  // namespace

bool finite(const glm::dmat4& m) {
  for (int i = 0; i < 16; ++i)
    if (!(std::abs(m[i / 4][i % 4]) <= kFarthest)) return false;
  return true;
}

bool flattens(const glm::dmat4& toWorld) {
  const glm::dmat3 linear(toWorld);
  const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  return !(std::abs(glm::determinant(linear)) > 1e-12 * size);
}

glm::dmat4 composed(GltfContext& context, const std::string& field, const double* translation,
                    const double* r, const double* scale) {
  glm::dmat4 m(1);
  if (r) {
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (!(length > 1e-6 && std::isfinite(length)))
      context.fail(field + ".rotation", "has no length, expected a unit quaternion");
    if (std::abs(length - 1) > 1e-3)
      context.warn(field + ".rotation is not a unit quaternion; it was normalized");
    const double x = r[0] / length, y = r[1] / length, z = r[2] / length, w = r[3] / length;
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
    m[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
    m[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
  }
  if (scale)
    for (int i = 0; i < 3; ++i) m[i] *= scale[i];
  if (translation) m[3] = {translation[0], translation[1], translation[2], 1};
  return m;
}

NodeTree::NodeTree(GltfContext& context)
    : m_context(context),
      m_parent(context.model.nodes.size(), kNoParent),
      m_toWorld(context.model.nodes.size(), glm::dmat4(1)),
      m_known(context.model.nodes.size()) {
  for (size_t i = 0; i < m_parent.size(); ++i)
    for (const int child : context.model.nodes[i].children) m_parent[size_t(child)] = i;
}

const glm::dmat4& NodeTree::toWorld(size_t node) {
  // An own stack: files may nest nodes deeper than the machine's.
  std::vector<size_t> chain;
  for (size_t n = node; n != kNoParent && !m_known[n]; n = m_parent[n]) chain.push_back(n);
  for (auto n = chain.rbegin(); n != chain.rend(); ++n) {
    const size_t parent = m_parent[*n];
    m_toWorld[*n] = localTransform(m_context, *n);
    if (parent != kNoParent) m_toWorld[*n] = m_toWorld[parent] * m_toWorld[*n];
    if (!finite(m_toWorld[*n]))
      m_context.fail(fieldAt("nodes", *n),
                     "its transform overflows, expected numbers of at most 1e18");
    m_known[*n] = 1;
  }
  return m_toWorld[node];
}

size_t NodeTree::chosenScene() {
  const auto& scenes = m_context.model.scenes;
  const std::string& wanted = m_context.source.options.scene;
  if (wanted.empty()) return size_t(std::max(m_context.model.defaultScene, 0));
  std::vector<std::string> names;
  for (size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i].name == wanted) return i;
    names.push_back(scenes[i].name);
  }
  const auto index = base::readWhole(wanted, 0, std::numeric_limits<uint64_t>::max());
  if (index && *index < scenes.size()) return size_t(*index);
  m_context.fail("scenes",
                 (index ? "there is no number " + wanted : unknownName("scene", wanted, names)) +
                     " (--gltf-scene), the file holds " + std::to_string(scenes.size()));
}

std::vector<size_t> NodeTree::roots() {
  const tinygltf::Model& model = m_context.model;
  if (!model.scenes.empty() || !m_context.source.options.scene.empty()) {
    const size_t scene = chosenScene();
    const tinygltf::Scene& chosen = model.scenes[scene];
    if (model.scenes.size() > 1)
      m_context.warn("the file holds " + std::to_string(model.scenes.size()) +
                     " scenes; the picture shows scenes[" + std::to_string(scene) + "]" +
                     (chosen.name.empty() ? "" : " '" + chosen.name + "'") +
                     " (--gltf-scene NAME|INDEX shows another)");
    readSceneExtras(m_context, fieldAt("scenes", scene), chosen.extras);
    return {chosen.nodes.begin(), chosen.nodes.end()};
  }
  std::vector<size_t> roots;
  for (size_t i = 0; i < m_parent.size(); ++i)
    if (m_parent[i] == kNoParent) roots.push_back(i);
  if (!roots.empty()) m_context.warn("the file names no scene; all its nodes are shown");
  return roots;
}

std::vector<NodeTree::Shown> NodeTree::shown() {
  const std::vector<size_t> tops = roots();
  // A node that the scene lists although it has a parent is shown once: under that parent if the
  // scene shows it, else by itself.
  std::vector<uint8_t> listed(m_parent.size()), seen(m_parent.size());
  for (const size_t top : tops) listed[top] = 1;
  enum : uint8_t { kUnknown, kNo, kYes };
  std::vector<uint8_t> below(m_parent.size(), kUnknown);  // remembered: chains may be long
  std::vector<size_t> chain;
  const auto belowAnother = [&](size_t node) {
    chain.clear();
    for (size_t n = node; n != kNoParent && below[n] == kUnknown; n = m_parent[n])
      chain.push_back(n);
    for (auto n = chain.rbegin(); n != chain.rend(); ++n) {
      const size_t parent = m_parent[*n];
      below[*n] = parent != kNoParent && (listed[parent] || below[parent] == kYes) ? kYes : kNo;
    }
    return below[node] == kYes;
  };
  std::vector<Shown> stack, out;
  for (auto top = tops.rbegin(); top != tops.rend(); ++top)
    if (!belowAnother(*top)) stack.push_back({*top, false});
  while (!stack.empty()) {
    Shown at = stack.back();
    stack.pop_back();
    if (seen[at.node]) continue;
    seen[at.node] = 1;
    const tinygltf::Node& node = m_context.model.nodes[at.node];
    const auto visibility = node.extensions.find("KHR_node_visibility");
    if (visibility != node.extensions.end() && visibility->second.Has("visible"))
      at.hidden |= !visibility->second.Get("visible").Get<bool>();
    out.push_back(at);
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      stack.push_back({size_t(*child), at.hidden});
  }
  return out;
}

}  // namespace sb

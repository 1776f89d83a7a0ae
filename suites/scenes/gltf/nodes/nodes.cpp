// The node tree: instances, lights, cameras and media with their place in the world, in double.
#include <cmath>

#include "suites/scenes/gltf/nodes/roots.h"
#include "suites/scenes/gltf/surfaces/deform.h"
#include "suites/scenes/gltf/surfaces/variants.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

/// A node's meshes as they are shown: those of its glTF mesh, or bent copies.
struct Shape {
  std::vector<uint32_t> parts;
  glm::dmat4 toWorld;
  size_t node = kNoNode;             ///< that it follows
  glm::dmat4 place = glm::dmat4(1);  ///< relative to it
};

void addInstances(GltfContext& context, const std::string& field, const std::string& name,
                  const Shape& shape, Variants& variants) {
  Scene& scene = context.scene;
  if (shape.parts.empty()) return;
  if (flattens(shape.toWorld)) {
    context.warn(field + " is flattened by its transform (scale 0) and left out");
    return;
  }
  for (const uint32_t part : shape.parts) {
    if (scene.instances.size() == kMaxInstances)
      context.fail(field, "is one instance more than the " + std::to_string(kMaxInstances) +
                              " that are read");
    const uint32_t key = uint32_t(scene.instances.size());
    scene.instances.push_back({name, variants.get(part, shape.toWorld), shape.toWorld, key});
    context.followers.instances.emplace_back(shape.node, shape.place);
    checkReach(context, field, scene.meshes[scene.instances.back().mesh], shape.toWorld);
  }
}

std::string nameOf(const tinygltf::Node& node, size_t index) {
  return node.name.empty() ? "node" + std::to_string(index) : node.name;
}

// Bent meshes are made before variants of any mesh are, which stand behind them.
std::map<size_t, Shape> bentShapes(GltfContext& context, NodeTree& tree,
                                   const std::vector<NodeTree::Shown>& shown) {
  std::map<size_t, Shape> shapes;
  std::map<std::tuple<size_t, int, std::vector<double>>, std::vector<uint32_t>> made;
  for (const auto& [index, hidden] : shown) {
    const tinygltf::Node& node = context.model.nodes[index];
    if (node.mesh < 0 || hidden) continue;
    const Deform deform = nodeDeform(context, tree, index);
    const size_t mesh = size_t(node.mesh);
    if (!deform.skinned() && deform.weights == meshWeights(context, mesh)) continue;
    const auto [found, added] = made.try_emplace({mesh, deform.skin, deform.weights});
    if (added) found->second = readBentMeshes(context, mesh, deform);
    Shape shape{found->second, tree.toWorld(index), index};
    // A skin says where vertices are in the world: the node's own place has no say.
    if (deform.skinned()) {
      shape.toWorld = glm::dmat4(1);
      shape.toWorld[3] = glm::dvec4(deform.origin, 1);
      shape.node = kNoNode;
      if (context.source.options.animation)
        context.warn("skinned meshes keep the shape and place that they have at t = 0");
    }
    shapes[index] = std::move(shape);
  }
  return shapes;
}

void addMesh(GltfContext& context, NodeTree& tree, size_t index,
             const std::map<size_t, Shape>& bent, Variants& variants) {
  const tinygltf::Node& node = context.model.nodes[index];
  const std::string field = fieldAt("nodes", index), name = nameOf(node, index);
  const auto found = bent.find(index);
  const Shape shape = found != bent.end()
                          ? found->second
                          : Shape{context.meshes[size_t(node.mesh)], tree.toWorld(index), index};
  if (!node.extensions.contains("EXT_mesh_gpu_instancing"))
    return addInstances(context, field, name, shape, variants);
  const std::vector<glm::dmat4> places = gpuInstances(context, index);
  for (size_t i = 0; i < places.size(); ++i) {
    const glm::dmat4 toWorld = shape.toWorld * places[i];
    if (!finite(toWorld))
      context.fail(
          field + ".extensions.EXT_mesh_gpu_instancing",
          "instance " + std::to_string(i) + " overflows, expected numbers of at most 1e18");
    addInstances(context, field, fieldAt(name, i), {shape.parts, toWorld, shape.node, places[i]},
                 variants);
  }
}

}  // namespace

void checkReach(GltfContext& context, const std::string& field, const Mesh& mesh,
                const glm::dmat4& toWorld) {
  const Box box = transformedBox(meshBox(mesh), toWorld);
  if (!(glm::length(box.low) < 1e18 && glm::length(box.high) < 1e18))
    context.fail(field, "shows a mesh beyond 1e18 world units from the origin, expected less");
}

void readNodes(GltfContext& context) {
  NodeTree tree(context);
  const std::vector<NodeTree::Shown> shown = tree.shown();
  const std::map<size_t, Shape> bent = bentShapes(context, tree, shown);
  Variants variants(context);
  for (const auto& [index, hidden] : shown) {
    const tinygltf::Node& node = context.model.nodes[index];
    const std::string field = fieldAt("nodes", index);
    const glm::dmat4& toWorld = tree.toWorld(index);
    if (node.camera >= 0) addCamera(context, field, node.camera, toWorld);
    context.followers.cameras.resize(context.scene.cameras.size(), index);
    if (hidden) continue;
    if (node.mesh >= 0) addMesh(context, tree, index, bent, variants);
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) addLight(context, field, light->second, toWorld);
    context.followers.lights.resize(context.scene.lights.size(), index);
    const size_t media = context.scene.media.size();
    readMediumExtras(context, field, node.extras, toWorld);
    if (context.scene.media.size() > media) context.scene.media.back().name = nameOf(node, index);
  }
  if (context.model.nodes.empty() && !context.scene.meshes.empty()) {
    context.warn("the file has no nodes; each mesh is shown once, at the origin");
    for (size_t m = 0; m < context.meshes.size(); ++m)
      addInstances(context, fieldAt("meshes", m), context.model.meshes[m].name,
                   {context.meshes[m], glm::dmat4(1)}, variants);
  }
  variants.arrange();
  closeFarPlanes(context.scene);
}

}  // namespace sb

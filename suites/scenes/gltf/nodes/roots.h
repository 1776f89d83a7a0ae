// Which nodes a file shows and where they stand. Internal to the loader.
#pragma once

#include <vector>

#include "suites/scenes/gltf/context.h"

namespace sb {

/// Nodes with their transforms in the world, in double, each worked out once.
class NodeTree {
 public:
  explicit NodeTree(GltfContext& context);
  /// Product of the local transforms from the root down. Fails, naming the node, if it overflows.
  const glm::dmat4& toWorld(size_t node);

  struct Shown {
    size_t node;
    bool hidden;  ///< by KHR_node_visibility, its own or an ancestor's
  };
  /// Nodes of the chosen scene, parents first, in the file's order.
  std::vector<Shown> shown();

 private:
  std::vector<size_t> roots();
  size_t chosenScene();

  GltfContext& m_context;
  std::vector<size_t> m_parent;
  std::vector<glm::dmat4> m_toWorld;
  std::vector<uint8_t> m_known;
};

// nodes_lights.cpp
void addLight(GltfContext& context, const std::string& node, const tinygltf::Value& reference,
              const glm::dmat4& toWorld);
void addCamera(GltfContext& context, const std::string& node, int index, const glm::dmat4& toWorld);
/// Far planes for cameras that see to infinity: behind the scene.
void closeFarPlanes(Scene& scene);

/// Transforms of EXT_mesh_gpu_instancing relative to their node; empty: the node has none.
std::vector<glm::dmat4> gpuInstances(GltfContext& context, size_t node);

/// A transform of the three parts, the rotation normalized. Fails naming `field`.
glm::dmat4 composed(GltfContext& context, const std::string& field, const double* translation,
                    const double* rotation, const double* scale);
bool finite(const glm::dmat4& m);
/// Fails where a mesh would reach too far for floats.
void checkReach(GltfContext& context, const std::string& field, const Mesh& mesh,
                const glm::dmat4& toWorld);
/// Does it take away all volume?
bool flattens(const glm::dmat4& toWorld);

}  // namespace sb

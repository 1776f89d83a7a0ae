// Skins and morph targets, applied while a mesh is read. Internal to the loader.
#pragma once

#include <string>
#include <vector>

#include "suites/scenes/gltf/context.h"
#include "suites/scenes/gltf/nodes/roots.h"

namespace sb {

/// What bends the meshes of one node.
struct Deform {
  std::vector<double> weights;        ///< of morph targets, up to the last that is not 0
  int skin = -1;                      ///< its number; -1: none
  std::vector<glm::dmat4> palette;    ///< of joints: bind pose -> world relative to `origin`
  glm::dvec3 origin = glm::dvec3(0);  ///< world point that skinned positions are relative to
  bool skinned() const { return !palette.empty(); }
};

/// Weights of a mesh's morph targets where no node states others.
std::vector<double> meshWeights(const GltfContext& context, size_t mesh);
/// What bends the meshes of `node`: its animated or own weights, else those of its mesh; its skin.
Deform nodeDeform(GltfContext& context, NodeTree& tree, size_t node);

/// The primitives of a mesh once more, bent: their numbers in Scene::meshes. mesh.cpp.
std::vector<uint32_t> readBentMeshes(GltfContext& context, size_t mesh, const Deform& deform);

/// Adds the weighted targets of a primitive to positions, normals and tangents.
void applyMorph(GltfContext& context, size_t mesh, size_t primitive,
                const std::vector<double>& weights, Mesh& out);
/// Moves a mesh's vertices with their joints.
void applySkin(GltfContext& context, size_t mesh, size_t primitive, const Deform& deform,
               Mesh& out);

}  // namespace sb

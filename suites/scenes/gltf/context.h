// What the parts of the glTF loader share while one file becomes a Scene. Internal to the loader.
#pragma once

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "suites/scenes/gltf/nodes/animation.h"
#include "suites/scenes/gltf/source/source.h"
#include "techniques/scene/scene.h"

namespace sb {

constexpr size_t kNoNode = size_t(-1);

/// Which node each thing of the scene hangs on, in the scene's order.
struct Followers {
  /// With its place relative to the node; kNoNode: it stands, whatever moves.
  std::vector<std::pair<size_t, glm::dmat4>> instances;
  std::vector<size_t> lights, cameras;
};

struct GltfContext {
  GltfSource& source;
  const tinygltf::Model& model;
  Scene& scene;
  size_t vertices = 0;         ///< made so far, against kMaxVertices
  size_t triangles = 0;        ///< made so far, against kMaxTriangles
  size_t degenerate = 0;       ///< triangles dropped
  size_t repairedNormals = 0;  ///< normals of no length, replaced
  size_t pixels = 0;           ///< of all images, against kMaxImagePixels
  std::map<int, NodePose> poses = {};  ///< of animated nodes
  /// Scene meshes of each glTF mesh, one per primitive that draws triangles.
  std::vector<std::vector<uint32_t>> meshes = {};
  Followers followers = {};

  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    source.fail(field, what);
  }
  void warn(const std::string& what) { source.warn(what); }
};

/// "key[i]"
inline std::string fieldAt(const std::string& key, size_t i) {
  return key + "[" + std::to_string(i) + "]";
}

/// The checked JSON, without buffers and images, as tinygltf reads it. Throws InputError.
tinygltf::Model parseModel(const GltfSource& source);

// One step each, in this order.
void readPoses(GltfContext& context);  ///< the animation at t = 0
void readImages(GltfContext& context);
void readMaterials(GltfContext& context);
void readMeshes(GltfContext& context);
void readNodes(GltfContext& context);  ///< instances, lights, cameras, media
void playAnimation(GltfContext& context);  ///< the scene's path, where one is to play

/// Textures as TextureSlot: texture.cpp.
TextureSlot readTextureSlot(GltfContext& context, const std::string& field, int texture,
                            int texCoord, const tinygltf::ExtensionMap& extensions, bool srgb);

// extras.shadowbench (EXTRAS.md): extras.cpp. `field` names the object that holds `extras`.
void readMaterialExtras(const GltfContext& context, const std::string& field,
                        const tinygltf::Value& extras, Material& material);
/// Extent of a light whose type is known; `frame`: its axes in the world, columns.
void readLightExtras(const GltfContext& context, const std::string& field,
                     const tinygltf::Value& extras, const glm::dmat3& frame, Light& light);
/// Appends a medium if the node's extras state one.
void readMediumExtras(GltfContext& context, const std::string& field, const tinygltf::Value& extras,
                      const glm::dmat4& toWorld);
void readSceneExtras(GltfContext& context, const std::string& field, const tinygltf::Value& extras);

/// Elements of accessor `index` as floats, `components` each; normalized integers become [0,1] or
/// [-1,1]. Sparse accessors are resolved. Fails, naming `field` and accessor, on numbers that are
/// not finite. At most `count` elements from `first` on.
std::vector<float> readFloats(const GltfContext& context, const std::string& field, int index,
                              int components, size_t first = 0, size_t count = size_t(-1));
/// Elements of a SCALAR accessor of unsigned integers.
std::vector<uint32_t> readIndices(const GltfContext& context, const std::string& field, int index);
/// Components of an element: 1 for SCALAR ... 4 for VEC4; fails for matrices.
int componentCount(const GltfContext& context, const std::string& field, int index);

}  // namespace sb

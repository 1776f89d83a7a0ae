// Variants of meshes and materials that instances need. Internal to the loader.
#pragma once

#include <cmath>
#include <tuple>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/gltf/context.h"

namespace sb {

// Meshes as instances need them: a mirroring transform wants the winding reversed, and a volume's
// thickness, stated in mesh units, grows with the scale of the node.
class Variants {
 public:
  explicit Variants(GltfContext& context) : m_context(context) {}

  uint32_t get(uint32_t mesh, const glm::dmat4& toWorld) {
    Scene& scene = m_context.scene;
    const double determinant = glm::determinant(glm::dmat3(toWorld));
    const bool mirrored = determinant < 0;
    double scale = 1;
    if (scene.materials[scene.meshes[mesh].material].thickness > 0) {
      scale = std::cbrt(std::abs(determinant));
      if (std::abs(scale - 1) < 1e-6) scale = 1;
    }
    const auto [found, added] = m_meshes.try_emplace({mesh, mirrored, scale}, mesh);
    if (!added || (!mirrored && scale == 1)) return found->second;
    m_context.source.take("nodes", scene.meshes[mesh].positions.size(), 72);
    m_context.source.take("nodes", scene.meshes[mesh].indices.size(), 6);
    Mesh variant = mirrored ? mirroredMesh(scene.meshes[mesh]) : scene.meshes[mesh];
    if (scale != 1) variant.material = thickened(variant.material, scale);
    variant.key = uint32_t(scene.meshes.size());
    m_context.vertices += variant.positions.size();
    m_context.triangles += variant.triangleCount();
    if (m_context.vertices > kMaxVertices || m_context.triangles > kMaxTriangles)
      m_context.fail("nodes", "instances take the file beyond " + std::to_string(kMaxVertices) +
                                  " vertices or triangles");
    scene.meshes.push_back(std::move(variant));
    m_baseOfMesh.push_back(mesh);
    return found->second = uint32_t(scene.meshes.size() - 1);
  }

  /// Drops meshes that no instance shows and materials that thickened ones replace; puts variants
  /// where what they come from stood; numbers the meshes' keys in that order.
  void arrange() {
    Scene& scene = m_context.scene;
    std::vector<uint8_t> shown(scene.meshes.size());
    for (const Instance& instance : scene.instances) shown[instance.mesh] = 1;
    const std::vector<uint32_t> meshes = placesOf(shown, m_baseOfMesh);
    move(scene.meshes, meshes);
    for (Instance& instance : scene.instances) instance.mesh = meshes[instance.mesh];

    std::vector<uint8_t> kept(scene.materials.size(), 1);
    for (const uint32_t base : m_baseOfMaterial) kept[base] = 0;
    for (const Mesh& mesh : scene.meshes) kept[mesh.material] = 1;
    const std::vector<uint32_t> materials = placesOf(kept, m_baseOfMaterial);
    move(scene.materials, materials);
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
      scene.meshes[i].key = uint32_t(i);
      scene.meshes[i].material = materials[scene.meshes[i].material];
    }
  }

 private:
  uint32_t thickened(uint32_t material, double scale) {
    Scene& scene = m_context.scene;
    const auto [found, added] =
        m_materials.try_emplace({material, scale}, uint32_t(scene.materials.size()));
    if (added) {
      scene.materials.push_back(scene.materials[material]);
      scene.materials.back().thickness *= float(scale);
      if (!std::isfinite(scene.materials.back().thickness))
        m_context.fail("nodes", "scale the thickness of a material beyond what a float can hold");
      m_baseOfMaterial.push_back(material);
    }
    return found->second;
  }

  // New place of each item, kNone for those not kept. Variants, whose bases are listed, stand at
  // the end and move to their bases.
  static std::vector<uint32_t> placesOf(const std::vector<uint8_t>& kept,
                                        const std::vector<uint32_t>& bases) {
    std::vector<std::vector<uint32_t>> groups(kept.size() - bases.size());
    for (uint32_t i = 0; i < kept.size(); ++i)
      if (kept[i]) groups[i < groups.size() ? i : bases[i - groups.size()]].push_back(i);
    std::vector<uint32_t> places(kept.size(), kNone);
    uint32_t next = 0;
    for (const auto& group : groups)
      for (const uint32_t i : group) places[i] = next++;
    return places;
  }

  template <typename T>
  static void move(std::vector<T>& items, const std::vector<uint32_t>& places) {
    std::vector<T> moved(
        size_t(std::ranges::count_if(places, [](uint32_t p) { return p != kNone; })));
    for (size_t i = 0; i < items.size(); ++i)
      if (places[i] != kNone) moved[places[i]] = std::move(items[i]);
    items = std::move(moved);
  }

  GltfContext& m_context;
  std::vector<uint32_t> m_baseOfMesh, m_baseOfMaterial;  ///< of each variant, in order
  std::map<std::tuple<uint32_t, bool, double>, uint32_t> m_meshes;
  std::map<std::pair<uint32_t, double>, uint32_t> m_materials;
};

}  // namespace sb

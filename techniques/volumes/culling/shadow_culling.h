// Which shadow volumes a frame needs (spec 07, culling; thesis of the third source document,
// sections 5.3 and 5.4). In this order: lights that reach nothing in view; casters beyond a light's
// range; volumes that lie beside the view, or beside all that is seen of what the light reaches;
// and, with a budget, the least important ones. All but the last leave the picture as it is, bit
// for bit. Chosen anew at every step of what moves, by trees over instances and lights.
#pragma once

#include <array>

#include "techniques/draw/views/scene_view.h"
#include "techniques/scene/tree/scene_tree.h"
#include "techniques/volumes/culling/volume_bounds.h"

namespace sb {

struct CullingChoice {
  bool extents = false;  ///< penumbrae are drawn: lights are as large as they are
  bool cull = true;      ///< false: each caster of the scene in each light that touches the view
  TreeKind tree = TreeKind::QuadTree;
  /// Triangles of casters in a frame; the volumes that come first fill it. 0: no limit.
  uint64_t budget = 0;
};

/// A light, and what throws its shadow.
struct LightCasters {
  uint32_t light = 0;                    ///< index into Scene::lights
  std::vector<uint32_t> instances = {};  ///< in scene order, never empty
  /// Pixels outside get no light; nothing: all may get some.
  std::optional<rhi::Rect> scissor = {};
};

/// What becomes of a volume, in the order in which it is asked.
enum class VolumeFate : uint8_t {
  LightUnseen,
  OutOfReach,
  OutOfView,
  OffReceivers,
  OverBudget,
  Drawn,
  Count
};

struct CullingCounts {
  struct Volumes {
    uint64_t volumes = 0, triangles = 0;  ///< the latter of their casters
  };
  uint64_t lights = 0, unseenLights = 0;
  std::array<Volumes, size_t(VolumeFate::Count)> fates = {};
  uint64_t boxTests = 0;  ///< boxes held against regions, by trees
  Volumes& operator[](VolumeFate fate) { return fates[size_t(fate)]; }
};

/// Instances that cast in a light. Perforated ones are whole triangles here.
std::vector<uint32_t> volumeCasters(const LightEffects& light);

/// As records name them.
std::vector<std::pair<std::string, uint64_t>> namedCounts(const CullingCounts& counts);

class ShadowCulling {
 public:
  /// While techniques prepare: the view shows the whole path.
  ShadowCulling(const SceneView& view, const CullingChoice& choice);

  /// Where everything is now.
  std::vector<LightCasters> casters();
  /// All that casters() may give: nothing of it culled.
  const std::vector<LightCasters>& all() const { return m_all; }
  /// Of the last casters().
  const CullingCounts& counts() const { return m_counts; }

 private:
  struct Volume {
    uint32_t light, instance;
    uint64_t triangles;  ///< of the caster
    VolumeBounds bounds;
    double reach;
  };
  void place();
  Box placedBox(uint32_t instance) const;
  /// Of a light with a range.
  std::optional<Sphere> reachOf(uint32_t light) const;
  Box lightBox(uint32_t light) const;
  uint64_t triangles(uint32_t instance) const;
  void count(VolumeFate fate, uint64_t triangles);
  void query(const SceneTree& tree, const ConvexRegion& region, std::vector<uint32_t>& found);
  /// What the camera sees of what the light reaches, relative to the eye.
  Box receivers(const ConvexRegion& seen, const std::optional<Sphere>& reach);
  void cull(const LightCasters& light, const ConvexRegion& seen, std::vector<Volume>& kept);
  void keepWithinBudget(std::vector<Volume>& volumes);
  double importance(const Volume& volume) const;

  const SceneView& m_view;
  const CullingChoice m_choice;
  std::vector<LightCasters> m_all;
  std::vector<Box> m_boxes;  ///< of instances, in the world
  std::unique_ptr<SceneTree> m_instances, m_lights;
  double m_size = 0;  ///< of everything, at first
  CullingCounts m_counts;
};

}  // namespace sb

// The shadow volumes of a frame (spec 07): for each light the casters that may darken the view,
// which of their triangles cast, and how their volumes are counted. Chosen anew at every step of a
// path: all of it depends on where light, caster and camera are.
#pragma once

#include <optional>

#include "shaders/common/shared_volume.h"
#include "techniques/draw/views/scene_view.h"
#include "techniques/volumes/culling/shadow_culling.h"
#include "techniques/volumes/edges/edge_buffers.h"

namespace sb {

/// What a ray from the eye counts: volumes entered and left before the receiver, or behind it.
enum class DepthCount : uint8_t { Pass, Fail };

/// What is the same for all casters; absent: chosen for each, so that the picture is exact.
struct VolumeChoice {
  std::optional<uint32_t> casts = {};  ///< CASTS_*
  std::optional<DepthCount> count = {};
  bool finite = false;  ///< extruded as far as the light reaches, else to infinity
  /// Shares of what casts are added up: closed casters cast by one of their sides, whichever is
  /// right, never by both, and triangles that a mesh holds twice cast once. What casts is listed
  /// whether its caps are drawn or not.
  bool addsUp = false;
  bool byLoops = false;  ///< with addsUp: items are sorted by the loops of silhouettes
};

struct CasterVolume {
  uint32_t instance = 0;
  uint32_t mesh = 0;
  DepthCount count = DepthCount::Fail;
  std::vector<uint32_t> parts;               ///< VOLUME_*, those that are drawn
  std::vector<uint32_t> caps = {CAPS_BOTH};  ///< CAPS_*, what of them is drawn, one by one
  gpu::VolumeData data{};                    ///< but for the lists
  /// Items of each part (shaders/common/volume_vertex.glsl), at most.
  std::array<uint32_t, VOLUME_PARTS> items{};
  uint32_t number = 0;  ///< among all volumes of the frame

  uint32_t verticesOfItem(uint32_t part) const {
    return part == VOLUME_SIDES ? data.vertices.x : data.vertices.y;
  }
  uint32_t vertices(uint32_t part) const { return items[part] * verticesOfItem(part); }
};

struct LightVolumes {
  uint32_t light = 0;  ///< index into Scene::lights
  std::vector<CasterVolume> casters;
  std::optional<rhi::Rect> scissor = {};  ///< as LightCasters
};

/// The volumes of casters where they are now. `edges`: of all of them.
std::vector<LightVolumes> lightVolumes(const SceneView& view, const EdgeBuffers& edges,
                                       const VolumeChoice& choice,
                                       const std::vector<LightCasters>& lights);

}  // namespace sb

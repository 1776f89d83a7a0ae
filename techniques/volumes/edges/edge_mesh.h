// The edges of a mesh for shadow volumes and wedges (spec 07, signed edge multiplicity): any
// triangle soup, closed or not. What casts is the sum of whole triangles, each a closed chain of
// its three edges; so the sides that an edge needs are its signed sum over the triangles that cast.
#pragma once

#include <functional>
#include <vector>

#include "shaders/common/shared_edges.h"
#include "techniques/scene/scene.h"

namespace sb {

struct EdgeMesh {
  /// In the order of their vertices. Corners at one position are one vertex; triangles without area
  /// have no edges. Of triangles that meet at an edge those of opposite direction are paired first,
  /// so that parts that are closed cancel within one record.
  std::vector<gpu::EdgeData> edges;
  std::vector<uint32_t> triangles;  ///< that may cast, of the mesh
  /// Every edge has two triangles, of opposite direction: the mesh encloses a volume.
  bool closed = false;
  /// Closed meshes: 1 where every connected part encloses its inside as it is wound, -1 where every
  /// one is inside out; else 0.
  int winding = 0;
};

/// Triangles without area neither cast nor have edges.
bool hasArea(const Mesh& mesh, uint32_t triangle);

/// Triangles of a mesh at the same three corners, whichever way they are wound.
enum class Doubles : uint8_t {
  Each,  ///< cast each for itself: two surfaces
  Once,  ///< cast as one: the first
};
EdgeMesh edgeMesh(const Mesh& mesh, Doubles doubles = Doubles::Each);

/// Signed number of sides along an edge; `casts`: of a triangle, 1 as it is wound, -1 turned over,
/// 0 not at all.
int edgeMultiplicity(const gpu::EdgeData& edge, const std::function<int(uint32_t)>& casts);

}  // namespace sb

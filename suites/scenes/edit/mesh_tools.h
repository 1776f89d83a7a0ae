// Repairs and completions of one triangle mesh: bounds, normals, tangents, degenerate triangles.
#pragma once

#include <string>

#include "techniques/scene/scene.h"

namespace sb {

/// Sets boundsMin, boundsMax to the box of the vertices that triangles use (zero if there are
/// none).
void computeBounds(Mesh& mesh);
/// Numbers the triangles in order: triangleKeys.
void numberTriangles(Mesh& mesh);
/// Removes triangles without area (repeated or collinear corners, area below 1e-12 of the longest
/// edge squared); keys of the others stay. Returns how many.
size_t dropDegenerate(Mesh& mesh);
/// Gives every triangle vertices of its own with the normal of its plane.
void makeFlatNormals(Mesh& mesh);
/// Normalizes the normals; those of no length or not finite become those of an adjacent triangle.
/// Returns how many.
size_t repairNormals(Mesh& mesh);
/// Tangents along u of the given set, as MikkTSpace has them: weighted by the angle of each triangle
/// at a vertex, perpendicular to its normal; cross(normal, tangent) * w points to where v falls.
/// Vertices that mirrored and upright triangles share are split. Any perpendicular one where uv says
/// nothing.
void makeTangents(Mesh& mesh, uint32_t uvSet);
/// The mesh with its winding and tangent handedness reversed: what a transform with a negative
/// determinant must be given so that front faces stay counter-clockwise in the world and
/// cross(normal, tangent) * w, taken in the world, stays right.
Mesh mirroredMesh(const Mesh& mesh);

}  // namespace sb

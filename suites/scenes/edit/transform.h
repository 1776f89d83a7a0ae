// Changes of a scene that must not change its picture, or change it in a known way (spec 17,
// G1-G5): for tests and for suites of hard cases.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// G1: moves everything - instances, lights, media, cameras, at every step - by `offset`.
void translateScene(Scene& scene, glm::dvec3 offset);
/// G2: scales the world about its origin by `factor` > 0: instances, cameras with near and far,
/// lights with range and shape, media (extinction divided) and thicknesses. The intensity of point
/// and spot lights grows by factor^2, so that the picture stays; angles and lux stay.
void scaleScene(Scene& scene, double factor);
/// G3: permutes meshes, instances, triangles within meshes and lights, by `seed`. Keys stay with
/// what they name (D2).
void permuteScene(Scene& scene, uint64_t seed);
/// G4: gives every triangle of a mesh whose material blocks all light (see materialTraits) a twin.
/// Twins get keys of their own.
void duplicateOpaque(Scene& scene);
/// G5: adds to every mesh triangles without area - a repeated corner, and a collinear one on a new
/// vertex in the middle of an edge. Bounds stay; the new triangles get keys of their own.
void insertDegenerate(Scene& scene);

}  // namespace sb

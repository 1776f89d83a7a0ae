// Scenes built in code for tests and hard cases, small enough to be worked out by hand: quads,
// boxes, lights, an orthographic camera, materials whose alpha and t are stated outright. Everything
// gets keys in order.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// Matte grey, opaque.
Material matte(glm::vec3 color = glm::vec3(0.5f));
/// Opacity and transmission stated outright.
Material glass(float alpha, glm::vec3 t);

/// Adds a material, a mesh or an instance; returns its index.
uint32_t add(Scene& scene, Material material);
uint32_t add(Scene& scene, Mesh mesh);
uint32_t place(Scene& scene, uint32_t mesh, const glm::dmat4& toWorld = glm::dmat4(1));

/// A parallelogram around `center` with half axes `u` and `v`, normal along cross(u, v).
Mesh quadMesh(uint32_t material, glm::vec3 center, glm::vec3 u, glm::vec3 v);
/// A quad parallel to the ground, normal +y. Returns its instance.
uint32_t addHorizontal(Scene& scene, uint32_t material, glm::vec3 center, float halfX, float halfZ);
uint32_t addQuad(Scene& scene, uint32_t material, glm::vec3 center, glm::vec3 u, glm::vec3 v);
/// Six quads with normals outward.
uint32_t addBox(Scene& scene, uint32_t material, glm::vec3 low, glm::vec3 high);
glm::dmat4 translation(glm::dvec3 offset);

Light sun(glm::dvec3 direction);
/// Unlimited range; `intensity` in candela.
Light pointLight(glm::dvec3 position, float intensity = 10);
Light spotLight(glm::dvec3 position, glm::dvec3 direction, double outerCone, float intensity = 10);
void addLight(Scene& scene, Light light);

/// Orthographic, straight down from `eye`: picture x is world x, picture y is world -z.
Camera downCamera(glm::dvec3 eye, double halfHeight, double farPlane);
Camera lookAt(glm::dvec3 eye, glm::dvec3 target, double fovY = 1.0, double farPlane = 100);

/// Opaque floor [-4,4]^2 at y = 0 under a camera at y = 0.5 whose picture is exactly that floor
/// (what lies higher casts unseen), the sun straight above. `light` false: no light yet.
Scene floorScene(bool light = true);

}  // namespace sb

// The makers behind the registry, and what they share. Internal to suites/scenes.
#pragma once

#include <map>

#include "suites/scenes/procedural/procedural.h"

namespace sb {

/// Values of every parameter of a scene, by name.
using ParamValues = std::map<std::string, double, std::less<>>;

struct ProceduralScene {
  SceneInfo info;
  Scene (*make)(const ParamValues&);
  /// Gives what moves its places in so many steps; null: nothing but its lights does.
  void (*move)(Scene&, const ParamValues&, uint32_t steps) = nullptr;
};

ProceduralScene spheresQuads();
ProceduralScene layers();
ProceduralScene panes();
ProceduralScene penumbra();
ProceduralScene mine();
ProceduralScene yard();
ProceduralScene library();
ProceduralScene wedges();
ProceduralScene roseWindow();
ProceduralScene teapot();
ProceduralScene fog();

/// Adds a mesh or an instance, with keys in order. Returns its index.
uint32_t addMesh(Scene& scene, Mesh mesh);
uint32_t addInstance(Scene& scene, std::string name, uint32_t mesh, const glm::dmat4& toWorld);
uint32_t addMaterial(Scene& scene, Material material);
/// A double-sided rectangle in its plane z = 0, from -half to half, normal +z, u right, v down.
Mesh quadMesh(std::string name, uint32_t material, glm::vec2 half);
/// A unit sphere of `rings` x 2 rings quads (poles of triangles), smooth normals, outward.
Mesh sphereMesh(std::string name, uint32_t material, uint32_t rings);
/// A white light that travels along `direction`; a facing white diffuse surface gets radiance 1.
Light sunLight(glm::dvec3 direction, double angularRadius);
/// Matte material of one linear colour.
Material matteMaterial(std::string name, glm::vec3 colour);
/// alphaMode BLEND, double-sided, matte.
Material paneMaterial(std::string name, glm::vec3 colour, float alpha);
/// The camera of the picture, named "view"; `fovY` in radians, the planes in world units.
void addView(Scene& scene, glm::dvec3 eye, glm::dvec3 target, double fovY, double nearPlane,
             double farPlane);
/// A parameter that counts.
SceneParam countParam(std::string name, double fallback, double low, double high, std::string help);
/// The parameter that every scene has: how far its lights go round.
SceneParam circlingParam();
/// The parameter every scene with a directional light has.
SceneParam sunRadiusParam();
/// Adds those of a scene whose light may be a lamp: the sun's radius, the lamp's shape and size.
std::vector<SceneParam> withLight(std::vector<SceneParam> params);
/// The sun along `direction`, or a lamp that far before `target` that lights it as much.
Light chosenLight(const ParamValues& p, glm::dvec3 direction, glm::dvec3 target, double distance);
/// A lamp at a place that faces along `direction`: `shape` counts from LightShape::Point. Flat ones
/// are 2 to 1, ellipsoids 3 to 2 to 1 of `size`, their largest half axis.
Light lampLight(glm::dvec3 position, glm::dvec3 direction, LightShape shape, double size);

}  // namespace sb

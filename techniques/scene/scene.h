// The scene as plain data: what every technique draws and what the truth traces. No file format and
// no API stands behind it. World space is right-handed; lengths are in world units; positions of
// vertices are floats in mesh space, every transform is double (shading is camera-relative).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

namespace sb {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// 8-bit RGBA texels, row 0 first (top row of the file, v = 0 as in glTF).
struct Image {
  std::string name;
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgba;  ///< width * height * 4
};

enum class Wrap : uint8_t { Repeat, MirroredRepeat, ClampToEdge };

/// Use of an image: sampled at LOD 0 (decision D9), bilinearly unless `nearest`.
struct TextureSlot {
  uint32_t image = kNone;  ///< index into Scene::images; kNone: no texture, factor alone
  Wrap wrapU = Wrap::Repeat;
  Wrap wrapV = Wrap::Repeat;
  bool nearest = false;
  bool srgb = false;   ///< texels are sRGB-encoded (colour textures)
  uint32_t uvSet = 0;  ///< 0 or 1
  /// KHR_texture_transform as rows of a 2x3 matrix: uv' = (dot(row0, (u,v,1)), dot(row1, (u,v,1))).
  std::array<glm::vec3, 2> uvTransform = {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
  bool present() const { return image != kNone; }
};

enum class AlphaMode : uint8_t { Opaque, Mask, Blend };

/// Metallic-roughness material with transmission, as glTF states it. How it becomes opacity and
/// transmission is one function: optics() in techniques/scene/optics.h (decision D8).
struct Material {
  std::string name;
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool unlit = false;
  glm::vec4 baseColor = glm::vec4(1);  ///< linear factor, times texture, times vertex colour
  TextureSlot baseColorTexture;
  float metallic = 1;
  float roughness = 1;
  TextureSlot metallicRoughnessTexture;  ///< g roughness, b metallic
  float normalScale = 1;
  TextureSlot normalTexture;
  float occlusionStrength = 1;
  TextureSlot occlusionTexture;  ///< r, a factor on the ambient term
  glm::vec3 emissive = glm::vec3(0);
  TextureSlot emissiveTexture;
  float transmission = 0;  ///< KHR_materials_transmission
  TextureSlot transmissionTexture;  ///< r
  float thickness = 0;  ///< KHR_materials_volume, world units; 0: thin
  TextureSlot thicknessTexture;  ///< g
  glm::vec3 attenuationColor = glm::vec3(1);
  float attenuationDistance = std::numeric_limits<float>::infinity();
  /// extras.shadowbench {"alpha": a, "t": [r,g,b]}: opacity and transmission colour stated outright.
  bool opticsOverride = false;
  float overrideAlpha = 1;
  glm::vec3 overrideTransmission = glm::vec3(0);
};

/// One primitive: an indexed triangle list with one material. Arrays of attributes are either empty
/// or as long as `positions`.
struct Mesh {
  std::string name;
  uint32_t material = 0;  ///< index into Scene::materials
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< always present after loading (generated where missing)
  std::vector<glm::vec4> tangents;  ///< w: handedness; present iff the material has a normal map
  std::vector<glm::vec2> uv0;
  std::vector<glm::vec2> uv1;
  std::vector<glm::vec4> colors;    ///< linear RGBA
  std::vector<uint32_t> indices;    ///< 3 per triangle
  /// Persistent key of each triangle (decision D2): its number in the source, kept when triangles
  /// are permuted. indices.size() / 3 entries.
  std::vector<uint32_t> triangleKeys;
  /// Persistent key of the mesh, kept when meshes are permuted.
  uint32_t key = 0;
  glm::vec3 boundsMin = glm::vec3(0);
  glm::vec3 boundsMax = glm::vec3(0);
  uint32_t triangleCount() const { return uint32_t(indices.size() / 3); }
};

/// A mesh placed in the world.
struct Instance {
  std::string name;
  uint32_t mesh = 0;
  glm::dmat4 toWorld = glm::dmat4(1);
  uint32_t key = 0;  ///< persistent, unique; part of every random number
  uint32_t pose = kNone;  ///< into SceneState::instances; kNone: it stands
};

enum class LightType : uint8_t { Directional, Point, Spot };

/// What a point or spot light is made of (how receivers see it: techniques/scene/light_area.h).
enum class LightShape : uint8_t { Point, Ellipsoid, Rectangle, Disc };

struct Light {
  std::string name;
  LightType type = LightType::Directional;
  glm::dvec3 position = glm::dvec3(0);          ///< Point, Spot
  glm::dvec3 direction = glm::dvec3(0, -1, 0);  ///< unit, the way light travels; Directional, Spot
  glm::vec3 color = glm::vec3(1);  ///< linear; times `intensity`
  float intensity = 1;             ///< lux (Directional) or candela (Point, Spot)
  double range = 0;                ///< world units; 0: unlimited
  double innerCone = 0;            ///< radians, Spot
  double outerCone = 0.7853981633974483;
  double angularRadius = 0;              ///< radians, Directional; 0: hard shadows
  LightShape shape = LightShape::Point;  ///< Point, Spot; Point: hard shadows
  /// Columns, perpendicular to one another, in world units: the shape's half axes. A sphere is an
  /// ellipsoid of equal ones; rectangles and discs lie in the first two and their third is 0. A
  /// spot light's flat shape faces along `direction`.
  glm::dmat3 halfAxes = glm::dmat3(0);
  uint32_t key = 0;  ///< persistent, unique; part of every random number
  uint32_t pose = kNone;  ///< into SceneState::lights; kNone: it stands
};

/// What of a light moves.
struct LightPose {
  glm::dvec3 position = glm::dvec3(0), direction = glm::dvec3(0, -1, 0);
  glm::dmat3 halfAxes = glm::dmat3(0);
};

enum class MediumKind : uint8_t { Homogeneous, Smoke, Grid };

/// A participating medium in an oriented box (spec 14): it scatters what lights send there once,
/// and neither emits nor scatters ambient light. Where several overlap, densities add. At most
/// kMaxMedia (medium_data.h) a scene. extras.shadowbench {"medium": {...}}.
struct Medium {
  std::string name;
  MediumKind kind = MediumKind::Homogeneous;
  glm::dmat4 boxToWorld = glm::dmat4(1);   ///< takes the unit cube [0,1]^3 to the world
  glm::vec3 extinction = glm::vec3(0);     ///< sigma_t of density 1, per world unit
  glm::vec3 albedo = glm::vec3(0);
  float anisotropy = 0;                    ///< Henyey-Greenstein g
  uint32_t seed = 0;                       ///< Smoke
  double time = 0;                         ///< seconds that the smoke has been rising
  glm::uvec3 size = glm::uvec3(0);         ///< Grid: cells along x, y, z
  /// Grid: densities at the middles of cells, x fastest, z slowest; trilinear between, constant
  /// beyond the outermost.
  std::vector<float> density;
};

/// A pinhole camera (or an orthographic one). Looks down -z of its frame, y up.
struct Camera {
  std::string name;
  glm::dmat4 toWorld = glm::dmat4(1);  ///< rigid
  bool orthographic = false;
  double fovY = 0.8;        ///< radians
  double halfHeight = 1;    ///< world units, orthographic
  double nearPlane = 0.1;   ///< world units
  double farPlane = 1000;   ///< world units
  uint32_t pose = kNone;    ///< into SceneState::cameras; kNone: it stands
  glm::dvec3 eye() const { return glm::dvec3(toWorld[3]); }
};

/// One step of a loop: where everything that moves stands, found by its `pose`.
struct SceneState {
  std::vector<glm::dmat4> cameras, instances;  ///< toWorld of each
  std::vector<LightPose> lights;
};

struct Scene {
  std::string name;    ///< canonical spec of a procedural scene, stem of a file: "layers", "Sponza"
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Medium> media;
  std::vector<Camera> cameras;  ///< the first one renders; never empty after loading
  /// Where what moves stands in each frame of a loop; in the last one it stands where the lists
  /// above say, so that whatever knows no motion sees the last frame. Empty: nothing moves. Asked
  /// through techniques/scene/placed_scene.h.
  std::vector<SceneState> path;
  glm::vec3 ambient = glm::vec3(0.1f);    ///< radiance that reaches every point from everywhere
  /// Radiance of the sky straight above, on top of `ambient`: a surface gets the share (1 + n.y) / 2
  /// of it, half at a wall, none from below; unshadowed, like `ambient`. Up is +y.
  glm::vec3 sky = glm::vec3(0);
  glm::vec3 background = glm::vec3(0);    ///< linear radiance where no surface is
  std::vector<std::string> warnings;      ///< what loading found and mended, for people
  const Camera& camera() const { return cameras.front(); }
};

}  // namespace sb

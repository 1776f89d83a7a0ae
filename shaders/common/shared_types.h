// Structures that C++ fills and GLSL reads, written once. Only 16-byte members, so that std140,
// std430 and C++ agree; every offset is asserted below.
#ifndef SHADOWBENCH_SHARED_TYPES_H
#define SHADOWBENCH_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace sb::gpu {
using vec4 = glm::vec4;
using mat4 = glm::mat4;
using uvec4 = glm::uvec4;
using uint = uint32_t;
#endif

// Per frame.
struct FrameData {
  mat4 viewProjection;  // camera-relative world -> clip
  vec4 ambient;         // rgb
  uvec4 counts;         // x: lights, y: width, z: height, w: seed
  vec4 eye;             // of the camera in the world, rounded: for noise=source alone
  vec4 sky;             // rgb: ambient light from above
  // From a pixel and its depth to a camera-relative position (common/position.glsl).
  vec4 rayOrigin;       // where the ray through window (0, 0) is one unit before the eye; parallel
                        // rays: where it starts
  vec4 rayRight;        // change of it to the next pixel
  vec4 rayUp;           // to the next row
  vec4 rayForward;      // the way the camera looks; w: 1 if rays are parallel (orthographic)
  vec4 depthToDistance; // along the axis (x + y depth) / (z + w depth)
};

// A placed mesh: vertex attributes that advance once an instance (common/instance.glsl).
struct InstanceData {
  vec4 toRelative0;  // rows of mesh space -> camera-relative world
  vec4 toRelative1;
  vec4 toRelative2;
  vec4 normal0;  // rows of the cofactor matrix (geometric normals); w of row 0: sign of det
  vec4 normal1;
  vec4 normal2;
  uvec4 ids;    // x: instance, y: instance key, z: first triangle, w: mesh key
  uvec4 order;  // x: base into the triangle order, y: which of several copies, zw: unused
};

// A triangle of a mesh: geometric normal in mesh space, persistent key as bits. The normal is 2^b
// long, b the concave sides: 1 the side that it points to, 2 the other (0: degenerate).
struct TriangleData {
  vec4 normalKey;
};

// Indices of a material's textures.
#define TEXTURE_BASE_COLOR 0
#define TEXTURE_METALLIC_ROUGHNESS 1
#define TEXTURE_NORMAL 2
#define TEXTURE_OCCLUSION 3
#define TEXTURE_EMISSIVE 4
#define TEXTURE_TRANSMISSION 5
#define TEXTURE_THICKNESS 6
#define MATERIAL_TEXTURES 7

// Bits of MaterialData::flags.x
#define MATERIAL_MASK 1u
#define MATERIAL_BLEND 2u
#define MATERIAL_DOUBLE_SIDED 4u
#define MATERIAL_UNLIT 8u
#define MATERIAL_TRANSMISSION 16u
#define MATERIAL_OVERRIDE 32u

struct MaterialData {
  vec4 baseColor;
  vec4 emissiveCutoff;   // rgb, alpha cutoff
  vec4 surface;          // metallic, roughness, normal scale, occlusion strength
  vec4 transmission;     // factor, thickness, 1 / attenuation distance, -
  vec4 attenuation;      // rgb
  vec4 overrideOptics;   // t rgb, alpha
  uvec4 flags;           // bits, bit i: texture i present, bit i: texture i uses uv1, -
  vec4 uvRows[14];       // two rows of the uv transform of each texture
};

#define LIGHT_DIRECTIONAL 0u
#define LIGHT_POINT 1u
#define LIGHT_SPOT 2u
#define NO_SHADOW 0xFFFFFFFFu

// What a light is made of: LightData::shape.x
#define SHAPE_POINT 0u
#define SHAPE_ELLIPSOID 1u
#define SHAPE_RECTANGLE 2u
#define SHAPE_DISC 3u

struct LightData {
  vec4 positionRange;   // camera-relative position, 1 / range (0: unlimited)
  vec4 directionScale;  // unit, the way light travels; w: spot angle scale
  vec4 colorOffset;     // intensity x colour; w: spot angle offset
  uvec4 ids;            // x: type, y: first shadow view or NO_SHADOW, z: number of views, w: scene index
  vec4 halfAxis0;       // of the shape, world units; directional: of a disc across the light at
  vec4 halfAxis1;       // distance 1 from the receiver (angular radius)
  vec4 halfAxis2;       // 0: the shape is flat
  uvec4 shape;          // x: SHAPE_*; POINT casts hard shadows
};

// A projection of a light onto a layer of a shadow map.
struct ShadowViewData {
  mat4 toClip;       // (camera-relative position - origin) -> light clip, depth 1 near .. 0 far
  mat4 planeToClip;  // inverse transpose of toClip: takes planes to light clip
  vec4 origin;       // camera-relative; w: layer
  vec4 texel;        // x: 1 / size, y: depth step of the format, z: texel width at distance 1
                     // (perspective) or anywhere (orthographic), w: 1 if perspective
  uvec4 ids;         // x: persistent key of light and face, part of every random number; y: 1 if a
                     // caster of any view rises before itself
};

#ifdef __cplusplus
static_assert(offsetof(FrameData, ambient) == 64 && offsetof(FrameData, counts) == 80 &&
              offsetof(FrameData, eye) == 96 && offsetof(FrameData, sky) == 112 &&
              offsetof(FrameData, rayOrigin) == 128 && offsetof(FrameData, rayForward) == 176 &&
              offsetof(FrameData, depthToDistance) == 192 && sizeof(FrameData) == 208);
static_assert(offsetof(InstanceData, normal0) == 48 && offsetof(InstanceData, ids) == 96 &&
              offsetof(InstanceData, order) == 112 && sizeof(InstanceData) == 128);
static_assert(sizeof(TriangleData) == 16);
static_assert(offsetof(MaterialData, emissiveCutoff) == 16 && offsetof(MaterialData, surface) == 32 &&
              offsetof(MaterialData, transmission) == 48 &&
              offsetof(MaterialData, attenuation) == 64 &&
              offsetof(MaterialData, overrideOptics) == 80 && offsetof(MaterialData, flags) == 96 &&
              offsetof(MaterialData, uvRows) == 112 && sizeof(MaterialData) == 336);
static_assert(offsetof(LightData, directionScale) == 16 && offsetof(LightData, colorOffset) == 32 &&
              offsetof(LightData, ids) == 48 && offsetof(LightData, halfAxis0) == 64 &&
              offsetof(LightData, halfAxis1) == 80 && offsetof(LightData, halfAxis2) == 96 &&
              offsetof(LightData, shape) == 112 && sizeof(LightData) == 128);
static_assert(offsetof(ShadowViewData, planeToClip) == 64 && offsetof(ShadowViewData, origin) == 128 &&
              offsetof(ShadowViewData, texel) == 144 && offsetof(ShadowViewData, ids) == 160 &&
              sizeof(ShadowViewData) == 176);
}  // namespace sb::gpu
#endif

#endif

#include "techniques/scene/light_data.h"

#include <algorithm>
#include <cmath>

#include "techniques/scene/light_area.h"

namespace sb {

using glm::dmat3;
using glm::dvec3;

gpu::LightData lightData(const Light& light, uint32_t index, const dvec3& eye) {
  gpu::LightData d{};
  d.positionRange =
      glm::vec4(glm::vec3(light.position - eye), light.range > 0 ? float(1 / light.range) : 0.0f);
  // KHR_lights_punctual: smooth edge between the cosines of the two cones.
  const double cosOuter = std::cos(light.outerCone), cosInner = std::cos(light.innerCone);
  const double scale = 1 / std::max(1e-3, cosInner - cosOuter);
  d.directionScale = glm::vec4(glm::vec3(glm::normalize(light.direction)), float(scale));
  d.colorOffset = glm::vec4(light.color * light.intensity, float(-cosOuter * scale));
  d.ids = {uint32_t(light.type), NO_SHADOW, 0, index};
  static_assert(uint32_t(LightShape::Ellipsoid) == SHAPE_ELLIPSOID &&
                uint32_t(LightShape::Rectangle) == SHAPE_RECTANGLE &&
                uint32_t(LightShape::Disc) == SHAPE_DISC);
  if (!isAreaLight(light)) return d;
  if (light.type == LightType::Directional) {
    const LightPatch patch = lightPatch(light, dvec3(0));
    d.halfAxis0 = glm::vec4(glm::vec3(patch.u), 0);
    d.halfAxis1 = glm::vec4(glm::vec3(patch.v), 0);
    d.shape.x = SHAPE_DISC;
  } else {
    d.halfAxis0 = glm::vec4(glm::vec3(light.halfAxes[0]), 0);
    d.halfAxis1 = glm::vec4(glm::vec3(light.halfAxes[1]), 0);
    d.halfAxis2 = glm::vec4(glm::vec3(light.halfAxes[2]), 0);
    d.shape.x = uint32_t(light.shape);
  }
  return d;
}

dmat3 lightAxes(const dvec3& direction) {
  const dvec3 z = -glm::normalize(direction);
  const dvec3 up = std::abs(z.y) < 0.99 ? dvec3(0, 1, 0) : dvec3(0, 0, -1);
  const dvec3 x = glm::normalize(glm::cross(up, z));
  return glm::transpose(dmat3(x, glm::cross(z, x), z));
}

dvec3 cubeFaceDirection(uint32_t face) {
  dvec3 d(0);
  d[int(face / 2)] = face % 2 == 0 ? 1 : -1;
  return d;
}

uint32_t cubeFaceOf(const dvec3& d) {
  const dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x >= 0 ? 0 : 1;
  if (a.y >= a.z) return d.y >= 0 ? 2 : 3;
  return d.z >= 0 ? 4 : 5;
}

}  // namespace sb

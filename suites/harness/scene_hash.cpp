#include "suites/harness/scene_hash.h"

#include <cstring>
#include <span>
#include <type_traits>

#include "reports/picture.h"
#include "techniques/scene/material_data.h"

namespace sb {
namespace {

class Bytes {
 public:
  template <class T>
  Bytes& operator<<(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof value);
    return *this;
  }
  template <class T>
  Bytes& operator<<(const std::vector<T>& values) {
    *this << uint64_t(values.size());
    append(values.data(), values.size() * sizeof(T));
    return *this;
  }
  std::string hash() const { return report::contentHash(std::as_bytes(std::span(m_bytes))); }

 private:
  void append(const void* data, size_t size) {
    const auto* bytes = static_cast<const char*>(data);
    m_bytes.insert(m_bytes.end(), bytes, bytes + size);
  }
  std::vector<char> m_bytes;
};

}  // namespace

std::string sceneHash(const Scene& scene) {
  Bytes b;
  for (const Image& i : scene.images) b << i.width << i.height << i.rgba;
  for (const Material& m : scene.materials) {
    b << materialData(m);
    for (uint32_t t = 0; t < MATERIAL_TEXTURES; ++t) {
      const TextureSlot& s = textureSlot(m, t);
      b << s.image << s.wrapU << s.wrapV << s.nearest << s.srgb;
    }
  }
  for (const Mesh& m : scene.meshes)
    b << m.material << m.positions << m.normals << m.tangents << m.uv0 << m.uv1 << m.colors
      << m.indices << m.triangleKeys << m.key;
  for (const Instance& i : scene.instances) b << i.mesh << i.toWorld << i.key;
  for (const Light& l : scene.lights) {
    b << l.type << l.position << l.direction << l.color << l.intensity << l.range << l.innerCone
      << l.outerCone << l.angularRadius << l.key;
    // As below: lights without a shape keep what they were.
    if (l.shape != LightShape::Point) b << l.shape << l.halfAxes;
  }
  for (const Medium& m : scene.media)
    b << m.kind << m.boxToWorld << m.extinction << m.albedo << m.anisotropy << m.seed << m.time
      << m.size << m.density;
  const Camera& c = scene.camera();
  b << c.toWorld << c.orthographic << c.fovY << c.halfHeight << c.nearPlane << c.farPlane
    << scene.ambient << scene.background;
  // Scenes without a sky keep their hashes, and the truths that are filed under them.
  if (scene.sky != glm::vec3(0)) b << scene.sky;
  return b.hash();
}

}  // namespace sb

#include "suites/cli/memory.h"

#include <cstdio>

#include "backends/rhi/memory_limit.h"
#include "reports/exr.h"
#include "suites/truth/truth.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

std::string gib(uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < uint64_t(1) << 30 ? "%.0f MiB" : "%.1f GiB",
                double(bytes) / double(bytes < uint64_t(1) << 30 ? 1 << 20 : 1 << 30));
  return text;
}

template <class T>
uint64_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

uint64_t bytesOf(const Scene& scene) {
  uint64_t bytes = bytesOf(scene.materials) + bytesOf(scene.instances);
  for (const Mesh& m : scene.meshes)
    bytes += bytesOf(m.positions) + bytesOf(m.normals) + bytesOf(m.tangents) + bytesOf(m.uv0) +
             bytesOf(m.uv1) + bytesOf(m.colors) + bytesOf(m.indices) + bytesOf(m.triangleKeys);
  for (const Image& image : scene.images) bytes += bytesOf(image.rgba);
  for (const Medium& medium : scene.media) bytes += bytesOf(medium.density);
  return bytes;
}

/// Floats of four channels: what is read back, what it is compared with, what is written.
constexpr uint64_t kPicture = 16;
/// Of each light and layer: the visibility, a mask and what would be reflected.
constexpr uint64_t kVisibility = kPicture + 1 + 4;

void require(const std::string& what, uint64_t bytes) {
  const uint64_t most = rhi::hostMemoryLimit();
  if (bytes > most)
    throw InputError("--max-memory",
                     what + " needs " + gib(bytes) + ", expected at most " + gib(most));
}

}  // namespace

void limitMemory(const Options& options) {
  rhi::limitHostMemory(options.device.maxMemory.value_or(rhi::machineMemory() / 2));
}

void requireMemory(const Scene& scene, rhi::Extent2D size, Made made) {
  const uint64_t pixels = uint64_t(size.width) * size.height;
  const std::string shown = std::to_string(size.width) + "x" + std::to_string(size.height);
  require("the scene '" + scene.name + "'", bytesOf(scene));
  require("a picture of " + shown, 4 * kPicture * pixels);
  if (made == Made::Picture) return;
  const uint64_t layers = uint64_t(kTruthLayers) * scene.lights.size();
  const std::string lights = std::to_string(scene.lights.size()) + " lights";
  if (made == Made::VisibilityFiles) {
    const uint64_t each = layers * (kPicture + report::kExrWritingBytes) + 4 * kPicture;
    return require("the visibility of " + lights + " at " + shown, each * pixels);
  }
  // Beside it the picture that it is compared with, and the technique's own visibility of a light.
  const uint64_t traced = layers + (scene.media.empty() ? 0 : scene.lights.size());
  uint64_t each = traced * kVisibility + kTruthLayers * (1 + kPicture) + 4 * kPicture;
  if (made == Made::TruthFiles) each += traced * report::kExrWritingBytes;
  require("a truth of " + shown + " with " + lights, each * pixels);
}

}  // namespace sb

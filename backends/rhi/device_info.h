// What a device is and can do: identity, features, limits. `bench doctor` prints all of it.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "backends/rhi/types.h"

namespace rhi {

enum class DeviceType : uint8_t { Discrete, Integrated, Virtual, Software, Other };

/// Optional abilities. Absence is an answer, never an empty implementation.
enum class Feature : uint8_t {
  DepthClamp, GeometryShader, VertexLayer, SampleRateShading, DualSourceBlend, IndependentBlend,
  LogicOp, FragmentStoresAndAtomics, PipelineStatistics, PreciseOcclusion, MultiDrawIndirect,
  SamplerAnisotropy, FragmentInterlock, ConservativeRaster, DepthBounds, RayQuery, Presentation,
  Count
};
std::string_view featureName(Feature feature);
std::string_view deviceTypeName(DeviceType type);

struct Limits {
  uint32_t maxTexture2D = 0;
  uint32_t maxTexture3D = 0;
  uint32_t maxTextureLayers = 0;
  uint32_t maxColorAttachments = 0;
  std::vector<uint32_t> sampleCounts;  ///< ascending, for colour and depth alike
  uint64_t maxStorageRange = 0;        ///< bytes
  uint64_t maxUniformRange = 0;        ///< bytes
  uint32_t uniformAlignment = 256;     ///< bytes, of Binding::offset
  uint32_t storageAlignment = 256;     ///< bytes
  uint32_t subPixelBits = 0;
  uint32_t maxGeometryVertices = 0;
  uint32_t maxComputeInvocations = 0;
  float timestampPeriodNs = 1;
  uint32_t timestampBits = 0;  ///< 0: no timestamps
};

struct DeviceInfo {
  std::string backend;  ///< "vulkan", "opengl" (EGL), "opengl-osmesa", "null"
  uint32_t index = 0;   ///< within its backend; what `--device N` selects
  std::string name;
  DeviceType type = DeviceType::Other;
  std::string driver;         ///< e.g. "llvmpipe", "NVIDIA"
  std::string driverVersion;  ///< as the driver says it
  std::string apiVersion;     ///< e.g. "1.3.230", "4.5 core"
  uint64_t memoryBytes = 0;   ///< device-local; 0 where the API does not tell
  std::set<Feature> features;
  Limits limits;
  std::string unusable;  ///< not empty: why this device cannot be opened (missing extensions, say)
};

/// What a format can be used for on a device.
struct FormatCaps {
  bool sampled = false;
  bool linearFilter = false;
  bool colorTarget = false;
  bool blend = false;
  bool depthTarget = false;
  bool storage = false;
  bool storageAtomic = false;
  std::vector<uint32_t> sampleCounts;
};

/// Index into `devices` of the one that `selector` names: empty = the best usable one (discrete,
/// integrated, virtual, software); a number = DeviceInfo::index; else a case-insensitive part of the
/// name. Throws Error listing what exists when nothing matches.
size_t chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view selector);

}  // namespace rhi

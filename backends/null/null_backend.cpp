#include "backends/null/null_backend.h"

#include "backends/null/null_device.h"

namespace null_backend {
namespace {

class Backend final : public rhi::Backend {
 public:
  std::string_view name() const override { return "null"; }
  std::vector<rhi::DeviceInfo> enumerate() override { return {describe()}; }
  std::unique_ptr<rhi::Device> open(const rhi::DeviceRequest& request) override {
    rhi::chooseDevice(enumerate(), request.selector);
    return std::make_unique<Device>(describe());
  }

 private:
  static rhi::DeviceInfo describe() {
    rhi::DeviceInfo info = {
        .backend = "null",
        .name = "null",
        .type = rhi::DeviceType::Software,
        .driver = "null",
        .driverVersion = "1",
        .apiVersion = "1",
        .limits = {.maxTexture2D = 16384,
                   .maxTexture3D = 2048,
                   .maxTextureLayers = 2048,
                   .maxColorAttachments = rhi::kMaxColorAttachments,
                   .sampleCounts = {1, 2, 4, 8},
                   .maxStorageRange = uint64_t(1) << 31,
                   .maxUniformRange = 65536,
                   .subPixelBits = 8,
                   .maxGeometryVertices = 256,
                   .maxComputeInvocations = 1024,
                   .timestampBits = 64},
    };
    for (int i = 0; i < int(rhi::Feature::Count); ++i)
      if (rhi::Feature(i) != rhi::Feature::Presentation) info.features.insert(rhi::Feature(i));
    return info;
  }
};

}  // namespace

std::string_view callName(CallKind kind) {
  static constexpr std::string_view kNames[] = {"beginPass",    "endPass",
                                                "draw",         "drawIndexed",
                                                "drawIndirect", "drawIndexedIndirect",
                                                "dispatch",     "dispatchIndirect",
                                                "write",        "fill",
                                                "copy",         "timestamp",
                                                "beginQuery",   "endQuery"};
  static_assert(std::size(kNames) == size_t(CallKind::EndQuery) + 1);
  return kNames[size_t(kind)];
}

std::unique_ptr<rhi::Backend> makeBackend() { return std::make_unique<Backend>(); }

const std::vector<Call>& calls(const rhi::Device& device) {
  return dynamic_cast<const Device&>(device).calls();
}

void clearCalls(rhi::Device& device) { dynamic_cast<Device&>(device).clearCalls(); }

}  // namespace null_backend

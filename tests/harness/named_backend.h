// The null backend under the names of the real ones, with faults where a driver would have them.
#pragma once
#include <functional>

#include "backends/null/null_backend.h"
#include "suites/harness/group.h"

namespace shadowbench_shader_blob {
void addTo(rhi::ShaderLibrary& library);
}

namespace sb::test {

inline const std::vector<std::string> kBackendNames = {"vulkan", "opengl", "opengl-osmesa"};
inline const std::vector<std::string> kDefaultBackends = {"vulkan", "opengl"};

/// What a driver does wrong, by what is asked of it.
struct Faults : rhi::Observer {
  std::function<void()> onPass = [] {};
  std::function<void()> onTexture = [] {};
  void beginPass(const rhi::PassDesc&) override { onPass(); }
  void created(rhi::TextureId, const rhi::TextureDesc&) override { onTexture(); }
};

class NamedBackend final : public rhi::Backend {
 public:
  /// One that does not start has no driver.
  explicit NamedBackend(std::string name, bool starts = true)
      : m_name(std::move(name)), m_starts(starts) {}
  std::string_view name() const override { return m_name; }
  std::vector<rhi::DeviceInfo> enumerate() override { return m_inner->enumerate(); }
  std::unique_ptr<rhi::Device> open(const rhi::DeviceRequest& request) override {
    if (!m_starts) throw rhi::Error("open", "", "no driver");
    auto device = m_inner->open(request);
    device->setObserver(&faults);
    return device;
  }
  Faults faults;

 private:
  std::string m_name;
  bool m_starts;
  std::unique_ptr<rhi::Backend> m_inner = null_backend::makeBackend();
};

inline CellId smallCell(const std::string& technique, const std::string& backend) {
  return {.technique = technique, .backend = backend, .scene = "layers", .width = 16, .height = 16};
}

/// Three repetitions of one frame each, of nothing but the frames.
inline MeasureSettings shortSettings() {
  MeasureSettings s;
  s.stop.repetitions = 3;
  s.blockSeconds = 0;
  s.checkTimers = false;
  s.judge.enabled = false;
  return s;
}

}  // namespace sb::test

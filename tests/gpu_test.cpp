#include "tests/gpu_test.h"

#include <cstdlib>
#include <map>

#include "backends/opengl/device/gl_backend.h"
#include "backends/rhi/validate/validator.h"
#include "backends/vulkan/device/vk_backend.h"

namespace test_shaders {
void addTo(rhi::ShaderLibrary& library);
}

namespace sb::test {
namespace {

struct Opened {
  // Closed in reverse order: what is kept, then the validator, which detaches itself, the device.
  std::unique_ptr<rhi::Device> device;
  std::unique_ptr<rhi::Validator> validator;
  std::vector<std::shared_ptr<void>> kept;
  std::string why;
};

std::unique_ptr<rhi::Backend> makeBackend(const std::string& name) {
  if (name == "vulkan") return vulkan::makeBackend();
  if (name == "opengl") return opengl::makeBackend(opengl::ContextKind::Egl);
  return opengl::makeBackend(opengl::ContextKind::OSMesa);
}

std::map<std::string, Opened>& openedDevices() {
  static std::map<std::string, Opened> opened;
  return opened;
}

/// Closes the devices while the drivers still live: Mesa's own exit handlers run before the
/// destructors of static objects that are older than the driver.
class CloseDevices : public testing::Environment {
  void TearDown() override { openedDevices().clear(); }
};
const testing::Environment* const kCloseDevices =
    testing::AddGlobalTestEnvironment(new CloseDevices);

bool required(const std::string& backend) {
  const char* list = std::getenv("SHADOWBENCH_REQUIRE");
  return list && ("," + std::string(list) + ",").find("," + backend + ",") != std::string::npos;
}

}  // namespace

const std::vector<std::string>& gpuBackends() {
  static const std::vector<std::string> names = {"vulkan", "opengl", "opengl-osmesa"};
  return names;
}

rhi::Device* sharedDevice(const std::string& backend, std::string* why) {
  auto [it, first] = openedDevices().try_emplace(backend);
  if (first) {
    try {
      it->second.device = makeBackend(backend)->open({.validate = true});
      it->second.validator = std::make_unique<rhi::Validator>(*it->second.device);
    } catch (const std::exception& e) {
      it->second.why = e.what();
    }
  }
  if (why) *why = it->second.why;
  return it->second.device.get();
}

void keepWithDevice(const rhi::Device& device, std::shared_ptr<void> object) {
  for (auto& [name, opened] : openedDevices())
    if (opened.device.get() == &device) opened.kept.push_back(std::move(object));
}

const rhi::ShaderLibrary& testShaders() {
  static const rhi::ShaderLibrary library = [] {
    rhi::ShaderLibrary lib;
    test_shaders::addTo(lib);
    return lib;
  }();
  return library;
}

void GpuTest::SetUp() {
  std::string why;
  m_device = sharedDevice(GetParam(), &why);
  if (m_device) return;
  if (required(GetParam())) FAIL() << GetParam() << " is required but does not start: " << why;
  GTEST_SKIP() << GetParam() << " does not start: " << why;
}

void GpuTest::TearDown() {
  if (!m_device) return;
  m_device->waitIdle();
  for (const rhi::Message& m : m_device->takeMessages())
    ADD_FAILURE() << m.source << " [" << m.rule << "] " << m.text;
}

}  // namespace sb::test

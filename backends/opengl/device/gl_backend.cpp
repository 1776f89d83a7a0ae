#include "backends/opengl/device/gl_backend.h"

#include "backends/opengl/device/gl_context_egl.h"
#include "backends/opengl/device/gl_context_osmesa.h"
#include "backends/opengl/device/gl_device.h"
#include "backends/opengl/device/gl_device_info.h"

namespace opengl {
namespace {

class Backend : public rhi::Backend {
 public:
  explicit Backend(ContextKind kind) : m_kind(kind) {}

  std::string_view name() const override {
    return m_kind == ContextKind::Egl ? "opengl" : "opengl-osmesa";
  }

  std::vector<rhi::DeviceInfo> enumerate() override {
    std::vector<rhi::DeviceInfo> infos;
    for (size_t i = 0; i < platform().deviceCount(); ++i) {
      rhi::DeviceInfo info;
      try {
        // OpenGL tells what a device is only through a context on it.
        info = queryDeviceInfo(platform().createContext(i, false)->use());
      } catch (const rhi::Error& error) {
        info.name = platform().deviceName(i);
        info.unusable = error.what();
      }
      infos.push_back(identified(std::move(info), i));
    }
    return infos;
  }

  std::unique_ptr<rhi::Device> open(const rhi::DeviceRequest& request) override {
    const size_t index = rhi::chooseDevice(enumerate(), request.selector);
    auto context = platform().createContext(index, request.validate);
    rhi::DeviceInfo info = identified(queryDeviceInfo(context->use()), index);
    return std::make_unique<Device>(std::move(context), std::move(info), request.validate);
  }

 private:
  rhi::DeviceInfo identified(rhi::DeviceInfo info, size_t index) const {
    info.backend = name();
    info.index = uint32_t(index);
    return info;
  }

  Platform& platform() {
    if (!m_platform)
      m_platform = m_kind == ContextKind::Egl ? makeEglPlatform() : makeOsmesaPlatform();
    return *m_platform;
  }

  ContextKind m_kind;
  std::unique_ptr<Platform> m_platform;
};

}  // namespace

std::unique_ptr<rhi::Backend> makeBackend(ContextKind kind) {
  return std::make_unique<Backend>(kind);
}

}  // namespace opengl

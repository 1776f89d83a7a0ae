#include "backends/opengl/device/gl_context_egl.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <map>
#include <vector>

#include "backends/rhi/error.h"

namespace opengl {
namespace {

struct Egl {
  decltype(&::eglGetProcAddress) getProcAddress = nullptr;
  decltype(&::eglGetError) getError = nullptr;
  decltype(&::eglQueryString) queryString = nullptr;
  decltype(&::eglInitialize) initialize = nullptr;
  decltype(&::eglTerminate) terminate = nullptr;
  decltype(&::eglBindAPI) bindApi = nullptr;
  decltype(&::eglChooseConfig) chooseConfig = nullptr;
  decltype(&::eglCreateContext) createContext = nullptr;
  decltype(&::eglDestroyContext) destroyContext = nullptr;
  decltype(&::eglMakeCurrent) makeCurrent = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;  // null: no enumeration
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;
};

std::string eglErrorName(EGLint code) {
  switch (code) {
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONTEXT:
      return "EGL_BAD_CONTEXT";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    case EGL_CONTEXT_LOST:
      return "EGL_CONTEXT_LOST";
    default:
      return "EGL error " + std::to_string(code);
  }
}

[[noreturn]] void fail(const Egl& egl, const char* call, const std::string& detail) {
  throw rhi::Error(call, eglErrorName(egl.getError()), detail);
}

bool listed(const char* extensions, std::string_view name) {
  const std::string all = " " + std::string(extensions ? extensions : "") + " ";
  return all.find(" " + std::string(name) + " ") != std::string::npos;
}

/// An initialised display. eglTerminate counts no references, so contexts share one of these.
class Display {
 public:
  Display(const Egl& egl, EGLDisplay display) : m_egl(egl), m_display(display) {
    if (!egl.initialize(display, nullptr, nullptr))
      fail(egl, "eglInitialize", "the EGL display does not start");
  }
  ~Display() { m_egl.terminate(m_display); }
  EGLDisplay get() const { return m_display; }

  static std::shared_ptr<Display> open(const Egl& egl, EGLDisplay display) {
    static std::map<EGLDisplay, std::weak_ptr<Display>> open;
    std::weak_ptr<Display>& entry = open[display];
    std::shared_ptr<Display> shared = entry.lock();
    if (!shared) entry = shared = std::make_shared<Display>(egl, display);
    return shared;
  }

 private:
  const Egl& m_egl;
  EGLDisplay m_display;
};

class EglContext : public Context {
 public:
  EglContext(const Egl& egl, std::shared_ptr<Display> display, bool debug)
      : m_egl(egl), m_display(std::move(display)) {
    const EGLDisplay d = m_display->get();
    const char* extensions = egl.queryString(d, EGL_EXTENSIONS);
    if (!listed(extensions, "EGL_KHR_surfaceless_context"))
      throw rhi::Error("EGL", "", "the display lacks EGL_KHR_surfaceless_context");
    if (!egl.bindApi(EGL_OPENGL_API)) fail(egl, "eglBindAPI", "the display has no OpenGL");
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!listed(extensions, "EGL_KHR_no_config_context")) {
      const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                               EGL_PBUFFER_BIT, EGL_NONE};
      EGLint count = 0;
      if (!egl.chooseConfig(d, wanted, &config, 1, &count) || count == 0)
        fail(egl, "eglChooseConfig", "no configuration renders OpenGL");
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 debug ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    m_context = egl.createContext(d, config, EGL_NO_CONTEXT, attributes);
    if (m_context == EGL_NO_CONTEXT)
      fail(egl, "eglCreateContext", "the driver gives no OpenGL 4.5 core context");
    try {
      use();
      m_gl = loadFunctions(
          [&](const char* name) { return reinterpret_cast<void*>(egl.getProcAddress(name)); });
    } catch (...) {
      close();
      throw;
    }
  }
  ~EglContext() override { close(); }

 protected:
  void activate() override {
    if (!m_egl.makeCurrent(m_display->get(), EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
      fail(m_egl, "eglMakeCurrent", "the context cannot be used");
  }
  void release() override {
    m_egl.makeCurrent(m_display->get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

 private:
  void close() {
    retire();
    m_egl.destroyContext(m_display->get(), m_context);
  }

  const Egl& m_egl;
  std::shared_ptr<Display> m_display;
  EGLContext m_context = EGL_NO_CONTEXT;
};

const Egl& loadEgl() {
  static const Egl egl = [] {
    void* library = openLibrary("libEGL.so.1", "OpenGL through EGL");
    Egl e;
    auto core = [&](auto& pointer, const char* name) {
      pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(
          librarySymbol(library, name));
    };
    core(e.getProcAddress, "eglGetProcAddress");
    core(e.getError, "eglGetError");
    core(e.queryString, "eglQueryString");
    core(e.initialize, "eglInitialize");
    core(e.terminate, "eglTerminate");
    core(e.bindApi, "eglBindAPI");
    core(e.chooseConfig, "eglChooseConfig");
    core(e.createContext, "eglCreateContext");
    core(e.destroyContext, "eglDestroyContext");
    core(e.makeCurrent, "eglMakeCurrent");
    auto extension = [&](auto& pointer, const char* name) {
      pointer =
          reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(e.getProcAddress(name));
    };
    extension(e.getPlatformDisplay, "eglGetPlatformDisplayEXT");
    extension(e.queryDevices, "eglQueryDevicesEXT");
    extension(e.queryDeviceString, "eglQueryDeviceStringEXT");
    return e;
  }();
  return egl;
}

class EglPlatform : public Platform {
 public:
  EglPlatform() : m_egl(loadEgl()) {
    const char* extensions = m_egl.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!m_egl.getPlatformDisplay)
      throw rhi::Error("EGL", "", "libEGL has no eglGetPlatformDisplayEXT");
    if (listed(extensions, "EGL_EXT_platform_device") && m_egl.queryDevices) {
      EGLint count = 0;
      if (m_egl.queryDevices(0, nullptr, &count) && count > 0) {
        m_devices.resize(size_t(count));
        m_egl.queryDevices(count, m_devices.data(), &count);
        m_devices.resize(size_t(count));
      }
    }
    if (m_devices.empty() && listed(extensions, "EGL_MESA_platform_surfaceless"))
      m_devices.push_back(nullptr);
    if (m_devices.empty())
      throw rhi::Error("eglQueryDevicesEXT", "",
                       "EGL knows no device and no surfaceless platform (no driver installed?)");
  }

  size_t deviceCount() const override { return m_devices.size(); }

  std::string deviceName(size_t index) const override {
    if (!m_devices[index]) return "EGL surfaceless";
    std::string name = "EGL device " + std::to_string(index);
    if (m_egl.queryDeviceString &&
        listed(m_egl.queryDeviceString(m_devices[index], EGL_EXTENSIONS), "EGL_EXT_device_drm"))
      if (const char* file = m_egl.queryDeviceString(m_devices[index], EGL_DRM_DEVICE_FILE_EXT))
        name += std::string(" (") + file + ")";
    return name;
  }

  std::unique_ptr<Context> createContext(size_t index, bool debug) override {
    const EGLDisplay display =
        m_devices[index]
            ? m_egl.getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, m_devices[index], nullptr)
            : m_egl.getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY)
      fail(m_egl, "eglGetPlatformDisplayEXT", deviceName(index) + " gives no display");
    return std::make_unique<EglContext>(m_egl, Display::open(m_egl, display), debug);
  }

 private:
  const Egl& m_egl;
  std::vector<EGLDeviceEXT> m_devices;  ///< a null entry is the surfaceless platform
};

}  // namespace

std::unique_ptr<Platform> makeEglPlatform() { return std::make_unique<EglPlatform>(); }

}  // namespace opengl

#include "backends/opengl/device/gl_context_osmesa.h"

#include <GL/osmesa.h>

#include <array>

#include "backends/rhi/error.h"

namespace opengl {
namespace {

struct Osmesa {
  decltype(&::OSMesaCreateContextAttribs) createContext = nullptr;
  decltype(&::OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&::OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&::OSMesaGetProcAddress) getProcAddress = nullptr;
};

class OsmesaContext : public Context {
 public:
  explicit OsmesaContext(const Osmesa& osmesa) : m_osmesa(osmesa) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0,
                              0};
    m_context = osmesa.createContext(attributes, nullptr);
    if (!m_context)
      throw rhi::Error("OSMesaCreateContextAttribs", "",
                       "libOSMesa gives no OpenGL 4.5 core context");
    try {
      use();
      m_gl = loadFunctions(
          [&](const char* name) { return reinterpret_cast<void*>(osmesa.getProcAddress(name)); });
    } catch (...) {
      close();
      throw;
    }
  }
  ~OsmesaContext() override { close(); }

 protected:
  void activate() override {
    if (!m_osmesa.makeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize))
      throw rhi::Error("OSMesaMakeCurrent", "", "the context cannot be used");
  }
  void release() override { m_osmesa.makeCurrent(nullptr, nullptr, 0, 0, 0); }

 private:
  void close() {
    retire();
    m_osmesa.destroyContext(m_context);
  }

  // OSMesa insists on a window-like buffer; nothing is ever drawn to it.
  static constexpr int kSize = 4;
  std::array<unsigned char, size_t(kSize) * kSize * 4> m_pixels{};
  const Osmesa& m_osmesa;
  OSMesaContext m_context = nullptr;
};

class OsmesaPlatform : public Platform {
 public:
  OsmesaPlatform() {
    void* library = openLibrary("libOSMesa.so.8", "OpenGL through OSMesa");
    auto load = [&](auto& pointer, const char* name) {
      pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(
          librarySymbol(library, name));
    };
    static Osmesa table;  // contexts outlive the platform
    load(table.createContext, "OSMesaCreateContextAttribs");
    load(table.destroyContext, "OSMesaDestroyContext");
    load(table.makeCurrent, "OSMesaMakeCurrent");
    load(table.getProcAddress, "OSMesaGetProcAddress");
    m_osmesa = &table;
  }
  size_t deviceCount() const override { return 1; }
  std::string deviceName(size_t) const override { return "OSMesa"; }
  std::unique_ptr<Context> createContext(size_t, bool) override {
    return std::make_unique<OsmesaContext>(*m_osmesa);
  }

 private:
  const Osmesa* m_osmesa;
};

}  // namespace

std::unique_ptr<Platform> makeOsmesaPlatform() { return std::make_unique<OsmesaPlatform>(); }

}  // namespace opengl

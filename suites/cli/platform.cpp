// The one file that names concrete backends.
#include "backends/opengl/device/gl_backend.h"
#include "backends/shader/collect.h"
#include "backends/vulkan/device/vk_backend.h"
#include "base/atomic_file.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/vector_width.h"
#include "techniques/plan/error.h"

namespace shadowbench_shader_blob {
void addTo(rhi::ShaderLibrary& library);
}

namespace sb {

std::vector<rhi::Backend*> Platform::backends() const {
  std::vector<rhi::Backend*> list;
  for (const auto& b : owned) list.push_back(b.get());
  return list;
}

std::vector<std::string> Platform::names() const {
  std::vector<std::string> list;
  for (const auto& b : owned) list.emplace_back(b->name());
  return list;
}

Platform makePlatform(const Options& options) {
  // Doctor tells of it and goes on; nothing is measured with a driver that may crash.
  const std::string why = whyNoVectorWidth(vectorWidth());
  if (!why.empty() && options.command != Command::Doctor)
    throw InputError("LP_NATIVE_VECTOR_WIDTH", why);
  guardVectorWidth();
  Platform platform;
  platform.owned.push_back(vulkan::makeBackend());
  platform.owned.push_back(opengl::makeBackend(opengl::ContextKind::Egl));
  platform.owned.push_back(opengl::makeBackend(opengl::ContextKind::OSMesa));
  if (options.device.shaderFolder.empty())
    shadowbench_shader_blob::addTo(platform.shaders);
  else
    platform.shaders = shader::compileFolder(options.device.shaderFolder);
  return platform;
}

void requireWritable(const std::string& option, const std::string& path) {
  if (const std::string why = base::whyNotWritable(path); !why.empty())
    throw InputError(option, "cannot write " + path + ": " + why);
}

std::vector<std::string> defaultBackends(const Options& options) {
  return {"vulkan", options.device.gl == "osmesa" ? "opengl-osmesa" : "opengl"};
}

}  // namespace sb

#include "backends/opengl/device/gl_device_info.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "backends/opengl/resources/gl_formats.h"

namespace opengl {
namespace {

// Of extensions without a place in glcorearb.h.
constexpr GLenum kDedicatedVideoMemoryNvx = 0x9047;
constexpr GLenum kTextureFreeMemoryAti = 0x87FC;

std::string text(const Functions& gl, GLenum name) {
  const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
  return value ? value : "";
}

GLint integer(const Functions& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

std::set<std::string> extensions(const Functions& gl) {
  std::set<std::string> names;
  for (GLint i = 0; i < integer(gl, GL_NUM_EXTENSIONS); ++i)
    names.insert(reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i))));
  return names;
}

rhi::DeviceType typeOf(std::string renderer) {
  std::ranges::transform(renderer, renderer.begin(),
                         [](unsigned char c) { return char(std::tolower(c)); });
  auto says = [&](std::initializer_list<const char*> words) {
    return std::ranges::any_of(
        words, [&](const char* w) { return renderer.find(w) != std::string::npos; });
  };
  if (says({"llvmpipe", "softpipe", "swrast", "swr ", "software", "swiftshader", "basic render"}))
    return rhi::DeviceType::Software;
  if (says({"virgl", "svga3d", "virtio"})) return rhi::DeviceType::Virtual;
  // AMD's integrated parts are named without a model ("AMD Radeon Graphics"), Intel's cards "Arc".
  if (says({"radeon graphics", "radeon vega", "mali", "adreno", "apple", "v3d", "tegra"}) ||
      (says({"intel"}) && !says({"arc"})))
    return rhi::DeviceType::Integrated;
  return rhi::DeviceType::Discrete;
}

GLint counterBits(const Functions& gl, GLenum target) {
  GLint bits = 0;
  gl.GetQueryiv(target, GL_QUERY_COUNTER_BITS, &bits);
  return bits;
}

std::set<rhi::Feature> features(const Functions& gl, const std::set<std::string>& ext) {
  using F = rhi::Feature;
  auto any = [&](std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* n) { return ext.contains(n); });
  };
  // Required by OpenGL 4.5 itself.
  std::set<F> out = {F::DepthClamp,       F::GeometryShader, F::SampleRateShading,
                     F::IndependentBlend, F::LogicOp,        F::MultiDrawIndirect};
  auto add = [&](F feature, bool present) {
    if (present) out.insert(feature);
  };
  add(F::VertexLayer, any({"GL_ARB_shader_viewport_layer_array"}));
  add(F::DualSourceBlend, integer(gl, GL_MAX_DUAL_SOURCE_DRAW_BUFFERS) > 0);
  // Both may be zero in the fragment stage: the specification asks for them in compute only.
  add(F::FragmentStoresAndAtomics, integer(gl, GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS) > 0 &&
                                       integer(gl, GL_MAX_FRAGMENT_IMAGE_UNIFORMS) > 0);
  add(F::PipelineStatistics,
      any({"GL_ARB_pipeline_statistics_query"}) || integer(gl, GL_MINOR_VERSION) >= 6);
  add(F::PreciseOcclusion, counterBits(gl, GL_SAMPLES_PASSED) > 0);
  add(F::SamplerAnisotropy,
      any({"GL_ARB_texture_filter_anisotropic", "GL_EXT_texture_filter_anisotropic"}));
  add(F::FragmentInterlock, any({"GL_ARB_fragment_shader_interlock"}));
  add(F::ConservativeRaster,
      any({"GL_NV_conservative_raster", "GL_INTEL_conservative_rasterization"}));
  add(F::DepthBounds, any({"GL_EXT_depth_bounds_test"}));
  return out;
}

std::vector<uint32_t> sampleCounts(const Functions& gl, GLenum internalFormat) {
  std::vector<uint32_t> counts = {1};
  constexpr GLenum target = GL_TEXTURE_2D_MULTISAMPLE;
  GLint count = 0;
  gl.GetInternalformativ(target, internalFormat, GL_NUM_SAMPLE_COUNTS, 1, &count);
  std::vector<GLint> values(size_t(std::max(count, 0)));
  if (count > 0) gl.GetInternalformativ(target, internalFormat, GL_SAMPLES, count, values.data());
  for (GLint value : values)
    if (value > 1) counts.push_back(uint32_t(value));
  std::ranges::sort(counts);
  return counts;
}

rhi::Limits limits(const Functions& gl) {
  rhi::Limits out;
  out.maxTexture2D =
      uint32_t(std::min(integer(gl, GL_MAX_TEXTURE_SIZE), integer(gl, GL_MAX_RENDERBUFFER_SIZE)));
  out.maxTexture3D = uint32_t(integer(gl, GL_MAX_3D_TEXTURE_SIZE));
  out.maxTextureLayers = uint32_t(integer(gl, GL_MAX_ARRAY_TEXTURE_LAYERS));
  out.maxColorAttachments =
      uint32_t(std::min(integer(gl, GL_MAX_COLOR_ATTACHMENTS), integer(gl, GL_MAX_DRAW_BUFFERS)));
  const auto color = sampleCounts(gl, GL_RGBA8), depth = sampleCounts(gl, GL_DEPTH_COMPONENT32F);
  std::ranges::set_intersection(color, depth, std::back_inserter(out.sampleCounts));
  GLint64 storage = 0;
  gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
  out.maxStorageRange = uint64_t(storage);
  out.maxUniformRange = uint64_t(integer(gl, GL_MAX_UNIFORM_BLOCK_SIZE));
  out.uniformAlignment = uint32_t(integer(gl, GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT));
  out.storageAlignment = uint32_t(integer(gl, GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT));
  out.subPixelBits = uint32_t(integer(gl, GL_SUBPIXEL_BITS));
  out.maxGeometryVertices = uint32_t(integer(gl, GL_MAX_GEOMETRY_OUTPUT_VERTICES));
  out.maxComputeInvocations = uint32_t(integer(gl, GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS));
  out.timestampPeriodNs = 1;  // by specification
  out.timestampBits = uint32_t(counterBits(gl, GL_TIMESTAMP));
  return out;
}

uint64_t memoryBytes(const Functions& gl, const std::set<std::string>& ext) {
  if (ext.contains("GL_NVX_gpu_memory_info"))
    return uint64_t(integer(gl, kDedicatedVideoMemoryNvx)) * 1024;
  if (ext.contains("GL_ATI_meminfo")) {
    GLint values[4] = {};  // free memory of the pool comes first; there is no total
    gl.GetIntegerv(kTextureFreeMemoryAti, values);
    return uint64_t(values[0]) * 1024;
  }
  return 0;
}

}  // namespace

rhi::DeviceInfo queryDeviceInfo(const Functions& gl) {
  const std::set<std::string> ext = extensions(gl);
  rhi::DeviceInfo info;
  info.name = text(gl, GL_RENDERER);
  info.type = typeOf(info.name);
  info.driver = info.name.find("llvmpipe") != std::string::npos ? "llvmpipe" : text(gl, GL_VENDOR);
  info.driverVersion = text(gl, GL_VERSION);
  info.apiVersion = std::to_string(integer(gl, GL_MAJOR_VERSION)) + "." +
                    std::to_string(integer(gl, GL_MINOR_VERSION)) + " core";
  info.memoryBytes = memoryBytes(gl, ext);
  info.features = features(gl, ext);
  info.limits = limits(gl);
  return info;
}

rhi::FormatCaps queryFormatCaps(const Functions& gl, rhi::Format format) {
  rhi::FormatCaps caps;
  const GLenum internalFormat = formatTriple(format).internalFormat;
  auto query = [&](GLenum name) {
    GLint value = 0;
    gl.GetInternalformativ(GL_TEXTURE_2D, internalFormat, name, 1, &value);
    return GLenum(value);
  };
  auto supported = [&](GLenum name) {
    const GLenum value = query(name);
    return value == GL_FULL_SUPPORT || value == GL_CAVEAT_SUPPORT;
  };
  if (internalFormat == 0 || query(GL_INTERNALFORMAT_SUPPORTED) != GL_TRUE) return caps;
  const rhi::FormatInfo& info = rhi::formatInfo(format);
  caps.sampled = supported(GL_FRAGMENT_TEXTURE);
  caps.linearFilter = supported(GL_FILTER);
  const bool renderable = supported(GL_FRAMEBUFFER_RENDERABLE);
  caps.colorTarget = renderable && !info.depth;
  caps.depthTarget = renderable && info.depth;
  const bool isInteger = info.kind == rhi::FormatKind::Uint || info.kind == rhi::FormatKind::Sint;
  caps.blend = caps.colorTarget && !isInteger && supported(GL_FRAMEBUFFER_BLEND);
  // Not every driver answers GL_NONE for formats that image units refuse; those have no class.
  caps.storage = !info.depth && query(GL_IMAGE_COMPATIBILITY_CLASS) != GL_NONE &&
                 supported(GL_SHADER_IMAGE_LOAD) && supported(GL_SHADER_IMAGE_STORE);
  caps.storageAtomic = caps.storage &&
                       (format == rhi::Format::R32Uint || format == rhi::Format::R32Sint) &&
                       supported(GL_SHADER_IMAGE_ATOMIC);
  caps.sampleCounts = renderable ? sampleCounts(gl, internalFormat) : std::vector<uint32_t>{1};
  return caps;
}

}  // namespace opengl

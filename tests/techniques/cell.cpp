#include "tests/techniques/cell.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace shadowbench_shader_blob {
void addTo(rhi::ShaderLibrary& library);
}
namespace test_shaders {
void addTo(rhi::ShaderLibrary& library);
}

namespace sb::test {
namespace {

template <class T>
std::vector<float> unormToFloat(std::span<const std::byte> bytes, float most) {
  std::vector<float> out(bytes.size() / sizeof(T));
  for (size_t i = 0; i < out.size(); ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    out[i] = float(double(value) / most);
  }
  return out;
}

std::vector<float> rgb10a2ToFloat(std::span<const std::byte> bytes) {
  std::vector<float> out;
  for (size_t i = 0; i < bytes.size(); i += 4) {
    uint32_t v;
    std::memcpy(&v, bytes.data() + i, 4);
    for (int c = 0; c < 3; ++c) out.push_back(float((v >> (10 * c)) & 1023u) / 1023.0f);
    out.push_back(float(v >> 30) / 3.0f);
  }
  return out;
}

std::vector<float> floats(std::span<const std::byte> bytes) {
  std::vector<float> out(bytes.size() / 4);
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

}  // namespace

RendererDesc rendererDescOf(const CellOptions& options) {
  std::map<std::string, std::string> given = options.knobs;
  const std::string technique = options.entry ? "none" : options.technique;
  if (hasKnob(technique, "size")) given.try_emplace("size", "256");
  RendererDesc desc = rendererDesc({.technique = technique,
                                    .transparency = options.transparency,
                                    .knobs = {given.begin(), given.end()},
                                    .width = options.size.width,
                                    .height = options.size.height,
                                    .seed = options.seed});
  if (options.entry) desc.technique = options.entry;
  desc.forced = options.forced;
  return desc;
}

const rhi::ShaderLibrary& productionShaders() {
  static const rhi::ShaderLibrary library = [] {
    rhi::ShaderLibrary lib;
    shadowbench_shader_blob::addTo(lib);
    test_shaders::addTo(lib);  // of techniques that only tests know
    return lib;
  }();
  return library;
}

bool hasKnob(const std::string& technique, const std::string& knob) {
  const auto& knobs = shadowTechnique(technique).info.knobs;
  return std::ranges::find(knobs, knob, &KnobInfo::name) != knobs.end();
}

Cell::Cell(CellDevice& device, Scene scene, const CellOptions& options)
    : m_device(device), m_scene(std::move(scene)), m_options(options) {
  const RendererDesc desc = rendererDescOf(options);
  m_knobs = desc.knobs;
  m_stage.emplace(m_scene, options.size);
  m_renderer = m_stage->renderer(device.context(), desc);
  renderAgain();
}

report::Picture Cell::picture() {
  return {m_options.size.width, m_options.size.height, m_renderer->readImage()};
}

const std::vector<VisibilityImage>& Cell::visibility(uint32_t light) {
  if (light == kFirstInView) light = m_renderer->lights().front();
  auto [it, isNew] = m_visibility.try_emplace(light);
  if (isNew) it->second = m_renderer->readVisibility(light);
  return it->second;
}

bool Cell::hasMap(const std::string& label) {
  if (!m_renderer->technique()) return false;
  for (const auto& [name, texture] : m_renderer->technique()->maps())
    if (name == label) return true;
  return false;
}

std::vector<float> Cell::map(const std::string& label, uint32_t layer) {
  for (const auto& [name, texture] : m_renderer->technique()->maps()) {
    if (name != label) continue;
    const rhi::Format format = m_device.device.textureDesc(texture).format;
    const bool depth = rhi::formatInfo(format).depth;
    const auto bytes = m_device.device.read(texture, {.layer = layer},
                                            depth ? rhi::Aspect::Depth : rhi::Aspect::Color);
    switch (format) {
      case rhi::Format::D16Unorm:
      case rhi::Format::RGBA16Unorm:
        return unormToFloat<uint16_t>(bytes, 65535);
      case rhi::Format::D24Unorm:
      case rhi::Format::D24UnormS8:
        return unormToFloat<uint32_t>(bytes, 16777215);
      case rhi::Format::RGB10A2Unorm:
        return rgb10a2ToFloat(bytes);
      default:
        return floats(bytes);
    }
  }
  throw std::runtime_error("no map " + label);
}

uint32_t Cell::mapSize() const { return m_knobs.integer("size"); }

std::vector<LightView> Cell::lightViews() const {
  const uint32_t size = mapSize();
  return fitLights(m_scene, effects(), double(m_options.size.width) / m_options.size.height,
                   {.mapSize = size,
                    .guardTexels = std::min(m_knobs.integer("kernel") / 2 + 2, size / 4),
                    .fit = m_knobs.is("fit", "stable") ? LightFit::Stable : LightFit::Tight,
                    .depthStep = m_knobs.is("depth", "d32f") ? 0 : 0x1p-24f});
}

}  // namespace sb::test

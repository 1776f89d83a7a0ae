#include "techniques/render/renderer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "techniques/draw/texels.h"
#include "techniques/render/frame_order.h"

namespace sb {
namespace {

std::map<std::string, uint64_t> difference(std::map<std::string, uint64_t> after,
                                           const std::map<std::string, uint64_t>& before) {
  for (const auto& [label, bytes] : before) {
    after[label] -= bytes;
    if (after[label] == 0) after.erase(label);
  }
  return after;
}

void add(VisibilityInputs& inputs, const VisibilityInputs& more) {
  inputs.bindings.insert(inputs.bindings.end(), more.bindings.begin(), more.bindings.end());
  inputs.reads.insert(inputs.reads.end(), more.reads.begin(), more.reads.end());
  inputs.constants.insert(inputs.constants.end(), more.constants.begin(), more.constants.end());
}

}  // namespace

Renderer::Renderer(const DeviceContext& device, const GpuScene& gpuScene, const Effects& effects,
                   RendererDesc desc)
    : m_device(device),
      m_desc(std::move(desc)),
      m_runner(device.device, device.queries),
      m_stream(device.device, device.queries) {
  const auto before = device.device.ledger().bytesByLabel();
  const TechniqueInfo& info = m_desc.technique->info;
  m_plan = makePlan(effects, representedBy(m_desc.set()), m_desc.forced);
  m_view = std::make_unique<SceneView>(device.device, gpuScene, effects, m_desc.size, m_desc.seed);

  // Without a light that casts there is no shadow to compute: lighting alone, whatever the
  // technique.
  const bool casts = std::ranges::any_of(effects.lights, &LightEffects::casts);
  std::string folder = baselineTechnique().info.folder;
  VisibilityInputs inputs;
  if (casts) {
    m_technique = m_desc.technique->make();
    m_technique->prepare(context());
    // While the view shows the whole path, every layer is drawn; steps that lack some read it.
    if (!m_view->fit().firstHasAll())
      m_runner.run(FrameMode::Plain, [&](Frame& frame) { m_technique->record(frame); });
    inputs = m_technique->inputs();
    folder = inputs.folder.empty() ? info.folder : inputs.folder;
  }
  m_lights = m_desc.lights->make();
  m_lights->prepare(context());
  add(inputs, m_lights->inputs());
  m_camera = std::make_unique<CameraPass>(
      context(), CameraPassDesc{.folder = folder,
                                .inputs = std::move(inputs),
                                .lightsFolder = m_desc.lights->info.folder,
                                .byLayer = info.receiversByLayer ? m_technique.get() : nullptr,
                                .transparency = m_desc.transparency});
  m_bytes = difference(device.device.ledger().bytesByLabel(), before);
}

Context Renderer::context() {
  return {m_device.device, m_device.shaders, m_device.pipelines, *m_view, m_plan, m_desc.knobs};
}

Renderer::Record Renderer::moved(std::function<void(rhi::CommandList&)> move) {
  return [this, move = std::move(move)](Frame& frame) {
    frame.between("moved", PassGroup::Shadow, [&](rhi::CommandList& commands) {
      move(commands);
      if (m_technique) m_technique->moved(frame);
      m_lights->moved(frame);
      m_camera->moved(frame);
    });
  };
}

// Decided before the frame is recorded: one that is recorded twice (FrameRunner) moves twice.
Renderer::Record Renderer::nextMove() {
  if (m_look)
    return moved([this, look = *std::exchange(m_look, {})](rhi::CommandList& commands) {
      m_view->look(commands, look);
    });
  const uint32_t next = m_at ? (*m_at + 1) % steps() : 0;
  const uint32_t step = m_standing.value_or(next);
  const bool moves = steps() > 1 && m_at != step;
  m_at = step;
  if (!moves) return [](Frame&) {};
  return moved([this, step](rhi::CommandList& commands) { m_view->moveTo(commands, step); });
}

void Renderer::record(Frame& frame) {
  m_lights->record(frame);
  recordInOrder(frame, m_technique.get(),
                {.opaque = [&] { m_camera->recordOpaque(frame); },
                 .translucent = [&] { m_camera->recordTranslucent(frame); },
                 .translucentPart = [&](auto part) { m_camera->recordTranslucent(frame, part); }});
}

FrameResult Renderer::frame(FrameMode mode) {
  const Record move = nextMove();
  return m_runner.run(mode, [&](Frame& frame) {
    move(frame);
    record(frame);
  });
}

rhi::Ticket Renderer::show(const Present& present) {
  const Record move = nextMove();
  return m_stream.submit([&](Frame& frame) {
    move(frame);
    record(frame);
    present(frame.commands(), m_camera->color());
  });
}

std::vector<float> Renderer::readImage() {
  return halfToFloat(m_device.device.read(m_camera->color()));
}

std::vector<VisibilityImage> Renderer::readVisibility(uint32_t light) {
  if (!m_visibility)
    m_visibility = std::make_unique<VisibilityBuffer>(context(), *m_camera, m_technique.get(),
                                                      m_device.queries);
  const std::vector<uint32_t> inView = lights();
  const auto at = std::ranges::find(inView, light);
  if (at == inView.end()) throw std::out_of_range("the light does not touch the view");
  return m_visibility->render(ViewLight(at - inView.begin()));
}

std::vector<uint32_t> Renderer::lights() const {
  std::vector<uint32_t> lights;
  for (const LightEffects& effects : m_view->effects().lights)
    if (effects.touchesView) lights.push_back(effects.light);
  return lights;
}

std::string Renderer::whyNotRandom() const {
  if (m_desc.technique->info.stochastic && m_plan.runs(Effect::TranslucentCasters)) return "";
  return m_desc.transparency->info.stochastic && m_plan.runs(Effect::CameraTransparency)
             ? "visibility is not random, only the mix of translucent surfaces is"
             : "nothing random runs";
}

void Renderer::setSeed(uint32_t seed) {
  m_desc.seed = seed;
  m_view->setSeed(m_device.device, seed);
}

std::vector<VisibilityImage> Renderer::visibilityAtEnd(uint32_t light, uint32_t seed) {
  standStill();
  if (seed != m_desc.seed || m_at != steps() - 1) {
    setSeed(seed);
    frame();
  }
  return readVisibility(light);
}

LookupReach Renderer::reach(uint32_t light) const {
  return m_technique ? m_technique->reach(light) : LookupReach{};
}

}  // namespace sb

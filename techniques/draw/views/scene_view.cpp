#include "techniques/draw/views/scene_view.h"

#include <cassert>

namespace sb {

SceneView::SceneView(rhi::Device& device, const GpuScene& gpuScene, const Effects& effects,
                     rhi::Extent2D size, uint32_t seed)
    : m_gpu(gpuScene),
      m_effects(effects),
      m_moving(gpuScene.scene()),
      m_placed(gpuScene.scene()),
      m_shown(&effects),
      m_size(size),
      m_seed(seed),
      m_fit(aspect(), effects.overview.has_value()),
      m_instances(gpuScene),
      m_buffers(device, size_t(std::ranges::count_if(effects.lights, &LightEffects::touchesView)),
                coplanarWords()) {
  copyInstances(device, 1);
  bind();
  showAll();
  writeAll(uploadsTo(device));
}

ViewFit::Step SceneView::stepOf(uint32_t step) const {
  PlacedScene placed(scene(), step);
  if (m_effects.overview) placed = placed.seenBy(*m_effects.overview);
  const bool standing = m_effects.steps.empty();
  return {std::move(placed), standing ? m_effects : m_effects.steps[step]};
}

size_t SceneView::coplanarWords() const {
  if (!m_gpu.everCoplanar()) return 0;
  const CameraMatrices any = cameraMatrices(scene().camera(), aspect());
  size_t most = 1;
  for (uint32_t k = 0; k < pathSteps(); ++k)
    most = std::max(most, m_gpu.coplanar(k).words(any, m_size.width, m_size.height).size());
  return most;
}

void SceneView::bind() {
  m_bindings = m_buffers.bindings();
  m_bindings.push_back(m_gpu.triangles());
}

void SceneView::show(PlacedScene placed, const ViewEffects& shown) {
  m_placed = std::move(placed);
  m_shown = &shown;
  m_camera = cameraMatrices(m_placed.camera(), aspect());
  m_instances.place(m_placed, m_camera.eye, m_moving.instances);
}

void SceneView::showAll() {
  PlacedScene placed(scene());
  show(m_effects.overview ? placed.seenBy(*m_effects.overview) : placed, m_effects);
  m_fit.showAll();
}

void SceneView::moveTo(rhi::CommandList& commands, uint32_t step) {
  const ViewFit::Step there = stepOf(step);
  show(there.placed, there.shown);
  m_step = step;
  m_fit.fit(there);
  const BufferWrite write = writesTo(commands);
  if (m_moving.camera) return writeAll(write);
  // Relative to an eye that stands, so does what stands.
  m_instances.write(write, m_moving.instances);
  if (!m_moving.instances.empty()) m_buffers.writeCoplanar(write, *this);
  m_buffers.writeFrame(write, *this);
  m_buffers.writeLights(write, *this);
}

void SceneView::look(rhi::CommandList& commands, Look look) {
  assert(isFree() && look.step < pathSteps());
  m_looked = std::move(look.shown);
  m_step = look.step;
  show(PlacedScene(scene(), m_step).seenBy(look.camera), m_looked);
  m_fit.fit({m_placed, m_looked});
  writeAll(writesTo(commands));
}

void SceneView::alongPath(rhi::Device& device, const std::function<void()>& visit) {
  if (m_effects.steps.empty()) return visit();
  for (m_step = 0; m_step < pathSteps(); ++m_step) {
    const ViewFit::Step there = stepOf(m_step);
    show(there.placed, there.shown);
    m_fit.fitWidely(there);
    writeAll(uploadsTo(device));
    visit();
  }
  m_step = pathSteps() - 1;
  showAll();
  writeAll(uploadsTo(device));
}

void SceneView::fitLightViews(rhi::Device& device, const LightFitSettings& settings) {
  std::vector<ViewFit::Step> steps;
  for (uint32_t k = 0; k < m_effects.steps.size(); ++k) steps.push_back(stepOf(k));
  if (steps.empty()) steps.push_back({m_placed, m_effects});
  m_fit.prepare(settings, steps);
  m_buffers.makeRoom(device, m_fit.places());
  bind();
  m_buffers.writeLights(uploadsTo(device), *this);
}

void SceneView::setSeed(rhi::Device& device, uint32_t seed) {
  m_seed = seed;
  m_buffers.writeFrame(uploadsTo(device), *this);
}

void SceneView::writeAll(const BufferWrite& write) {
  m_instances.writeAll(write);
  m_buffers.writeAll(write, *this);
}

}  // namespace sb

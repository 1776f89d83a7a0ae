#include "techniques/draw/views/view_buffers.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/views/scene_view.h"
#include "techniques/scene/light_data.h"

namespace sb {
namespace {

rhi::Buffer makeStorage(rhi::Device& device, const char* label, uint64_t bytes,
                        rhi::BufferUse use = rhi::BufferUse::Storage) {
  return device.createBuffer({.label = label,
                              .size = std::max<uint64_t>(16, bytes),
                              .use = use | rhi::BufferUse::CopyTarget});
}

/// Lists of lights are read from uniform blocks where they fit, else from storage.
constexpr rhi::BufferUse kListUse = rhi::BufferUse::Uniform | rhi::BufferUse::Storage;

/// Elements of a block that holds `count`: one, or a power of four, so that few pipelines serve all
/// scenes.
uint32_t blockLength(size_t count) {
  uint32_t length = 1;
  while (length < count) length *= 4;
  return length;
}

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& data) {
  return std::as_bytes(std::span(data));
}

/// Of any light view, as it is now.
bool casterRises(const SceneView& view) {
  const auto rises = [&](uint32_t i) { return view.gpu().rises(i, view.step()); };
  return std::ranges::any_of(view.lightViews(), [&](const LightView& v) {
    return std::ranges::any_of(v.opaque, rises) || std::ranges::any_of(v.perforated, rises) ||
           std::ranges::any_of(v.translucent, rises);
  });
}

}  // namespace

ViewBuffers::ViewBuffers(rhi::Device& device, size_t lights, size_t coplanarWords)
    : m_mostUniform(std::min<uint64_t>(kMostUniformBytes, device.info().limits.maxUniformRange)),
      m_lightCount(blockLength(lights)) {
  m_frame = makeStorage(device, "view frame", sizeof(gpu::FrameData), rhi::BufferUse::Uniform);
  // Only lights that touch the view exist for the shaders.
  m_lights =
      makeStorage(device, "view lights", uint64_t(m_lightCount) * sizeof(gpu::LightData), kListUse);
  makeRoom(device, 0);
  if (coplanarWords > 0)
    m_coplanar = makeStorage(device, "view coplanar surfaces", coplanarWords * sizeof(uint32_t));
}

void ViewBuffers::makeRoom(rhi::Device& device, size_t lightViews) {
  m_viewCount = blockLength(lightViews);
  m_shadowViews = makeStorage(device, "view shadow views",
                              uint64_t(m_viewCount) * sizeof(gpu::ShadowViewData), kListUse);
}

std::vector<rhi::Binding> ViewBuffers::bindings() const {
  const bool stored = inStorage();
  return {rhi::uniformAt(UNIFORM_FRAME, m_frame, 0, sizeof(gpu::FrameData)),
          rhi::uniformAt(UNIFORM_LIGHTS, m_lights, 0,
                         (stored ? 1 : m_lightCount) * sizeof(gpu::LightData)),
          rhi::uniformAt(UNIFORM_SHADOW_VIEWS, m_shadowViews, 0,
                         (stored ? 1 : m_viewCount) * sizeof(gpu::ShadowViewData)),
          rhi::storageAt(STORAGE_LIGHTS, m_lights),
          rhi::storageAt(STORAGE_SHADOW_VIEWS, m_shadowViews),
          // Scenes without such surfaces do not read it.
          rhi::storageAt(STORAGE_COPLANAR, m_coplanar ? m_coplanar.id() : m_lights.id())};
}

bool ViewBuffers::inStorage() const {
  return m_lightCount * sizeof(gpu::LightData) > m_mostUniform ||
         m_viewCount * sizeof(gpu::ShadowViewData) > m_mostUniform;
}

std::vector<rhi::SpecConstant> ViewBuffers::constants() const {
  const bool stored = inStorage();
  return {{5, stored ? 1 : m_lightCount}, {6, stored ? 1 : m_viewCount}, {7, stored}};
}

void ViewBuffers::writeAll(const BufferWrite& write, const SceneView& view) const {
  writeCoplanar(write, view);
  writeFrame(write, view);
  writeLights(write, view);
}

void ViewBuffers::writeCoplanar(const BufferWrite& write, const SceneView& view) const {
  if (!m_coplanar) return;
  const auto [width, height] = view.size();
  write(m_coplanar, 0,
        bytesOf(view.gpu().coplanar(view.step()).words(view.camera(), width, height)));
}

void ViewBuffers::writeFrame(const BufferWrite& write, const SceneView& view) const {
  const auto lights = std::ranges::count_if(view.effects().lights, &LightEffects::touchesView);
  const auto [width, height] = view.size();
  const CameraMatrices& camera = view.camera();
  const CameraRays rays = cameraRays(view.placed().camera(), width, height);
  const gpu::FrameData frame{.viewProjection = glm::mat4(camera.viewProjection),
                             .ambient = glm::vec4(view.scene().ambient, 0),
                             .counts = {uint32_t(lights), width, height, view.seed()},
                             .eye = glm::vec4(camera.eye, 1),
                             .sky = glm::vec4(view.scene().sky, 0),
                             .rayOrigin = glm::vec4(rays.origin, 0),
                             .rayRight = glm::vec4(rays.right, 0),
                             .rayUp = glm::vec4(rays.up, 0),
                             .rayForward = glm::vec4(rays.forward, rays.parallel ? 1 : 0),
                             .depthToDistance = glm::vec4(rays.depthToDistance)};
  write(m_frame, 0, std::as_bytes(std::span(&frame, 1)));
}

void ViewBuffers::writeLights(const BufferWrite& write, const SceneView& view) const {
  std::vector<gpu::LightData> lights;
  std::vector<gpu::ShadowViewData> shadowViews;
  const std::vector<LightView>& views = view.lightViews();
  const bool rises = casterRises(view);
  for (const LightView& v : views)
    shadowViews.push_back(shadowViewData(v, view.fit().settings(), rises));
  for (const LightEffects& effects : view.effects().lights) {
    if (!effects.touchesView) continue;
    gpu::LightData d =
        lightData(view.placed().light(effects.light), effects.light, view.camera().eye);
    const auto first = std::ranges::find(views, effects.light, &LightView::light);
    if (effects.casts() && first != views.end()) {
      d.ids.y = uint32_t(first - views.begin());
      d.ids.z = uint32_t(std::ranges::count(views, effects.light, &LightView::light));
    }
    lights.push_back(d);
  }
  write(m_lights, 0, bytesOf(lights));
  write(m_shadowViews, 0, bytesOf(shadowViews));
}

}  // namespace sb

#include "techniques/partition/light_order.h"

#include <algorithm>
#include <tuple>

#include "techniques/scene/box.h"

namespace sb {

KnobInfo lightOrderKnob() {
  return {.name = "order",
          .help =
              "where blending needs an order from the light: meshes by their centre or nearest "
              "point, triangles, or none",
          .fallback = "centre",
          .choices = {"centre", "nearest", "triangle", "none"}};
}

double lightDepth(const LightView& view, const glm::dvec3& relative) {
  const glm::dvec4 clip =
      glm::dmat4(view.toClip) * glm::dvec4(relative - glm::dvec3(view.origin), 1);
  if (view.perspective) return clip.w;
  const auto& m = view.toClip;  // depth is reversed, and 1 over the depth of the map's volume
  return -clip.z / glm::length(glm::dvec3(m[0].z, m[1].z, m[2].z));
}

namespace {

double boxDepth(const LightView& view, const Box& box, bool nearest) {
  if (!nearest) return lightDepth(view, box.center());
  double least = 1e300;
  for (int corner = 0; corner < 8; ++corner)
    least = std::min(least, lightDepth(view, box.corner(corner)));
  return least;
}

}  // namespace

LightOrder::LightOrder(const Context& context, const ShadowMaps& maps, size_t view,
                       const std::string& how)
    : m_view(&context.view), m_maps(&maps), m_index(view), m_how(how) {
  if (m_how == "triangle")
    // By value: an order may move in memory.
    m_triangles.emplace(
        context,
        [&maps, view]() -> std::span<const uint32_t> { return maps.views()[view].translucent; },
        [&maps, view](const glm::dvec3& p) { return lightDepth(maps.views()[view], p); },
        std::vector{maps.passBlock(view)});
  else
    sortInstances();
}

void LightOrder::sort(rhi::CommandList& commands) {
  if (m_triangles)
    m_triangles->sort(commands);
  else
    sortInstances();
}

void LightOrder::sortInstances() {
  m_instances = lightView().translucent;
  if (m_how == "none") return;
  const Scene& scene = m_view->scene();
  std::vector<std::tuple<double, uint32_t, uint32_t>> order;
  for (const uint32_t i : m_instances)
    order.emplace_back(boxDepth(lightView(), instanceBox(m_view->placed(), i, m_view->camera().eye),
                                m_how == "nearest"),
                       scene.instances[i].key, i);
  std::ranges::sort(order);
  for (size_t i = 0; i < order.size(); ++i) m_instances[i] = std::get<2>(order[i]);
}

void LightOrder::draw(rhi::CommandList& commands, DrawList& whole, rhi::PipelineId pipeline) {
  if (m_triangles)
    m_triangles->draw(commands, pipeline);
  else
    whole.draw(commands, pipeline, m_instances);
}

std::vector<LightOrder> lightOrder(const Context& context, const ShadowMaps& maps,
                                   const std::string& how) {
  std::vector<LightOrder> orders;
  orders.reserve(maps.views().size());
  for (size_t v = 0; v < maps.views().size(); ++v) orders.emplace_back(context, maps, v, how);
  return orders;
}

}  // namespace sb

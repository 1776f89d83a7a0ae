#include "techniques/common/light_order.h"

#include <algorithm>
#include <tuple>

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
  const glm::dvec4 clip = glm::dmat4(view.data.toClip) *
                          glm::dvec4(relative - glm::dvec3(glm::vec3(view.data.origin)), 1);
  if (view.data.texel.w > 0) return clip.w;
  const auto& m = view.data.toClip;  // depth is reversed, and 1 over the depth of the map's volume
  return -clip.z / glm::length(glm::dvec3(m[0].z, m[1].z, m[2].z));
}

namespace {

double boxDepth(const LightView& view, const Box& box, bool nearest) {
  if (!nearest) return lightDepth(view, (box.min + box.max) * 0.5);
  double least = 1e300;
  for (int corner = 0; corner < 8; ++corner)
    least = std::min(least, lightDepth(view, {corner & 1 ? box.max.x : box.min.x,
                                              corner & 2 ? box.max.y : box.min.y,
                                              corner & 4 ? box.max.z : box.min.z}));
  return least;
}

}  // namespace

std::vector<LightOrder> lightOrder(const Context& context, const ShadowMaps& maps,
                                   const std::string& how) {
  const Scene& scene = context.view.scene();
  std::vector<LightOrder> orders(maps.views().size());
  for (size_t v = 0; v < orders.size(); ++v) {
    const LightView& view = maps.views()[v];
    LightOrder& order = orders[v];
    order.instances = view.translucent;
    if (how == "triangle") {
      order.byTriangle = true;
      order.triangles = TriangleOrder(context, view.translucent,
                                      [&](const glm::dvec3& p) { return lightDepth(view, p); },
                                      {maps.passBlock(v)});
    } else if (how != "none") {
      const auto key = [&](uint32_t i) {
        return std::tuple(
            boxDepth(view, instanceBounds(scene, i, context.view.camera().eye), how == "nearest"),
            scene.instances[i].key);
      };
      std::ranges::sort(order.instances, {}, key);
    }
  }
  return orders;
}

void LightOrder::draw(rhi::CommandList& commands, DrawList& whole, rhi::PipelineId pipeline) {
  if (byTriangle)
    triangles.draw(commands, pipeline);
  else
    whole.draw(commands, pipeline, instances);
}

}  // namespace sb

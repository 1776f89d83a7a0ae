// EXT_mesh_gpu_instancing: one mesh at many places, stated as attributes of a node.
#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/nodes/roots.h"

namespace sb {
namespace {

using nlohmann::json;

struct Part {
  std::vector<float> values;  ///< empty: not stated
  int components = 3;
  const float* at(size_t i) const { return values.data() + i * size_t(components); }
};

}  // namespace

std::vector<glm::dmat4> gpuInstances(GltfContext& context, size_t node) {
  const std::string field = fieldAt("nodes", node) + ".extensions.EXT_mesh_gpu_instancing";
  const json& attributes =
      context.source.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  Part translation, rotation{.values = {}, .components = 4}, scale;
  std::optional<size_t> count;
  for (const auto& [key, value] : attributes.items()) {
    const std::string at = field + ".attributes." + key;
    Part* part = key == "TRANSLATION" ? &translation
                 : key == "ROTATION"  ? &rotation
                 : key == "SCALE"     ? &scale
                                      : nullptr;
    const int accessor = int(checkedIndex(context.source, value, at, "accessors"));
    const size_t found = context.model.accessors[size_t(accessor)].count;
    if (count.value_or(found) != found)
      context.fail(at, "has " + std::to_string(found) + " elements, another attribute has " +
                           std::to_string(*count));
    count = found;
    if (!part) continue;  // attributes of applications
    if (const int c = componentCount(context, at, accessor); c != part->components)
      context.fail(at, "has " + std::to_string(c) + " components, expected " +
                           std::to_string(part->components));
    if (found > kMaxInstances)
      context.fail(at, "has " + std::to_string(found) + " elements, at most " +
                           std::to_string(kMaxInstances) + " instances are read");
    context.source.take(at, found, 400);
    part->values = readFloats(context, at, accessor, part->components);
  }
  std::vector<glm::dmat4> places(count.value_or(0));
  for (size_t i = 0; i < places.size(); ++i) {
    double t[3], r[4], s[3];
    const auto fill = [i](const Part& part, double* out) -> const double* {
      if (part.values.empty()) return nullptr;
      for (int c = 0; c < part.components; ++c) out[c] = double(part.at(i)[c]);
      return out;
    };
    places[i] = composed(context, field + ".attributes", fill(translation, t), fill(rotation, r),
                         fill(scale, s));
  }
  return places;
}

}  // namespace sb

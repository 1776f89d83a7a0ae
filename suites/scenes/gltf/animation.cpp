// Animations at t = 0: of the first one, each channel's first key. Keys begin at 0 or later and a
// sampler clamps before its first key, so interpolation never matters.
#include "suites/scenes/gltf/check.h"
#include "suites/scenes/gltf/context.h"

namespace sb {
namespace {

using nlohmann::json;

const json& member(const GltfContext& context, const json& object, const std::string& field,
                   const char* key) {
  if (!object.is_object()) context.fail(field, "is " + shown(object) + ", expected an object");
  const auto found = object.find(key);
  if (found == object.end()) context.fail(field + "." + key, "is missing");
  return *found;
}

const json& array(const GltfContext& context, const json& object, const std::string& field,
                  const char* key) {
  const json& found = member(context, object, field, key);
  if (!found.is_array())
    context.fail(field + "." + key, "is " + shown(found) + ", expected an array");
  return found;
}

std::string text(const json& object, const char* key, const char* fallback) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : fallback;
}

// Values of a sampler's first key: `elements` elements of the output accessor, `components` each.
std::vector<double> firstKey(const GltfContext& context, const json& sampler,
                             const std::string& field, int components, size_t elements) {
  const std::string outputField = field + ".output";
  const int output = int(checkedIndex(context.source, member(context, sampler, field, "output"),
                                      outputField, "accessors"));
  if (const int found = componentCount(context, outputField, output); found != components)
    context.fail(outputField, "has " + std::to_string(found) + " components, expected " +
                                  std::to_string(components));
  // Splines hold an incoming tangent, the value and an outgoing tangent for each key.
  const bool spline = text(sampler, "interpolation", "LINEAR") == "CUBICSPLINE";
  const size_t first = spline ? elements : 0;
  const size_t count = context.model.accessors[size_t(output)].count;
  if (count < first + elements)
    context.fail(outputField, "has " + std::to_string(count) + " elements, expected at least " +
                                  std::to_string(first + elements));
  const auto floats = readFloats(context, outputField, output, components, first, elements);
  return {floats.begin(), floats.end()};
}

size_t morphTargets(const GltfContext& context, const json& node) {
  if (!node.contains("mesh")) return 0;
  const json& mesh = context.source.json["meshes"][node["mesh"].get<size_t>()];
  const json& primitives = mesh["primitives"];
  if (primitives.empty() || !primitives[0].contains("targets")) return 0;
  return primitives[0]["targets"].size();
}

void readChannel(GltfContext& context, const json& animation, const std::string& field,
                 const json& channel, const std::string& channelField) {
  const json& target = member(context, channel, channelField, "target");
  const std::string targetField = channelField + ".target";
  if (!target.is_object())
    context.fail(targetField, "is " + shown(target) + ", expected an object");
  if (!target.contains("node")) return;  // extensions animate other things
  const size_t node = checkedIndex(context.source, target["node"], targetField + ".node", "nodes");
  const std::string path = text(target, "path", "");

  const json& samplers = array(context, animation, field, "samplers");
  const json& number = member(context, channel, channelField, "sampler");
  if (!number.is_number_unsigned() || number.get<size_t>() >= samplers.size())
    context.fail(channelField + ".sampler", "is " + shown(number) + ", but there are " +
                                                std::to_string(samplers.size()) + " samplers");
  const json& sampler = samplers[number.get<size_t>()];
  const std::string samplerField = fieldAt(field + ".samplers", number.get<size_t>());
  if (!sampler.is_object())
    context.fail(samplerField, "is " + shown(sampler) + ", expected an object");

  NodePose& pose = context.poses[int(node)];
  if (path == "translation")
    pose.translation = firstKey(context, sampler, samplerField, 3, 1);
  else if (path == "rotation")
    pose.rotation = firstKey(context, sampler, samplerField, 4, 1);
  else if (path == "scale")
    pose.scale = firstKey(context, sampler, samplerField, 3, 1);
  else if (path == "weights") {
    const size_t count = morphTargets(context, context.source.json["nodes"][node]);
    if (count > 0) pose.weights = firstKey(context, sampler, samplerField, 1, count);
  } else {
    context.warn(targetField + ".path is " + shown(path) + ", which is left out");
  }
}

}  // namespace

void readPoses(GltfContext& context) {
  const auto animations = context.source.json.find("animations");
  if (animations == context.source.json.end() || !animations->is_array() || animations->empty())
    return;
  const json& animation = (*animations)[0];
  const std::string field = "animations[0]";
  const json& channels = array(context, animation, field, "channels");
  const std::string name = text(animation, "name", "");
  const std::string called = field + (name.empty() ? "" : " '" + name + "'");
  context.warn((animations->size() > 1
                    ? "the file holds " + std::to_string(animations->size()) + " animations; "
                    : std::string()) +
               called + " is shown at t = 0");
  for (size_t i = 0; i < channels.size(); ++i)
    readChannel(context, animation, field, channels[i], fieldAt(field + ".channels", i));
}

}  // namespace sb

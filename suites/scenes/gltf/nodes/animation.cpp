// Which animation counts, and where it puts nodes at t = 0: each channel's first key. Keys begin at
// 0 or later and a sampler clamps before its first key, so interpolation never matters.
#include "suites/scenes/gltf/nodes/animation.h"

#include <limits>

#include "base/number.h"
#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/context.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using nlohmann::json;

const json& array(const GltfContext& context, const json& object, const std::string& field,
                  const char* key) {
  const json& found = memberOf(context, object, field, key);
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
  const int output = int(checkedIndex(context.source, memberOf(context, sampler, field, "output"),
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

void readFirstKey(GltfContext& context, const AnimationChannel& channel) {
  NodePose& pose = context.poses[int(channel.node)];
  const auto first = [&](int components, size_t elements) {
    return firstKey(context, channel.sampler, channel.samplerField, components, elements);
  };
  if (channel.path == "translation")
    pose.translation = first(3, 1);
  else if (channel.path == "rotation")
    pose.rotation = first(4, 1);
  else if (channel.path == "scale")
    pose.scale = first(3, 1);
  else if (channel.path == "weights") {
    const size_t count = morphTargets(context, context.source.json["nodes"][channel.node]);
    if (count > 0) pose.weights = first(1, count);
  } else {
    context.warn(channel.targetField + ".path is " + shown(channel.path) + ", which is left out");
  }
}

/// Of the animation that plays, else the first. The file has one at least.
size_t chosenAnimation(const GltfContext& context) {
  const std::optional<std::string>& wanted = context.source.options.animation;
  if (!wanted) return 0;
  const json& all = context.source.list("animations");
  std::vector<std::string> names;
  for (size_t i = 0; i < all.size(); ++i) {
    names.push_back(text(all[i], "name", ""));
    if (names.back() == *wanted) return i;
  }
  const auto index = base::readWhole(*wanted, 0, std::numeric_limits<uint32_t>::max());
  if (index && *index < all.size()) return size_t(*index);
  context.fail("animations", (index ? "there is no number " + *wanted
                                    : unknownName("animation", *wanted, names)) +
                                 " (--motion), the file holds " + std::to_string(all.size()));
}

AnimationChannel channelOf(const GltfContext& context, const json& animation,
                           const std::string& field, const json& channel,
                           const std::string& channelField, const json& target) {
  const std::string targetField = channelField + ".target";
  AnimationChannel out{
      .node = checkedIndex(context.source, target["node"], targetField + ".node", "nodes"),
      .path = text(target, "path", ""),
      .sampler = {}};
  const json& samplers = array(context, animation, field, "samplers");
  const json& number = memberOf(context, channel, channelField, "sampler");
  if (!number.is_number_unsigned() || number.get<size_t>() >= samplers.size())
    context.fail(channelField + ".sampler", "is " + shown(number) + ", but there are " +
                                                std::to_string(samplers.size()) + " samplers");
  out.sampler = samplers[number.get<size_t>()];
  out.samplerField = fieldAt(field + ".samplers", number.get<size_t>());
  out.targetField = targetField;
  if (!out.sampler.is_object())
    context.fail(out.samplerField, "is " + shown(out.sampler) + ", expected an object");
  return out;
}

}  // namespace

const json& memberOf(const GltfContext& context, const json& object, const std::string& field,
                     const char* key) {
  if (!object.is_object()) context.fail(field, "is " + shown(object) + ", expected an object");
  const auto found = object.find(key);
  if (found == object.end()) context.fail(field + "." + key, "is missing");
  return *found;
}

std::vector<AnimationChannel> animationChannels(const GltfContext& context) {
  const auto animations = context.source.json.find("animations");
  const bool none =
      animations == context.source.json.end() || !animations->is_array() || animations->empty();
  if (none && context.source.options.animation)
    context.fail("animations", "are missing, but one is to play (--motion)");
  if (none) return {};
  const size_t chosen = chosenAnimation(context);
  const json& animation = (*animations)[chosen];
  const std::string field = fieldAt("animations", chosen);
  const json& channels = array(context, animation, field, "channels");
  std::vector<AnimationChannel> out;
  for (size_t i = 0; i < channels.size(); ++i) {
    const std::string channelField = fieldAt(field + ".channels", i);
    const json& target = memberOf(context, channels[i], channelField, "target");
    if (!target.is_object())
      context.fail(channelField + ".target", "is " + shown(target) + ", expected an object");
    // Extensions animate other things.
    if (target.contains("node"))
      out.push_back(channelOf(context, animation, field, channels[i], channelField, target));
  }
  return out;
}

void readPoses(GltfContext& context) {
  const std::vector<AnimationChannel> channels = animationChannels(context);
  const auto animations = context.source.json.find("animations");
  if (animations == context.source.json.end() || !animations->is_array() || animations->empty())
    return;
  const size_t chosen = chosenAnimation(context);
  const std::string name = text((*animations)[chosen], "name", "");
  const std::string called =
      fieldAt("animations", chosen) + (name.empty() ? "" : " '" + name + "'");
  const std::optional<std::string>& plays = context.source.options.animation;
  context.warn((animations->size() > 1
                    ? "the file holds " + std::to_string(animations->size()) + " animations; "
                    : std::string()) +
               called + (plays ? " plays, from t = 0 to its last key" : " is shown at t = 0"));
  for (const AnimationChannel& channel : channels) readFirstKey(context, channel);
}

}  // namespace sb

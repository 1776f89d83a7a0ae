// An animation that plays: keys of its channels, sampled evenly from t = 0 to its last key into the
// steps of the scene's path. Nodes move, with all that hangs on them; meshes keep the shape that
// they have at t = 0.
#include <algorithm>
#include <cmath>

#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/nodes/animation.h"
#include "suites/scenes/gltf/nodes/roots.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

using nlohmann::json;

enum class Between : uint8_t { Step, Linear, Spline };

struct Channel {
  size_t node = 0;
  std::vector<double> NodePose::*part = nullptr;
  Between between = Between::Linear;
  std::vector<float> times;   ///< seconds, rising
  std::vector<float> values;  ///< of splines: incoming tangent, value, outgoing tangent of each key
  size_t components = 3;
  bool turns() const { return part == &NodePose::rotation; }
  double at(size_t key, size_t third, size_t c) const {
    const size_t element = between == Between::Spline ? 3 * key + third : key;
    return double(values[element * components + c]);
  }
  double value(size_t key, size_t c) const { return at(key, 1, c); }
};

std::vector<float> readTimes(GltfContext& context, const std::string& field,
                             const json& sampler) {
  const int input = int(checkedIndex(context.source, memberOf(context, sampler, field, "input"),
                                     field + ".input", "accessors"));
  const std::string at = field + ".input";
  if (const int found = componentCount(context, at, input); found != 1)
    context.fail(at, "has " + std::to_string(found) + " components, expected 1");
  context.source.take(at, context.model.accessors[size_t(input)].count, 2 * sizeof(float));
  std::vector<float> times = readFloats(context, at, input, 1);
  if (times.empty()) context.fail(at, "has no elements, expected one at least");
  for (size_t i = 0; i < times.size(); ++i)
    if (i > 0 ? !(times[i] > times[i - 1]) : !(times[i] >= 0))
      context.fail(at, "element " + std::to_string(i) + " is " + shown(times[i]) + ", expected " +
                           (i > 0 ? "more than the " + shown(times[i - 1]) + " before it"
                                  : std::string("no less than 0")));
  return times;
}

Between interpolationOf(const GltfContext& context, const std::string& field, const json& sampler) {
  const auto found = sampler.find("interpolation");
  if (found == sampler.end() || *found == "LINEAR") return Between::Linear;
  if (*found == "STEP") return Between::Step;
  if (*found == "CUBICSPLINE") return Between::Spline;
  context.fail(field + ".interpolation",
               "is " + shown(*found) + ", expected LINEAR, STEP or CUBICSPLINE");
}

Channel readChannel(GltfContext& context, const AnimationChannel& from) {
  Channel channel{.node = from.node, .times = {}, .values = {}};
  if (from.path == "translation")
    channel.part = &NodePose::translation;
  else if (from.path == "rotation")
    channel.part = &NodePose::rotation, channel.components = 4;
  else if (from.path == "scale")
    channel.part = &NodePose::scale;
  else
    context.fail(from.targetField + ".path",
                 "is " + shown(from.path) + ", expected translation, rotation, scale or weights");
  const std::string& field = from.samplerField;
  channel.times = readTimes(context, field, from.sampler);
  channel.between = interpolationOf(context, field, from.sampler);
  const std::string at = field + ".output";
  const int output = int(checkedIndex(
      context.source, memberOf(context, from.sampler, field, "output"), at, "accessors"));
  if (const int found = componentCount(context, at, output); found != int(channel.components))
    context.fail(at, "has " + std::to_string(found) + " components, expected " +
                         std::to_string(channel.components));
  const size_t expected = channel.times.size() * (channel.between == Between::Spline ? 3 : 1);
  if (const size_t found = context.model.accessors[size_t(output)].count; found != expected)
    context.fail(at, "has " + std::to_string(found) + " elements, expected " +
                         std::to_string(expected) + " for " + std::to_string(channel.times.size()) +
                         " keys");
  context.source.take(at, expected, 2 * channel.components * sizeof(float));
  channel.values = readFloats(context, at, output, int(channel.components));
  return channel;
}

/// Between two keys, `s` of the way from `a` on.
std::vector<double> mixed(const Channel& channel, size_t a, double s) {
  const size_t b = a + 1;
  std::vector<double> out(channel.components);
  double wa = 1 - s, wb = s;
  if (channel.turns() && channel.between == Between::Linear) {
    // Spherically, the shorter way round.
    double dot = 0;
    for (size_t c = 0; c < 4; ++c) dot += channel.value(a, c) * channel.value(b, c);
    const double angle = std::acos(std::min(std::abs(dot), 1.0));
    if (const double sine = std::sin(angle); sine > 1e-6) {
      wa = std::sin((1 - s) * angle) / sine;
      wb = std::sin(s * angle) / sine;
    }
    if (dot < 0) wb = -wb;
  }
  const double span = double(channel.times[b]) - double(channel.times[a]);
  for (size_t c = 0; c < channel.components; ++c) {
    const double va = channel.value(a, c), vb = channel.value(b, c);
    if (channel.between == Between::Spline) {
      const double out0 = span * channel.at(a, 2, c), in1 = span * channel.at(b, 0, c);
      const double s2 = s * s, s3 = s2 * s;
      out[c] = (2 * s3 - 3 * s2 + 1) * va + (s3 - 2 * s2 + s) * out0 + (3 * s2 - 2 * s3) * vb +
               (s3 - s2) * in1;
    } else {
      out[c] = wa * va + wb * vb;
    }
  }
  return out;
}

std::vector<double> valueAt(const Channel& channel, double time) {
  const auto after = std::ranges::upper_bound(channel.times, time);
  const size_t next = size_t(after - channel.times.begin()), key = next > 0 ? next - 1 : 0;
  if (next == 0 || next == channel.times.size() || channel.between == Between::Step) {
    std::vector<double> value;
    for (size_t c = 0; c < channel.components; ++c) value.push_back(channel.value(key, c));
    return value;
  }
  const double from = channel.times[key], to = channel.times[next];
  return mixed(channel, key, (time - from) / (to - from));
}

/// Places of nodes, step by step.
using Ways = std::map<size_t, std::vector<glm::dmat4>>;

/// Those of nodes that something hangs on and that move.
Ways waysOfNodes(GltfContext& context, const std::vector<Channel>& channels) {
  Ways ways;
  for (const auto& [node, place] : context.followers.instances)
    if (node != kNoNode) ways[node];
  for (const auto* nodes : {&context.followers.lights, &context.followers.cameras})
    for (const size_t node : *nodes) ways[node];
  double length = 0;
  for (const Channel& channel : channels) length = std::max(length, double(channel.times.back()));
  const uint32_t steps = context.source.options.steps;
  context.source.take("animations", (ways.size() + context.followers.instances.size()) * steps,
                      2 * sizeof(glm::dmat4));
  for (uint32_t k = 0; k < steps; ++k) {
    const double time = length * (double(k) / double(steps - 1));
    for (const Channel& channel : channels)
      context.poses[int(channel.node)].*channel.part = valueAt(channel, time);
    NodeTree tree(context);
    for (auto& [node, way] : ways) way.push_back(tree.toWorld(node));
  }
  std::erase_if(ways, [](const auto& way) {
    return std::ranges::count(way.second, way.second.front()) == std::ssize(way.second);
  });
  return ways;
}

void moveInstances(GltfContext& context, const Ways& ways) {
  for (uint32_t i = 0; i < context.followers.instances.size(); ++i) {
    const auto& [node, place] = context.followers.instances[i];
    const auto found = ways.find(node);
    if (found == ways.end()) continue;
    std::vector<glm::dmat4> way;
    for (const glm::dmat4& toWorld : found->second) {
      const glm::dmat4& at = way.emplace_back(toWorld * place);
      checkReach(context, fieldAt("nodes", node),
                 context.scene.meshes[context.scene.instances[i].mesh], at);
      if (glm::determinant(glm::dmat3(at)) * glm::determinant(glm::dmat3(way.front())) < 0)
        context.warn(fieldAt("nodes", node) +
                     " is mirrored by the animation; its triangles face as at t = 0");
    }
    moveInstance(context.scene, i, way);
  }
}

/// Lights and cameras once more, at each place of their node: `add` appends one to a list of the
/// scene that it is given, or leaves it out.
template <class Thing, class Add>
std::vector<std::vector<Thing>> addedAlong(GltfContext& context, const Ways& ways,
                                           const std::vector<size_t>& nodes,
                                           std::vector<Thing> Scene::*list, const Add& add) {
  std::vector<std::vector<Thing>> all(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    const auto found = ways.find(nodes[i]);
    if (found == ways.end()) continue;
    const std::string field = fieldAt("nodes", nodes[i]);
    for (const glm::dmat4& toWorld : found->second) {
      Scene scene;
      GltfContext here{.source = context.source, .model = context.model, .scene = scene};
      add(here, field, context.model.nodes[nodes[i]], toWorld);
      if ((scene.*list).empty())
        context.fail(field,
                     "gets scale 0 from the animation: its light or camera has no direction");
      all[i].push_back((scene.*list).front());
    }
  }
  return all;
}

void moveLights(GltfContext& context, const Ways& ways) {
  const auto add = [](GltfContext& here, const std::string& field, const tinygltf::Node& node,
                      const glm::dmat4& toWorld) {
    addLight(here, field, node.extensions.at("KHR_lights_punctual"), toWorld);
  };
  const auto all = addedAlong(context, ways, context.followers.lights, &Scene::lights, add);
  for (uint32_t l = 0; l < all.size(); ++l) {
    std::vector<LightPose> way;
    for (const Light& light : all[l])
      way.push_back({light.position, light.direction, light.halfAxes});
    if (!way.empty()) moveLight(context.scene, l, way);
  }
}

void moveCameras(GltfContext& context, const Ways& ways) {
  const auto add = [](GltfContext& here, const std::string& field, const tinygltf::Node& node,
                      const glm::dmat4& toWorld) { addCamera(here, field, node.camera, toWorld); };
  const auto all = addedAlong(context, ways, context.followers.cameras, &Scene::cameras, add);
  std::vector<Camera>& cameras = context.scene.cameras;
  for (size_t c = 0; c < all.size(); ++c) {
    std::vector<glm::dmat4> way;
    for (const Camera& camera : all[c]) way.push_back(camera.toWorld);
    if (way.empty()) continue;
    std::swap(cameras.front(), cameras[c]);
    moveCamera(context.scene, way);
    std::swap(cameras.front(), cameras[c]);
  }
}

}  // namespace

void playAnimation(GltfContext& context) {
  if (!context.source.options.animation) return;
  std::vector<Channel> channels;
  for (const AnimationChannel& channel : animationChannels(context)) {
    if (channel.path == "weights")
      context.warn("morph targets keep the shape that they have at t = 0");
    else
      channels.push_back(readChannel(context, channel));
  }
  const Ways ways = waysOfNodes(context, channels);
  moveInstances(context, ways);
  moveLights(context, ways);
  moveCameras(context, ways);
  if (context.scene.path.empty()) context.fail("animations", "move nothing that is shown");
}

}  // namespace sb

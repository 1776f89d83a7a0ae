// Morph targets and skins at t = 0, in double: positions, normals, tangents.
#include <cmath>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/surfaces/deform.h"

namespace sb {
namespace {

using nlohmann::json;

std::vector<double> trimmed(std::vector<double> weights) {
  while (!weights.empty() && weights.back() == 0) weights.pop_back();
  return weights;
}

std::vector<double> weightsAt(const GltfContext& context, const json& owner,
                              const std::string& field) {
  const auto found = owner.find("weights");
  if (found == owner.end()) return {};
  if (!found->is_array()) context.fail(field, "is " + shown(*found) + ", expected an array");
  std::vector<double> weights;
  for (size_t i = 0; i < found->size(); ++i) {
    const json& value = (*found)[i];
    if (!value.is_number() || !(std::abs(value.get<double>()) < 1e18))
      context.fail(fieldAt(field, i), "is " + shown(value) + ", expected a number below 1e18");
    weights.push_back(value.get<double>());
  }
  return trimmed(std::move(weights));
}

const json& primitiveOf(const GltfContext& context, size_t mesh, size_t primitive) {
  return context.source.json["meshes"][mesh]["primitives"][primitive];
}

glm::dvec3 vectorAt(const std::vector<float>& values, size_t i) {
  return {double(values[3 * i]), double(values[3 * i + 1]), double(values[3 * i + 2])};
}

// So many floats of each of `count` vertices, from the accessor that `index` names.
std::vector<float> vertexFloats(const GltfContext& context, const json& index,
                                const std::string& at, int components, size_t count) {
  const int accessor = int(checkedIndex(context.source, index, at, "accessors"));
  if (const int c = componentCount(context, at, accessor); c != components)
    context.fail(
        at, "has " + std::to_string(c) + " components, expected " + std::to_string(components));
  if (const size_t n = context.model.accessors[size_t(accessor)].count; n != count)
    context.fail(at,
                 "has " + std::to_string(n) + " elements, POSITION has " + std::to_string(count));
  return readFloats(context, at, accessor, components);
}

// A target's deltas of one attribute; empty if it has none.
std::vector<float> deltas(const GltfContext& context, const json& target, const std::string& field,
                          const char* name, size_t count) {
  const auto found = target.find(name);
  if (found == target.end()) return {};
  const std::string at = field + "." + name;
  return vertexFloats(context, *found, at, 3, count);
}

// Four floats a vertex of one set of joints or weights.
std::vector<float> influences(const GltfContext& context, const json& attributes,
                              const std::string& field, const std::string& name, size_t count) {
  const std::string at = field + ".attributes." + name;
  if (!attributes.contains(name)) context.fail(at, "is missing beside its joints or weights");
  return vertexFloats(context, attributes[name], at, 4, count);
}

// Blended joint matrix of every vertex.
std::vector<glm::dmat4> blend(const GltfContext& context, const json& attributes,
                              const std::string& field, const Deform& deform, size_t count) {
  std::vector<glm::dmat4> matrices(count, glm::dmat4(0));
  std::vector<double> sums(count);
  for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
    const std::string number = std::to_string(set);
    const auto joints = influences(context, attributes, field, "JOINTS_" + number, count);
    const auto weights = influences(context, attributes, field, "WEIGHTS_" + number, count);
    for (size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] == 0) continue;
      if (!(joints[i] >= 0 && joints[i] < float(deform.palette.size())))
        context.fail(field + ".attributes.JOINTS_" + number,
                     "element " + std::to_string(i / 4) + " names joint " +
                         std::to_string(int64_t(joints[i])) + ", but the skin has " +
                         std::to_string(deform.palette.size()));
      matrices[i / 4] += double(weights[i]) * deform.palette[size_t(joints[i])];
      sums[i / 4] += double(weights[i]);
    }
  }
  // Weights sum to 1 but for rounding; a vertex that nothing holds follows the first joint.
  for (size_t i = 0; i < count; ++i)
    matrices[i] = sums[i] > 0 ? matrices[i] / sums[i] : deform.palette.front();
  return matrices;
}

glm::dmat4 matrixAt(const std::vector<float>& values, size_t i) {
  glm::dmat4 m;
  for (int k = 0; k < 16; ++k) m[k / 4][k % 4] = double(values[16 * i + size_t(k)]);
  return m;
}

std::vector<glm::dmat4> inverseBinds(const GltfContext& context, const json& skin,
                                     const std::string& field, size_t joints) {
  std::vector<glm::dmat4> matrices(joints, glm::dmat4(1));
  const auto found = skin.find("inverseBindMatrices");
  if (found == skin.end()) return matrices;
  const std::string at = field + ".inverseBindMatrices";
  const int accessor = int(checkedIndex(context.source, *found, at, "accessors"));
  const tinygltf::Accessor& a = context.model.accessors[size_t(accessor)];
  if (a.type != TINYGLTF_TYPE_MAT4 || a.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
    context.fail(at, fieldAt("is accessors", size_t(accessor)) + ", expected MAT4 of 5126 (float)");
  if (a.count < joints)
    context.fail(at, "has " + std::to_string(a.count) + " elements, but the skin has " +
                         std::to_string(joints) + " joints");
  const auto floats = readFloats(context, at, accessor, 16, 0, joints);
  for (size_t j = 0; j < joints; ++j) matrices[j] = matrixAt(floats, j);
  return matrices;
}

bool hasJoints(const GltfContext& context, size_t mesh) {
  const json& primitives = context.source.json["meshes"][mesh]["primitives"];
  return std::ranges::all_of(primitives,
                             [](const json& p) { return p["attributes"].contains("JOINTS_0"); });
}

}  // namespace

std::vector<double> meshWeights(const GltfContext& context, size_t mesh) {
  return weightsAt(context, context.source.json["meshes"][mesh],
                   fieldAt("meshes", mesh) + ".weights");
}

Deform nodeDeform(GltfContext& context, NodeTree& tree, size_t index) {
  const json& node = context.source.json["nodes"][index];
  const std::string field = fieldAt("nodes", index);
  const size_t mesh = node["mesh"].get<size_t>();
  Deform deform;
  const auto pose = context.poses.find(int(index));
  if (pose != context.poses.end() && pose->second.weights)
    deform.weights = trimmed(*pose->second.weights);
  else if (node.contains("weights"))
    deform.weights = weightsAt(context, node, field + ".weights");
  else
    deform.weights = meshWeights(context, mesh);
  if (!node.contains("skin")) return deform;

  const auto skins = context.source.json.find("skins");
  if (skins == context.source.json.end() || !skins->is_array() ||
      !node["skin"].is_number_unsigned() || node["skin"].get<size_t>() >= skins->size()) {
    context.warn(field + ".skin is " + shown(node["skin"]) +
                 ", which is not there: " + "its mesh is shown without it");
    return deform;
  }
  if (!hasJoints(context, mesh)) {
    context.warn(field + " has a skin, but its mesh no joints: it is shown without the skin");
    return deform;
  }
  const size_t number = node["skin"].get<size_t>();
  deform.skin = int(number);
  const std::string skinField = fieldAt("skins", number);
  const json& skin = (*skins)[number];
  if (!skin.contains("joints") || !skin["joints"].is_array() || skin["joints"].empty())
    context.fail(skinField + ".joints", "is missing or empty, expected indices of nodes");
  const json& joints = skin["joints"];
  context.source.take(skinField, joints.size(), 2 * sizeof(glm::dmat4));
  const auto binds = inverseBinds(context, skin, skinField, joints.size());
  for (size_t j = 0; j < joints.size(); ++j) {
    const size_t joint =
        checkedIndex(context.source, joints[j], fieldAt(skinField + ".joints", j), "nodes");
    glm::dmat4 toWorld = tree.toWorld(joint);
    if (j == 0) deform.origin = glm::dvec3(toWorld[3]);
    toWorld[3] -= glm::dvec4(deform.origin, 0);
    deform.palette.push_back(toWorld * binds[j]);
  }
  return deform;
}

void applyMorph(GltfContext& context, size_t mesh, size_t primitive,
                const std::vector<double>& weights, Mesh& out) {
  const json& source = primitiveOf(context, mesh, primitive);
  const auto targets = source.find("targets");
  if (targets == source.end()) return;
  const std::string field =
      fieldAt(fieldAt("meshes", mesh) + ".primitives", primitive) + ".targets";
  if (!targets->is_array()) context.fail(field, "is " + shown(*targets) + ", expected an array");
  const size_t count = out.positions.size();
  std::vector<glm::dvec3> positions(out.positions.begin(), out.positions.end());
  std::vector<glm::dvec3> normals(out.normals.begin(), out.normals.end());
  for (size_t t = 0; t < targets->size() && t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    const json& target = (*targets)[t];
    const std::string at = fieldAt(field, t);
    if (!target.is_object()) context.fail(at, "is " + shown(target) + ", expected an object");
    const auto moved = deltas(context, target, at, "POSITION", count);
    for (size_t i = 0; 3 * i < moved.size(); ++i) positions[i] += weights[t] * vectorAt(moved, i);
    if (!normals.empty()) {
      const auto turned = deltas(context, target, at, "NORMAL", count);
      for (size_t i = 0; 3 * i < turned.size(); ++i) normals[i] += weights[t] * vectorAt(turned, i);
    }
    if (!out.tangents.empty()) {
      const auto turned = deltas(context, target, at, "TANGENT", count);
      for (size_t i = 0; 3 * i < turned.size(); ++i)
        out.tangents[i] += glm::vec4(glm::vec3(weights[t] * vectorAt(turned, i)), 0);
    }
    for (const auto& [key, value] : target.items())
      if (key != "POSITION" && key != "NORMAL" && key != "TANGENT")
        context.warn(at + "." + key + " is left out");
  }
  for (size_t i = 0; i < count; ++i) out.positions[i] = glm::vec3(positions[i]);
  for (size_t i = 0; i < normals.size(); ++i)
    if (const double length = glm::length(normals[i]); length > 1e-6)
      out.normals[i] = glm::vec3(normals[i] / length);
  for (glm::vec4& t : out.tangents)
    if (const float length = glm::length(glm::vec3(t)); length > 1e-6f)
      t = glm::vec4(glm::vec3(t) / length, t.w);
}

void applySkin(GltfContext& context, size_t mesh, size_t primitive, const Deform& deform,
               Mesh& out) {
  if (!deform.skinned()) return;
  const json& attributes = primitiveOf(context, mesh, primitive)["attributes"];
  const std::string field = fieldAt(fieldAt("meshes", mesh) + ".primitives", primitive);
  context.source.take(field, out.positions.size(), sizeof(glm::dmat4));
  const std::vector<glm::dmat4> matrices =
      blend(context, attributes, field, deform, out.positions.size());
  size_t mirrored = 0;
  for (size_t i = 0; i < out.positions.size(); ++i) {
    const glm::dmat4& m = matrices[i];
    const glm::dmat3 linear(m);
    out.positions[i] = glm::vec3(glm::dvec3(m * glm::dvec4(glm::dvec3(out.positions[i]), 1)));
    const double side = glm::determinant(linear) < 0 ? -1 : 1;
    mirrored += side < 0;
    // Cofactors take normals along, whatever the scale.
    const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                              glm::cross(linear[0], linear[1]));
    if (!out.normals.empty()) {
      const glm::dvec3 n = side * (cofactor * glm::dvec3(out.normals[i]));
      if (const double length = glm::length(n); length > 0) out.normals[i] = glm::vec3(n / length);
    }
    if (!out.tangents.empty()) {
      const glm::dvec3 t = linear * glm::dvec3(glm::vec3(out.tangents[i]));
      if (const double length = glm::length(t); length > 0)
        out.tangents[i] = glm::vec4(glm::vec3(t / length), out.tangents[i].w);
    }
  }
  if (2 * mirrored > out.positions.size()) out = mirroredMesh(out);
}

}  // namespace sb

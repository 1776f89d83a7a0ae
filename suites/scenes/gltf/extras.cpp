// The keys of ours that a glTF file may carry under `extras.shadowbench`, where other viewers leave
// them alone (described for users in EXTRAS.md):
//   material  {"alpha": 0..1, "t": [r,g,b] 0..1}   opacity and transmission colour stated outright
//   light     {"radius": r >= 0}                   world units (point, spot) or radians
//   (directional)
//             {"shape": "sphere"|"ellipsoid"|"rectangle"|"disc", "half_axes": [..] > 0}
//   node      {"medium": {"kind": "homogeneous"|"smoke"|"grid",
//              "extinction": [r,g,b] >= 0, "albedo": [r,g,b] 0..1, "anisotropy": -1..1,
//              "seed": 0.., "time": 0.., "size": [x,y,z], "density": accessor}}
//                                                  fills the node's unit cube [0,1]^3
//   scene     {"ambient": [r,g,b] >= 0, "sky": [r,g,b] >= 0, "background": [r,g,b] >= 0}
#include <array>
#include <cfloat>
#include <cmath>

#include "suites/scenes/gltf/nodes/roots.h"
#include "techniques/plan/error.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/medium_data.h"

namespace sb {
namespace {

using tinygltf::Value;

// The object `extras.shadowbench`, or null. Unknown keys in it are errors: they are meant for us.
const Value* shadowbench(const GltfContext& context, const std::string& field, const Value& extras,
                         const std::vector<std::string>& known) {
  if (!extras.IsObject() || !extras.Has("shadowbench")) return nullptr;
  const Value& ours = extras.Get("shadowbench");
  const std::string path = field + ".extras.shadowbench";
  if (!ours.IsObject()) context.fail(path, "expected an object");
  for (const std::string& key : ours.Keys())
    if (std::ranges::find(known, key) == known.end())
      context.fail(path, unknownName("key", key, known));
  return &ours;
}

double number(const GltfContext& context, const std::string& field, const Value& value, double low,
              double high) {
  const double d = value.IsNumber() ? value.GetNumberAsDouble() : NAN;
  if (!(d >= low && d <= high)) {
    if (d > FLT_MAX)
      context.fail(field, "is " + shown(d) + ", expected a number that a 32-bit float can hold");
    const std::string range =
        high < FLT_MAX ? "from " + shown(low) + " to " + shown(high) : "of at least " + shown(low);
    context.fail(field, (value.IsNumber() ? "is " + shown(d) : "is no number") +
                            ", expected a number " + range);
  }
  return d;
}

uint32_t whole(const GltfContext& context, const std::string& field, const Value& value, double low,
               double high) {
  const double d = number(context, field, value, low, high);
  if (d != std::floor(d)) context.fail(field, "is " + shown(d) + ", expected a whole number");
  return uint32_t(d);
}

glm::vec3 triple(const GltfContext& context, const std::string& field, const Value& value,
                 double high) {
  if (!value.IsArray() || value.ArrayLen() != 3)
    context.fail(field, "expected an array of 3 numbers");
  glm::vec3 v;
  for (int i = 0; i < 3; ++i)
    v[i] = float(number(context, fieldAt(field, size_t(i)), value.Get(size_t(i)), 0, high));
  return v;
}

constexpr double kMostCells = 512;    ///< of a grid, along an axis
constexpr double kLongestTime = 1e6;  ///< seconds

void readGrid(const GltfContext& context, const std::string& path, const Value& value,
              Medium& medium) {
  for (const char* key : {"size", "density"})
    if (!value.Has(key)) context.fail(path + "." + key, "is missing");
  const Value& size = value.Get("size");
  if (!size.IsArray() || size.ArrayLen() != 3)
    context.fail(path + ".size", "expected an array of 3 whole numbers");
  for (int i = 0; i < 3; ++i)
    medium.size[i] =
        whole(context, fieldAt(path + ".size", size_t(i)), size.Get(size_t(i)), 1, kMostCells);
  const std::string field = path + ".density";
  const size_t accessors = context.model.accessors.size();
  if (accessors == 0) context.fail(field, "names an accessor, but the file has none");
  const int index = int(whole(context, field, value.Get("density"), 0, double(accessors - 1)));
  const size_t cells = size_t(medium.size.x) * medium.size.y * medium.size.z;
  if (componentCount(context, field, index) != 1 ||
      context.model.accessors[size_t(index)].count != cells)
    context.fail(field, "is " + fieldAt("accessors", size_t(index)) + " of " +
                            std::to_string(context.model.accessors[size_t(index)].count) +
                            " elements of " +
                            std::to_string(componentCount(context, field, index)) + ", expected " +
                            std::to_string(cells) + " of 1, as the size says");
  context.source.take(field, cells, sizeof(float));
  medium.density = readFloats(context, field, index, 1);
  for (size_t i = 0; i < cells; ++i)
    if (!(medium.density[i] >= 0))
      context.fail(field, "element " + std::to_string(i) + " is " + shown(medium.density[i]) +
                              ", expected a number of at least 0");
}

std::string word(const GltfContext& context, const std::string& field, const std::string& what,
                 const Value& value, const std::vector<std::string>& known) {
  const std::string name = value.IsString() ? value.Get<std::string>() : "";
  if (std::ranges::find(known, name) == known.end())
    context.fail(field, unknownName(what, name, known));
  return name;
}

/// Directional lights fill less than the half of the sky before a receiver.
constexpr double kHalfTurn = 1.5;
/// World units: of what has a place in the world (EXTRAS.md), and what doubles can divide by.
constexpr double kLongest = 1e18, kShortest = 1e-18;

}  // namespace

void readMaterialExtras(const GltfContext& context, const std::string& field, const Value& extras,
                        Material& material) {
  const Value* ours = shadowbench(context, field, extras, {"alpha", "t"});
  if (!ours) return;
  const std::string path = field + ".extras.shadowbench";
  material.opticsOverride = true;
  if (ours->Has("alpha"))
    material.overrideAlpha = float(number(context, path + ".alpha", ours->Get("alpha"), 0, 1));
  if (ours->Has("t"))
    material.overrideTransmission = triple(context, path + ".t", ours->Get("t"), 1);
}

void readLightExtras(const GltfContext& context, const std::string& field, const Value& extras,
                     const glm::dmat3& frame, Light& light) {
  const bool local = light.type != LightType::Directional;
  const Value* ours = shadowbench(context, field, extras,
                                  local ? std::vector<std::string>{"radius", "shape", "half_axes"}
                                        : std::vector<std::string>{"radius"});
  if (!ours) return;
  const std::string path = field + ".extras.shadowbench";
  const std::vector<std::string> shapes = {"sphere", "ellipsoid", "rectangle", "disc"};
  std::string shape = "sphere";
  if (ours->Has("shape"))
    shape = word(context, path + ".shape", "shape", ours->Get("shape"), shapes);
  const char* extent = shape == "sphere" ? "radius" : "half_axes";
  for (const char* key : {"radius", "half_axes"})
    if (ours->Has(key) != (key == std::string(extent)) && (ours->Has(key) || ours->Has("shape")))
      context.fail(path + "." + key,
                   ours->Has(key) ? "is no property of a " + shape : "is missing of a " + shape);
  if (shape == "sphere") {
    if (!ours->Has("radius")) return;
    const double most = local ? kLongest : kHalfTurn;
    const double radius = number(context, path + ".radius", ours->Get("radius"), 0, most);
    if (local)
      makeSphere(light, radius);
    else
      light.angularRadius = radius;
    return;
  }
  const int axes = shape == "ellipsoid" ? 3 : 2;
  const Value& lengths = ours->Get("half_axes");
  if (!lengths.IsArray() || lengths.ArrayLen() != size_t(axes))
    context.fail(path + ".half_axes", "expected an array of " + std::to_string(axes) + " numbers");
  light.shape = shape == "ellipsoid"   ? LightShape::Ellipsoid
                : shape == "rectangle" ? LightShape::Rectangle
                                       : LightShape::Disc;
  for (int i = 0; i < axes; ++i)
    light.halfAxes[i] = frame[i] * number(context, fieldAt(path + ".half_axes", size_t(i)),
                                          lengths.Get(size_t(i)), kShortest, kLongest);
}

void readMediumExtras(GltfContext& context, const std::string& field, const Value& extras,
                      const glm::dmat4& toWorld) {
  const Value* ours = shadowbench(context, field, extras, {"medium"});
  if (!ours || !ours->Has("medium")) return;
  const Value& value = ours->Get("medium");
  const std::string path = field + ".extras.shadowbench.medium";
  if (!value.IsObject()) context.fail(path, "expected an object");
  Medium medium;
  medium.boxToWorld = toWorld;
  if (value.Has("kind")) {
    const std::vector<std::string> kinds = {"homogeneous", "smoke", "grid"};
    const std::string name =
        word(context, path + ".kind", "kind of medium", value.Get("kind"), kinds);
    medium.kind = MediumKind(std::ranges::find(kinds, name) - kinds.begin());
  }
  std::vector<std::string> known = {"kind", "extinction", "albedo", "anisotropy", "seed", "time"};
  if (medium.kind == MediumKind::Grid) known.insert(known.end(), {"size", "density"});
  for (const std::string& key : value.Keys())
    if (std::ranges::find(known, key) == known.end())
      context.fail(path, unknownName("key", key, known));
  if (!value.Has("extinction")) context.fail(path + ".extinction", "is missing");
  medium.extinction = triple(context, path + ".extinction", value.Get("extinction"), FLT_MAX);
  if (value.Has("albedo"))
    medium.albedo = triple(context, path + ".albedo", value.Get("albedo"), 1);
  if (value.Has("anisotropy"))
    medium.anisotropy =
        float(number(context, path + ".anisotropy", value.Get("anisotropy"), -1, 1));
  if (value.Has("seed"))
    medium.seed = uint32_t(whole(context, path + ".seed", value.Get("seed"), 0, 4294967295.0));
  if (value.Has("time"))
    medium.time = number(context, path + ".time", value.Get("time"), 0, kLongestTime);
  if (medium.kind == MediumKind::Grid) readGrid(context, path, value, medium);
  if (flattens(toWorld)) {
    context.warn(field + " is flattened by its transform (scale 0): its medium is left out");
    return;
  }
  if (context.scene.media.size() == kMaxMedia)
    context.fail(path,
                 "is one medium more than the " + std::to_string(kMaxMedia) + " that are read");
  context.scene.media.push_back(std::move(medium));
}

void readSceneExtras(GltfContext& context, const std::string& field, const Value& extras) {
  const Value* ours = shadowbench(context, field, extras, {"ambient", "sky", "background"});
  if (!ours) return;
  const std::string path = field + ".extras.shadowbench";
  if (ours->Has("ambient"))
    context.scene.ambient = triple(context, path + ".ambient", ours->Get("ambient"), FLT_MAX);
  if (ours->Has("sky"))
    context.scene.sky = triple(context, path + ".sky", ours->Get("sky"), FLT_MAX);
  if (ours->Has("background"))
    context.scene.background =
        triple(context, path + ".background", ours->Get("background"), FLT_MAX);
}

}  // namespace sb

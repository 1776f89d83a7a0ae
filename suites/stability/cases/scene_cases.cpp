// The generic properties (spec 17, section 1) of a scene that the user names: what its own known
// numbers say in the cases is said by the scene itself here, moved, scaled, permuted, stripped, or
// by the truth.
#include "suites/stability/cases/scene_cases.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "suites/harness/checks/verify.h"
#include "suites/metrics/exposure.h"
#include "suites/scenes/edit/transform.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

/// A power of two near the size of what is in the scene.
double unitOf(const Scene& scene) {
  const double size = 2 * sceneBox(scene).radius();
  return std::isfinite(size) && size > 0 ? std::exp2(std::ceil(std::log2(size))) : 1;
}

const char* const kNoLight = "no light touches what is seen";

template <class Change>
Found changed(const CaseContext& context, const Scene& from, const std::vector<double>& parameters,
              double tolerance, const Change& change) {
  Found found;
  Probe before(context, from, sceneOptions(context));
  for (const double x : parameters) {
    if (context.quick && found.curve.size() == 2) break;
    Scene scene = from;
    change(scene, x);
    Probe after(context, std::move(scene), sceneOptions(context));
    found.curve.push_back({x, pictureDifference(before, after), tolerance});
  }
  return found;
}

Found translated(const CaseContext& context) {
  const double unit = unitOf(*context.scene);
  const auto offset = [&](double times) { return times * unit * glm::dvec3(1, -2, 3); };
  // There and back, once: places become such that every offset can be added to them exactly.
  Scene rounded = *context.scene;
  translateScene(rounded, offset(1e9));
  translateScene(rounded, -offset(1e9));
  std::vector<double> offsets;
  for (const double times : {1e3, 1e5, 1e6, 1e7, 1e9}) offsets.push_back(times * unit);
  return changed(context, rounded, offsets, 0,
                 [&](Scene& scene, double x) { translateScene(scene, offset(x / unit)); });
}

Found scaled(const CaseContext& context) {
  return changed(context, *context.scene, {0x1p-20, 0x1p-10, 0x1p-3, 0x1p3, 0x1p10, 0x1p20}, 0,
                 [](Scene& scene, double x) { scaleScene(scene, x); });
}

/// Largest difference of visibility over lights and layers, in 1/255.
double visibilityDifference(Probe& a, Probe& b) {
  Compared worst;
  for (const uint32_t light : a.renderer().lights())
    for (size_t layer = 0; layer < a.visibility(light).size(); ++layer) {
      const VisibilityImage &p = a.visibility(light)[layer], &q = b.visibility(light)[layer];
      for (size_t i = 0; i < p.size(); ++i)
        if (p[i | 3] != 0 || q[i | 3] != 0)
          worst.worst(255 * std::abs(double(p[i]) - double(q[i])));
    }
  return worst.value();
}

Found permuted(const CaseContext& context) {
  Found found;
  Probe before(context, *context.scene, sceneOptions(context));
  if (before.renderer().lights().empty())
    return {.curve = {}, .expected = "", .leftOut = kNoLight};
  // Products in half floats round in the order of drawing.
  const double tolerance =
      context.info().stochastic || !context.represents(Effect::TranslucentCasters) ? 0 : 1;
  for (const double x : {1.0, 2.0, 3.0}) {
    Scene scene = *context.scene;
    permuteScene(scene, uint64_t(x));
    scene.lights = context.scene->lights;
    Probe after(context, std::move(scene), sceneOptions(context));
    found.curve.push_back({x, visibilityDifference(before, after), tolerance});
    if (context.quick) break;
  }
  return found;
}

Found permutedLights(const CaseContext& context) {
  if (context.scene->lights.size() < 2)
    return {.curve = {}, .expected = "", .leftOut = "the scene has fewer than two lights"};
  return changed(context, *context.scene, {4, 5}, 1, [](Scene& scene, double x) {
    const std::vector<Light> lights = scene.lights;
    for (size_t i = 0; i < lights.size(); ++i)
      scene.lights[i] = x == 4 ? lights[lights.size() - 1 - i] : lights[(i + 1) % lights.size()];
  });
}

Found doubled(const CaseContext& context) {
  return changed(context, *context.scene, {2}, 0,
                 [](Scene& scene, double) { duplicateOpaque(scene); });
}

Found degenerate(const CaseContext& context) {
  return changed(context, *context.scene, {1}, 0,
                 [](Scene& scene, double) { insertDegenerate(scene); });
}

Found perturbed(const CaseContext& context) {
  Found found;
  ProbeOptions options = sceneOptions(context);
  options.knobs = {{"kernel", "1"}, {"compare", "manual"}};
  Probe before(context, *context.scene, options);
  if (before.renderer().lights().empty() || before.scene().instances.empty())
    return {.curve = {}, .expected = "", .leftOut = kNoLight};
  if (std::isnan(changedInside(before, before)))
    return {
        .curve = {}, .expected = "", .leftOut = "no pixel has neighbours of the same visibility"};
  const double size = unitOf(*context.scene);
  for (const double x : {1e-7, 1e-6}) {
    Scene scene = *context.scene;
    scene.instances[scene.instances.size() / 2].toWorld[3].x += x * size;
    Light& light = scene.lights[before.renderer().lights().front()];
    if (light.type == LightType::Directional)
      light.direction = glm::normalize(light.direction + glm::dvec3(x, 0, 0));
    else
      light.position.x += x * size;
    Probe after(context, std::move(scene), options);
    found.curve.push_back({x, changedInside(before, after), 0});
  }
  return found;
}

Found otherApi(const CaseContext& context) {
  ProbeOptions other = sceneOptions(context);
  other.onOther = true;
  Probe a(context, *context.scene, sceneOptions(context)), b(context, *context.scene, other);
  const report::Picture picture = a.picture();
  const auto beyond = pixelsBeyondOneStep(picture, b.picture(), automaticExposure(picture));
  const double pixels = double(context.size.width) * context.size.height;
  return {.curve = {{1, 100 * double(beyond) / pixels, 0.1}}, .expected = ""};
}

Found finite(const CaseContext& context) {
  Probe probe(context, *context.scene, sceneOptions(context));
  return {.curve = {{1, badValues(probe), 0}}, .expected = ""};
}

Found strippedAndOdd(const CaseContext& context) {
  Scene empty = *context.scene, dark = *context.scene, triangle = *context.scene;
  empty.instances.clear();
  dark.lights.clear();
  if (triangle.instances.size() > 1) triangle.instances.resize(1);
  for (const Instance& instance : triangle.instances) {
    Mesh& mesh = triangle.meshes[instance.mesh];
    mesh.indices.resize(std::min<size_t>(mesh.indices.size(), 3));
    mesh.triangleKeys.resize(mesh.indices.size() / 3);
  }
  Found found;
  double x = 0;
  const std::vector<const Scene*> scenes = {&empty, &dark, &triangle, context.scene};
  for (const Scene* scene : scenes)
    for (const rhi::Extent2D size : {rhi::Extent2D{1, 1}, {37, 53}, {1, 4096}}) {
      if (size.height == 4096 && context.quick) continue;
      Probe probe(context, *scene, {.knobs = {}, .size = size});
      found.curve.push_back({++x, badValues(probe), 0});
    }
  return found;
}

}  // namespace

SceneForm sceneForm(const std::string& id) {
  const std::string picture = "the picture stays (largest difference, 1/255)";
  static const std::string kFinite =
      "everything is finite, visibility in [0, 1] (values that are not)";
  const std::map<std::string, SceneForm> forms = {
      {"G1", {translated, picture, "exact: places are rounded so that offsets add exactly"}},
      {"G2", {scaled, picture, "exact: scaling by powers of two is"}},
      {"G3",
       {permuted, "visibility stays (largest difference, 1/255)",
        "exact by persistent keys; products of half floats round as they are ordered"}},
      {"G3 lights", {permutedLights, picture, "a sum of lights rounds as it is ordered"}},
      {"G4", {doubled, picture, "exact: depth keeps the nearest"}},
      {"G5", {degenerate, picture, "exact: they cover nothing"}},
      {"G6",
       {perturbed, "visibility changes at edges alone (pixels elsewhere)",
        "none: a map is constant between its edges"}},
      {"G7",
       {otherApi, "the same picture (pixels off by more than 1/255, %)",
        "rasterisers may round edges apart (spec 17, G7)"}},
      {"G8", {finite, kFinite, "nothing is allowed"}},
      {"G9", {strippedAndOdd, kFinite, "nothing is allowed"}},
      {"G10",
       {sceneCorners,
        "casters that let all light pass take none, those that block all are as opaque ones "
        "(lights "
        "that differ away from edges, light lost)",
        "exact"}},
      {"G11",
       {sceneGrazing, "what the truth shows lit is lit (light lost, beyond 84.3 degrees times N.L)",
        "none to atan(10); beyond, what a clamped bias may lose costs a tenth"}},
  };
  const auto found = forms.find(id);
  return found == forms.end() ? SceneForm{} : found->second;
}

}  // namespace sb

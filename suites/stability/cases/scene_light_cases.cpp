// Generic properties of a user's scene that its light decides: what casters take at the corners of
// alpha and t (G10), what is lost of grazing light (G11).
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/cases/scene_cases.h"
#include "techniques/scene/optics.h"

namespace sb {
namespace {

constexpr double kClamped = 84.28;  // atan(10), as in G11 of the cases
constexpr double kSteps[] = {45, 60, 75, 80, kClamped, 87, 90};

/// Light that surfaces lose which the truth shows in full light, by the angle at which it comes
/// (the upper end of each step); beyond kClamped times N.L.
std::map<double, Compared> lostLight(const CaseContext& context, const Scene& scene) {
  Probe probe(context, scene, sceneOptions(context));
  const auto [width, height] = context.size;
  const Tracer tracer(probe.scene(), width, height);
  const auto truth = tracer.trace({.width = width, .height = height});
  std::map<double, Compared> lost;
  for (const uint32_t light : probe.renderer().lights()) {
    const auto& expected = truth->visibility[light * kTruthLayers];
    const auto& edges = truth->edges[light * kTruthLayers];
    const VisibilityImage& image = probe.visibility(light)[0];
    for (uint32_t p = 0; p < edges.size(); ++p) {
      const float *t = expected.data() + 4 * p, *v = image.data() + 4 * p;
      const bool lit = t[3] != 0 && t[0] == 1 && t[1] == 1 && t[2] == 1;
      if (!lit || v[3] == 0 || edges[p]) continue;
      const auto point = tracer.pointAt(p % width, p / width, 0);
      if (!point) continue;
      const double cos = cosine(probe.scene(), light, *point);
      const double angle = std::acos(std::min(1.0, cos)) * 180 / std::numbers::pi;
      const double step = *std::ranges::lower_bound(kSteps, std::min(angle, 90.0));
      const bool dark = v[0] < 1 || v[1] < 1 || v[2] < 1;
      const bool right =
          dark && explained(tracer, light, *point, probe.renderer().reach(light), v);
      for (int c = 0; c < 3; ++c)
        lost[step].worst(right ? 0 : (1 - double(v[c])) * (step > kClamped ? cos : 1));
    }
  }
  return lost;
}

}  // namespace

/// Translucent casters that let all light pass take none, those that let none pass cast the shadow
/// of opaque ones: away from edges, for frusta are fitted to what casts.
Found sceneCorners(const CaseContext& context) {
  std::vector<uint8_t> pane;
  for (const Material& m : context.scene->materials)
    pane.push_back(materialTraits(*context.scene, m).lightClass == MaterialClass::Translucent);
  const auto isPane = [&](const Instance& i) {
    return pane[context.scene->meshes[i.mesh].material] != 0;
  };
  const auto painted = [&](const Material& material) {
    Scene scene = *context.scene;
    for (size_t i = 0; i < pane.size(); ++i)
      if (pane[i]) scene.materials[i] = material;
    for (Mesh& mesh : scene.meshes)
      if (pane[mesh.material]) mesh.tangents.clear();  // they belong to normal maps
    return scene;
  };
  if (std::ranges::none_of(context.scene->instances, isPane))
    return {.curve = {}, .expected = "", .leftOut = "no caster of the scene is translucent"};
  Scene without = *context.scene;
  std::erase_if(without.instances, isPane);
  Probe clear(context, without, sceneOptions(context));
  Probe blocked(context, painted(matte()), sceneOptions(context));
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentCasters)};
  for (const float alpha : {0.0f, 1.0f})
    for (const float t : {0.0f, 1.0f}) {
      const Scene scene = painted(glass(alpha, glm::vec3(t)));
      const double x = 2 * double(alpha) + double(t);
      Compared wrong;
      if (x == 3) {
        // These are seen, opaque to the eye, and cast nothing: the truth alone tells.
        for (const auto& [step, lost] : lostLight(context, scene))
          if (step <= kClamped) wrong.worst(lost.value());
      } else {
        Probe probe(context, scene, sceneOptions(context));
        Probe& expected = x == 2 ? blocked : clear;
        const std::vector<uint32_t> known = expected.renderer().lights();
        for (const uint32_t light : probe.renderer().lights()) {
          if (std::ranges::find(known, light) == known.end()) continue;
          const double n = changedInside(expected, probe, light);
          if (!std::isnan(n)) wrong.count(n > 0);
        }
      }
      if (!std::isnan(wrong.value())) found.curve.push_back({x, wrong.value(), 0});
    }
  if (found.curve.empty()) found.leftOut = "no opaque surface is seen in light";
  return found;
}

Found sceneGrazing(const CaseContext& context) {
  Found found;
  for (const auto& [step, worst] : lostLight(context, *context.scene))
    found.curve.push_back({step, worst.value(), step > kClamped ? 0.1 : 0.0});
  if (found.curve.empty()) found.leftOut = "no opaque surface is seen in full light";
  return found;
}

}  // namespace sb

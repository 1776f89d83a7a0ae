#include "suites/scenes/analysis/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "suites/scenes/analysis/parts.h"
#include "suites/scenes/analysis/penumbra_bound.h"
#include "techniques/scene/geometry/mesh_shape.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/medium_data.h"

namespace sb {
namespace {

using base::counted;

// Notes one effect after another with its reason.
class Notes {
 public:
  explicit Notes(Effects& effects) : m_effects(effects) {}
  void note(Effect effect, bool present, const std::string& why, const std::string& whyNot) {
    if (present) m_effects.present.add(effect);
    m_effects.reason[effect] = present ? why : whyNot;
  }

 private:
  Effects& m_effects;
};

// Instances that some light lists, each once.
std::vector<uint32_t> castersOf(const Effects& effects, std::vector<uint32_t> LightEffects::*list) {
  std::vector<uint32_t> all;
  for (const LightEffects& light : effects.lights)
    all.insert(all.end(), (light.*list).begin(), (light.*list).end());
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void noteCasters(const Analysis& a, const Effects& effects, Notes& notes) {
  const auto note = [&](Effect effect, std::vector<uint32_t> LightEffects::*list,
                        const std::string& kind) {
    const size_t n = castersOf(effects, list).size();
    notes.note(effect, n > 0, counted(n, kind + " instance") + " may throw shadows into the view",
               "no " + kind + " instance can throw a shadow into the view");
  };
  note(Effect::OpaqueCasters, &LightEffects::opaqueCasters, "opaque");
  note(Effect::PerforatedCasters, &LightEffects::perforatedCasters, "alpha-masked");
  note(Effect::TranslucentCasters, &LightEffects::translucentCasters, "translucent");
  size_t coloured = 0, textured = 0;
  for (const uint32_t i : castersOf(effects, &LightEffects::translucentCasters)) {
    coloured += a.instances[i].traits.coloured;
    textured += a.instances[i].traits.textured;
  }
  notes.note(Effect::ColouredTransmission, coloured > 0,
             counted(coloured, "translucent caster lets", "translucent casters let") +
                 " colours through unequally",
             "no translucent caster has a transmission colour");
  notes.note(Effect::TexturedTransmission, textured > 0,
             counted(textured, "translucent caster varies over its surface",
                     "translucent casters vary over their surface") +
                 " (texture or colours)",
             "no translucent caster varies over its surface");
}

void noteOverlap(const Analysis& a, const Effects& effects, Notes& notes) {
  size_t receivers = 0;
  for (const AnalysedInstance& instance : a.instances)
    receivers +=
        instance.visible && instance.lit && (instance.seeThrough() || instance.passesLight());
  const bool casts = std::ranges::any_of(effects.lights, &LightEffects::casts);
  notes.note(Effect::TranslucentReceivers, receivers > 0 && casts,
             counted(receivers, "visible translucent instance") + " may receive shadows",
             receivers == 0 ? "no lit translucent instance is visible"
                            : "nothing throws a shadow into the view");
  Overlap overlap;
  for (const LightEffects& light : effects.lights)
    if (!overlap.found() && light.touchesView) overlap = findShadowOverlap(a, light);
  const auto name = [&](uint32_t i) { return "'" + a.scene.instances[i].name + "'"; };
  notes.note(Effect::TranslucentOverlap, overlap.found(),
             !overlap.found() ? ""
             : overlap.first == overlap.second
                 ? name(overlap.first) + " is not flat and may shadow itself"
                 : name(overlap.first) + " and " + name(overlap.second) +
                       " may overlap as the light sees them",
             "no visible translucent instance lies in another's shadow");
}

void noteLights(const Analysis& a, const Effects& effects, Notes& notes) {
  size_t touching = 0, local = 0;
  for (const LightEffects& light : effects.lights) {
    if (!light.touchesView) continue;
    ++touching;
    local += a.scene.lights[light.light].type != LightType::Directional;
  }
  notes.note(Effect::MultipleLights, touching > 1,
             counted(touching, "light touches", "lights touch") + " the view",
             touching == 0 ? "no light touches the view" : "one light touches the view");
  notes.note(
      Effect::LocalLights, local > 0,
      counted(local, "point or spot light touches", "point or spot lights touch") + " the view",
      "no point or spot light touches the view");
}

/// Penumbrae that are narrower, in pixels, are none: few samples, one a pixel, would fall into
/// them.
constexpr double kLeastPenumbra = 1.0 / 16;

void noteAreaLights(const Analysis& a, const Effects& effects, Notes& notes) {
  size_t area = 0, soft = 0;
  double widest = 0;
  for (const LightEffects& light : effects.lights) {
    area += light.touchesView && isAreaLight(a.scene.lights[light.light]);
    soft += light.penumbra * a.rows >= kLeastPenumbra;
    widest = std::max(widest, light.penumbra);
  }
  notes.note(Effect::AreaLights, soft > 0,
             counted(soft, "light", "lights") + " with an extent: " + penumbraBoundText(widest),
             area == 0     ? "no light that touches the view has an extent"
             : widest == 0 ? "no light with an extent throws shadows into the view"
                           : "penumbrae are at most " + fmt::format("{:.2g}", widest * a.rows) +
                                 " pixels wide");
}

void noteMedia(const Analysis& a, const Effects& effects, Notes& notes) {
  const size_t seen = effects.visibleMedia.size();
  const bool between =
      std::ranges::any_of(effects.lights, [](const LightEffects& l) { return !l.media.empty(); });
  const bool thin =
      std::ranges::all_of(a.media, [](const AnalysedMedium& m) { return m.box.empty(); });
  notes.note(Effect::ParticipatingMedia, seen > 0 || between,
             seen > 0 ? counted(seen, "medium box", "medium boxes") + " in view"
                      : "a medium lies between a light and the view",
             a.media.empty() ? "the scene has no medium"
             : thin          ? "no medium is dense enough to be seen"
                             : "no medium is in view or between a light and the view");
}

Plane placedPlane(const Plane& plane, const glm::dmat4& toWorld, const glm::dvec3& eye) {
  const glm::dmat3 linear(toWorld);
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const glm::dvec3 normal = glm::normalize(cofactor * plane.normal);
  const glm::dvec3 point = glm::dvec3(toWorld * glm::dvec4(plane.normal * plane.offset, 1)) - eye;
  return {normal, glm::dot(normal, point)};
}

/// The camera's view of media, which its near and far planes do not cut.
Camera uncut(Camera camera, const std::vector<AnalysedMedium>& media) {
  camera.nearPlane = 0;
  for (const AnalysedMedium& medium : media)
    for (int i = 0; i < 8 && !medium.box.empty(); ++i)
      camera.farPlane = std::max(camera.farPlane, glm::length(medium.box.corner(i)));
  return camera;
}

void noteView(const Analysis& a, const Effects& effects, Notes& notes) {
  const size_t through = effects.visibleTranslucent.size();
  notes.note(Effect::CameraTransparency, through > 0,
             "the camera sees through " + counted(through, "instance"),
             "the camera sees through nothing");
  const Overlap overlap = findScreenOverlap(a);
  const auto name = [&](uint32_t i) { return "'" + a.scene.instances[i].name + "'"; };
  notes.note(
      Effect::CameraLayers, overlap.found(),
      !overlap.found() ? ""
      : overlap.first == overlap.second
          ? name(overlap.first) + " is not flat and may cover itself"
          : name(overlap.first) + " and " + name(overlap.second) + " may overlap in the picture",
      through < 2 ? "fewer than two see-through surfaces are visible"
                  : "see-through instances do not overlap in the picture");
  const auto glass = [&](uint32_t i) { return a.instances[i].traits.cameraColoured; };
  const size_t coloured = size_t(std::ranges::count_if(effects.visibleTranslucent, glass));
  notes.note(Effect::ColouredTransparency, coloured > 0,
             "the camera sees through glass in " + counted(coloured, "instance") +
                 ": each channel has a weight of its own",
             "no visible surface transmits what lies behind");
  size_t mapped = 0, emitting = 0;
  for (size_t i = 0; i < a.instances.size(); ++i) {
    if (!a.instances[i].visible) continue;
    const Material& m = a.scene.materials[a.scene.meshes[a.scene.instances[i].mesh].material];
    mapped += m.normalTexture.present();
    emitting += m.unlit || m.emissive != glm::vec3(0);
  }
  notes.note(Effect::NormalMaps, mapped > 0,
             counted(mapped, "visible instance has", "visible instances have") + " a normal map",
             "no visible instance has a normal map");
  notes.note(Effect::Emission, emitting > 0,
             counted(emitting, "visible instance emits light or is unlit",
                     "visible instances emit light or are unlit"),
             "no visible instance emits light or is unlit");
}

}  // namespace

SceneTraits::SceneTraits(const Scene& scene) {
  for (const Material& material : scene.materials)
    materials.push_back(materialTraits(scene, material));
  const bool soft = std::ranges::any_of(scene.lights, isAreaLight);
  for (const Mesh& mesh : scene.meshes) {
    const MaterialTraits& t = materials.at(mesh.material);
    const bool matters = soft || t.cameraTranslucent || t.lightClass == MaterialClass::Translucent;
    planes.push_back(matters ? planeOf(mesh) : std::nullopt);
  }
}

Analysis::Analysis(const PlacedScene& p, const SceneTraits& traits, Shape shape)
    : placed(p),
      scene(p.scene()),
      eye(p.camera().eye()),
      view(shape.anywhere ? ViewVolume::everywhere(shape.aspect)
                          : ViewVolume(p.camera(), shape.aspect)),
      rows(shape.rows) {
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes.at(instance.mesh);
    const glm::dmat4& toWorld = placed.toWorld(i);
    AnalysedInstance& a = instances.emplace_back();
    a.box = transformedBox(meshBox(mesh), toWorld, eye);
    a.traits = traits.materials[mesh.material];
    a.visible = !mesh.indices.empty() && view.mayShow(a.box);
    a.lit = !scene.materials[mesh.material].unlit;
    const std::optional<Plane>& plane = traits.planes[instance.mesh];
    a.flat = plane.has_value();
    if (plane && plane->normal != glm::dvec3(0)) a.plane = placedPlane(*plane, toWorld, eye);
  }
  for (const Medium& medium : scene.media) {
    AnalysedMedium& m = media.emplace_back();
    if (greatestDepth(medium) >= kThinnest)
      m.box = transformedBox(kMediumBox, medium.boxToWorld, eye);
    m.scatters = medium.albedo != glm::vec3(0);
  }
  if (media.empty()) return;
  const ViewVolume before =
      shape.anywhere ? view : ViewVolume(uncut(placed.camera(), media), shape.aspect);
  mediaView = before.bounds();
  for (AnalysedMedium& medium : media) medium.visible = before.mayShow(medium.box);
}

ViewEffects viewEffects(const Analysis& a) {
  ViewEffects effects;
  for (uint32_t i = 0; i < a.instances.size(); ++i)
    if (a.instances[i].visible)
      (a.instances[i].seeThrough() ? effects.visibleTranslucent : effects.visibleOpaque)
          .push_back(i);
  for (uint32_t m = 0; m < a.media.size(); ++m)
    if (a.media[m].visible) effects.visibleMedia.push_back(m);
  for (uint32_t i = 0; i < a.scene.lights.size(); ++i) effects.lights.push_back(analyseLight(a, i));
  return effects;
}

Effects analyseView(const Analysis& a) {
  Effects effects{viewEffects(a), {}, {}, {}, {}};
  Notes notes(effects);
  noteCasters(a, effects, notes);
  noteOverlap(a, effects, notes);
  noteLights(a, effects, notes);
  noteAreaLights(a, effects, notes);
  noteMedia(a, effects, notes);
  noteView(a, effects, notes);
  return effects;
}

Effects analyse(const Scene& scene, double aspect, double rows) {
  const SceneTraits traits(scene);
  const Analysis::Shape shape = {aspect, rows};
  if (scene.path.empty()) return analyseView(Analysis(scene, traits, shape));
  std::vector<Effects> steps;
  for (uint32_t k = 0; k < scene.path.size(); ++k)
    steps.push_back(analyseView(Analysis(PlacedScene(scene, k), traits, shape)));
  return uniteSteps(std::move(steps));
}

}  // namespace sb

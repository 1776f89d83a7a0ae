// Working data of the analysis. Internal to suites/scenes.
#pragma once

#include <optional>
#include <string>

#include "suites/scenes/analysis/light_reach.h"
#include "techniques/plan/effects.h"
#include "techniques/scene/geometry/mesh_shape.h"
#include "techniques/scene/optics.h"
#include "techniques/scene/placed_scene.h"

namespace sb {

/// One instance as the analysis sees it.
struct AnalysedInstance {
  Box box;  ///< relative to the eye
  MaterialTraits traits;
  bool visible = false;        ///< may lie in the view
  bool lit = false;            ///< its material is shaded by lights
  bool flat = false;           ///< its triangles lie in one plane: it cannot shadow or cover itself
  std::optional<Plane> plane;  ///< that plane, relative to the eye, where something asks for it
  bool seeThrough() const { return traits.cameraTranslucent; }
  bool passesLight() const { return traits.lightClass == MaterialClass::Translucent; }
};

/// One medium as the analysis sees it.
struct AnalysedMedium {
  Box box;               ///< relative to the eye; empty if the medium is too thin to be seen
  bool visible = false;  ///< may lie before the camera; near and far plane do not cut media
  bool scatters = false;
};

/// What does not depend on where anything is.
struct SceneTraits {
  explicit SceneTraits(const Scene& scene);
  std::vector<MaterialTraits> materials;
  std::vector<std::optional<Plane>> planes;  ///< by mesh, in its space, where it matters
};

struct Analysis {
  struct Shape {
    double aspect;
    double rows;
    bool anywhere = false;  ///< of any camera: everything is in view, as near as it may be
  };
  Analysis(const PlacedScene& p, const SceneTraits& traits, Shape shape);
  PlacedScene placed;
  const Scene& scene;
  glm::dvec3 eye;
  ViewVolume view;
  double rows;  ///< of the picture
  std::vector<AnalysedInstance> instances;
  std::vector<AnalysedMedium> media;
  Box mediaView;  ///< around what of media is before the camera
};

/// What is shown at one step.
ViewEffects viewEffects(const Analysis& analysis);
/// The same, and what the scene calls for.
Effects analyseView(const Analysis& analysis);
/// What a path calls for, of the analyses of its steps.
Effects uniteSteps(std::vector<Effects> steps);

/// Fills `light`'s part of the effects.
LightEffects analyseLight(const Analysis& analysis, uint32_t light);

/// Two instances' indices; first == second: one instance with itself.
struct Overlap {
  uint32_t first = kNone, second = kNone;
  bool found() const { return first != kNone; }
};
/// A visible translucent surface that another translucent one (or another part of itself) may
/// shadow under `light`. Stops at the first.
Overlap findShadowOverlap(const Analysis& analysis, const LightEffects& light);
/// Two visible see-through surfaces, or parts of one, that may overlap in the picture.
Overlap findScreenOverlap(const Analysis& analysis);

}  // namespace sb

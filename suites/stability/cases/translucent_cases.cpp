// Translucent casters driven to where techniques break (spec 17, rows 02-05): many layers, faint
// and dense ones, coplanar ones, surfaces between layers, orders that do not exist.
#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

/// One texel a comparison, and no two pixels of the same: means of independent draws.
const ProbeOptions kSingle = {.knobs = {{"kernel", "1"}, {"size", "512"}, {"compare", "manual"}},
                              .size = {128, 128}};
constexpr double kDraws = 64 * 64;  // of the middle half

/// The floor under layers of one material that cover it; the camera sees the floor from below them.
Scene under(const std::vector<Material>& layers) {
  Scene scene = floorScene();
  for (size_t i = 0; i < layers.size(); ++i)
    addHorizontal(scene, add(scene, layers[i]), {0, float(layers.size() - i), 0}, 4.5f, 4.5f);
  return scene;
}

/// Stochastic: 4 sigma. Others: what 8 bits or half floats round k factors to.
double tolerance(const CaseContext& context, double q, double layers) {
  if (context.info().stochastic) return fourSigma(q, kDraws * context.seeds) + 1e-9;
  return layers * (context.is("colour", "rgba8") ? 1.0 / 510 : 0x1p-11) + 1e-6;
}

Found manyLayers(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentCasters)};
  for (const int n : {1, 2, 5, 20, 50, 100, 300}) {
    if (context.quick && n != 2 && n != 20) continue;
    // A sheet behind another needs its own depth: 300 sheets at 1 % are the torture scene H4.
    const float alpha = n == 300 ? 0.01f : 0.05f;
    const double q = std::pow(1 - double(alpha), n);
    Probe probe(context, under(std::vector<Material>(size_t(n), glass(alpha, glm::vec3(0)))),
                kSingle);
    found.curve.push_back(
        {double(n), std::abs(probe.meanVisibility(0).x - q), tolerance(context, q, n)});
  }
  return found;
}

Found faint(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentCasters)};
  for (const double alpha : {1e-6, 1e-4, 1.0 / 512, 0.01, 0.1, 0.5, 0.9, 0.99, 0.9999, 0.999999}) {
    if (context.quick && alpha != 0.01 && alpha != 0.99) continue;
    const double q = 1 - alpha;
    Probe probe(context, under({glass(float(alpha), glm::vec3(0))}), kSingle);
    double allowed = tolerance(context, q, 1);
    // Less than 1/512 counts as not there (spec 02, P2).
    if (!context.info().stochastic) allowed += 1.0 / 512;
    found.curve.push_back({alpha, std::abs(probe.meanVisibility(0).x - q), allowed});
  }
  return found;
}

Found coplanar(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentCasters)};
  for (const double p : {0.1, 0.5, 0.7}) {
    if (context.quick && p != 0.5) continue;
    Scene scene = under({glass(float(p), glm::vec3(0))});
    addHorizontal(scene, scene.meshes.back().material, {0, 1, 0}, 4.5f, 4.5f);
    const double q = (1 - p) * (1 - p);
    Probe probe(context, std::move(scene), kSingle);
    found.curve.push_back({p, std::abs(probe.meanVisibility(0).x - q), tolerance(context, q, 2)});
  }
  return found;
}

Found ownSurface(const CaseContext& context) {
  Found found;
  for (const double angle : {0.0, 30.0, 60.0, 80.0}) {
    if (context.quick && angle != 60) continue;
    const double a = angle * 3.14159265358979323846 / 180;
    Scene scene;
    addHorizontal(scene, add(scene, glass(0.5f, {0.5f, 0.5f, 0.5f})), {0, 0, 0}, 4.5f, 4.5f);
    addLight(scene, sun({std::sin(a) * 0.8, -std::cos(a), std::sin(a) * 0.6}));
    scene.cameras.push_back(downCamera({0, 2, 0}, 4, 8));
    Probe probe(context, std::move(scene), kSingle);
    found.curve.push_back({angle, 1 - probe.meanVisibility(1).x, 1.0 / 255});
  }
  return found;
}

Found betweenLayers(const CaseContext& context) {
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(0.8f, {0.9f, 0.3f, 0.3f})), {0, 2, 0}, 4.5f, 4.5f);
  addHorizontal(scene, add(scene, glass(0.5f, {0.2f, 0.8f, 0.2f})), {0, 1, 0}, 4.5f, 4.5f);
  scene.cameras[0] = downCamera({0, 3, 0}, 4, 10);
  Probe probe(context, std::move(scene), kSingle);
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentOverlap)};
  const glm::dvec3 expected[] = {{0.552, 0.396, 0.264}, {1, 1, 1}, {0.92, 0.44, 0.44}};
  for (uint32_t layer = 0; layer < 3; ++layer) {
    const glm::dvec3 mean = probe.meanVisibility(layer);
    for (int c = 0; c < 3; ++c)
      found.curve.push_back({double(layer), std::abs(mean[c] - expected[layer][c]),
                             tolerance(context, expected[layer][c], 2)});
  }
  if (!context.represents(Effect::ColouredTransmission) && found.expected.empty())
    found.expected = missing(context, Effect::ColouredTransmission);
  return found;
}

/// Against the truth: every value for techniques without noise, else their mean.
Found againstTruth(const CaseContext& context, Scene scene) {
  Probe probe(
      context, std::move(scene),
      {.knobs = {{"kernel", "1"}, {"size", "1024"}, {"compare", "manual"}}, .size = {128, 128}});
  const TruthDifference d = truthDifference(probe);
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentOverlap)};
  if (context.info().stochastic)
    found.curve.push_back({1, std::abs(d.mean), fourSigma(0.5, double(d.compared) / 3)});
  else
    found.curve.push_back({1, d.worst, 1.0 / 255});
  return found;
}

Found cyclic(const CaseContext& context) {
  Scene scene = floorScene();
  for (int i = 0; i < 3; ++i) {
    const double angle = i * 2.0943951023931953;
    const glm::vec3 along(float(std::cos(angle)), 0.12f, float(std::sin(angle)));
    const glm::vec3 across(-along.z, 0, along.x);
    addQuad(scene, add(scene, glass(0.75f, glm::vec3(0.25f * float(i + 1)))),
            glm::vec3(0, 1.5f, 0) + across * 0.9f, along * 2.4f, across * 0.35f);
  }
  scene.cameras[0] = downCamera({0, 4, 0}, 3, 12);
  scene.lights[0] = sun({0.2, -1, 0.1});
  return againstTruth(context, std::move(scene));
}

Found crossing(const CaseContext& context) {
  Scene scene = floorScene();
  addQuad(scene, add(scene, glass(0.5f, glm::vec3(0.5f))), {0, 1.5f, 0}, {2, 1, 0}, {0, 0, 2});
  addQuad(scene, add(scene, glass(0.5f, glm::vec3(0))), {0, 1.5f, 0}, {2, -1, 0}, {0, 0, 2});
  scene.cameras[0] = downCamera({0, 4, 0}, 3, 12);
  return againstTruth(context, std::move(scene));
}

Found batchTrap(const CaseContext& context) {
  // Spec 05, rule (ii) of batches: the highest pane lies over the middle one, that over the lowest,
  // and the highest and the lowest share nothing but the middle one's map.
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(0.5f, {1, 0.25f, 0.25f})), {-1.5f, 3, 0}, 1, 1.5f);
  addHorizontal(scene, add(scene, glass(0.5f, {0.25f, 1, 0.25f})), {0, 2, 0}, 1.25f, 1.5f);
  addHorizontal(scene, add(scene, glass(0.5f, {0.25f, 0.25f, 1})), {1.5f, 1, 0}, 1, 1.5f);
  scene.cameras[0] = downCamera({0, 4, 0}, 3, 12);
  return againstTruth(context, std::move(scene));
}

Found closed(const CaseContext& context) {
  Scene scene = floorScene();
  addBox(scene, add(scene, glass(0.5f, glm::vec3(0.25f))), {-1, 0.5f, -1}, {1, 2, 1});
  scene.lights[0] = sun({0.3, -1, 0.2});
  scene.cameras[0] = lookAt({2, 4, 3}, {0, 1, 0});
  return againstTruth(context, std::move(scene));
}

Found sheetOnFloor(const CaseContext& context) {
  Found found;
  for (const double slant : {0.0, 0.3, 1.0, 3.0}) {
    if (context.quick && slant != 0.3) continue;
    Scene scene = under({glass(0.5f, glm::vec3(0.5f))});
    addHorizontal(scene, add(scene, glass(1, glm::vec3(0.5f))), {0.3f, 0, 0.2f}, 3.3f, 2.9f);
    scene.lights[0] = sun({slant, -1, slant / 2});
    Probe probe(context, std::move(scene), kSingle);
    const VisibilityImage& image = probe.visibility()[0];
    const float* centre = image.data() + 4 * (64 * 128 + 64);
    Compared mixed;
    for (uint32_t y = 48; y < 80; ++y)
      for (uint32_t x = 48; x < 80; ++x)
        if (image[4 * (y * 128 + x) + 3] != 0)
          mixed.count(std::abs(image[4 * (y * 128 + x)] - centre[0]) > 1e-3f);
    found.curve.push_back({slant, mixed.value(), 0});
  }
  return found;
}

std::string ofDeterministic(const CaseContext& context) {
  return context.info().stochastic ? "its answer is noise there, not speckle" : "";
}

}  // namespace

std::vector<StabilityCase> translucentCases() {
  const std::string mean = "mean visibility is the product of what passes (difference)";
  const std::string rounding = "4 sigma of the draws (N7), or 2^-11 a layer (1/510 of 8 bits; N5)";
  const std::string truth =
      "visibility is the truth's away from its edges (largest difference; of stochastic "
      "techniques the mean's)";
  return {
      {.id = "layers",
       .title = "Many layers (300: torture scene H4)",
       .property = mean,
       .reason = rounding,
       .parameter = "layers",
       .logarithmic = true,
       .run = manyLayers},
      {.id = "alpha",
       .title = "Faint and dense layers",
       .property = mean,
       .reason = rounding + "; below 1/512 a layer counts as absent",
       .parameter = "alpha",
       .logarithmic = true,
       .run = faint},
      {.id = "coplanar",
       .title = "Two identical layers in one place",
       .property = "mean visibility is (1 - p)^2 (difference)",
       .reason = rounding,
       .parameter = "p",
       .run = coplanar},
      {.id = "own",
       .title = "The receiver is the caster",
       .property = "a surface does not shadow itself (mean light lost)",
       .reason = "1/255: the bias exceeds what rounding there is",
       .parameter = "angle of incidence, degrees",
       .run = ownSurface},
      {.id = "between",
       .title = "A surface between layers",
       .property = "floor, first and second layer as worked out (difference)",
       .reason = rounding,
       .parameter = "layer",
       .run = betweenLayers},
      {.id = "cycle",
       .title = "Three strips, each over the next",
       .property = truth,
       .reason = "1/255, or 4 sigma",
       .run = cyclic},
      {.id = "crossing",
       .title = "Surfaces through one another",
       .property = truth,
       .reason = "1/255, or 4 sigma",
       .run = crossing},
      {.id = "batch trap",
       .title = "Panes over one another in turn",
       .property = truth,
       .reason = "1/255, or 4 sigma",
       .run = batchTrap},
      {.id = "closed",
       .title = "A closed translucent box",
       .property = truth,
       .reason = "1/255, or 4 sigma",
       .run = closed},
      {.id = "sheet",
       .title = "A sheet in the plane of the floor",
       .property = "tinted everywhere or nowhere (pixels that differ)",
       .reason = "nothing is allowed",
       .parameter = "slant of the light",
       .leavesOut = ofDeterministic,
       .run = sheetOnFloor},
  };
}

}  // namespace sb

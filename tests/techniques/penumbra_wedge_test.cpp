// Penumbra wedges (spec 08): light behind single outlines, convex or not, is the outline's area
// within the light; casters add up; hard shadows are those of volumes.
#include <set>

#include "suites/scenes/edit/transform.h"
#include "tests/techniques/penumbra_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

using Setting = std::map<std::string, std::string>;

CellOptions wedges(Setting knobs = {}, rhi::Extent2D size = {48, 36}) {
  return {.technique = "PenumbraWedge", .knobs = std::move(knobs), .size = size};
}

/// A star, tilted, of one outline.
PenumbraScene star(Light light, const glm::dvec3& eye = {2, 5, 6}) {
  PenumbraScene s = penumbraFloor(std::move(light), eye);
  addSheet(s, {0.25, 1.25, 0}, {1, 0.25, 0}, {0, 0.25, 0.875},
           {1, 0.25, 0.875, 0.25, 1.125, 0.375, 0.75, 0.25, 1, 0.25});
  return s;
}

PenumbraScene apart() {
  PenumbraScene s = penumbraFloor(ball(0.5));
  addSheet(s, {-0.75, 1, -0.5}, {0.5, 0.25, 0.125}, {0.125, 0.25, 0.5}, {1, 0.75, 1, 0.75, 1});
  addSheet(s, {1.25, 0.75, 0.5}, {0.5, 0.25, 0}, {0, 0, 0.5}, {1, 1, 1});
  return s;
}

/// Of an edge straight below the light, from an eye in their plane: the middle column of pixels
/// lies in it, but for less than vertices snap to.
PenumbraScene alongThePlane() {
  PenumbraScene s = penumbraFloor(ball(0.5, {0, 4, 0}));
  addSheet(s, {0.75 + 4e-5, 1, 0}, {0.75, 0, 0.75}, {-0.75, 0, 0.75}, {1, 1, 1, 1});
  s.scene.cameras[0] = lookAt({0, 3, 6}, {0, 0, 0}, 0.5);
  return s;
}

}  // namespace

GPU_TEST(PenumbraWedge, OneOutlineIsExactConvexOrNot) {
  for (const char* combine : {"shader", "wrap", "exact"}) {
    const PenumbraScene s = star(ball(0.5));
    Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}));
    expectPenumbra(cell, s, combine);
  }
  const PenumbraScene s = apart();
  for (const char* combine : {"shader", "wrap", "exact"}) {
    Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}));
    const PenumbraErrors e = penumbraErrors(cell, s);
    EXPECT_LE(e.worst, 1e-3) << combine << ", " << e.where;
    EXPECT_LE(e.rmse(), 5e-4) << combine;
  }
}

GPU_TEST(PenumbraWedge, HardEdgesThatCountsAndSharesSeeDifferentlyArePutRight) {
  const PenumbraScene s = alongThePlane();
  for (const char* combine : {"float", "shader", "wrap", "exact"}) {
    Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}, {49, 49}));
    if (combine == std::string("float"))
      EXPECT_GT(penumbraErrors(cell, s).wrong, 5u) << "they agree: nothing is tested";
    else
      expectPenumbra(cell, s, combine);
  }
}

GPU_TEST(PenumbraWedge, SolidsHaveTheSilhouetteThatTheLightsCentreSees) {
  // Other points of the light see others: an error by construction, which vanishes with its size.
  std::vector<double> rmse;
  for (const double radius : {0.5, 0.125}) {
    PenumbraScene s = penumbraFloor(ball(radius));
    addTurnedBox(s, {0.25, 1, 0}, {0.75, 0.25, 0.5});
    Cell cell(cellDevice(device()), s.scene, wedges());
    const PenumbraErrors e = penumbraErrors(cell, s);
    rmse.push_back(e.rmse());
    EXPECT_LE(e.worst, 0.2) << e.where;
    EXPECT_GE(e.partly, 8u);
  }
  EXPECT_LE(rmse[0], 0.01);
  EXPECT_LE(rmse[1], 0.25 * rmse[0]);
}

GPU_TEST(PenumbraWedge, EveryShapeOfLightIsRight) {
  Light other = ball(0.5);
  other.halfAxes = glm::dmat3(glm::dvec3(0.75, 0.125, 0), glm::dvec3(0, 0.25, 0.125),
                              glm::dvec3(-0.125, 0, 0.375));
  for (const LightShape shape : {LightShape::Ellipsoid, LightShape::Rectangle, LightShape::Disc}) {
    other.shape = shape;
    if (shape != LightShape::Ellipsoid)
      other.halfAxes =
          glm::dmat3(glm::dvec3(0.75, 0.125, 0), glm::dvec3(-0.0125, 0.075, 0.375), glm::dvec3(0));
    const PenumbraScene s = star(other);
    Cell cell(cellDevice(device()), s.scene, wedges());
    expectPenumbra(cell, s, "shape " + std::to_string(int(shape)));
  }
  Light wide = sun({0.25, -1, 0.125});
  wide.angularRadius = 0.1;
  const PenumbraScene s = star(wide);
  Cell cell(cellDevice(device()), s.scene, wedges());
  expectPenumbra(cell, s, "sun", 25);
  // Close: half of the disc lies beyond what an orthogonal projection would show.
  const PenumbraScene close = star(ball(1.25, {0.5, 3, 0.25}));
  Cell near(cellDevice(device()), close.scene, wedges());
  expectPenumbra(near, close, "close");
}

GPU_TEST(PenumbraWedge, FloorsThatSeeALampEdgeOnDoNotHideIt) {
  // Upright: near its plane, seen points are large, and rounding with them. Sums do not ask what
  // hides the centre, and are off at hard edges alone.
  for (const LightShape shape : {LightShape::Disc, LightShape::Rectangle}) {
    Light lamp = ball(0.5);
    lamp.shape = shape;
    lamp.halfAxes = glm::dmat3(glm::dvec3(0.3, 0, 0.4), glm::dvec3(0, 0.5, 0), glm::dvec3(0));
    const PenumbraScene s = star(lamp);
    const auto found = [&](const char* combine) {
      Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}, {96, 72}));
      return cell.visibility()[0];
    };
    const VisibilityImage sums = found("float"), exact = found("exact");
    size_t differ = 0, lit = 0;
    for (size_t i = 0; i < sums.size(); i += 4) {
      differ += !(std::abs(exact[i] - sums[i]) <= 0.25f);
      lit += sums[i] == 1;
    }
    EXPECT_LE(differ, 1u) << int(shape);
    EXPECT_GE(lit, 3000u) << int(shape);
  }
}

GPU_TEST(PenumbraWedge, CastersThatOverlapAddUp) {
  // Never lighter than the truth, and darker by the smaller share at most.
  PenumbraScene s = apart();
  addSheet(s, {-0.5, 0.5, -0.25}, {0.75, 0, 0}, {0, 0.125, 0.5}, {1, 0.5, 1, 1});
  for (const char* combine : {"shader", "wrap", "exact"}) {
    Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}));
    const PenumbraErrors e = penumbraErrors(cell, s);
    EXPECT_LE(e.worst, 1e-3) << combine << ", " << e.where;
    EXPECT_LE(e.lighter, 1e-3) << combine;
  }
}

GPU_TEST(PenumbraWedge, ItDoesNotMatterWhereTheEyeIs) {
  // Within the penumbra, looking along it; beyond the sheet; with parallel rays.
  for (const glm::dvec3 eye : {glm::dvec3(-0.3, 0.25, -0.5), glm::dvec3(0.3, 3.5, 0.5)}) {
    const PenumbraScene s = star(ball(0.5), eye);
    Cell cell(cellDevice(device()), s.scene, wedges());
    expectPenumbra(cell, s, "eye", 20);
  }
  PenumbraScene s = star(ball(0.5));
  s.scene.cameras[0].orthographic = true;
  s.scene.cameras[0].halfHeight = 2.5;
  Cell cell(cellDevice(device()), s.scene, wedges());
  expectPenumbra(cell, s, "parallel");
}

GPU_TEST(PenumbraWedge, ScenesThatAreMovedAndScaledKeepTheirBits) {
  const PenumbraScene s = star(ball(0.5));
  for (const char* combine : {"shader", "exact"}) {
    const auto picture = [&](const Scene& scene) {
      Cell cell(cellDevice(device()), scene, wedges({{"combine", combine}}));
      return cell.visibility()[0];
    };
    const VisibilityImage before = picture(s.scene);
    Scene moved = s.scene, scaled = s.scene;
    translateScene(moved, {1e6, -2e6, 3e6});
    EXPECT_EQ(picture(moved), before) << combine;
    scaleScene(scaled, 1024);
    EXPECT_EQ(picture(scaled), before) << combine;
  }
}

GPU_TEST(PenumbraWedge, TranslucentLayersThatArePeeledReceive) {
  PenumbraScene s = star(ball(0.5));
  addHorizontal(s.scene, add(s.scene, glass(0.5f, glm::vec3(1))), {0, 0.25f, 0}, 3, 3);
  const uint32_t pane = uint32_t(s.scene.instances.size()) - 1;
  CellOptions options = wedges();
  options.transparency = "DepthPeeling";
  Cell cell(cellDevice(device()), s.scene, options);
  const PenumbraErrors e =
      penumbraErrors(cell, s, 1, 0, [&](const sb::Tracer::Point& p) { return p.instance == pane; });
  EXPECT_LE(e.worst, 1e-3) << e.where;
  EXPECT_GE(e.partly, 40u);
}

GPU_TEST(PenumbraWedge, WithoutPenumbraeItIsStencilShadowVolume) {
  // The last one's are planned for, but narrower than a pixel.
  for (const double radius : {0.0, 1e-4, 2e-3}) {
    const PenumbraScene s = star(ball(radius));
    EXPECT_EQ(Stage(s.scene, {48, 36}).effects().present.has(Effect::AreaLights), radius > 1e-3);
    const auto frame = [&](const char* technique) {
      Cell cell(cellDevice(device()), s.scene, {.technique = technique, .size = {48, 36}});
      std::vector<std::string> passes;
      for (const PassResult& pass : cell.result().passes)
        passes.push_back(pass.label + " " + std::to_string(pass.counters.draws) + " " +
                         std::to_string(pass.counters.triangles));
      return std::pair(passes, cell.picture().rgba);
    };
    EXPECT_EQ(frame("PenumbraWedge"), frame("StencilShadowVolume")) << radius;
  }
}

GPU_TEST(PenumbraWedge, HardLightsBesideSoftOnesAreHard) {
  PenumbraScene s = star(ball(0.5));
  addLight(s.scene, pointLight({-1.5, 3, 1}, 4));
  Cell cell(cellDevice(device()), s.scene, wedges());
  EXPECT_LE(penumbraErrors(cell, s).worst, 1e-3);
  Cell volumes(cellDevice(device()), s.scene,
               {.technique = "StencilShadowVolume", .size = {48, 36}});
  EXPECT_EQ(cell.visibility(1)[0], volumes.visibility(1)[0]);
}

GPU_TEST(PenumbraWedge, EdgesThatTouchTheLightAreDrawnEverywhere) {
  PenumbraScene s = star(ball(0.5));
  addSheet(s, {0.75, 4, 0.25}, {0.5, 0.125, 0}, {0, 0.125, 0.5}, {1, 1, 1});
  for (const char* combine : {"shader", "exact"}) {
    Cell cell(cellDevice(device()), s.scene, wedges({{"combine", combine}}));
    std::map<std::string, uint64_t> counts;
    for (const auto& [name, count] : cell.renderer().counts()) counts[name] = count;
    EXPECT_EQ(counts.at("penumbra wedges"), 17u) << "star, triangle and floor";
    EXPECT_EQ(counts.at("penumbra wedges drawn everywhere"), 3u);
    for (const float v : cell.visibility()[0]) ASSERT_TRUE(v >= 0 && v <= 1) << v;
  }
}

GPU_TEST(PenumbraWedge, TheSourcesTablesAndBytesAreCoarse) {
  const PenumbraScene s = star(ball(0.5));
  const auto errors = [&](Setting knobs) {
    Cell cell(cellDevice(device()), s.scene, wedges(std::move(knobs)));
    return penumbraErrors(cell, s);
  };
  const auto tables = [&](const char* combine, const char* nodes) {
    return errors({{"coverage", "lut"}, {"combine", combine}, {"lut", nodes}}).rmse();
  };
  const double coarse = tables("float", "16"), fine = tables("float", "64");
  EXPECT_NEAR(tables("exact", "16"), coarse, 0.1 * coarse);
  EXPECT_LE(coarse, 0.02);
  EXPECT_LE(fine, 0.25 * coarse);
  EXPECT_LE(fine, 2e-3);
  EXPECT_LE(errors({{"format", "r16f"}}).worst, 4e-3);
  Cell cell(cellDevice(device()), s.scene, wedges({{"format", "rgba8"}}));
  const PenumbraErrors bytes = penumbraErrors(cell, s);
  // Half a step for each edge that is seen at once.
  EXPECT_LE(bytes.worst, 4 * 0.5 / 32) << bytes.where;
  EXPECT_GE(bytes.worst, 0.4 / 32);
  std::set<float> shades;
  for (size_t i = 0; i < cell.visibility()[0].size(); i += 4)
    if (cell.visibility()[0][i + 3] == 1) shades.insert(cell.visibility()[0][i]);
  EXPECT_LE(shades.size(), 33u);
  EXPECT_GE(shades.size(), 12u);
}

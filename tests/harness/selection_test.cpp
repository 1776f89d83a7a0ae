// From arguments to cells, names and groups.
#include "suites/harness/suite/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "techniques/plan/error.h"
#include "tests/harness/named_backend.h"

namespace sb::test {
namespace {

std::vector<CellId> select(const Selection& s) { return selectCells(s, kBackendNames, kDefaultBackends); }

std::string messageOf(const Selection& s) {
  try {
    select(s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Selection, DefaultIsAllTechniquesOnFourScenesAndTwoBackends) {
  const auto cells = select({});
  std::set<std::string> techniques, scenes, names;
  for (const CellId& c : cells) {
    techniques.insert(c.technique);
    scenes.insert(c.scene);
    EXPECT_TRUE(names.insert(cellName(c)).second) << cellName(c);
  }
  EXPECT_EQ(scenes.size(), 4u);
  // Ray tracing runs on no backend.
  EXPECT_TRUE(techniques.contains("RayTraced"));
  EXPECT_EQ(cells.size(), (techniques.size() - 1) * 4 * 2 + 4);
}

TEST(Selection, RayTracingRunsOnTheCpuWhenAskedForOrWhenNoBackendIs) {
  auto names = [](const Selection& s) {
    std::vector<std::string> list;
    for (const CellId& c : select(s)) list.push_back(cellName(c));
    return list;
  };
  using Names = std::vector<std::string>;
  const Names traced = {"RayTraced/cpu/layers/512x512"};
  EXPECT_EQ(names({.techniques = {"RayTraced"}, .scenes = {"layers"}}), traced);
  EXPECT_EQ(names({.techniques = {"RayTraced"}, .backends = {"vulkan"}, .scenes = {"layers"}}),
            traced);
  EXPECT_EQ(names({.backends = {"cpu"}, .scenes = {"layers"}}), traced);
  for (const std::string& name : names({.backends = {"vulkan"}}))
    EXPECT_EQ(name.find("RayTraced"), std::string::npos) << name;
}

TEST(Selection, NamesSayWhatDiffersFromTheDefaultAndNoMore) {
  const auto cells = select({.techniques = {"CSSM2+Sorted"},
                             .backends = {"opengl-osmesa"},
                             .scenes = {"spheres_quads:size=0.5,quads=7"},
                             .sets = {"kernel=1,3.0", "size=1024"},
                             .filter = "",
                             .size = {{64, 32}},
                             .seed = 5});
  ASSERT_EQ(cells.size(), 2u);
  std::set<std::string> names;
  for (const CellId& c : cells) names.insert(cellName(c));
  for (const std::string& name : names) {
    EXPECT_TRUE(
        std::regex_match(name, std::regex("CSSM2/opengl-osmesa/spheres_quads:quads=7,size=0.5"
                                          "(/kernel:[13])?/seed:5/64x32")))
        << name;
  }
}

TEST(Selection, APlainNameMeansTheDefaultTransparency) {
  const Selection s = {.techniques = {"none", "none+Sorted", "none+DepthPeeling"},
                       .backends = {"vulkan"},
                       .scenes = {"layers"},
                       .sets = {"sort=triangle", "layers=4"}};
  const auto cells = select(s);
  ASSERT_EQ(cells.size(), 2u) << "none and none+Sorted are one cell";
  EXPECT_EQ(cells[0].transparency, kDefaultTransparency);
  EXPECT_EQ(cellName(cells[0]), "none/vulkan/layers/sort:triangle/512x512");
  EXPECT_EQ(cells[1].transparency, "DepthPeeling");
  // Each takes the knobs that it has.
  EXPECT_EQ(cellName(cells[1]), "none+DepthPeeling/vulkan/layers/layers:4/512x512");
  EXPECT_EQ(cellCommand(cells[1]),
            "./bench --technique none+DepthPeeling --backend vulkan --scene layers --set layers=4 "
            "--size 512x512");
  EXPECT_EQ(cellName(baselineOf(cells[1])), cellName(cells[1]));
}

// TECHNIQUE[+TRANSPARENCY]/backend/scene/knob:value.../WxH
TEST(Selection, NamesCanBeTakenApart) {
  const std::regex form(
      R"(([A-Za-z0-9]+)(\+[A-Za-z0-9]+)?/([a-z-]+)/([^/]+)((/[A-Za-z0-9_]+:[^/:]+)*)/(\d+)x(\d+))");
  Selection s;
  s.sets = {"size=512,2048", "kernel=1,5"};
  s.seed = 3;
  for (const CellId& c : select(s)) {
    std::smatch parts;
    const std::string name = cellName(c);
    ASSERT_TRUE(std::regex_match(name, parts, form)) << name;
    EXPECT_EQ(parts[1], c.technique);
    EXPECT_EQ(parts[3], c.backend);
    EXPECT_EQ(parts[4], c.scene);
    EXPECT_EQ(parts[7], "512");
  }
}

TEST(Selection, ASweepIsEveryCombinationOnce) {
  const auto cells = select({.techniques = {"ShadowMap"},
                             .backends = {"vulkan"},
                             .scenes = {"layers"},
                             .sets = {"size=512,1024,512", "kernel=1,3"},
                             .filter = {},
                             .size = {}});
  EXPECT_EQ(cells.size(), 4u);
}

TEST(Selection, KnobsOfOneTechniqueLeaveOthersAlone) {
  const auto cells = select({.techniques = {"none", "ShadowMap"},
                             .backends = {"vulkan"},
                             .scenes = {"layers"},
                             .sets = {"kernel=1,3"},
                             .filter = {},
                             .size = {}});
  EXPECT_EQ(cells.size(), 3u);
}

TEST(Selection, CommandsReproduceTheCell) {
  CellId id = {.technique = "CSSM2",
               .backend = "vulkan",
               .scene = "/tmp/it's a $cene.glb",
               .knobs = {{"kernel", "3"}},
               .width = 8,
               .height = 4,
               .seed = 2};
  EXPECT_EQ(cellCommand(id),
            "./bench --technique CSSM2 --backend vulkan --scene '/tmp/it'\\''s a $cene.glb' --set "
            "kernel=3 --seed 2 --size 8x4");
}

TEST(Selection, ErrorsNameTheNearest) {
  EXPECT_NE(messageOf({.techniques = {"CSM2"}, .filter = {}, .size = {}}).find("CSSM2"),
            std::string::npos);
  EXPECT_NE(messageOf({.techniques = {"none+DepthPeling"}}).find("DepthPeeling"), std::string::npos);
  EXPECT_NE(messageOf({.backends = {"vulcan"}, .filter = {}, .size = {}}).find("vulkan"),
            std::string::npos);
  EXPECT_NE(messageOf({.scenes = {"layer"}, .filter = {}, .size = {}}).find("layers"),
            std::string::npos);
  EXPECT_NE(messageOf({.sets = {"kernal=3"}, .filter = {}, .size = {}}).find("kernel"),
            std::string::npos);
  EXPECT_NE(
      messageOf({.filter = "CSM2/vulkan/windo", .size = {}}).find("CSSM2/vulkan/window/512x512"),
      std::string::npos);
}

TEST(Selection, ErrorsSayWhatWasExpected) {
  for (const char* bad : {"kernel", "kernel=", "kernel=4", "kernel=1000", "kernel=x", "kernel=3,"})
    EXPECT_NE(messageOf({.techniques = {"CSSM2"}, .sets = {bad}, .filter = {}, .size = {}})
                  .find("expected"),
              std::string::npos)
        << bad;
  EXPECT_NE(messageOf({.sets = {"kernel=1", "kernel=3"}, .filter = {}, .size = {}}).find("twice"),
            std::string::npos);
  EXPECT_NE(messageOf({.techniques = {"CSSM2+Sorted+x"}, .filter = {}, .size = {}}), "");
  EXPECT_NE(messageOf({.filter = "(", .size = {}}).find("regular expression"), std::string::npos);
  EXPECT_NE(messageOf({.filter = ".", .filterExcludes = true, .size = {}}), "");
}

TEST(Selection, FiltersKeepOrLeaveOut) {
  for (const CellId& c : select({.filter = "^CSSM2/vulkan", .size = {}}))
    EXPECT_TRUE(c.technique == "CSSM2" && c.backend == "vulkan");
  for (const CellId& c : select({.filter = "CSSM2", .filterExcludes = true, .size = {}}))
    EXPECT_NE(c.technique, "CSSM2");
}

TEST(Groups, EveryCellHasItsBaselineBesideIt) {
  const auto groups = groupCells(select({.filter = "CSSM2", .size = {}}));
  EXPECT_EQ(groups.size(), 4u) << "one a scene";
  for (const auto& group : groups) {
    std::set<CellId> ids;
    for (const auto& [id, companion] : group) {
      ids.insert(id);
      EXPECT_EQ(companion, id.technique == "none");
    }
    for (const GroupCell& c : group) EXPECT_TRUE(ids.contains(baselineOf(c.id)));
    EXPECT_EQ(ids.size(), 4u);
  }
}

TEST(Groups, BaselinesThatWereAskedForAreNoCompanions) {
  // In groups that hold a scene: smaller ones repeat their baseline.
  for (const auto& group : groupCells(select({}), 64))
    for (const GroupCell& c : group) EXPECT_FALSE(c.companion);
}

TEST(Groups, BackendsOfACellStayTogether) {
  // Three backends do not divide the limit of four.
  const auto cells = select({.techniques = {"ShadowMap"},
                             .backends = kBackendNames,
                             .scenes = {"layers"},
                             .sets = {"size=256,512,2048"},
                             .filter = {},
                             .size = {}});
  const auto groups = groupCells(cells, 4);
  EXPECT_EQ(groups.size(), 3u);
  for (const auto& group : groups) {
    std::set<std::string> backends;
    for (const GroupCell& c : group)
      if (!c.companion) backends.insert(c.id.backend);
    EXPECT_EQ(backends.size(), 3u);
  }
}

TEST(Selection, ANameFindsItselfWhateverItMeansAsAnExpression) {
  const std::vector<std::string> names = {
      "CSSM2/vulkan/layers/512x512", "CSSM2+DepthPeeling/vulkan/layers/512x512",
      "none/vulkan/layers?*:alpha=0.5/512x512", "none/vulkan/layers/32x32",
      "none/vulkan/layers/32x320"};
  for (const std::string& name : names) {
    const NameFilter filter({.filter = name, .size = {}}, names);
    for (const std::string& other : names) EXPECT_EQ(filter.keeps(other), other == name) << name;
  }
  const auto kept = [&](const std::string& text, bool exclude = false) {
    const NameFilter filter({.filter = text, .filterExcludes = exclude, .size = {}}, names);
    return std::ranges::count_if(names, [&](const std::string& n) { return filter.keeps(n); });
  };
  EXPECT_EQ(kept(""), 5);
  EXPECT_EQ(kept("CSSM2+Depth"), 1);      // as it stands
  EXPECT_EQ(kept("layers?*:alpha"), 1);   // no expression at all
  EXPECT_EQ(kept("^CSSM2.*/layers/"), 2);
  EXPECT_EQ(kept("32x32", true), 3);
  EXPECT_THROW(kept("("), InputError);
  EXPECT_THROW(kept("nothing"), InputError);
  EXPECT_THROW(kept("/", true), InputError);
}

}  // namespace
}  // namespace sb::test

// A cell's identity: a key with an order, and the names that are made from it.
#include "reports/cell_id.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "reports/record_view.h"

namespace report {
namespace {

CellId sample() {
  return {.technique = "CSSM2",
          .backend = "vulkan",
          .scene = "a/b:c.glb",
          .knobs = {{"size", "512"}, {"kernel", "9"}},
          .width = 64,
          .height = 32,
          .seed = 7};
}

TEST(CellId, EveryFieldTellsCellsApart) {
  const std::vector<void (*)(CellId&)> changes = {
      [](CellId& id) { id.technique = "CSSM1"; },   [](CellId& id) { id.transparency = "X"; },
      [](CellId& id) { id.lights = "Clustered"; },  [](CellId& id) { id.backend = "opengl"; },
      [](CellId& id) { id.scene = "layers"; },      [](CellId& id) { id.knobs.pop_back(); },
      [](CellId& id) { id.knobs[1].second = "5"; }, [](CellId& id) { id.width = 65; },
      [](CellId& id) { id.height = 65; },           [](CellId& id) { id.seed = 0; }};
  std::map<CellId, std::string> cells = {{sample(), cellName(sample())}};
  std::set<std::string> names = {cellName(sample())};
  for (const auto change : changes) {
    CellId id = sample();
    change(id);
    EXPECT_NE(id, sample());
    EXPECT_TRUE((id < sample()) != (sample() < id));
    EXPECT_TRUE(cells.emplace(id, cellName(id)).second) << cellName(id);
    EXPECT_TRUE(names.insert(cellName(id)).second) << cellName(id);
  }
  EXPECT_EQ(cells.at(sample()), "CSSM2/vulkan/a/b:c.glb/size:512/kernel:9/seed:7/64x32");
}

TEST(CellId, NamesLeaveOutWhatIsMeantAnyway) {
  EXPECT_EQ(techniqueName({.technique = "A"}), "A");
  EXPECT_EQ(techniqueName({.technique = "A", .transparency = kDefaultTransparency}), "A");
  EXPECT_EQ(techniqueName({.technique = "A", .lights = kDefaultLights}), "A");
  EXPECT_EQ(techniqueName({.technique = "A", .transparency = "X"}), "A+X");
  EXPECT_EQ(techniqueName({.technique = "A", .lights = "L"}), "A@L");
  EXPECT_EQ(techniqueName({.technique = "A", .transparency = "X", .lights = "L"}), "A+X@L");
  EXPECT_EQ(cellName({.technique = "A", .backend = "b", .scene = "s"}), "A/b/s/512x512");
  EXPECT_EQ(cellName({.technique = "A", .backend = "b", .scene = "s\n\xff"}),
            "A/b/s\\x0a\\xff/512x512");
}

// A scene may hold whatever separates the parts of a name.
TEST(CellId, VariantsAreOfTheFieldsAndNotOfTheName) {
  EXPECT_EQ(variantOf(sample()), "size:512 kernel:9 seed:7");
  EXPECT_EQ(variantOf({.technique = "A", .scene = "x/size:3/y"}), "");
  EXPECT_EQ(variantOf({.technique = "A", .seed = 2}), "seed:2");
}

}  // namespace
}  // namespace report

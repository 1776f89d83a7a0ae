// Suite files: cells they name, and mistakes in them by line and field.
#include "suites/harness/suite.h"

#include <gtest/gtest.h>

#include <set>

#include "techniques/common/error.h"

namespace sb {
namespace {

const std::vector<std::string> kKnown = {"vulkan", "opengl", "opengl-osmesa"};
const std::vector<std::string> kDefault = {"vulkan", "opengl"};

std::vector<std::string> namesOf(std::string_view text, const Selection& over = {}) {
  std::vector<std::string> names;
  for (const CellId& id : suiteCells(parseSuite(text, "s.toml"), over, kKnown, kDefault))
    names.push_back(cellName(id));
  return names;
}

std::string errorOf(std::string_view text) {
  try {
    namesOf(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Suite, SweepsTurnOneKnobAtATimeAndGridsAllTogether) {
  const char* text = R"(
    [[run]]
    scenes = ["layers"]
    techniques = ["ShadowMap"]
    backends = ["vulkan"]
    size = "64x32"
    set.compare = "manual"
    sweep.kernel = [3, 5]
    sweep.size = [512]
    [[run]]
    scenes = ["layers"]
    techniques = ["none", "ShadowMap"]
    backends = ["vulkan"]
    size = "64x32"
    grid.kernel = [1, 3]
    grid.size = [512, 256.0]
  )";
  EXPECT_EQ(namesOf(text),
            (std::vector<std::string>{
                "ShadowMap/vulkan/layers/compare:manual/64x32",
                "ShadowMap/vulkan/layers/kernel:3/compare:manual/64x32",
                "ShadowMap/vulkan/layers/kernel:5/compare:manual/64x32",
                "ShadowMap/vulkan/layers/size:512/compare:manual/64x32",
                "none/vulkan/layers/64x32", "ShadowMap/vulkan/layers/size:512/64x32",
                "ShadowMap/vulkan/layers/size:256/64x32",
                "ShadowMap/vulkan/layers/size:512/kernel:3/64x32",
                "ShadowMap/vulkan/layers/size:256/kernel:3/64x32"}));
}

TEST(Suite, ArgumentsReplaceBackendsAndSizeAndFilter) {
  const char* text = "[[run]]\nscenes = ['layers', 'window']\ntechniques = ['none']\n";
  EXPECT_EQ(namesOf(text).size(), 4u);
  EXPECT_EQ(namesOf(text, {.backends = {"opengl-osmesa"}, .filter = "window", .size = {{8, 4}}}),
            (std::vector<std::string>{"none/opengl-osmesa/window/8x4"}));
}

TEST(Suite, SettingsOfTheMeasurement) {
  const Suite suite = parseSuite(
      "title = 't'\nseeds = 3\nbudget = 0.5\nprecision = 2\n[[run]]\nscenes=['layers']\n"
      "techniques=['none']",
      "s.toml");
  EXPECT_EQ(suite.title, "t");
  EXPECT_EQ(suite.seeds, 3u);
  EXPECT_EQ(suite.budgetSeconds, 0.5);
  EXPECT_EQ(suite.precisionPercent, 2.0);
}

TEST(Suite, MistakesAreNamedWithLineAndField) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "s.toml: has no [[run]] and no [[stability]]"},
      {"title = ", "s.toml:1: "},
      {"\nseeds = 'many'\n", "s.toml:2: seeds: found"},
      {"budget = -1", "s.toml:1: budget: found -1"},
      {"seeds = nan", "seeds: found nan"},
      {"tilte = 'x'", "s.toml:1: unknown field 'tilte'"},
      {"run = 3", "run: found 3, expected tables [[run]]"},
      {"[[run]]\ntechniques=['none']", "s.toml:1: run 1: lacks scenes"},
      {"[[run]]\nscenes=['layers']\n", "run 1: lacks techniques"},
      {"[[run]]\nscenes='layers'\ntechniques=['none']", "s.toml:2: run 1.scenes: found 'layers'"},
      {"[[run]]\nscenes=[]\ntechniques=['none']", "a list with at least one entry"},
      {"[[run]]\nscenes=['layers', 3]\ntechniques=['none']", "run 1.scenes: found 3, expected a text"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsize='5'", "s.toml:4: run 1.size"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsweep.kernel=[[1]]",
       "s.toml:4: run 1.sweep.kernel"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsun='direction=0,x,0'",
       "s.toml:4: run 1.sun: scene edit 'sun:direction=0,x,0': direction holds 'x'"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nmaterials=['china']",
       "s.toml:4: run 1.materials: scene edit 'china': expected"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsweep=4", "run 1.sweep: found 4"},
      {"[[run]]\nscenes=['layers']\ntechniques=['Shadowmap']", "s.toml:1: run 1: unknown technique"},
      {"[[run]]\nscenes=['layer']\ntechniques=['none']", "unknown scene 'layer'"},
      {"[[run]]\nscenes=['layers']\ntechniques=['ShadowMap']\nsweep.kernel=[2]", "kernel"},
      {"[[run]]\nscenes=['layers']\ntechniques=['ShadowMap']\nsweep.kernal=[3]",
       "unknown knob 'kernal'"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(errorOf(text).find(expected), std::string::npos)
        << text << "\n-> " << errorOf(text) << "\nexpected " << expected;
}

TEST(Suite, ChangesOfScenesAreThoseOfTheCommandLine) {
  EXPECT_EQ(namesOf(R"(
    [[run]]
    scenes = ["layers:alpha=0.5", "teapot"]
    techniques = ["none"]
    backends = ["vulkan"]
    size = "8x8"
    sun = "direction=0,-1,0.50"
    camera = "eye=1,2,3,at=0,0,0"
    materials = ["*:alpha=0.5,t=0.9", "w?:alpha=0"]
  )"),
            (std::vector<std::string>{
                "none/vulkan/layers:alpha=0.5?camera:eye=1,2,3,at=0,0,0;sun:direction=0,-1,0.5;"
                "*:alpha=0.5,t=0.9,0.9,0.9;w?:alpha=0/8x8",
                "none/vulkan/teapot?camera:eye=1,2,3,at=0,0,0;sun:direction=0,-1,0.5;"
                "*:alpha=0.5,t=0.9,0.9,0.9;w?:alpha=0/8x8"}));
}

TEST(Suite, EveryBuiltInSuiteSelectsCells) {
  ASSERT_FALSE(builtinSuites().empty());
  for (const std::string& name : builtinSuites()) {
    const Suite suite = loadSuite(name);
    const auto cells = suiteCells(suite, {}, kKnown, kDefault);
    EXPECT_TRUE(cells.size() > 10 || !suite.stability.empty()) << name;
    std::set<std::string> names;
    for (const CellId& id : cells) EXPECT_TRUE(names.insert(cellName(id)).second) << cellName(id);
  }
  EXPECT_THROW(loadSuite("accuracies"), InputError);
  EXPECT_THROW(loadSuite("/no/such.toml"), InputError);
}

}  // namespace
}  // namespace sb

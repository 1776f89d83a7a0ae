// Suite files: cells they name, and mistakes in them by line and field.
#include "suites/harness/suite/suite.h"

#include <gtest/gtest.h>

#include <set>

#include "techniques/plan/error.h"
#include "techniques/render/registry.h"
#include "tests/harness/named_backend.h"

namespace sb::test {
namespace {

std::vector<std::string> namesOf(std::string_view text, const Selection& over = {}) {
  std::vector<std::string> names;
  for (const CellId& id : suiteCells(parseSuite(text, "s.toml"), over, kBackendNames, kDefaultBackends))
    names.push_back(cellName(id));
  return names;
}

std::string messageOf(std::string_view text) {
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
    set.compare = "hardware"
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
                "ShadowMap/vulkan/layers/compare:hardware/64x32",
                "ShadowMap/vulkan/layers/kernel:3/compare:hardware/64x32",
                "ShadowMap/vulkan/layers/kernel:5/compare:hardware/64x32",
                "ShadowMap/vulkan/layers/size:512/compare:hardware/64x32",
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

TEST(Suite, QuickIsEveryTechniqueOnTheScenesThatStandInForNone) {
  const Suite quick = loadSuite("quick");
  const auto cells = suiteCells(quick, {}, kBackendNames, kDefaultBackends);
  std::set<std::string> scenes, techniques;
  for (const CellId& id : cells) {
    scenes.insert(id.scene);
    techniques.insert(id.technique);
    EXPECT_EQ(std::pair(id.width, id.height), std::pair(256u, 256u));
  }
  EXPECT_EQ(scenes, std::set<std::string>(quickScenes().begin(), quickScenes().end()));
  EXPECT_EQ(techniques.size(), shadowTechniques().size() + 1);  // and the tracer
}

TEST(Suite, GridsThatMultiplyBeyondReasonAreRefusedBeforeTheyAreMade) {
  std::string values;
  for (int i = 0; i < 1000; ++i) values += (i ? "," : "") + std::to_string(i + 64);
  EXPECT_NE(messageOf("[[run]]\nscenes=['layers']\ntechniques=['CSSM2']\ngrid.size=[" + values +
                    "]\ngrid.kernel=[" + values + "]")
                .find("more than 100000 cells"),
            std::string::npos);
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
      {"seeds = 1e300", ", expected a whole number from 1 to 65536"},
      {"seeds = 0.5", "seeds: found 0.5, expected a whole number from 1 to 65536"},
      {"seeds = 0", "seeds: found 0, expected a whole number from 1 to 65536"},
      {"budget = inf", "budget: found inf"},
      {"[[stability]]\nseeds = 0.5", "s.toml:2: stability 1.seeds: found 0.5"},
      {"[[run]]\nscenes=['layers']\nsize='4294967297x1'", "s.toml:3: run 1.size"},
      {"tilte = 'x'", "s.toml:1: unknown field 'tilte'"},
      {"run = 3", "run: found 3, expected tables [[run]]"},
      {"[[run]]\ntechniques=['none']", "s.toml:1: run 1: lacks scenes"},
      {"[[run]]\nscenes='layers'\ntechniques=['none']", "s.toml:2: run 1.scenes: found 'layers'"},
      {"[[run]]\nscenes=[]\ntechniques=['none']", "a list with at least one entry"},
      {"[[run]]\nscenes=['layers', 3]\ntechniques=['none']", "run 1.scenes: found 3, expected a text"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsize='5'", "s.toml:4: run 1.size"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsweep.kernel=[[1]]",
       "s.toml:4: run 1.sweep.kernel"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsun='direction=0,x,0'",
       "s.toml:4: run 1.sun: --sun 'direction=0,x,0': direction holds 'x'"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nmaterials=['china']",
       "s.toml:4: run 1.materials: --set-material 'china': expected"},
      {"[[run]]\nscenes=['layers']\ntechniques=['none']\nsweep=4", "run 1.sweep: found 4"},
      {"[[run]]\nscenes=['layers']\ntechniques=['Shadowmap']", "s.toml:1: run 1: unknown technique"},
      {"[[run]]\nscenes=['layer']\ntechniques=['none']", "unknown scene 'layer'"},
      {"[[run]]\nscenes=['layers']\ntechniques=['ShadowMap']\nsweep.kernel=[2]", "kernel"},
      {"[[run]]\nscenes=['layers']\ntechniques=['ShadowMap']\nsweep.kernal=[3]",
       "unknown knob 'kernal'"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(messageOf(text).find(expected), std::string::npos)
        << text << "\n-> " << messageOf(text) << "\nexpected " << expected;
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

const std::string kScaling = R"(
[[run]]
scenes = ["spheres_quads:quads=0", "spheres_quads"]
techniques = ["none", "ShadowMap", "CSSM2"]
[[figure]]
id = "5.3"
title = "t"
kind = "scaling"
x = "quads"
document = "d"
cells = "^(none|ShadowMap)/"
)";
const std::string kStatement = R"([[figure.statement]]
text = "s"
measure = "combined_ms"
left = "^none/"
relation = "less"
otherwise = "o"
)";

TEST(Suite, FiguresNameTheirCells) {
  const Suite suite = parseSuite(
      kScaling + kStatement + "right = '^Shadow'\nof = 'slope'\nfactor = 2\nat = 3\nleft_at = 4\n" +
          kStatement + "number = 7\n[[figure.stated]]\ncells = '^none'\nbytes = 'b'\n",
      "s.toml");
  const auto figures = suiteFigures(suite, {.backends = {"vulkan"}, .filter = "CSSM2"}, kBackendNames, kDefaultBackends);
  ASSERT_EQ(figures.size(), 1u);
  const report::Figure& f = figures[0];
  // What a filter leaves out belongs to the figure all the same.
  EXPECT_EQ(f.cells, (std::vector<report::FigureCell>{
                         {"none/vulkan/spheres_quads:quads=0/512x512", "vulkan"},
                         {"ShadowMap/vulkan/spheres_quads:quads=0/512x512", "vulkan"},
                         {"none/vulkan/spheres_quads/512x512", "vulkan"},
                         {"ShadowMap/vulkan/spheres_quads/512x512", "vulkan"}}));
  EXPECT_EQ(f.kind, report::FigureKind::Scaling);
  EXPECT_EQ(f.xFallback, 200);
  ASSERT_EQ(f.statements.size(), 2u);
  const report::FigureStatement& s = f.statements[0];
  EXPECT_EQ(s.of, "slope");
  EXPECT_EQ(s.right.cells, "^Shadow");
  EXPECT_EQ(s.right.measure, "combined_ms");
  EXPECT_EQ(s.left.at, 4);
  EXPECT_EQ(s.right.at, 3);
  EXPECT_EQ(s.factor, 2);
  EXPECT_EQ(f.statements[1].number, 7);
  EXPECT_EQ(f.stated.at(0).bytes, "b");
}

TEST(Suite, MistakesInFiguresAreNamed) {
  const auto errorOfFigures = [](const std::string& text) -> std::string {
    try {
      suiteFigures(parseSuite(text, "s.toml"), {}, kBackendNames, kDefaultBackends);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const std::string right = kStatement + "right = 'S'\n";
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_EQ(errorOfFigures(kScaling + right), "");
  const std::pair<std::string, std::string> cases[] = {
      {changed(kScaling, "quads\"\ndocument", "quad\"\ndocument"),
       "s.toml:5: figure 1: x: 'quad' is no parameter of its scenes and no knob"},
      {changed(kScaling, "\"scaling\"", "\"scalign\""), "s.toml:8: figure 1.kind: unknown value"},
      {changed(kScaling, "x = \"quads\"", ""), "s.toml:5: figure 1: lacks x"},
      {changed(kScaling, "^(none|ShadowMap)/", "^Teapot"),
       "figure 1: cells: no cell of the figure matches '^Teapot'"},
      {changed(kScaling, "^(none", "^((none"), "s.toml:11: figure 1.cells: '^((none|ShadowMap)/' is"},
      {kScaling + kStatement, "s.toml:12: figure 1.statement 1: lacks right, or number"},
      {kScaling + right + "number = 1\n", "has both a right side and a number"},
      {kScaling + changed(right, "^none/", "^CSSM2"),
       "statement 1.left: no cell of the figure matches '^CSSM2'"},
      {kScaling + changed(right, "combined_ms", "combined"),
       "s.toml:14: figure 1.statement 1.measure: found 'combined', expected a measure"},
      {kScaling + changed(right, "\"less\"", "\"fewer\""), "statement 1.relation: unknown value"},
      {kScaling + right + "of = 'slop'", "statement 1.of: unknown value 'slop'"},
      {kScaling + changed(right, "otherwise", "other"), "unknown field 'other'"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(errorOfFigures(text).find(expected), std::string::npos)
        << text << "\n-> " << errorOfFigures(text) << "\nexpected " << expected;
}

TEST(Suite, EveryBuiltInSuiteSelectsCells) {
  ASSERT_FALSE(builtinSuites().empty());
  for (const std::string& name : builtinSuites()) {
    const Suite suite = loadSuite(name);
    const auto cells = suiteCells(suite, {}, kBackendNames, kDefaultBackends);
    EXPECT_TRUE(cells.size() > 5 || !suite.stability.empty()) << name;
    const auto figures = suiteFigures(suite, {}, kBackendNames, kDefaultBackends);
    EXPECT_EQ(name.starts_with("coloured_") || name.starts_with("stencil_"), !figures.empty())
        << name;
    std::set<std::string> names;
    for (const CellId& id : cells) EXPECT_TRUE(names.insert(cellName(id)).second) << cellName(id);
  }
  EXPECT_THROW(loadSuite("accuracies"), InputError);
  EXPECT_THROW(loadSuite("/no/such.toml"), InputError);
}

}  // namespace
}  // namespace sb::test

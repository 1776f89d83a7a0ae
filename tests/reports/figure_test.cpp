// Measures, statements and tables of figures, from cells made by hand.
#include <gtest/gtest.h>

#include "reports/console/console_figures.h"
#include "reports/figures/cells.h"
#include "reports/figures/evaluate.h"
#include "reports/figures/measure.h"
#include "reports/figures/table.h"
#include "reports/html/html.h"
#include "reports/json/json.h"
#include "reports/json/json_read.h"

namespace report {
namespace {

using Results = report::Run;  // a test has a member Run

Record cell(const std::string& technique, const std::string& backend, int quads, double ms,
            double precision = 0) {
  const std::string scene = "spheres_quads:quads=" + std::to_string(quads);
  Record r{
      .id = {.technique = technique, .backend = backend, .scene = scene, .width = 64, .height = 64},
      .name = technique + "/" + backend + "/" + scene + "/64x64",
      .timeSource = "software",
      .cpu = Distribution{.median = ms},
      .passes = {{.label = "shadow map", .count = 2, .draws = 7, .triangles = 24}, {.label = "opaque", .draws = 3}},
      .shadowMs = ms / 4,
      .sceneMs = ms / 2,
      .combinedMs = ms * 3 / 4,
      .stampedFrameMs = ms,
      .precision = precision,
      .passCount = 3,
      .triangleCount = 36,
      .bytes = 3072,
      .bytesByLabel = {{"camera colour", 1024}, {"shadow map", 2048}},
      .counts = {{"volumes drawn", 5}}};
  return r;
}

/// A: 1 + 0.01 x; B: 2 + 0.02 x; three cells each on two backends.
Results twoLines() {
  Results run;
  for (const char* backend : {"vulkan", "opengl"})
    for (const int quads : {0, 100, 200}) {
      run.records.push_back(cell("A", backend, quads, 1 + 0.01 * quads));
      run.records.push_back(cell("B", backend, quads, 2 + 0.02 * quads));
    }
  return run;
}

Figure scaling(const Results& run, const std::vector<FigureStatement>& statements) {
  Figure f{.id = "5.3 <A>",
           .title = "Scaling",
           .kind = FigureKind::Scaling,
           .cells = {},
           .x = "quads",
           .xFallback = 200,
           .document = "It says <so>.",
           .statements = statements,
           .stated = {}};
  for (const Record& r : run.records) f.cells.push_back({r.name, r.id.backend});
  return f;
}

FigureStatement less(const std::string& of, double factor = 1) {
  return {.text = "A is less than B",
          .of = of,
          .left = {.cells = "^A/", .measure = "time", .at = {}},
          .right = {.cells = "^B/", .measure = "time", .at = {}},
          .number = {},
          .relation = "less",
          .factor = factor,
          .otherwise = "software tells otherwise"};
}

StatementResult evaluated(const Results& run, const FigureStatement& s) {
  return evaluate(scaling(run, {}), s, run);
}

TEST(Figures, MeasuresAreNamed) {
  Record r = cell("A", "vulkan", 100, 2);
  r.visibilityLayers = {{.light = 0, .lightName = "", .layer = 2, .error = {{.rmse = 0.25}, {}}},
                        {.light = 1, .lightName = "", .layer = 2, .error = {{.rmse = 0.5}, {}}}};
  r.visibilityRegions = {{.region = "pale", .share = 1, .rmse = 0.125, .bias = 0, .noise = 0.0625}};
  const auto value = [&](const char* name) { return measured(r, name)->value; };
  EXPECT_EQ(value("time"), 2);
  EXPECT_EQ(value("combined_ms"), 1.5);
  EXPECT_EQ(value("passes"), 3);
  EXPECT_EQ(value("passes:shadow*"), 2);
  EXPECT_EQ(value("passes:*"), 3);
  EXPECT_EQ(value("draws:opaque"), 3);
  EXPECT_EQ(value("triangles"), 36);
  EXPECT_EQ(value("triangles:shadow*"), 24);
  EXPECT_EQ(value("counts:volumes drawn"), 5);
  EXPECT_EQ(value("bytes"), 3072);
  EXPECT_EQ(value("bytes:*map"), 2048);
  EXPECT_EQ(value("layer:2"), 0.5);
  EXPECT_EQ(value("region:pale"), 0.125);
  EXPECT_EQ(value("region_noise:pale"), 0.0625);
  EXPECT_FALSE(measured(r, "layer:1") || measured(r, "region:dark") || measured(r, "visibility"));
  EXPECT_TRUE(isMeasure("layer:3") && isMeasure("time"));
  EXPECT_FALSE(isMeasure("tme") || isMeasure("time:x") || isMeasure(""));
  r.contamination = {"validation"};
  EXPECT_FALSE(measured(r, "time"));
  EXPECT_TRUE(measured(r, "passes"));
}

TEST(Figures, XIsAParameterOfTheSceneAKnobOrTheDefault) {
  Figure f = scaling({}, {});
  Record r = cell("A", "vulkan", 100, 1);
  const auto x = [&](const std::string& scene) {
    r.id.scene = scene;
    return xOf(f, r);
  };
  EXPECT_EQ(x("s:quads=250"), 250);
  EXPECT_EQ(x("s:a=1,quads=0,size=2?camera:eye=quads=3"), 0);
  EXPECT_EQ(x("s:myquads=1"), 200);
  EXPECT_EQ(x("s?sun:quads=4"), 200);
  EXPECT_EQ(sceneWithoutX(f, r), "s?sun:quads=4");
  const auto rest = [&](const std::string& scene) {
    r.id.scene = scene;
    return sceneWithoutX(f, r);
  };
  EXPECT_EQ(rest("s:quads=1"), "s");
  EXPECT_EQ(rest("s:quads=1,b=2"), "s:b=2");
  EXPECT_EQ(rest("s:b=2,quads=1?sun:x"), "s:b=2?sun:x");
  f.x = "kernel";
  r.knobs["kernel"] = "9";
  EXPECT_EQ(xOf(f, r), 9);
}

TEST(Figures, StatementsAreDecidedByTheMeasurements) {
  const Results run = twoLines();
  const StatementResult slope = evaluated(run, less("slope"));
  EXPECT_EQ(slope.verdict, FigureVerdict::Reproduced);
  EXPECT_EQ(slope.found,
            "slope of time, ms, over quads: 0.01 < 0.02 (vulkan); 0.01 < 0.02 (opengl)");
  EXPECT_EQ(evaluated(run, less("intercept", 1.9)).verdict, FigureVerdict::Reproduced);
  const StatementResult fails = evaluated(run, less("slope", 2.5));
  EXPECT_EQ(fails.verdict, FigureVerdict::NotReproduced);
  EXPECT_EQ(fails.why, "software tells otherwise");
  EXPECT_NE(fails.found.find("(2.5 times): 0.01 > 0.02"), std::string::npos) << fails.found;
  FigureStatement s = less("value", 2);
  s.relation = "about";
  s.left.at = s.right.at = 100;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Reproduced);  // 2 and 4
  s.factor = 1.9;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::NotReproduced);
  s.relation = "more";
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::NotReproduced);
  s.left.at = 200, s.right.at = 0, s.factor = 1.4;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Reproduced);  // 3 and 2
}

TEST(Figures, EveryCellAgainstItself) {
  Results run = twoLines();
  FigureStatement s = less("each");
  s.left.cells = ".";
  s.left.measure = "combined_ms";
  s.right = {.cells = "", .measure = "stamped_frame_ms", .at = {}};
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Reproduced);
  EXPECT_NE(evaluated(run, s).found.find("holds in 6 cells (vulkan)"), std::string::npos);
  run.records[3].combinedMs = 99;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::NotReproduced);
  EXPECT_NE(evaluated(run, s).found.find(run.records[3].name + ": 99 > 4"), std::string::npos)
      << evaluated(run, s).found;
  s.left.measure = "passes";
  s.number = 3;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Reproduced);  // equal is not more
}

TEST(Figures, OverlappingIntervalsDecideNothing) {
  Results run;
  run.records = {cell("A", "vulkan", 0, 1, 0.2), cell("B", "vulkan", 0, 1.25, 0.2)};
  FigureStatement s = less("value");
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Undecided);
  EXPECT_NE(evaluated(run, s).found.find("1 ± 0.2 ? 1.25 ± 0.25"), std::string::npos);
  for (Record& r : run.records) r.precision = 0.05;
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::Reproduced);
  s.relation = "more";
  EXPECT_EQ(evaluated(run, s).verdict, FigureVerdict::NotReproduced);
}

TEST(Figures, WhatLacksIsNamed) {
  Results run = twoLines();
  Figure f = scaling(run, {});
  run.records[1].status = Status::Failed;
  run.records[1].reason = "no picture";
  run.records[7].contamination = {"load"};
  StatementResult result = evaluate(f, less("slope"), run);
  EXPECT_EQ(result.verdict, FigureVerdict::NotMeasured);
  EXPECT_EQ(result.why, "B/vulkan/spheres_quads:quads=0/64x64: failed, no picture");
  EXPECT_EQ(missingCells(f, run), std::vector<std::string>{result.why});
  run.records.erase(run.records.begin());
  result = evaluate(f, less("slope"), run);
  EXPECT_EQ(result.why, "A/vulkan/spheres_quads:quads=0/64x64 is not in this run");
  EXPECT_EQ(missingCells(f, run).size(), 2u);
}

TEST(Figures, MeansOverDifferentCellsAreNotCompared) {
  Results run = twoLines();
  const Figure f = scaling(run, {});
  run.records.erase(run.records.begin() + 4);  // A on Vulkan with the most quads
  const StatementResult result = evaluate(f, less("value"), run);
  EXPECT_EQ(result.verdict, FigureVerdict::Reproduced);
  EXPECT_EQ(result.found, "time, ms: 2 < 4 (opengl)");
  std::erase_if(run.records, [](const Record& r) { return r.id.backend == "opengl"; });
  EXPECT_EQ(evaluate(f, less("value"), run).why,
            "A/vulkan/spheres_quads:quads=200/64x64 is not in this run");
  // Of a backend that was not measured nothing is said while there is another.
  run.records.push_back(cell("A", "vulkan", 200, 3));
  run.records.erase(run.records.begin() + 1);
  EXPECT_EQ(evaluate(f, less("value"), run).why,
            "B/vulkan/spheres_quads:quads=0/64x64 is not in this run");
}

TEST(Figures, SeriesGoOverXAndTablesFitThem) {
  Results run = twoLines();
  std::swap(run.records[0], run.records[4]);
  const Figure f = scaling(run, {});
  const auto series = seriesOf(f, run);
  ASSERT_EQ(series.size(), 4u);
  EXPECT_EQ(xOf(f, *series[0].records.front()), 0);
  EXPECT_EQ(xOf(f, *series[0].records.back()), 200);
  const FigureTable table = tableOf(f, run);
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_NEAR(*table.rows[0].entries[6].value, 1, 1e-9);   // time at 0
  EXPECT_NEAR(*table.rows[0].entries[7].value, 10, 1e-9);  // microseconds per quad
  EXPECT_NEAR(*table.rows[0].entries[1].value, 2.5, 1e-9);
  EXPECT_EQ(*table.rows[0].entries[8].value, 200);
}

TEST(Figures, AreReadBackWholeAndShownWithoutTheSuite) {
  Results run = twoLines();
  FigureStatement number = less("each");
  number.number = 1e6;
  number.left.at = 100;
  Figure f = scaling(run, {less("slope"), less("slope", 3), number});
  f.stated = {{.cells = "^A/", .passes = "three", .attachments = "two depths", .bytes = "12 MB"}};
  f.cells.push_back({"C/vulkan/spheres_quads/64x64", "vulkan"});
  run.figures = {f};
  f.kind = FigureKind::Resources;
  run.figures.push_back(f);
  for (Record& r : run.records) r.status = Status::Ok;
  const std::string json = toJson(run);
  EXPECT_NE(json.find("\"verdict\": \"NOT reproduced\""), std::string::npos);
  EXPECT_NE(json.find("\"C/vulkan/spheres_quads/64x64: not in this run\""), std::string::npos);
  const Results back = fromJson(json, "a.json");
  EXPECT_EQ(toJson(back), json);
  EXPECT_EQ(figuresText(back), figuresText(run));
  const std::string text = figuresText(back);
  for (const char* part : {"Figure 5.3 <A>: Scaling", "  reproduced      A is less than B",
                           "  NOT reproduced  A is less than B", "because software tells otherwise",
                           "missing: C/vulkan/spheres_quads/64x64: not in this run"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  const std::string page = toHtml(back, {});
  for (const char* part : {"5.3 &lt;A&gt;", "It says &lt;so&gt;.", "✓</span> reproduced",
                           "✕</span> NOT reproduced", "Why: software tells otherwise",
                           "1 cell is missing of 13", "two depths; 12 MB", "data-curve=\"3\""})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("data-curve=\"4\""), std::string::npos);
}

TEST(Figures, OldFilesDoNotSayTheBackendsOfCells) {
  Results run = twoLines();
  run.figures = {scaling(run, {less("value")})};
  for (FigureCell& cell : run.figures[0].cells) cell.backend.clear();
  const Results back = fromJson(toJson(run), "a.json");
  EXPECT_EQ(back.figures[0].cells, scaling(run, {}).cells);
  // What was not measured may be of any: nothing is compared without it.
  run.records.erase(run.records.begin());
  const Results less = fromJson(toJson(run), "a.json");
  EXPECT_EQ(evaluate(less.figures[0], less.figures[0].statements[0], less).verdict,
            FigureVerdict::NotMeasured);
}

TEST(Figures, MistakesInTheFileAreNamed) {
  Results run = twoLines();
  run.figures = {scaling(run, {less("slope")})};
  std::string json = toJson(run);
  const size_t at = json.find("\"relation\": \"less\"");
  json.replace(at, 18, "\"relation\": \"best\"");
  try {
    fromJson(json, "a.json");
    FAIL();
  } catch (const ReadError& e) {
    EXPECT_EQ(e.field(), "figures[0].statements[0].relation");
  }
  // A pattern that is none, from elsewhere, matches nothing.
  run.figures[0].statements[0].left.cells = "(";
  EXPECT_EQ(evaluate(run.figures[0], run.figures[0].statements[0], run).verdict,
            FigureVerdict::NotMeasured);
}

}  // namespace
}  // namespace report

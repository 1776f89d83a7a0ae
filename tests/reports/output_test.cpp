// The exact text of every output, from a run made by hand, and CSV and JSON read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/console/console.h"
#include "reports/csv.h"
#include "reports/json/json.h"
#include "reports/record_view.h"
#include "tests/reports/sample_run.h"

namespace report {
namespace {

/// What tests/reports/expected/`name` holds. After a change that is meant, write the file anew with
/// SHADOWBENCH_WRITE_EXPECTED=1 and read the difference.
std::string expected(const std::string& name, const std::string& found) {
  const std::string path = std::string(SHADOWBENCH_SOURCE_DIR) + "/tests/reports/expected/" + name;
  if (std::getenv("SHADOWBENCH_WRITE_EXPECTED")) std::ofstream(path) << found;
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// RFC 4180, with LF between records.
std::vector<std::vector<std::string>> readCsv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool inside = false;
  for (size_t i = 0; i < text.size(); ++i) {
    std::string& field = rows.back().back();
    if (inside) {
      if (text[i] != '"')
        field += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else
        inside = false;
    } else if (text[i] == '"') {
      EXPECT_TRUE(field.empty()) << "a quote within a bare field";
      inside = true;
    } else if (text[i] == ',') {
      rows.back().emplace_back();
    } else if (text[i] == '\n') {
      if (i + 1 < text.size()) rows.push_back({""});
    } else {
      field += text[i];
    }
  }
  EXPECT_FALSE(inside);
  return rows;
}

TEST(Output, TableIsExact) {
  const std::string table = toTable(sampleRun());
  EXPECT_EQ(table, expected("table.txt", table));
}

TEST(Output, ErrorsBelowTheTruthAreMarked) {
  report::Run run = sampleRun();
  size_t marked = 0;
  for (Record& r : run.records) {
    EXPECT_FALSE(belowTruth(r)) << "the truth is exact";
    if (!r.visibility) continue;
    ++marked;
    r.truthStderr = 0.34 * r.visibility->all.rmse;
    EXPECT_TRUE(belowTruth(r));
  }
  EXPECT_GT(marked, 0u);
  const std::string table = toTable(run);
  EXPECT_NE(table.find(" ~0."), std::string::npos) << table;
  EXPECT_NE(table.find("~: less than three standard errors"), std::string::npos);
  EXPECT_EQ(toTable(sampleRun()).find("~"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(toJson(run));
  size_t told = 0;
  for (const auto& entry : json["benchmarks"])
    if (entry.contains("visibility") && !entry["visibility"].is_null()) {
      ++told;
      EXPECT_TRUE(entry["below_truth"].get<bool>());
    }
  EXPECT_GT(told, 0u);
  const auto rows = readCsv(toCsv(run));
  const auto column = std::ranges::find(rows[0], "below_truth") - rows[0].begin();
  EXPECT_EQ(size_t(std::ranges::count(rows, "true",
                                      [&](const auto& row) { return row[size_t(column)]; })),
            marked);
}

TEST(Output, TableNeverSaysGpuOfASoftwareDevice) {
  EXPECT_EQ(toTable(sampleRun()).find("GPU"), std::string::npos);
}

TEST(Console, LongScenesAreNumbered) {
  report::Run run = sampleRun();
  const std::string scene = "../a/Hall.gltf?curtain*:alpha=0.5,t=0.9,0.1,0.1;sun:direction=0,-1,0";
  for (Record& r : run.records) {
    r.name.replace(r.name.find(r.id.scene), r.id.scene.size(), scene);
    r.id.scene = scene;
  }
  const std::string table = toTable(run);
  EXPECT_NE(table.find("/Hall.gltf[1]/"), std::string::npos) << table;
  EXPECT_NE(table.find("[1] = " + scene + "\n"), std::string::npos) << table;
  EXPECT_EQ(table.find("[2]"), std::string::npos);
}

TEST(Console, SaysWhatATechniqueDoesNotShow) {
  report::Run run;
  const auto add = [&](const std::string& technique, std::vector<std::string> lacks) -> Record& {
    Record r;
    r.id.technique = technique;
    r.id.scene = "layers";
    r.status = Status::Ok;
    r.effectsUnrepresented = std::move(lacks);
    return run.records.emplace_back(std::move(r));
  };
  add("none", {"area-lights", "opaque-casters", "media"}).role = Role::Baseline;
  add("ShadowMap", {"area-lights", "media"});
  add("CSSM2", {"area-lights", "media"});
  add("PenumbraWedge", {"media"});
  const std::vector<std::string> expected = {
      "layers calls for area-lights, which CSSM2, ShadowMap do not show",
      "layers calls for media, which no cell here shows"};
  EXPECT_EQ(unshownEffects(run), expected);
  EXPECT_NE(toTable(run).find("warning: " + expected[0] + "\n"), std::string::npos);
}

TEST(Output, JsonIsExact) {
  const std::string json = toJson(sampleRun());
  EXPECT_EQ(json, expected("run.json", json));
}

TEST(Output, JsonOfCellsWithoutResultHasNoTimes) {
  int without = 0;
  const auto json = nlohmann::json::parse(toJson(sampleRun()));
  for (const auto& entry : json["benchmarks"]) {
    if (entry.value("status", "ok") == "ok") continue;
    ++without;
    EXPECT_TRUE(entry["error_occurred"]);
    for (const auto& [key, value] : entry.items()) {
      EXPECT_FALSE(key.find("time") != std::string::npos) << key;
      EXPECT_FALSE(key.ends_with("_ms")) << key;
    }
  }
  EXPECT_EQ(without, 2);
}

TEST(Output, JsonOfAbsentValuesIsNullWithAReason) {
  const auto json = nlohmann::json::parse(toJson(sampleRun()));
  for (const auto& entry : json["benchmarks"])
    for (const auto& [key, value] : entry.items())
      EXPECT_TRUE(!value.is_null() || entry.contains(key + "_why")) << entry["name"] << ' ' << key;
}

TEST(Output, CsvIsExact) {
  const std::string csv = toCsv(sampleRun());
  EXPECT_EQ(csv, expected("run.csv", csv));
}

TEST(Output, CsvReadsBack) {
  const auto rows = readCsv(toCsv(sampleRun()));
  ASSERT_EQ(rows.size(), 5u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  auto field = [&](size_t row, const std::string& name) {
    const auto column = std::ranges::find(rows[0], name);
    EXPECT_NE(column, rows[0].end()) << name;
    return rows[row][size_t(column - rows[0].begin())];
  };
  EXPECT_EQ(field(1, "name"), "ShadowMap/vulkan/layers/64x32");
  EXPECT_EQ(field(1, "device"), "llvmpipe, 256 bits");
  EXPECT_EQ(field(1, "driver"), "Mesa \"22\"");
  EXPECT_EQ(field(1, "seed"), "4294967295");
  EXPECT_EQ(field(1, "cpu_ms_cv"), "0.0625");
  EXPECT_EQ(field(1, "ratio_baseline_low"), "1.5");
  EXPECT_EQ(field(2, "cross_backend_over_1_255"), "17");
  EXPECT_EQ(field(3, "status"), "skipped");
  EXPECT_EQ(field(3, "draw_count"), "");
  EXPECT_EQ(field(4, "reason"), "3 values of the picture are not finite, or so");
  EXPECT_EQ(field(4, "frame_ms_median"), "");
}

// What a file calls its things can be a formula, or act on a terminal.
TEST(Output, TextsOfTablesDoNothing) {
  report::Run run = sampleRun();
  run.records.resize(1);
  Record& r = run.records.front();
  const std::pair<const char*, const char*> kTexts[] = {
      {"=1+1", "'=1+1"},         {"@SUM(A1)", "'@SUM(A1)"}, {"-cmd", "'-cmd"},
      {"+x", "'+x"},             {"-1.5", "-1.5"},          {"a=1", "a=1"},
      {"a\x1b[31m", "a\\x1b[31m"}, {"a\rb\tc", "a b c"}};
  for (const auto& [text, shown] : kTexts) {
    r.id.scene = text;
    const auto rows = readCsv(toCsv(run));
    const auto column = std::ranges::find(rows[0], "scene") - rows[0].begin();
    EXPECT_EQ(rows.at(1).at(size_t(column)), shown);
  }
}

TEST(Output, TextsThatAreNoUtf8CostNothing) {
  report::Run run = sampleRun();
  run.records.front().id.scene = "a\xff";
  run.records.front().warnings = {"material '\xc3'"};
  EXPECT_NE(toJson(run).find("\"scene\": \"a\xef\xbf\xbd\""), std::string::npos);
}

}  // namespace
}  // namespace report

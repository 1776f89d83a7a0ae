// Results read back: the same as written, old files, and what is said of files that are wrong.
#include "reports/json/json_read.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "reports/json/json.h"
#include "tests/reports/sample_run.h"

namespace report {
namespace {

using Json = nlohmann::ordered_json;

/// The sample with one change, as text.
std::string changed(const std::function<void(Json&)>& change) {
  Json json = Json::parse(toJson(sampleRun()));
  change(json);
  return json.dump();
}

/// The good cell's aggregate entry.
Json& good(Json& json) { return json["benchmarks"][2]; }

std::string complaint(const std::string& text) {
  try {
    fromJson(text, "a.json");
  } catch (const ReadError& e) {
    return e.what();
  }
  return "";
}

std::string complaint(const std::function<void(Json&)>& change) {
  return complaint(changed(change));
}

TEST(JsonRead, WhatIsReadIsWhatWasWritten) {
  const std::string text = toJson(sampleRun());
  EXPECT_EQ(toJson(fromJson(text, "a.json")), text);
}

TEST(JsonRead, ValuesArriveInTheirFields) {
  const auto run = fromJson(toJson(sampleRun()), "a.json");
  EXPECT_EQ(run.host, "host");
  EXPECT_EQ(run.loadAverage.size(), 3u);
  ASSERT_EQ(run.records.size(), 4u);
  const Record& r = run.records[0];
  EXPECT_EQ(r.name, "ShadowMap/vulkan/layers/64x32");
  EXPECT_EQ(r.id.seed, 4294967295u);
  EXPECT_EQ(r.blocks.size(), 2u);
  EXPECT_EQ(r.blocks[1].cpuMs, 4);
  EXPECT_EQ(r.cpu->q3, 5.5);
  EXPECT_EQ(r.ratios[1].against, "ShadowMap/opengl/layers/64x32");
  EXPECT_EQ(r.visibilityLayers[0].lightName, "sun <1>");
  EXPECT_EQ(r.certificate->regions[0].passes, 510u);
  EXPECT_EQ(r.blame->shares[4].first, "leaking");
  EXPECT_EQ(r.why.at("device_ms"), "plain frames carry no stamps");
  EXPECT_EQ(run.records[1].contamination.size(), 1u);
  EXPECT_EQ(run.records[2].status, Status::Skipped);
  EXPECT_FALSE(run.records[3].frame);
}

TEST(JsonRead, TheIdentityComesFromItsFields) {
  report::Run run = sampleRun();
  run.records.resize(2);
  Record& r = run.records[0];
  r.id.lights = "Clustered";
  r.id.transparency = "DepthPeeling";
  r.id.knobs = {{"size", "1024"}, {"kernel", "3"}};  // not in the order of the alphabet
  r.name = "what a name says decides nothing";
  r.knobs["format"] = "at its default";
  r.role = Role::Tracer;
  run.records[1].role = Role::Baseline;
  const auto back = fromJson(toJson(run), "a.json");
  ASSERT_EQ(back.records.size(), 2u);
  EXPECT_EQ(back.records[0].id, r.id);
  EXPECT_EQ(back.records[0].knobs, r.knobs);
  EXPECT_EQ(back.records[0].role, Role::Tracer);
  EXPECT_EQ(back.records[1].id, run.records[1].id);
  EXPECT_EQ(back.records[1].role, Role::Baseline);
}

TEST(JsonRead, OldFilesSayNeitherLoopNorRoleNorWhatWasChanged) {
  report::Run run = sampleRun();
  run.records.resize(2);
  run.records[0].ratios[0].against = run.records[1].name;
  run.records.push_back(run.records[0]);
  run.records[2].id.backend = "cpu";
  run.records[2].name = "RayTraced/cpu/layers/64x32";
  Json json = Json::parse(toJson(run));
  for (Json& e : json["benchmarks"])
    for (const char* key : {"lights", "role", "knobs_changed", "transparency"}) e.erase(key);
  const auto back = fromJson(json.dump(), "a.json").records;
  ASSERT_EQ(back.size(), 3u);
  EXPECT_EQ(back[0].id.lights, kDefaultLights);
  EXPECT_EQ(back[0].id.transparency, kDefaultTransparency);
  EXPECT_EQ(back[0].id.knobs, (decltype(back[0].id.knobs){{"kernel", "3"}, {"size", "1024"}}));
  EXPECT_EQ(back[0].role, Role::Technique);
  EXPECT_EQ(back[1].role, Role::Baseline);
  EXPECT_EQ(back[2].role, Role::Tracer);
}

TEST(JsonRead, OldFilesLackErrors) {
  const auto run =
      fromJson(changed([](Json& json) {
                 for (Json& e : json["benchmarks"])
                   for (const char* key : {"visibility", "visibility_layers", "visibility_regions",
                                           "image", "noise", "certificate", "blame",
                                           "truth_stderr", "pictures"})
                     e.erase(key);
               }),
               "a.json");
  const Record& r = run.records[0];
  EXPECT_FALSE(r.visibility || r.image || r.noise || r.certificate || r.blame || r.truthStderr);
  EXPECT_TRUE(r.visibilityLayers.empty() && r.visibilityRegions.empty() && r.pictures.empty());
  EXPECT_TRUE(r.cpu);
}

TEST(JsonRead, ComplaintsNameFileFieldFoundAndExpected) {
  EXPECT_EQ(complaint([](Json& j) { good(j)["frame_ms"]["median"] = "fast"; }),
            "a.json: benchmarks[2].frame_ms.median: found \"fast\", expected a number");
  EXPECT_EQ(complaint([](Json& j) { good(j).erase("technique"); }),
            "a.json: benchmarks[2].technique: found nothing, expected this key");
  EXPECT_EQ(
      complaint([](Json& j) { good(j)["status"] = "fine"; }),
      "a.json: benchmarks[2].status: found \"fine\", expected \"ok\", \"skipped\" or \"failed\"");
  EXPECT_EQ(complaint([](Json& j) { good(j)["role"] = "king"; }),
            "a.json: benchmarks[2].role: found \"king\", expected \"technique\", \"baseline\" or "
            "\"tracer\"");
  EXPECT_EQ(complaint([](Json& j) { good(j)["knobs_changed"] = Json::array({"taps"}); }),
            "a.json: benchmarks[2].knobs.taps: found nothing, expected this key");
  EXPECT_EQ(complaint([](Json& j) { good(j)["width"] = -1; }),
            "a.json: benchmarks[2].width: found -1, expected a whole number of 0 to 4294967295");
  EXPECT_EQ(
      complaint([](Json& j) { good(j)["seed"] = 4294967296; }),
      "a.json: benchmarks[2].seed: found 4294967296, expected a whole number of 0 to 4294967295");
  EXPECT_EQ(complaint([](Json& j) {
              good(j)["image"]["rmse_rgb"] = Json::array({1, 2});
            }),
            "a.json: benchmarks[2].image.rmse_rgb: found a list, expected three numbers");
  EXPECT_EQ(complaint([](Json& j) { good(j)["passes"] = 3; }),
            "a.json: benchmarks[2].passes: found 3, expected a list");
  EXPECT_EQ(complaint([](Json& j) { good(j)["bytes"] = 1.5; }),
            "a.json: benchmarks[2].bytes: found 1.5, expected a whole number of 0 to "
            "18446744073709551615");
  EXPECT_EQ(complaint([](Json& j) { j["benchmarks"] = nullptr; }),
            "a.json: benchmarks: found null, expected a list");
  EXPECT_EQ(complaint([](Json& j) { j["context"].erase("shadowbench_version"); }),
            "a.json: context.shadowbench_version: found nothing, expected this key");
  EXPECT_EQ(complaint("[]"), "a.json: found a list, expected an object");
}

TEST(JsonRead, BrokenTextIsToldByItsPlace) {
  EXPECT_EQ(complaint("{\n  \"a\": ,\n}"),
            "a.json: line 2, column 8: found no JSON, expected results");
  EXPECT_NE(complaint(""), "");
  EXPECT_NE(complaint("{\"context\": 1e999}"), "");
  EXPECT_NE(complaint("\xff\xfe"), "");
}

TEST(JsonRead, EveryTruncationIsRefused) {
  std::string text = toJson(sampleRun());
  text.pop_back();
  for (size_t length = 0; length < text.size(); length += 97)
    EXPECT_NE(complaint(text.substr(0, length)), "") << length;
}

/// Each value of the file, replaced by one of another kind: refused or read, never a crash.
TEST(JsonRead, NoReplacedValueEscapesAsAnotherException) {
  const Json sample = Json::parse(toJson(sampleRun()));
  const Json flat = sample.flatten();
  for (const auto& [path, value] : flat.items())
    for (const Json& other : {Json(nullptr), Json("text"), Json(-3), Json(1e300), Json::array({1}),
                              Json{{"a", 1}}, Json(true)}) {
      Json copy = sample;
      copy[Json::json_pointer(path)] = other;
      EXPECT_NO_THROW(complaint(copy.dump())) << path << " " << other.dump();
    }
}

}  // namespace
}  // namespace report

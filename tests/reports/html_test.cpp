// The page as text: escaping, pictures, policy, size. How it looks and acts: tests/report_page.
#include "reports/html/html.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "reports/html/elements/text.h"
#include "reports/picture.h"
#include "tests/reports/sample_run.h"

namespace report {
namespace {

namespace fs = std::filesystem;
using Results = report::Run;  // a test has a member Run

class Html : public testing::Test {
 protected:
  void SetUp() override {
    m_folder = fs::temp_directory_path() / ("report_test_" + std::to_string(getpid()));
    fs::create_directories(m_folder);
  }
  void TearDown() override { fs::remove_all(m_folder); }

  void write(const std::string& name, const std::string& content) const {
    std::ofstream(m_folder / name, std::ios::binary) << content;
  }
  std::string page(const Results& run) const { return toHtml(run, {.pictures = m_folder}); }

  fs::path m_folder;
};

size_t countOf(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// What stands before the scripts of Vega and of the page.
std::string markup(const std::string& page) { return page.substr(0, page.find("<script>")); }

std::string tinyPng() { return encodePng(1, 1, std::vector<uint8_t>{1, 2, 3}); }

TEST_F(Html, HostileTextStaysText) {
  const std::string bad = "</script><script>alert(1)</script><b>\"'&\u2028\xff";
  Results run = sampleRun();
  run.host = run.executable = run.version = run.date = run.buildType = bad;
  run.warnings = {bad};
  for (Record& r : run.records) {
    for (std::string* text :
         {&r.name, &r.id.technique, &r.id.transparency, &r.id.lights, &r.id.backend, &r.id.scene,
          &r.device, &r.deviceType, &r.driver, &r.stoppedBy, &r.reason, &r.command})
      *text = bad;
    r.id.knobs = {{bad, bad}};
    r.warnings = r.contamination = {bad};
    r.knobs = {{bad, bad}};
    r.bytesByLabel = {{bad, 1}};
    r.pictures = {{"image", bad}, {bad, bad}};
    if (r.blame) r.blame->shares = {{bad, 1}};
    for (PassRecord& p : r.passes) p.label = bad;
    for (LayerError& l : r.visibilityLayers) l.lightName = bad;
    for (Ratio& x : r.ratios) x.against = bad;
    for (auto& [key, why] : r.why) why = bad;
  }
  run.stability = {{.id = bad,
                    .title = bad,
                    .property = bad,
                    .reason = bad,
                    .technique = bad,
                    .backend = bad,
                    .parameter = bad,
                    .curve = {{1, 1, 0}, {2, 2, 0}},
                    .breaksAt = 1,
                    .verdict = Verdict::Fail,
                    .why = bad}};
  // As good again as the sample's first: points, and not only tables.
  run.records[0].contamination.clear();
  const std::string text = page(run);
  EXPECT_EQ(countOf(text, "alert(1)</script"), 0u);
  EXPECT_EQ(countOf(markup(text), "<b>"), 0u);
  EXPECT_EQ(countOf(text, "<script"), 3u);  // data, library, page
  EXPECT_EQ(countOf(text, "</script"), 3u);
  EXPECT_EQ(text.find('\xff'), std::string::npos);
  EXPECT_GT(countOf(markup(text), "&lt;script&gt;alert(1)"), 10u);
}

TEST_F(Html, AsksTheNetworkForNothing) {
  const std::string text = page(sampleRun());
  const std::string head = markup(text);
  EXPECT_NE(head.find("default-src 'none'; img-src data:;"), std::string::npos);
  EXPECT_EQ(countOf(head, "'sha256-"), 2u);
  EXPECT_EQ(head.find("unsafe-eval"), std::string::npos);
  for (const char* loader : {"src=\"http", "href=\"http", "url(", "@import", "src=\"//"})
    EXPECT_EQ(head.find(loader), std::string::npos) << loader;
  EXPECT_EQ(text.find("sourceMappingURL"), std::string::npos);
  EXPECT_EQ(head.find("{{"), std::string::npos);
}

TEST_F(Html, PixelsOfOneSideAloneStandBesideTheError) {
  Results run = sampleRun();
  VisibilityError& error = *run.records[0].visibility;
  error.oneSided = 47, error.oneSidedInterior = 5;
  const std::string text = page(run);
  EXPECT_NE(markup(text).find("One-sided px"), std::string::npos);
  EXPECT_NE(markup(text).find("5<small>42 at edges</small>"), std::string::npos);
  EXPECT_NE(text.find("5 away from edges, 42 at edges"), std::string::npos);
}

TEST_F(Html, HardCasesNameTheSceneThatTheyWereAskedOf) {
  Results run = sampleRun();
  run.stability = {{.id = "G1", .technique = "CSSM2", .backend = "vulkan", .scene = "a<b.glb",
                    .width = 96, .height = 64, .curve = {{1, 0, 0}}}};
  EXPECT_NE(page(run).find("Asked of a&lt;b.glb, 96×64."), std::string::npos);
  EXPECT_EQ(page(run).find("G1 a&lt;b.glb"), std::string::npos);
  run.stability.push_back(run.stability[0]);
  run.stability[1].scene = "layers";
  EXPECT_NE(page(run).find("G1 a&lt;b.glb"), std::string::npos);
  EXPECT_NE(page(run).find("G1 layers"), std::string::npos);
}

TEST_F(Html, WarnsFirst) {
  Results run = sampleRun();
  run.buildType = "debug";
  run.records[1].contamination = {"validation is on"};
  const std::string text = markup(page(run));
  const size_t facts = text.find("<dl class=\"facts\"");
  for (const char* warning : {"say nothing about graphics hardware", "Debug build",
                              "Validation was on", "<strong>1 cell failed</strong>: 3 values",
                              "<strong>1 cell skipped</strong>: the device lacks",
                              "1 cell contaminated", "no library", "ten warm-up windows"})
    EXPECT_LT(text.find(warning), facts) << warning;
}

TEST_F(Html, EachPictureIsEmbeddedOnce) {
  write("fedcba9876543210.png", tinyPng());
  write("00000000000000aa.png", tinyPng());
  const std::string text = page(sampleRun());
  EXPECT_EQ(countOf(text, "src=\"data:image/png;base64," + base64(tinyPng()) + "\""), 2u);
  EXPECT_EQ(text.find("missing in"), std::string::npos);
}

TEST_F(Html, MissingPicturesAreANote) {
  write("fedcba9876543210.png", "no PNG at all");
  const std::string text = page(sampleRun());
  EXPECT_EQ(text.find("base64,"), std::string::npos);
  EXPECT_NE(text.find("2 pictures are missing in " + m_folder.filename().string()),
            std::string::npos);
  EXPECT_NE(toHtml(sampleRun(), {}).find("made without a folder of pictures"), std::string::npos);
}

TEST_F(Html, LegendsHaveTheColoursGiven) {
  const std::string text = toHtml(sampleRun(), {.pictures = m_folder,
                                                .errorScale = {{0, 0, 4}, {255, 254, 253}},
                                                .causeColors = {{"leaking", {1, 2, 3}}}});
  EXPECT_NE(text.find("linear-gradient(to right,rgb(0,0,4),rgb(255,254,253))"), std::string::npos);
  EXPECT_NE(text.find("1/1024</span>"), std::string::npos);
  EXPECT_NE(text.find("background:rgb(1,2,3)\"></span>leaking"), std::string::npos);
}

TEST_F(Html, NamesThatAreNoHashesAreNotLookedFor) {
  fs::create_directories(m_folder / "sub");
  write("secret.png", tinyPng());
  write("sub/abc.png", tinyPng());
  for (const char* name : {"../secret", "secret", "sub/abc", "/etc/passwd", "", "abc.png"}) {
    Results run = sampleRun();
    for (Record& r : run.records) r.pictures = {{"image", name}};
    const std::string text = toHtml(run, {.pictures = m_folder / "sub"}) + page(run);
    EXPECT_EQ(text.find("base64," + base64(tinyPng())), std::string::npos) << name;
    EXPECT_NE(text.find("is no hash, and not looked for"), std::string::npos) << name;
  }
}

TEST_F(Html, RunsWithoutErrorsOrCellsAreWhole) {
  Results run = sampleRun();
  for (Record& r : run.records) r.visibility = {}, r.image = {};
  run.records[0].why["visibility"] = "no truth, \"here\"";
  EXPECT_NE(page(run).find("No plot of error over time: no truth, &quot;here&quot;."),
            std::string::npos);
  run.records.clear();
  EXPECT_NE(page(run).find("The run has no cells."), std::string::npos);
}

TEST_F(Html, TechniquesAreToldByAllThatDrawsThemAndTheBaselineIsGrey) {
  Results run = sampleRun();
  run.records.resize(2);
  run.records[0].role = Role::Baseline;
  run.records[1].id.lights = "Clustered";
  const std::string text = markup(page(run));
  EXPECT_NE(text.find("<span class=\"technique tn\">ShadowMap</span>"), std::string::npos);
  EXPECT_NE(text.find("<span class=\"technique t0\">ShadowMap@Clustered</span>"),
            std::string::npos);
  EXPECT_NE(text.find("data-technique=\"ShadowMap@Clustered\""), std::string::npos);
}

TEST_F(Html, HardCasesHaveVerdictsDetailsAndCurves) {
  Results run;
  StabilityRecord r{.id = "G2",
                    .title = "far <away>",
                    .property = "difference",
                    .reason = "rounding",
                    .technique = "CSSM2+Sorted",
                    .backend = "vulkan",
                    .parameter = "offset",
                    .curve = {{1, 0.25, 0.5}, {2, std::nan(""), 0.5}}};
  judge(r, "");
  run.stability = {r};
  r.backend = "opengl";
  r.curve = {{1, 0.25, 0.5}, {2, 0.75, 0.5}};
  judge(r, "by construction");
  run.stability.push_back(r);
  r.id = "G1";
  r.parameter = "";
  r.curve.resize(1);
  judge(r, "");
  run.stability.push_back(r);
  const std::string text = markup(page(run));
  EXPECT_EQ(text.find("The run has no cells."), std::string::npos);
  for (const char* part :
       {"3 hard cases: 1 ", "FAIL</span> 1/2", "far &lt;away&gt;", "no number at offset 2",
        "0.5: rounding", "by construction", "<dt>breaks at</dt><dd>offset 2</dd>",
        "href=\"#stability\"", "data-technique=\"CSSM2+Sorted\""})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(countOf(text, "class=\"lines\""), 1u);  // one configuration is no curve
  EXPECT_NE(text.find("\"points\":[[1.0,0.25]],\"limit\":[[1.0,0.5],[2.0,0.5]],\"breaksAt\":2.0"),
            std::string::npos);
}

TEST_F(Html, TheSameRunGivesTheSamePage) { EXPECT_EQ(page(sampleRun()), page(sampleRun())); }

/// As large as the quick suite's hardest picture (CSSM2 on spheres_quads, 74 kB): noise within a
/// lit disc, smooth elsewhere.
std::string noisyPng(uint32_t seed) {
  constexpr int kSize = 256;
  std::mt19937 random(seed);
  std::vector<uint8_t> rgb;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool lit = (x - 128) * (x - 128) + (y - 128) * (y - 128) < 86 * 86;
      for (int c = 0; c < 3; ++c)
        rgb.push_back(uint8_t(lit ? 120 + random() % 32 : unsigned(60 + y / 4)));
    }
  return encodePng(kSize, kSize, rgb);
}

TEST_F(Html, TheQuickSuiteStaysBelowTenMegabytes) {
  const Results sample = sampleRun();
  Results run = sample;
  run.records.clear();
  uint32_t picture = 0;
  for (int cell = 0; cell < 24; ++cell) {
    Record r = sample.records[0];
    r.id.scene = "scene" + std::to_string(cell % 4);
    r.id.width = r.id.height = 256;
    r.name = cellName(r.id);
    // The truth is the scene's.
    r.pictures["truth"] = "abc" + std::to_string(cell % 4);
    for (const char* role : {"image", "error", "blame"})
      r.pictures[role] = "def" + std::to_string(picture++);
    for (const auto& [role, hash] : r.pictures) {
      const std::string png = noisyPng(uint32_t(std::hash<std::string>()(hash)));
      ASSERT_GT(png.size(), 70u << 10);
      write(hash + ".png", png);
    }
    run.records.push_back(std::move(r));
  }
  const std::string text = page(run);
  EXPECT_EQ(text.find("missing in"), std::string::npos);
  EXPECT_LT(text.size(), 10'000'000u);
  // What is not pictures.
  EXPECT_LT(page(sample).size(), 700u << 10);
  RecordProperty("bytes", int(text.size()));
}

TEST_F(Html, PicturesLieBesideTheJson) {
  EXPECT_EQ(picturesBeside("a/results.json"), "a/results.pictures");
  EXPECT_EQ(picturesBeside("r"), "r.pictures");
}

}  // namespace
}  // namespace report

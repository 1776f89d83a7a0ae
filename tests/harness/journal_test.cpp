// A journal holds what was found, whole lines only, and goes on where it ended.
#include "suites/harness/journal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "suites/harness/cell.h"
#include "techniques/plan/error.h"
#include "tests/reports/sample_run.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

const CellId kA{.technique = "CSSM2",
                .lights = "Clustered",
                .backend = "vulkan",
                .scene = "layers",
                .knobs = {{"size", "512"}, {"kernel", "9"}},
                .seed = 7};
constexpr const char* kCell =
    "{\"technique\":\"a\",\"backend\":\"b\",\"scene\":\"c\",\"width\":1,\"height\":1}";

class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
  }
  ~JournalTest() override { fs::remove_all(m_folder); }

  static JournalHeader header() {
    return {.arguments = {"--scene", "layers"},
            .folder = "/somewhere",
            .program = "1 abc release",
            .settings = {{"budget", "3"}, {"seeds", "8"}},
            .scenes = {{"layers", "0123"}},
            .devices = {{"vulkan", "llvmpipe"}},
            .cells = {"a", "b"},
            .hardCases = {"G1/CSSM2/vulkan"}};
  }
  static SampleBlock block(double ms) {
    FrameResult f;
    f.wallMs = ms;
    f.cpuMs = 2 * ms;
    f.recordMs = 0.1;
    f.submitMs = 0.2;
    f.counters = {.passes = 2, .draws = 4, .dispatches = 1, .triangles = 12};
    FrameResult stamped = f;
    stamped.deviceMs = 0.7 * ms;
    return {{f, stamped}};
  }
  std::string text() const {
    std::ifstream in(m_path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }
  std::string errorOf() const {
    try {
      readJournal(m_path);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }

  const fs::path m_folder =
      fs::temp_directory_path() / ("journal-test-" + std::to_string(getpid()));
  const fs::path m_path = m_folder / "run.journal";
};

TEST_F(JournalTest, GivesBackWhatWasPut) {
  const report::Run run = report::sampleRun();
  {
    Journal journal(m_path, header());
    for (int i = 1; i <= 3; ++i) journal.block(kA, block(i / 3.0));
    for (const report::Record& r : run.records) journal.cell(r);
    for (const report::StabilityRecord& r : run.stability) journal.hardCase(r);
  }
  const JournalContent content = readJournal(m_path);
  EXPECT_TRUE(differences(content.header, header()).empty());
  EXPECT_EQ(content.header.arguments, header().arguments);
  EXPECT_FALSE(content.halfLine);
  EXPECT_EQ(content.wholeBytes, fs::file_size(m_path));
  ASSERT_EQ(content.blocks.at(kA).size(), 3u);
  const FrameResult& frame = content.blocks.at(kA)[1].frames[1];
  EXPECT_EQ(frame.wallMs, 2 / 3.0);  // to the last bit
  EXPECT_EQ(frame.counters, (rhi::Counters{.passes = 2, .draws = 4, .dispatches = 1, .triangles = 12}));
  EXPECT_EQ(frame.deviceMs, 0.7 * (2 / 3.0));
  EXPECT_FALSE(content.blocks.at(kA)[1].frames[0].deviceMs);
  ASSERT_EQ(content.cells.size(), run.records.size());
  for (const report::Record& r : run.records) {
    const report::Record& back = content.cells.at(r.id);
    EXPECT_EQ(back.status, r.status);
    EXPECT_EQ(back.blocks.size(), r.blocks.size());
    EXPECT_EQ(back.command, r.command);
    // The results say nothing of what a cell that did not run lacks.
    if (r.status == report::Status::Ok) EXPECT_EQ(back.why.size() > 0, r.why.size() > 0);
  }
  EXPECT_EQ(content.hardCases.size(), run.stability.size());
}

TEST_F(JournalTest, TheLastLineOfACellCounts) {
  report::Record r = report::sampleRun().records.front();
  {
    Journal journal(m_path, header());
    r.warnings = {"first"};
    journal.cell(r);
    r.warnings = {"second"};
    journal.cell(r);
  }
  EXPECT_EQ(readJournal(m_path).cells.at(r.id).warnings, std::vector<std::string>{"second"});
}

// Names of files need not be UTF-8, which lines of JSON are.
TEST_F(JournalTest, CellsOfAnyFileFindTheirBlocks) {
  CellId cell = kA;
  cell.scene = "a\xff\x1b[31m.glb";
  { Journal(m_path, header()).block(recordedId(cell), block(1)); }
  EXPECT_TRUE(readJournal(m_path).blocks.contains(recordedId(cell)));
  EXPECT_EQ(cellName(recordedId(cell)), cellName(cell));
}

TEST_F(JournalTest, OneRunAtATimeWritesIt) {
  EXPECT_FALSE(isJournalInUse(m_path));
  {
    Journal journal(m_path, header());
    journal.block(kA, block(1));
    EXPECT_TRUE(isJournalInUse(m_path));
    const std::string before = text();
    EXPECT_THROW(Journal(m_path, header()), InputError);
    EXPECT_THROW(Journal(m_path, readJournal(m_path)), InputError);
    EXPECT_EQ(text(), before);
    EXPECT_TRUE(isJournalInUse(m_path));
  }
  EXPECT_FALSE(isJournalInUse(m_path));
  EXPECT_NO_THROW(Journal(m_path, readJournal(m_path)));
}

// At every byte that a kill may leave as the last one.
TEST_F(JournalTest, ALineThatWasCutOffIsLeftOutAndWrittenOver) {
  {
    Journal journal(m_path, header());
    journal.block(kA, block(1));
    journal.block(kA, block(2));
  }
  const std::string whole = text();
  const size_t lastLine = whole.rfind('\n', whole.size() - 2) + 1;
  for (size_t size = lastLine; size < whole.size(); ++size) {
    std::ofstream(m_path, std::ios::binary) << whole.substr(0, size);
    const JournalContent content = readJournal(m_path);
    ASSERT_EQ(content.halfLine, size > lastLine) << size;
    ASSERT_EQ(content.wholeBytes, lastLine);
    ASSERT_EQ(content.blocks.at(kA).size(), 1u);
    Journal(m_path, content).block(kA, block(2));
    ASSERT_EQ(text(), whole);
  }
}

TEST_F(JournalTest, WhatIsNoJournalIsRefused) {
  EXPECT_NE(errorOf().find("found no journal"), std::string::npos);
  const std::string first =
      "{\"journal\":2,\"arguments\":[],\"folder\":\"\",\"program\":\"\","
      "\"settings\":{},\"scenes\":{},\"devices\":{},\"cells\":[],"
      "\"hard_cases\":[]}\n";
  const std::pair<std::string, std::string> kWrong[] = {
      {"", "holds nothing"},
      {"{}", "holds nothing"},
      {"{}\n", "run.journal:1: journal: found nothing"},
      {"{\"journal\":1}\n", "run.journal:1: journal: found 1"},
      {first + "x\n" + first, "run.journal:2: found no JSON"},
      {first + "{\"cell\":[]}\n", "run.journal:2: cell"},
      {first + "{\"block\":{\"cell\":" + std::string(kCell) + ",\"frames\":[[1]]}}\n",
       "nine numbers"},
      {first + "{\"block\":{\"cell\":\"a\",\"frames\":[]}}\n", "run.journal:2: block.cell"},
      {first + "{\"other\":1}\n", "run.journal:2"},
  };
  for (const auto& [content, words] : kWrong) {
    std::ofstream(m_path, std::ios::binary) << content;
    EXPECT_NE(errorOf().find(words), std::string::npos) << content << "\n" << errorOf();
  }
}

TEST_F(JournalTest, AnotherRunIsToldByWhatDiffers) {
  const auto first = [](const JournalHeader& here) {
    const auto list = differences(header(), here);
    return list.empty() ? "" : list.front();
  };
  JournalHeader other = header();
  EXPECT_EQ(first(other), "");
  other.arguments = {"in other words"};
  other.folder = "/elsewhere";
  EXPECT_EQ(first(other), "");
  other.settings["budget"] = "1";
  EXPECT_EQ(first(other), "setting budget: 3 there, 1 here");
  other = header();
  other.scenes["layers"] = "4567";
  EXPECT_EQ(first(other), "scene layers: 0123 there, 4567 here");
  other = header();
  other.devices.clear();
  EXPECT_EQ(first(other), "device of vulkan: llvmpipe there, nothing here");
  other = header();
  other.cells = {"a"};
  EXPECT_EQ(first(other), "cell b: only there");
  other.cells = {"a", "b", "c"};
  EXPECT_EQ(first(other), "cell c: only here");
  other = header();
  other.program = "2";
  EXPECT_EQ(first(other), "program: 1 abc release there, 2 here");
}

TEST_F(JournalTest, AFullDiskIsSaidAndTheRunGoesOn) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(Journal("/dev/full", header()), InputError);
  EXPECT_THROW(Journal(m_folder / "no" / "run.journal", header()), InputError);
}

}  // namespace
}  // namespace sb

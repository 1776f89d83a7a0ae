// Truths on disk: what was written is read, and nothing else is.
#include "suites/truth/truth_cache.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/tracer.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

class TruthCache : public testing::Test {
 protected:
  TruthCache() {
    fs::create_directories(m_folder);
    const Scene scene = makeScene("layers");
    m_truth = *Tracer(scene, 16, 8).trace({.width = 16, .height = 8});
  }
  ~TruthCache() override { fs::remove_all(m_folder); }

  std::string bytes() const {
    std::ostringstream text;
    text << std::ifstream(file(), std::ios::binary).rdbuf();
    return text.str();
  }
  void write(const std::string& content) const {
    std::ofstream(file(), std::ios::binary) << content;
  }
  fs::path file() const { return m_folder / (m_key + ".truth"); }

  const fs::path m_folder =
      fs::temp_directory_path() / ("truth_cache_test." + std::to_string(getpid()));
  const std::string m_key = truthKey("0123", 16, 8);
  Truth m_truth;
};

TEST_F(TruthCache, GivesBackWhatWasWritten) {
  EXPECT_FALSE(readTruth(m_folder, m_key));
  ASSERT_TRUE(writeTruth(m_folder, m_key, m_truth));
  const auto t = readTruth(m_folder, m_key);
  ASSERT_TRUE(t);
  EXPECT_EQ(t->width, 16u);
  EXPECT_EQ(t->visibility, m_truth.visibility);
  EXPECT_EQ(t->edges, m_truth.edges);
  EXPECT_EQ(t->surfaces, m_truth.surfaces);
  EXPECT_EQ(t->image, m_truth.image);
  EXPECT_EQ(t->imageEdges, m_truth.imageEdges);
  EXPECT_EQ(t->rays, m_truth.rays);
}

TEST_F(TruthCache, LayersWithinMediaAreKept) {
  const size_t without = writeTruth(m_folder, m_key, m_truth) ? bytes().size() : 0;
  EXPECT_TRUE(readTruth(m_folder, m_key)->mediaVisibility.empty());
  const size_t pixels = 16 * 8, lights = m_truth.visibility.size() / kTruthLayers;
  m_truth.mediaVisibility.assign(lights, std::vector<float>(4 * pixels, 0.25f));
  m_truth.mediaEdges.assign(lights, std::vector<uint8_t>(pixels, 1));
  ASSERT_TRUE(writeTruth(m_folder, m_key, m_truth));
  EXPECT_EQ(bytes().size(), without + 2 * 8 + lights * (2 * 8 + 17 * pixels));
  const auto t = readTruth(m_folder, m_key);
  ASSERT_TRUE(t);
  EXPECT_EQ(t->mediaVisibility, m_truth.mediaVisibility);
  EXPECT_EQ(t->mediaEdges, m_truth.mediaEdges);
  m_truth.mediaEdges.pop_back();
  ASSERT_TRUE(writeTruth(m_folder, m_key, m_truth));
  EXPECT_FALSE(readTruth(m_folder, m_key));
}

TEST_F(TruthCache, ReadsNothingThatIsDamagedOrOfAnotherKey) {
  ASSERT_TRUE(writeTruth(m_folder, m_key, m_truth));
  const std::string whole = bytes();
  for (int eighth = 0; eighth < 8; ++eighth) {
    write(whole.substr(0, whole.size() * size_t(eighth) / 8));
    EXPECT_FALSE(readTruth(m_folder, m_key)) << eighth << " eighths";
  }
  for (const size_t at : {size_t(0), size_t(9), size_t(20), whole.size() / 2, whole.size() - 1}) {
    std::string flipped = whole;
    flipped[at] = char(flipped[at] ^ 1);
    write(flipped);
    EXPECT_FALSE(readTruth(m_folder, m_key)) << "byte " << at;
  }
  write(whole + "x");
  EXPECT_FALSE(readTruth(m_folder, m_key));
  write(whole);
  EXPECT_TRUE(readTruth(m_folder, m_key));
  // Another truth's file under this name.
  fs::copy_file(file(), m_folder / (truthKey("0124", 16, 8) + ".truth"));
  EXPECT_FALSE(readTruth(m_folder, truthKey("0124", 16, 8)));
  EXPECT_NE(truthKey("0123", 16, 8), truthKey("0123", 8, 16));
}

TEST_F(TruthCache, WritersDoNotDisturbEachOther) {
  std::vector<std::thread> threads;
  std::atomic<int> broken = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int n = 0; n < 50; ++n) {
        if (!writeTruth(m_folder, m_key, m_truth)) ++broken;
        if (!readTruth(m_folder, m_key)) ++broken;
      }
    });
  for (auto& t : threads) t.join();
  EXPECT_EQ(broken, 0);
  EXPECT_EQ(cacheUse(m_folder).files, 1u);
}

TEST_F(TruthCache, ClearingRemovesOwnFilesAlone) {
  ASSERT_TRUE(writeTruth(m_folder, m_key, m_truth));
  std::ofstream(m_folder / (m_key + ".truth.99-0")) << "left by a killed process";
  std::ofstream(m_folder / "notes.txt") << "not ours";
  EXPECT_EQ(clearCache(m_folder).files, 2u);
  EXPECT_EQ(cacheUse(m_folder).files, 0u);
  EXPECT_TRUE(fs::exists(m_folder / "notes.txt"));
  EXPECT_EQ(clearCache(m_folder / "none").files, 0u);
  EXPECT_FALSE(writeTruth("/proc/no/such", m_key, m_truth));
}

}  // namespace
}  // namespace sb

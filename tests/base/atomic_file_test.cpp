// Files are whole or not there.
#include "base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace report {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "atomic-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
  }
  void TearDown() override { fs::remove_all(m_folder); }
  static std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  size_t files() const {
    return size_t(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
  }
  fs::path m_folder;
};

TEST_F(AtomicFile, ReplacesAndLeavesNothingElse) {
  base::writeAtomically(m_folder / "a", "first, which is longer");
  base::writeAtomically(m_folder / "a", "second");
  EXPECT_EQ(textOf(m_folder / "a"), "second");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, AFailureNamesThePathAndLeavesNothing) {
  const fs::path bad = m_folder / "none" / "a";
  EXPECT_NE(base::whyNotWritable(bad), "");
  try {
    base::writeAtomically(bad, "x");
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(bad.string()), std::string::npos) << e.what();
  }
  EXPECT_NE(base::whyNotWritable(m_folder), "") << "a folder";
  EXPECT_THROW(base::writeAtomically(m_folder, "x"), std::runtime_error);
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFile, AskingLeavesWhatIsThereAlone) {
  base::writeAtomically(m_folder / "a", "kept");
  EXPECT_EQ(base::whyNotWritable(m_folder / "a"), "");
  EXPECT_EQ(base::whyNotWritable(m_folder / "b"), "");
  EXPECT_EQ(textOf(m_folder / "a"), "kept");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFile, ALinkStaysALink) {
  base::writeAtomically(m_folder / "a", "old");
  fs::create_symlink("a", m_folder / "link");
  base::writeAtomically(m_folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(m_folder / "link"));
  EXPECT_EQ(textOf(m_folder / "a"), "new");
}

TEST_F(AtomicFile, ADeviceStaysADevice) {
  base::writeAtomically("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(base::isSpecialFile("/dev/null"));
  EXPECT_FALSE(base::isSpecialFile(m_folder / "a"));
}

}  // namespace
}  // namespace report

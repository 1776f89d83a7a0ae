// What reaches a terminal, a table or a shell cannot act there.
#include "base/text.h"

#include <gtest/gtest.h>

namespace base {
namespace {

TEST(Text, ControlCharactersAreWritten) {
  EXPECT_EQ(printable("a\x1b[31mb\nc\x7f"), "a\\x1b[31mb\\x0ac\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac"), "caf\xc3\xa9 \xe2\x82\xac");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");              // CSI as one character
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae");  // right to left override
  EXPECT_EQ(printable("\xff\xc0\x80\xed\xa0\x80"), "\\xff\\xc0\\x80\\xed\\xa0\\x80");
  EXPECT_TRUE(isUtf8("\xf0\x9f\x98\x80"));
  EXPECT_FALSE(isUtf8("\xf0\x9f\x98"));
}

TEST(Text, ErrorsStayShort) {
  const std::string line = errorLine("file.gltf: " + std::string(100000, 'x') + ", expected y");
  EXPECT_LE(line.size(), kErrorLine);
  EXPECT_TRUE(line.starts_with("file.gltf: x"));
  EXPECT_TRUE(line.ends_with("x, expected y"));
  EXPECT_EQ(errorLine("short"), "short");
  std::string accents;
  for (int i = 0; i < 400; ++i) accents += "\xc3\xa9";
  EXPECT_TRUE(isUtf8(errorLine(accents)));
  EXPECT_TRUE(isUtf8(errorLine("a" + accents)));
  EXPECT_LE(errorLine(accents).size(), kErrorLine);
}

TEST(Text, ShellWords) {
  EXPECT_EQ(shellWord("layers:gap=0.5"), "layers:gap=0.5");
  EXPECT_EQ(shellWord("layers?*:alpha=0.5"), "'layers?*:alpha=0.5'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("a\x1b'\\b"), "$'a\\x1b\\'\\\\b'");
  EXPECT_EQ(shellWord("a{b,c}!"), "'a{b,c}!'");
}

}  // namespace
}  // namespace base

// What reaches a terminal, a table or a shell cannot act there.
#include "base/text.h"

#include <gtest/gtest.h>

#include "base/percent.h"

namespace base {
namespace {

TEST(Text, ControlCharactersAreWritten) {
  EXPECT_EQ(printable("a\x1b[31mb\nc\x7f"), "a\\x1b[31mb\\x0ac\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac"), "caf\xc3\xa9 \xe2\x82\xac");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");           // CSI as one character
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

TEST(Text, BothEndsOfAShortenedTextStay) {
  EXPECT_EQ(shortened("abcdefghij", 7), "ab...ij");
  EXPECT_EQ(shortened("abcdefghij", 10), "abcdefghij");
  EXPECT_EQ(shortened("abcdefghij", 2), "..");
  const std::string five = "\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9";
  EXPECT_EQ(shortened(five, 8), "\xc3\xa9...\xc3\xa9");  // cuts the tail's first character
  EXPECT_EQ(shortened(five, 6), "...\xc3\xa9");          // and the head's last
}

TEST(Text, Percent) {
  const std::string odd = "a;b,c=d?e:%\xff Z-_.9";
  EXPECT_EQ(percentEncoded(odd), "a%3Bb%2Cc%3Dd%3Fe%3A%25%FF%20Z-_.9");
  EXPECT_EQ(percentDecoded(percentEncoded(odd)), odd);
  EXPECT_EQ(percentDecoded("%2e%2E%c3"), "..\xc3");
  for (const char* broken : {"%", "a%4", "%4g", "%-1", "%+1", "% 1", "%%41"})
    EXPECT_FALSE(percentDecoded(broken)) << broken;
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

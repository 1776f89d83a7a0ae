// Text, data and figures as they stand in the page.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/html/elements/text.h"

namespace report {
namespace {

TEST(HtmlText, EscapesTextAndScriptData) {
  EXPECT_EQ(escaped("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
  EXPECT_EQ(escaped("\u2028\u00e4"), "\u2028\u00e4");
  EXPECT_EQ(escaped(std::string("a\0b\x1b", 4)), "a\uFFFDb\uFFFD");
  EXPECT_EQ(escaped("\xc3(\xff\xe2\x82"), "\uFFFD(\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escaped("\xed\xa0\x80\xc0\xaf"), "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(scriptJson("</script><!--\u2028&\xff"),
            "\"\\u003c/script\\u003e\\u003c!--\\u2028\\u0026\\ufffd\"");
}

TEST(HtmlText, EncodesBase64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
  EXPECT_EQ(base64OfHex("00ff10"), "AP8Q");
}

TEST(HtmlText, FormatsFigures) {
  EXPECT_EQ(figure(0.0), "0");
  EXPECT_EQ(figure(1234.5), "1234");
  EXPECT_EQ(figure(99.96), "100");
  EXPECT_EQ(figure(12.345), "12.3");
  EXPECT_EQ(figure(0.000123), "0.000123");
  EXPECT_EQ(figure(0.0000123), "1.2e-5");
  EXPECT_EQ(figure(-1e-6), "-1e-6");
  EXPECT_EQ(figure(-0.5), "-0.5");
}

}  // namespace
}  // namespace report

#include "lib/base/codec/base64.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::base64_test {

std::vector<uint8_t> Bytes(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Base64, WritesTheExamplesOfTheStandard) {
  EXPECT_EQ(Base64({}), "");
  EXPECT_EQ(Base64(Bytes("f")), "Zg==");
  EXPECT_EQ(Base64(Bytes("fo")), "Zm8=");
  EXPECT_EQ(Base64(Bytes("foo")), "Zm9v");
  EXPECT_EQ(Base64(Bytes("foob")), "Zm9vYg==");
  EXPECT_EQ(Base64(Bytes("fooba")), "Zm9vYmE=");
  EXPECT_EQ(Base64(Bytes("foobar")), "Zm9vYmFy");
  EXPECT_EQ(Base64(std::vector<uint8_t>{0xFB, 0xFF, 0xBF}), "+/+/");
}

TEST(DecodeBase64, NeedsNoPadding) {
  EXPECT_EQ(DecodeBase64("Zg"), Bytes("f"));
  EXPECT_EQ(DecodeBase64("Zm8"), Bytes("fo"));
  EXPECT_EQ(DecodeBase64(""), Bytes(""));
}

TEST(DecodeBase64, RefusesWhatIsNoBase64) {
  for (const char* text :
       {"=", "==", "====", "Z", "Z===", "Zg=", "Zg===", "Zm9v=", "Zm9v==", "Zm8==", "Z=g=",
        "Zg==Zg==", "Zm 9v", "Zm9v\r", "Zm9v\n", "Zm-_", "Zm9v\x80", "Zm9vA"}) {
    EXPECT_FALSE(DecodeBase64(text)) << text;
  }
  EXPECT_FALSE(DecodeBase64(std::string_view("Zm9\0", 4)));
}

TEST(DecodeBase64, RefusesBitsThatBelongToNoByte) {
  EXPECT_FALSE(DecodeBase64("Zh=="));
  EXPECT_FALSE(DecodeBase64("Zm9"));
}

RC_GTEST_PROP(DecodeBase64, ReadsWhatBase64Writes, (const std::vector<uint8_t>& bytes)) {
  std::string text = Base64(bytes);
  RC_ASSERT(text.size() == (bytes.size() + 2) / 3 * 4);
  RC_ASSERT(DecodeBase64(text) == bytes);
  text.erase(std::min(text.find('='), text.size()));
  RC_ASSERT(DecodeBase64(text) == bytes);
}

RC_GTEST_PROP(DecodeBase64, TakesNoTextThatMeansWhatAnotherMeans, (const std::string& text)) {
  const auto bytes = DecodeBase64(text);
  if (bytes) RC_ASSERT(Base64(*bytes).substr(0, text.size()) == text);
}

}  // namespace shoal::base64_test

#include "lib/sea/modem/sentence_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::sentence_text_test {

TEST(SentenceText, WritesNumbersInTheirWidth) {
  EXPECT_EQ(FixedText(0.4, 4), "0.4000");
  EXPECT_EQ(FixedText(1e300, 1).size(), 303U);
}

TEST(SentenceText, KeepsEmptyFieldsInTheirPlaces) {
  const std::vector<std::string> fields = {"", "1", ""};
  EXPECT_EQ(JoinFields(fields), ",1,");
}

TEST(SentenceText, ReadsDigitsAndNothingElse) {
  EXPECT_EQ(ParseDigits("007"), 7);
  EXPECT_EQ(ParseDigits("999999999"), 999'999'999);
  for (const char* text : {"", "-1", "+1", " 1", "1.0", "1234567890", "0x1"}) {
    EXPECT_FALSE(ParseDigits(text)) << text;
  }
}

TEST(Hex, IsReadInPairsOfEitherCase) {
  EXPECT_EQ(ParseHex("00fFAb"), (std::vector<uint8_t>{0, 0xFF, 0xAB}));
  EXPECT_EQ(ParseHex(""), std::vector<uint8_t>{});
  for (const char* text : {"0", "0g", "g0", "0 ", "@0"}) EXPECT_FALSE(ParseHex(text)) << text;
}

RC_GTEST_PROP(HexProperty, ComesBackAsItWas, (const std::vector<uint8_t>& bytes)) {
  RC_ASSERT(ParseHex(HexText(bytes)) == bytes);
}

}  // namespace shoal::sentence_text_test

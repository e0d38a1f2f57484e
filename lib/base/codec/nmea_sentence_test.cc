#include "lib/base/codec/nmea_sentence.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::nmea_sentence_test {

using Fields = std::vector<std::string>;

constexpr std::string_view kRecordedBody =
    "GPRMC,021931.532997,A,4130.0000,N,07030.0000,W,2.9,90.0,211126,000.0,E";

TEST(NmeaSentence, HasTheChecksumOfARecordedSentence) {
  EXPECT_EQ(NmeaSentence(kRecordedBody), "$" + std::string(kRecordedBody) + "*76\r\n");
}

TEST(NmeaSentence, WritesTheChecksumInTwoUpperCaseDigits) {
  EXPECT_EQ(NmeaSentence("A,A,"), "$A,A,*00\r\n");
  EXPECT_EQ(NmeaSentence("CN@"), "$CN@*4D\r\n");
}

TEST(ParseNmea, KeepsEmptyFields) {
  const auto sentence = ParseNmea("$CARDP,1,,2,");
  ASSERT_TRUE(sentence);
  EXPECT_EQ(sentence->address, "CARDP");
  EXPECT_EQ(sentence->fields, (Fields{"1", "", "2", ""}));
  EXPECT_FALSE(sentence->has_checksum);
}

TEST(ParseNmea, HasNoFieldsWhereThereIsNoComma) {
  const auto sentence = ParseNmea("$CCPST");
  ASSERT_TRUE(sentence);
  EXPECT_EQ(sentence->address, "CCPST");
  EXPECT_TRUE(sentence->fields.empty());
}

TEST(ParseNmea, TakesAnySortOfEnd) {
  for (const std::string end : {"", "\r", "\n", "\r\n"}) {
    const auto sentence = ParseNmea("$CN@*4D" + end);
    ASSERT_TRUE(sentence);
    EXPECT_TRUE(sentence->has_checksum);
    EXPECT_TRUE(ParseNmea("$CN@" + end));
  }
}

TEST(ParseNmea, TakesAChecksumOfSmallLetters) { EXPECT_TRUE(ParseNmea("$CN@*4d")); }

TEST(ParseNmea, RefusesWhatIsNoSentence) {
  for (const char* line : {"", "$", "$*00", "$,1", "CN@*4D", " $CN@", "$CN@*4E", "$CN@*4", "$CN@*",
                           "$CN@*4D0", "$CN@*4D*4D", "$CN@*4D ", "$CN@$CN@", "$C\tN", "$CN\x80",
                           "$CN\rCN", "$CN@\r\r\n", "$CN@\n\r"}) {
    EXPECT_FALSE(ParseNmea(line)) << line;
  }
  EXPECT_FALSE(ParseNmea(std::string_view("$C\0", 3)));
}

RC_GTEST_PROP(ParseNmea, ReadsWhatNmeaSentenceWrites, ()) {
  const auto letter = rc::gen::elementOf(std::string("AZaz09 .;-+~"));
  const std::string address = *rc::gen::nonEmpty(rc::gen::container<std::string>(letter));
  const auto fields = *rc::gen::container<Fields>(rc::gen::container<std::string>(letter));
  std::string body = address;
  for (const std::string& field : fields) body += "," + field;
  const auto sentence = ParseNmea(NmeaSentence(body));
  RC_ASSERT(sentence.has_value());
  RC_ASSERT(sentence->address == address);
  RC_ASSERT(sentence->fields == fields);
  RC_ASSERT(sentence->has_checksum);
}

RC_GTEST_PROP(ParseNmea, FindsEveryWrongBit, ()) {
  std::string line = "$CACYC,0,1,2,0,1,3*5A";
  RC_ASSERT(ParseNmea(line).has_value());
  const auto bit = *rc::gen::inRange<size_t>(8, 8 * (line.size() - 3));
  line[bit / 8] = static_cast<char>(line[bit / 8] ^ (1 << (bit % 8)));
  RC_ASSERT(!ParseNmea(line).has_value());
}

}  // namespace shoal::nmea_sentence_test

#include "lib/mission/toml/suggest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

namespace shoal::suggest_test {

constexpr std::array<std::string_view, 4> kKeys = {"speed_mps", "comms_range", "stale_time",
                                                   "stale_forget_s"};

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndExchanges) {
  EXPECT_EQ(EditDistance("", ""), 0);
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("speed", "sped"), 1);
  EXPECT_EQ(EditDistance("speed", "spead"), 1);
  EXPECT_EQ(EditDistance("speed", "pseed"), 1);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
}

RC_GTEST_PROP(EditDistance, IsTheSameInBothDirectionsAndZeroOnlyForEqualWords,
              (const std::string& a, const std::string& b)) {
  RC_ASSERT(EditDistance(a, b) == EditDistance(b, a));
  RC_ASSERT((EditDistance(a, b) == 0) == (a == b));
}

TEST(Suggest, FindsAKeyByPartOfIt) {
  EXPECT_EQ(Suggest("sped", kKeys), "speed_mps");
  EXPECT_EQ(Suggest("range", kKeys), "comms_range");
  EXPECT_EQ(Suggest("comm_range", kKeys), "comms_range");
  EXPECT_EQ(Suggest("stale_forget", kKeys), "stale_forget_s");
}

TEST(Suggest, IgnoresCase) { EXPECT_EQ(Suggest("SPEED_MPS", kKeys), "speed_mps"); }

TEST(Suggest, FindsNothingForAnotherWord) {
  EXPECT_EQ(Suggest("colour", kKeys), "");
  EXPECT_EQ(Suggest("", kKeys), "");
  EXPECT_EQ(Suggest("x", kKeys), "");
  EXPECT_EQ(Suggest(std::string(1'000'000, 's'), kKeys), "");
}

TEST(Quoted, ShortensAndDropsControlCharacters) {
  EXPECT_EQ(Quoted("a\x1b[31mb\n"), "'a?[31mb?'");
  EXPECT_EQ(Quoted("a\xc2\x9b"
                   "2J\xe2\x80\xae"),
            "'a" + std::string(2, '?') + "2J" + std::string(3, '?') + "'")
      << "C1 as UTF-8 has it, and a turn of direction";
  EXPECT_EQ(Quoted(std::string(1000, 'a')), "'" + std::string(60, 'a') + "...'");
}

TEST(Quoted, DoesNotCutAnUtf8CharacterInTwo) {
  EXPECT_EQ(Quoted(std::string(59, 'a') + "\xC3\xA9" + "bcd"),
            "'" + std::string(59, 'a') + "\xC3\xA9" + "...'");
}

}  // namespace shoal::suggest_test

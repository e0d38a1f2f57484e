#include "lib/run/verdict/mission_verdict.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/run/verdict/expectation_text.h"

namespace shoal::mission_verdict_test {

TEST(MissionVerdict, IsReadAsItWasWritten) {
  const MissionVerdict verdict{.result = "FAIL",
                               .why = "1 of 2 expectations missed",
                               .end_s = 600.5,
                               .lines = {{.passed = true,
                                          .value = 7.25,
                                          .unit = "m",
                                          .margin = -2.25,
                                          .where = "a.toml:9",
                                          .text = "no two closer",
                                          .numbers = "closest: 7.2 m"},
                                         {.passed = false, .text = "there", .numbers = "never"}}};
  EXPECT_EQ(ReadVerdict(TextOf(verdict)), verdict);
}

TEST(MissionVerdict, KeepsALineWhole) {
  const MissionVerdict verdict{.result = "PASS", .lines = {{.text = "a\tb\nresult\tFAIL"}}};
  const auto read = ReadVerdict(TextOf(verdict));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->result, "PASS");
  EXPECT_EQ(read->lines.at(0).text, "a b result FAIL");
}

TEST(MissionVerdict, IsNotReadFromOtherText) {
  for (const char* text : {"", "\n\n", "result\tMAYBE\n", "result", "expectation\tpass\n"}) {
    EXPECT_EQ(ReadVerdict(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(MissionVerdict, IsReadFromAnythingWithoutHarm, (std::string text)) {
  (void)ReadVerdict("result\tPASS\n" + text);
}

TEST(MarginOf, IsTheWayToTheNearerLimit) {
  Mission mission;
  mission.duration_s = 600;
  const auto margin = [&](const auto& what, double value) {
    return MarginOf(mission, {.where = "", .what = what}, value);
  };
  EXPECT_EQ(margin(SeparationExpectation{.min_m = 5}, 7), 2);
  EXPECT_EQ(margin(SeparationExpectation{.min_m = 5}, 4), -1);
  EXPECT_EQ(margin(ArrivalExpectation{}, 590), 10) << "by the end of the mission";
  EXPECT_EQ(margin(TrackExpectation{.vehicle = "a", .max_m = 3}, 1), 2);
  EXPECT_EQ(margin(DistanceExpectation{.vehicle = "a", .to = "b", .min_m = 10, .max_m = 30}, 27),
            3);
  EXPECT_EQ(margin(CommsExpectation{.at_least = 10}, 8), -2);
  EXPECT_EQ(margin(CommsExpectation{.at_most_pct = 50.0}, 20), 30);
  EXPECT_EQ(margin(HelmExpectation{}, 1), std::nullopt) << "it is met or not";
  EXPECT_EQ(MarginOf(mission, {.where = "", .what = SeparationExpectation{}}, std::nullopt),
            std::nullopt);
}

}  // namespace shoal::mission_verdict_test

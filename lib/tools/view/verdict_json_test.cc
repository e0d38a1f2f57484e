#include "lib/tools/view/verdict_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace shoal::verdict_json_test {

using nlohmann::json;

TEST(VerdictJson, HasEveryExpectationWithItsNumberAndItsMargin) {
  const MissionVerdict verdict{
      .result = "FAIL",
      .why = "1 of 2 expectations missed",
      .end_s = 600,
      .lines = {{.passed = true,
                 .value = 7.25,
                 .unit = "m",
                 .margin = 2.25,
                 .where = "a.toml:9",
                 .text = "no two vehicles closer than 5 m",
                 .numbers = "closest: 7.2 m"},
                {.passed = false, .text = "alpha </script>", .numbers = "never"}}};
  const json answer = json::parse(VerdictJson(verdict))["verdict"];
  EXPECT_EQ(answer["result"], "FAIL");
  EXPECT_EQ(answer["t"], 600);
  EXPECT_EQ(answer["expectations"][0]["margin"], 2.25);
  EXPECT_EQ(answer["expectations"][0]["unit"], "m");
  EXPECT_EQ(answer["expectations"][1]["value"], nullptr);
  EXPECT_EQ(answer["expectations"][1]["text"], "alpha </script>");
}

TEST(VerdictJson, IsNullWithoutAVerdict) {
  EXPECT_EQ(VerdictJson(std::nullopt), R"({"verdict":null})");
  EXPECT_EQ(VerdictBeside("/nowhere/mission.lcm"), std::nullopt);
}

}  // namespace shoal::verdict_json_test

#include "lib/helm/modes/flag.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::flag_test {

std::optional<std::string> Macro(std::string_view name) {
  if (name == "OSX") return "12.5";
  if (name == "NAME") return "alpha";
  return std::nullopt;
}

std::vector<VariablePost> Fired(const std::string& text, const Variables& variables = {}) {
  const auto flag = Flag::Parse(text);
  EXPECT_TRUE(flag.ok()) << flag.error();
  return flag.ok() ? flag->Fire(variables, Macro) : std::vector<VariablePost>{};
}

VariablePost Text(const std::string& variable, const std::string& value,
                  const std::string& destination = "") {
  return {variable, value, destination};
}

TEST(Flag, SetsTextAndNumbers) {
  EXPECT_EQ(Fired("RETURN = true"), std::vector<VariablePost>{Text("RETURN", "true")});
  EXPECT_EQ(Fired("SPEED=2.5"), (std::vector<VariablePost>{{"SPEED", 2.5}}));
  EXPECT_EQ(Fired("ID = \"07\""), std::vector<VariablePost>{Text("ID", "07")});
  EXPECT_EQ(Fired("UPDATE = points=0,0:1,1 # speed=2"),
            std::vector<VariablePost>{Text("UPDATE", "points=0,0:1,1 # speed=2")});
  EXPECT_EQ(Fired("EMPTY = \"\""), std::vector<VariablePost>{Text("EMPTY", "")});
}

TEST(Flag, ReplacesMacros) {
  EXPECT_EQ(Fired("X = $[OSX]"), (std::vector<VariablePost>{{"X", 12.5}}));
  EXPECT_EQ(Fired("X = \"$[OSX]\""), std::vector<VariablePost>{Text("X", "12.5")});
  EXPECT_EQ(Fired("P = $[NAME] at $[OSX]"), std::vector<VariablePost>{Text("P", "alpha at 12.5")});
  EXPECT_EQ(Fired("P = $[WHAT]"), std::vector<VariablePost>{Text("P", "$[WHAT]")});
  EXPECT_EQ(Fired("P = $[OSX"), std::vector<VariablePost>{Text("P", "$[OSX")});
  EXPECT_EQ(Flag::Parse("P = $[NAME] at $[OSX]")->MacrosUsed(),
            (std::vector<std::string>{"NAME", "OSX"}));
}

TEST(Flag, IsForOthersOrForOthersAndOneself) {
  EXPECT_EQ(Fired("RETURN = true [to] all"),
            std::vector<VariablePost>{Text("RETURN", "true", "all")});
  EXPECT_EQ(
      Fired("RETURN = true [to] group:BLUE+"),
      (std::vector<VariablePost>{Text("RETURN", "true"), Text("RETURN", "true", "group:BLUE")}));
}

TEST(Flag, IsSetOnlyWhereItsConditionHolds) {
  Variables variables;
  variables.Set("RANGE", 10.0, 0);
  EXPECT_EQ(Fired("SLOW = true [to] henry [if] (RANGE < 20)", variables),
            std::vector<VariablePost>{Text("SLOW", "true", "henry")});
  EXPECT_TRUE(Fired("SLOW = true [if] RANGE > 20", variables).empty());
  EXPECT_TRUE(Fired("SLOW = true [if] RANGE < 20").empty());
}

TEST(Flag, StatesWhatIsWrongAndHowToWriteIt) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"RETURN", "write it as VARIABLE = value"},
      {"= true", "the name of a variable is missing"},
      {"RETURN =", "the value is missing"},
      {"RETURN = true [to]", "behind [to]"},
      {"RETURN = true [to] henry gilda", "behind [to]"},
      {"RETURN = \"true", "do not enclose"},
      {"RETURN = true [if] DEPLOY", "'DEPLOY' compares nothing"},
      {"RE TURN = true", "is not a name of a variable"},
  };
  for (const auto& [text, expected] : cases) {
    const auto flag = Flag::Parse(text);
    ASSERT_FALSE(flag.ok()) << text;
    EXPECT_NE(flag.error().find(expected), std::string::npos) << flag.error();
    EXPECT_TRUE(flag.error().starts_with("flag '" + text + "'")) << flag.error();
  }
}

}  // namespace shoal::flag_test

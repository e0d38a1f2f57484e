#include "lib/run/orders/order_words.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::order_words_test {

using Words = std::vector<std::string>;

std::string RuleError(const std::string& rule, const Words& words) {
  const Result<unc_control_t> control = ParseRuleWords(*FindControl(rule), words);
  return control.ok() ? "" : control.error();
}

TEST(RuleWords, StandForAValueAndAVehicleWhereTheRuleIsOfOne) {
  EXPECT_EQ(ParseRuleWords(*FindControl("comms_range"), Words{"300"})->value, 300);
  EXPECT_EQ(ParseRuleWords(*FindControl("comms_range"), Words{"nolimit"})->value, -1);
  EXPECT_EQ(ParseRuleWords(*FindControl("groups"), Words{"true"})->value, 1);
  const Result<unc_control_t> stealth =
      ParseRuleWords(*FindControl("stealth"), Words{"alpha", "0.5"});
  ASSERT_TRUE(stealth.ok());
  EXPECT_EQ(stealth->vehicle, "alpha");
  EXPECT_EQ(stealth->value, 0.5);
  EXPECT_EQ(ParseRuleWords(*FindControl("full_report"), Words{"alpha"})->vehicle, "alpha");
}

TEST(RuleWords, ThatAreWrongAreAnsweredWithWhatTheRuleTakes) {
  EXPECT_EQ(RuleError("comms_range", {}), "usage: shoal send comms_range 250 (metres, or nolimit)");
  EXPECT_EQ(RuleError("comms_range", {"far"}),
            "'far' is not a value of comms_range; usage: shoal send comms_range 250 (metres, or "
            "nolimit)");
  EXPECT_EQ(RuleError("stealth", {"0.5"}), "usage: shoal send stealth VEHICLE 0.5 (0 to 1)");
  EXPECT_EQ(RuleError("stealth", {"alpha", "1.5"}),
            "'1.5' is not a value of stealth; usage: shoal send stealth VEHICLE 0.5 (0 to 1)");
  EXPECT_EQ(RuleError("stealth", {"all", "0.5"}),
            "'all' is not a vehicle's name; usage: shoal send stealth VEHICLE 0.5 (0 to 1)");
  EXPECT_EQ(RuleError("full_report", {"alpha", "1"}),
            "usage: shoal send full_report VEHICLE (no value)");
}

TEST(RuleWords, OfEveryExampleAreUnderstood) {
  for (const ControlRow& row : ControlTable()) {
    Words words;
    if (row.of_vehicle) words.emplace_back("alpha");
    if (row.type != ControlType::kRequest) words.emplace_back(row.example);
    EXPECT_EQ(RuleError(std::string(row.rule), words), "");
  }
}

TEST(MessageWords, StandForATextOrANumberToNamesOrAGroup) {
  const auto text =
      ParseMessageWords(Words{"message", "bravo:charlie", "UPDATE_LOITER", "speed=2.4"});
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(text->dest_node, "bravo:charlie");
  EXPECT_EQ(text->var_name, "UPDATE_LOITER");
  EXPECT_EQ(text->string_val, "speed=2.4");
  EXPECT_FALSE(text->is_double);
  EXPECT_FALSE(text->ack_requested);

  const auto number =
      ParseMessageWords(Words{"message", "group:red_team", "SPEED", "-2.5", "--ack", "--double"});
  ASSERT_TRUE(number.ok());
  EXPECT_EQ(number->dest_node, "");
  EXPECT_EQ(number->dest_group, "red_team");
  EXPECT_EQ(number->double_val, -2.5);
  EXPECT_TRUE(number->is_double);
  EXPECT_TRUE(number->ack_requested);
}

TEST(MessageWords, ThatAreWrongAreAnsweredWithHowToWriteThem) {
  for (const Words& words :
       {Words{"message"}, Words{"message", "all", "A"}, Words{"message", "all", "A", "b", "c"},
        Words{"message", "all", "", "b"}, Words{"message", ":", "A", "b"},
        Words{"message", "group:", "A", "b"}}) {
    const Result<node_message_t> message = ParseMessageWords(words);
    ASSERT_FALSE(message.ok());
    EXPECT_NE(message.error().find("usage: message DEST VAR VALUE"), std::string::npos);
  }
  EXPECT_EQ(ParseMessageWords(Words{"message", "all", "A", "nan", "--double"}).error(),
            "'nan' is not a number");
}

TEST(HelmWords, StandForACommand) {
  const auto command = ParseHelmWords(Words{"goto", "10", "-20"});
  ASSERT_TRUE(command.ok());
  EXPECT_EQ(command->values, (std::vector<double>{10, -20}));
  const auto move = ParseHelmWords(Words{"move", "survey", "1", "2.5", "3", "4"});
  ASSERT_TRUE(move.ok());
  EXPECT_EQ(move->argument, "survey");
  EXPECT_EQ(move->values, (std::vector<double>{1, 2.5, 3, 4}));
  for (const Words& words : {Words{"move"}, Words{"move", "survey"}, Words{"move", "survey", "1"},
                             Words{"move", "survey", "1", "x"}, Words{"move", "1", "2"}}) {
    EXPECT_FALSE(ParseHelmWords(words).ok());
  }
  EXPECT_FALSE(ParseHelmWords(Words{"fly"}).ok());
  EXPECT_FALSE(ParseSimWords(Words{}).ok());
}

TEST(HelmWords, ThatAreUnknownAreAnsweredWithAllThatMayStandThere) {
  const Result<helm_command_t> command = ParseHelmWords(Words{"mesage", "bravo", "X", "hi"});
  ASSERT_FALSE(command.ok());
  EXPECT_TRUE(command.error().starts_with("unknown command 'mesage' (did you mean 'message'?)"))
      << command.error();
  for (const char* row : {"\n  deploy ", "\n  message ", "\n  sim "}) {
    EXPECT_NE(command.error().find(row), std::string::npos) << row << command.error();
  }
}

TEST(ClockWords, StandForAPauseOrAWarp) {
  EXPECT_EQ(ParseClockWords(Words{"pause"})->command, "pause");
  EXPECT_EQ(ParseClockWords(Words{"resume"})->command, "resume");
  EXPECT_EQ(ParseClockWords(Words{"warp", "2.5"})->warp, 2.5);
  EXPECT_EQ(ParseClockWords(Words{"warp", "max"})->warp, 0);
  EXPECT_EQ(ParseClockWords(Words{"seek", "12.5"})->command, "seek 12.5");
  for (const char* time : {"-1", "nan", "soon", ""}) {
    EXPECT_FALSE(ParseClockWords(Words{"seek", time}).ok()) << time;
  }
}

TEST(ClockWords, ThatAreWrongAreAnsweredWithTheRemedy) {
  for (const char* warp : {"0", "-1", "nan", "inf", "1e7", "1e-7", "fast", "", "1x"}) {
    const Result<clock_command_t> command = ParseClockWords(Words{"warp", warp});
    ASSERT_FALSE(command.ok()) << warp;
    EXPECT_NE(command.error().find("a number from 1e-6 to 1e6, or max"), std::string::npos)
        << command.error();
  }
  EXPECT_TRUE(ParseClockWords(Words{"puase"}).error().find("did you mean 'pause'?") !=
              std::string::npos);
  EXPECT_FALSE(ParseClockWords(Words{}).ok());
  EXPECT_FALSE(ParseClockWords(Words{"warp"}).ok());
  EXPECT_FALSE(ParseClockWords(Words{"pause", "now"}).ok());
}

TEST(SendCommandsText, ListsEveryRule) {
  const std::string text = SendCommandsText();
  for (const ControlRow& row : ControlTable()) {
    EXPECT_NE(text.find("  " + std::string(row.rule) + " "), std::string::npos) << row.rule;
  }
  EXPECT_NE(text.find("VEHICLE message DEST VAR VALUE"), std::string::npos);
  EXPECT_NE(text.find("  clock pause "), std::string::npos);
}

}  // namespace shoal::order_words_test

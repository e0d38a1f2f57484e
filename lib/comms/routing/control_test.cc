// The table of controls: names, words, possible values.
#include "lib/comms/routing/control.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace shoal::control_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const ControlRow& Row(std::string_view rule) { return *FindControl(rule); }

TEST(ControlTable, HasNamesAndChannelsOfTheirOwnAndFindsThem) {
  std::set<std::string_view> rules;
  std::set<std::string_view> channels;
  for (const ControlRow& row : ControlTable()) {
    EXPECT_TRUE(rules.insert(row.rule).second) << row.rule;
    EXPECT_TRUE(channels.insert(row.channel).second) << row.channel;
    EXPECT_TRUE(row.channel.starts_with("UNC_")) << row.channel;
    EXPECT_LE(row.channel.size(), 63U) << "LCM's limit";
    EXPECT_EQ(FindControl(row.rule), &row);
    EXPECT_EQ(FindControlOnChannel(row.channel), &row);
    EXPECT_FALSE(row.values.empty());
  }
  EXPECT_EQ(FindControl("comms_rage"), nullptr);
  EXPECT_EQ(FindControl("UNC_STEALTH"), nullptr);
  EXPECT_EQ(FindControlOnChannel("UNC_"), nullptr);
}

TEST(ControlTable, HasTheManualsChannels) {
  EXPECT_EQ(Row("stealth").channel, "UNC_STEALTH");
  EXPECT_EQ(Row("earange").channel, "UNC_EARANGE");
  EXPECT_EQ(Row("comms_range").channel, "UNC_COMMS_RANGE");
  EXPECT_EQ(Row("drop_percentage").channel, "UNC_DROP_PCT");
  EXPECT_EQ(Row("shared_node_reports").channel, "UNC_SHARED_NODE_REPORTS");
  EXPECT_EQ(Row("view_node_rpt_pulses").channel, "UNC_VIEW_NODE_RPT_PULSES");
  EXPECT_EQ(Row("full_report").channel, "UNC_FULL_REPORT_REQ");
}

TEST(ControlTable, AsksForAVehicleWhereTheRuleIsOneVehicles) {
  for (const ControlRow& row : ControlTable()) {
    const bool of_vehicle =
        row.rule == "stealth" || row.rule == "earange" || row.rule == "full_report";
    EXPECT_EQ(row.of_vehicle, of_vehicle) << row.rule;
  }
}

ControlValue Get(const ControlRow& row, const RoutingRules& rules, const LinkFactors& factors) {
  if (row.of_vehicle) return GetFactor(row, factors);
  return GetRule(row, rules);
}

TEST(ControlTable, EveryExampleCanBeSetByItsWordAndReadBackAndChangesNothingElse) {
  for (const ControlRow& row : ControlTable()) {
    if (row.type == ControlType::kRequest) continue;
    const std::optional<ControlValue> value = ParseControlValue(row, row.example);
    ASSERT_TRUE(value) << row.rule;
    RoutingRules rules;
    LinkFactors factors;
    row.of_vehicle ? SetFactor(row, value->number, &factors) : SetRule(row, *value, &rules);
    EXPECT_EQ(Get(row, rules, factors), *value) << row.rule;
    EXPECT_EQ(ParseControlValue(row, ControlWord(row, *value)), *value) << row.rule;
    for (const ControlRow& other : ControlTable()) {
      if (&other == &row || other.type == ControlType::kRequest) continue;
      EXPECT_EQ(Get(other, rules, factors), Get(other, {}, {})) << row.rule << " " << other.rule;
    }
  }
}

TEST(ControlTable, HoldsEveryDefaultPossible) {
  for (const ControlRow& row : ControlTable()) {
    if (row.type == ControlType::kRequest) continue;
    EXPECT_TRUE(IsPossible(row, Get(row, {}, {}))) << row.rule;
  }
}

TEST(IsPossible, RefusesWhatIsNoNumberOrInfinite) {
  for (const ControlRow& row : ControlTable()) {
    if (row.type == ControlType::kRequest || row.type == ControlType::kText) continue;
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
      EXPECT_FALSE(IsPossible(row, bad)) << row.rule << " " << bad;
    }
    for (const char* bad : {"", "nan", "inf", "-inf", "1e999", "5 ", " 5", "5m", "0x10", "+-5",
                            "++5", "TRUE", "yes", "no limit"}) {
      EXPECT_FALSE(ParseControlValue(row, bad)) << row.rule << " '" << bad << "'";
    }
  }
}

/// Both ends are possible, and what lies just beyond is not.
void ExpectRange(std::string_view rule, double min, double max) {
  const ControlRow& row = Row(rule);
  const bool whole = row.type != ControlType::kNumber;
  EXPECT_TRUE(IsPossible(row, min)) << rule;
  EXPECT_TRUE(IsPossible(row, max)) << rule;
  EXPECT_FALSE(IsPossible(row, whole ? min - 1 : std::nextafter(min, -kInfinity))) << rule;
  EXPECT_FALSE(IsPossible(row, whole ? max + 1 : std::nextafter(max, kInfinity))) << rule;
}

TEST(IsPossible, HasTheReferencesRanges) {
  ExpectRange("stealth", 0, 1);
  ExpectRange("earange", 1, 10);
  ExpectRange("drop_percentage", 0, 100);
  ExpectRange("groups", 0, 1);
  ExpectRange("msg_groups", 0, 1);
  ExpectRange("view_node_rpt_pulses", 0, 1);
  ExpectRange("max_msg_length", 0, 1e9);
  EXPECT_FALSE(IsPossible(Row("critical_range"), -1e-300));
  EXPECT_FALSE(IsPossible(Row("pulse_duration"), -1));
  for (const char* rule : {"comms_range", "stale_time", "min_rpt_interval", "min_msg_interval",
                           "shared_node_reports"}) {
    EXPECT_TRUE(IsPossible(Row(rule), -1)) << rule << ": off, or no limit";
  }
}

TEST(IsPossible, RefusesFractionsOfWholeNumbersAndOfYesAndNo) {
  EXPECT_TRUE(IsPossible(Row("max_msg_length"), 100));
  EXPECT_FALSE(IsPossible(Row("max_msg_length"), 100.5));
  EXPECT_FALSE(IsPossible(Row("groups"), 0.5));
  EXPECT_TRUE(IsPossible(Row("drop_percentage"), 0.5));
}

TEST(ControlWords, StandForNumbers) {
  EXPECT_EQ(ParseControlValue(Row("comms_range"), "nolimit"), -1);
  EXPECT_EQ(ParseControlValue(Row("stale_time"), "nolimit"), -1);
  EXPECT_EQ(ParseControlValue(Row("critical_range"), "nolimit"), std::nullopt);
  EXPECT_EQ(ParseControlValue(Row("groups"), "true"), 1);
  EXPECT_EQ(ParseControlValue(Row("groups"), "false"), 0);
  EXPECT_EQ(ParseControlValue(Row("groups"), "1"), 1);
  EXPECT_EQ(ParseControlValue(Row("comms_range"), "true"), std::nullopt);
  EXPECT_EQ(ParseControlValue(Row("shared_node_reports"), "true"), kSharedReportsInterval_s);
  EXPECT_EQ(ParseControlValue(Row("shared_node_reports"), "false"), -1);
  EXPECT_EQ(ParseControlValue(Row("shared_node_reports"), "0.25"), 0.25);
  EXPECT_EQ(ParseControlValue(Row("comms_range"), "+250"), 250);
  EXPECT_EQ(ParseControlValue(Row("min_rpt_interval"), "-1"), -1);
}

TEST(ControlWords, StandForTexts) {
  const ControlRow& row = Row("ignore_group");
  EXPECT_EQ(ParseControlValue(row, "Ghosts"), std::string("Ghosts"));
  EXPECT_EQ(ParseControlValue(row, "5"), std::string("5")) << "a group, no number";
  EXPECT_EQ(ParseControlValue(row, "none"), std::string()) << "no group is ignored";
  EXPECT_EQ(ParseControlValue(row, ""), std::nullopt);
  EXPECT_EQ(ParseControlValue(row, "a\nb"), std::nullopt);
  EXPECT_EQ(ParseControlValue(row, std::string(64, 'g')), std::string(64, 'g'));
  EXPECT_EQ(ParseControlValue(row, std::string(65, 'g')), std::nullopt);
  EXPECT_EQ(ControlWord(row, std::string("Ghosts")), "Ghosts");
  EXPECT_EQ(ControlWord(row, std::string()), "none");
  EXPECT_EQ(ShownValue(row, {}), "none");
}

TEST(ControlWords, AreWhatPeopleWrite) {
  EXPECT_EQ(ControlWord(Row("comms_range"), -7), "nolimit");
  EXPECT_EQ(ControlWord(Row("stale_time"), -1), "nolimit");
  EXPECT_EQ(ControlWord(Row("comms_range"), 250), "250");
  EXPECT_EQ(ControlWord(Row("groups"), 1), "true");
  EXPECT_EQ(ControlWord(Row("groups"), 0), "false");
  EXPECT_EQ(ControlWord(Row("shared_node_reports"), -1), "false");
  EXPECT_EQ(ControlWord(Row("shared_node_reports"), 0.1), "0.1");
  EXPECT_EQ(ControlWord(Row("min_rpt_interval"), -1), "-1");
}

RC_GTEST_PROP(ControlWords, AreReadBackAsTheSameNumber, (double value)) {
  for (const ControlRow& row : ControlTable()) {
    if (row.type == ControlType::kRequest || row.type == ControlType::kText) continue;
    if (!IsPossible(row, value)) continue;
    const std::optional<ControlValue> read = ParseControlValue(row, ControlWord(row, value));
    RC_ASSERT(read.has_value());
    // All negative numbers mean the same where there is a word for them.
    RC_ASSERT(*read == value || (value < 0 && *read == -1));
  }
}

}  // namespace shoal::control_test

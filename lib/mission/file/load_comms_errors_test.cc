// Errors and warnings about communication in mission files, with the exact texts: rules, messages,
// expectations of fates.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_comms_errors_test {

/// Returns the warnings of kShortest with `more` after it, one per line.
std::string WarningsAfter(std::string_view more) {
  std::string all;
  const LoadedMission loaded =
      LoadMissionText(std::string(kShortest) + std::string(more), "m.toml", {});
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  for (const std::string& warning : WarningsBesideConduct(loaded)) all += warning + "\n";
  return all;
}

/// Returns the errors of a [[event]] whose rule, value and so on begin in line 7.
std::string ErrorsOfEvent(std::string_view keys) {
  return ErrorsAfter("[[event]]\nat_s = 1\n" + std::string(keys) + "\n");
}

TEST(LoadErrors, ReportRulesOutOfTheirRange) {
  EXPECT_EQ(ErrorsAfter(R"(stealth = 1.1
earange = 0.9
[vehicle.messages]
ack_timeout_s = 0
max_repeats = -1
[comms]
critical_range = -1
groups = 1
ignore_group = 7
min_rpt_interval = -2
max_msg_length = 1.5
drop_percentage = 100.1
shared_node_reports = "often"
pulse_duration = inf
msg_color = ""
)"),
            "5:11: stealth = 1.1 is out of range; allowed: 0 to 1\n"
            "6:11: earange = 0.9 is out of range; allowed: 1 to 10\n"
            "8:17: ack_timeout_s = 0 is out of range; allowed: greater than 0, at most 100000\n"
            "9:15: max_repeats = -1 is out of range; allowed: 0 to 1000\n"
            "11:18: critical_range = -1 is out of range; allowed: 0 to 10000000\n"
            "12:10: groups must be true or false, not a whole number\n"
            "13:16: ignore_group must be a string in quotes, not a whole number\n"
            "14:20: min_rpt_interval = -2 is out of range; allowed: -1 to 10000000\n"
            "15:18: max_msg_length must be a whole number, not 1.5\n"
            "16:19: drop_percentage = 100.1 is out of range; allowed: 0 to 100\n"
            "17:23: shared_node_reports = 'often' is impossible; shared_node_reports takes true, "
            "false, or seconds of wall time between two of a vehicle\n"
            "18:18: pulse_duration = inf is out of range; allowed: 0 to 10000000\n"
            "19:13: msg_color must not be empty\n");
}

TEST(LoadErrors, ReportImpossibleValuesOfRuleEvents) {
  const auto with = [](std::string_view rule, std::string_view value) {
    return ErrorsOfEvent("rule = \"" + std::string(rule) + "\"\nvalue = " + std::string(value));
  };
  EXPECT_EQ(with("comms_range", "\"nolimit\""), "");
  EXPECT_EQ(with("comms_range", "250.5"), "");
  EXPECT_EQ(with("groups", "true"), "");
  EXPECT_EQ(with("shared_node_reports", "false"), "");
  EXPECT_EQ(with("ignore_group", "\"ghosts\""), "");
  EXPECT_EQ(with("ignore_group", "\"none\""), "");
  EXPECT_EQ(with("ignore_group", "\"\""),
            "8:9: value = '' is impossible; ignore_group takes a group, or none\n");
  EXPECT_EQ(with("comms_range", "\"far\""),
            "8:9: value = 'far' is impossible; comms_range takes metres, or nolimit\n");
  EXPECT_EQ(with("comms_range", "nan"),
            "8:9: value = 'nan' is impossible; comms_range takes metres, or nolimit\n");
  EXPECT_EQ(with("drop_percentage", "101"),
            "8:9: value = '101' is impossible; drop_percentage takes 0 to 100\n");
  EXPECT_EQ(with("critical_range", "\"nolimit\""),
            "8:9: value = 'nolimit' is impossible; critical_range takes metres\n");
  EXPECT_EQ(with("groups", "\"yes\""),
            "8:9: value = 'yes' is impossible; groups takes true or false\n");
  EXPECT_EQ(with("max_msg_length", "10.5"),
            "8:9: value = '10.5' is impossible; max_msg_length takes bytes; 0: no limit\n");
  EXPECT_EQ(with("stale_time", "[5]"),
            "8:9: value must be a number, true or false, or a string, not an array\n");
  EXPECT_EQ(with("comms_rnage", "5"),
            "7:8: unknown rule 'comms_rnage' (did you mean 'comms_range'?)\n");
}

TEST(LoadErrors, ReportWhetherARuleIsOfOneVehicle) {
  EXPECT_EQ(ErrorsOfEvent("rule = \"stealth\"\nvehicle = \"ALPHA\"\nvalue = 0.5"), "");
  EXPECT_EQ(ErrorsOfEvent("rule = \"stealth\"\nvalue = 0.5"),
            "5:1: event lacks 'vehicle'; for example: vehicle = \"alpha\"\n");
  EXPECT_EQ(ErrorsOfEvent("rule = \"stealth\"\nvehicle = \"all\"\nvalue = 0.5"),
            "8:11: unknown vehicle 'all'; the mission has alpha\n");
  EXPECT_EQ(ErrorsOfEvent("rule = \"comms_range\"\nvehicle = \"alpha\"\nvalue = 5"),
            "8:11: comms_range holds for all, not for one vehicle; leave vehicle out\n");
  EXPECT_EQ(ErrorsOfEvent("rule = \"comms_range\""),
            "5:1: event lacks 'value'; for example: value = 250\n");
  EXPECT_EQ(ErrorsOfEvent("rule = \"full_report\"\nvehicle = \"alpha\""), "");
  EXPECT_EQ(ErrorsOfEvent("rule = \"full_report\"\nvehicle = \"alpha\"\nvalue = 1"),
            "9:9: full_report takes no value\n");
}

TEST(LoadErrors, ReportWhatAMessageLacks) {
  const auto with = [](std::string_view members) {
    return ErrorsOfEvent("message = {" + std::string(members) + "}");
  };
  EXPECT_EQ(with("src_node = 'alpha', dest_node = 'all', var_name = 'A', string_val = 'b'"), "");
  EXPECT_EQ(with("src_node = 'alpha', dest_group = 'all', var_name = 'A', double_val = 2"), "");
  EXPECT_EQ(with("dest_node = 'all'"),
            "7:11: message lacks 'src_node'; for example: src_node = \"alpha\"\n"
            "7:11: message lacks 'var_name'; for example: var_name = \"UPDATE_LOITER\"\n");
  EXPECT_EQ(with("src_node = 'alpha', var_name = 'A'"),
            "7:11: a message needs dest_node or dest_group (or both)\n");
  EXPECT_EQ(with("src_node = 'alpha', dest_node = ' : ', var_name = 'A'"),
            "7:44: a message needs dest_node or dest_group (or both)\n");
  EXPECT_EQ(with("src_node = 'alfa', dest_node = 'ALPHA:zulu:alph', var_name = 'A'"),
            "7:23: unknown vehicle 'alfa' (did you mean 'alpha'?)\n"
            "7:43: unknown vehicle 'alph' (did you mean 'alpha'?)\n"
            "7:43: unknown vehicle 'zulu'; the mission has alpha, or \"all\"\n");
  EXPECT_EQ(with("src_node = 'alpha', dest_node = 'all', var_name = 'A', string_val = 'b', "
                 "double_val = 2"),
            "7:98: a message has string_val or double_val, not both\n");
  EXPECT_EQ(with("src_node = 'alpha', dest_node = 'all', var_name = 'A', double_val = nan, "
                 "value = 1"),
            "7:80: double_val = nan is out of range; allowed: -1e+300 to 1e+300\n"
            "7:85: unknown key 'value' (did you mean 'string_val'?)\n");
}

TEST(LoadErrors, LeadFromNamesOfTheManualToWhereTheyStandHere) {
  EXPECT_EQ(ErrorsAfter("[comms]\nstealth = \"vname=alpha, stealth=0.5\"\nearange = 2\n"
                        "verbose = true\ndebug = true\nmin_report_interval = 2\n"),
            "6:1: unknown key 'stealth' (each vehicle has its own: write stealth = 0.5 in its "
            "[[vehicle]])\n"
            "7:1: unknown key 'earange' (each vehicle has its own: write earange = 2 in its "
            "[[vehicle]])\n"
            "8:1: unknown key 'verbose' (without meaning here: `shoal status shore_broker` shows "
            "what the broker does)\n"
            "9:1: unknown key 'debug' (without meaning here: `shoal status shore_broker` shows "
            "what the broker does)\n"
            "10:1: unknown key 'min_report_interval' (here it is 'min_rpt_interval')\n");
  EXPECT_EQ(ErrorsOfEvent("message = {src_node = 'alpha', dest_node = 'all', dest_name = 'all', "
                          "var_name = 'A', string_val = 'b'}"),
            "7:51: unknown key 'dest_name' (here it is 'dest_node')\n");
}

TEST(LoadErrors, ReportSpeedsThatTheHelmWouldRefuse) {
  const auto with = [](std::string_view speed) {
    return ErrorsOfEvent("vehicle = \"alpha\"\ncommand = \"speed\"\nvalues = [" +
                         std::string(speed) + "]");
  };
  EXPECT_EQ(with("50"), "");
  EXPECT_EQ(with("0"), "9:10: speed = 0 is out of range; allowed: greater than 0, at most 50\n");
  EXPECT_EQ(with("-2"), "9:10: speed = -2 is out of range; allowed: greater than 0, at most 50\n");
  EXPECT_EQ(with("51"), "9:10: speed = 51 is out of range; allowed: greater than 0, at most 50\n");
}

TEST(LoadErrors, ReportMoreLapsThanATaskHas) {
  constexpr std::string_view kTasks = R"([[vehicle.task]]
kind = "waypoints"
points = [[1, 2]]
laps = 2
[[vehicle.task]]
kind = "return"
[[vehicle.task]]
kind = "station_keep"
[[vehicle.task]]
kind = "loiter"
center = [0, 0]
)";
  const auto with = [&](std::string_view task, int at_least) {
    return ErrorsAfter(std::string(kTasks) + "[[expect]]\nkind = \"laps\"\nvehicle = \"all\"\n" +
                       "task = \"" + std::string(task) +
                       "\"\nat_least = " + std::to_string(at_least) + "\n");
  };
  EXPECT_EQ(with("waypoints", 2), "");
  EXPECT_EQ(with("return", 1), "");
  EXPECT_EQ(with("loiter", 1000), "");
  EXPECT_EQ(with("waypoints", 3),
            "20:12: at_least = 3 can never hold: 'waypoints' of alpha ends after 2 laps\n");
  EXPECT_EQ(with("return", 2),
            "20:12: at_least = 2 can never hold: 'return' of alpha ends after 1 lap\n");
  EXPECT_EQ(with("station_keep", 1),
            "19:8: 'station_keep' of alpha is a station_keep, which has no laps\n");
}

TEST(LoadErrors, ReportExpectationsOfFatesThatCannotBeCounted) {
  EXPECT_EQ(ErrorsAfter("[[expect]]\nkind = \"messages\"\n[[expect]]\nkind = \"acks\"\n"),
            "5:1: an expectation of messages needs one of at_least, at_most, at_least_pct, "
            "at_most_pct, or several\n"
            "7:1: an expectation of acks needs one of at_least, at_most, at_least_pct, "
            "at_most_pct, or several\n");
  EXPECT_EQ(ErrorsAfter("[[expect]]\nkind = \"messages\"\ncause = \"too_late\"\nat_least = 1\n"),
            "7:9: unknown cause 'too_late' (did you mean 'too_long'?)\n");
  EXPECT_EQ(ErrorsAfter("[comms]\neach_fate_up_to = 0\n[[expect]]\nkind = \"reports\"\n"
                        "to = \"alpha\"\ncause = \"out_of_range\"\nat_most = 1\n"),
            "9:6: in a fleet of more than each_fate_up_to = 0 vehicles, those that are out of "
            "range are counted together: leave to out, or raise [comms] each_fate_up_to\n");
}

TEST(Load, TakesTheRulesOfEventsAndTheKindsOfExpectations) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest) + R"(stealth = 0.5
[vehicle.messages]
max_repeats = 0
[[event]]
at_s = 1
rule = "shared_node_reports"
value = true
[[event]]
at_s = 2
rule = "stealth"
vehicle = "ALPHA"
value = 0.25
[[event]]
at_s = 3
message = {src_node = "ALPHA", dest_node = "alpha : all", var_name = "X", double_val = 0}
[[expect]]
kind = "acks"
at_most = 0
)",
                                               "m.toml", {});
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  const Mission& mission = loaded.mission;
  EXPECT_EQ(mission.vehicles[0].link_factors, (LinkFactors{.stealth = 0.5, .earange = 1}));
  EXPECT_EQ(mission.vehicles[0].message_options.max_repeats, 0);
  using What = decltype(Event::what);
  EXPECT_EQ(mission.events[0].what,
            What(RuleEvent{"shared_node_reports", "", kSharedReportsInterval_s}));
  EXPECT_EQ(mission.events[1].what, What(RuleEvent{"stealth", "alpha", 0.25}));
  const auto& message = std::get<MessageEvent>(mission.events[2].what);
  EXPECT_EQ(message.src_node, "alpha");
  EXPECT_EQ(message.double_val, std::optional<double>(0));
  EXPECT_EQ(std::get<CommsExpectation>(mission.expectations[0].what).kind, Kind::kAck);
}

TEST(Load, TakesOrdersWithNames) {
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) +
          "[[order]]\nname = \"patrol\"\nvehicle = \"all\"\ncommand = \"set\"\n"
          "argument = \"PATROL=true\"\n[[order]]\nname = \"patrol\"\nvehicle = \"ALPHA\"\n"
          "command = \"speed\"\nvalues = [1.5]\n",
      "m.toml", {});
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(OrdersOf(loaded.mission),
            (std::vector<OrderWords>{{"patrol", "all", {"set", "PATROL=true"}},
                                     {"patrol", "alpha", {"speed", "1.5"}}}));
}

TEST(LoadErrors, ReportOrdersThatShoalSendWouldNotFind) {
  const auto errors = [](const std::string& name) {
    return ErrorsAfter("[[order]]\nname = \"" + name + "\"\nvehicle = \"all\"\n" +
                       "command = \"return\"\n");
  };
  EXPECT_EQ(errors("home"), "");
  EXPECT_NE(errors("ALPHA").find("no order can be called 'ALPHA': is a vehicle"),
            std::string::npos);
  EXPECT_EQ(errors("").find("no order can be called"), std::string::npos)
      << "one error is enough: " << errors("");
  EXPECT_NE(errors(""), "");
  for (const char* name : {"clock", "all", "comms_range", "a b"}) {
    EXPECT_NE(errors(name).find("no order can be called"), std::string::npos) << name;
  }
  EXPECT_NE(ErrorsAfter("[[order]]\nname = \"home\"\nvehicle = \"zulu\"\ncommand = \"return\"\n"),
            "");
}

constexpr std::string_view kHoldThenHome = R"([[vehicle.task]]
name = "hold"
kind = "station_keep"
[[vehicle.task]]
name = "away"
kind = "waypoints"
points = [[1, 2]]
[[vehicle.task]]
name = "home"
kind = "return"
)";

TEST(LoadWarnings, ReportTasksAfterOneThatNeverEnds) {
  EXPECT_EQ(WarningsAfter(kHoldThenHome),
            "m.toml:8:1: warning: the task 'away' is never reached: 'hold' before it never ends, "
            "and no event starts it\n"
            "m.toml:12:1: warning: the task 'home' is never reached: 'hold' before it never ends, "
            "and no event starts it\n");
  EXPECT_EQ(WarningsAfter("[[vehicle.task]]\nkind = \"loiter\"\ncenter = [0, 0]\nduration_s = 5\n"
                          "[[vehicle.task]]\nkind = \"return\"\n"),
            "");
}

TEST(LoadWarnings, AreNoneForTasksThatAnEventStarts) {
  const std::string start = "[[event]]\nat_s = 1\nvehicle = \"all\"\ncommand = \"task\"\n";
  EXPECT_EQ(WarningsAfter(std::string(kHoldThenHome) + start + "argument = \"away\"\n"), "");
  EXPECT_EQ(WarningsAfter(std::string(kHoldThenHome) + start + "argument = \"home\"\n"),
            "m.toml:8:1: warning: the task 'away' is never reached: 'hold' before it never ends, "
            "and no event starts it\n");
}

TEST(LoadWarnings, ReportGroupsWithoutMembers) {
  const auto to = [](std::string_view group) {
    return WarningsAfter(
        "group = \"Reds\"\n[[event]]\nat_s = 1\nmessage = {src_node = 'alpha', "
        "var_name = 'A', dest_group = '" +
        std::string(group) + "'}\n");
  };
  EXPECT_EQ(to("reds"), "");
  EXPECT_EQ(to("ALL"), "");
  EXPECT_EQ(to("red"),
            "m.toml:8:61: warning: no vehicle of the mission is of group 'red' (did you mean "
            "'Reds'?)\n");
}

TEST(LoadWarnings, AreNoneBesideErrors) {
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) + std::string(kHoldThenHome) + "sped = 3\n", "m.toml", {});
  EXPECT_EQ(loaded.errors.size(), 1U);
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST(LoadWarnings, ReportAnIgnoredGroupWithoutMembers) {
  EXPECT_EQ(WarningsAfter("group = \"survey\"\n[comms]\nignore_group = \"surveyy\"\n"),
            "m.toml:7:16: warning: no vehicle of the mission is of group 'surveyy' (did you mean "
            "'survey'?)\n");
  EXPECT_EQ(WarningsAfter("group = \"survey\"\n[comms]\nignore_group = \"Survey\"\n"), "");
}

TEST(LoadErrors, ReportFatesThatAKindCannotHave) {
  EXPECT_EQ(
      ErrorsAfter("[[expect]]\nkind = \"reports\"\ncause = \"unknown_destination\"\nat_least = 1\n")
          .substr(0, 20),
      "7:9: unknown cause '");
  EXPECT_EQ(
      ErrorsAfter("[[expect]]\nkind = \"messages\"\ncause = \"no_destination\"\nat_least = 1\n"),
      "");
}

}  // namespace shoal::load_comms_errors_test

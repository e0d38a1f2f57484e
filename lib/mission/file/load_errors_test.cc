// Every error that a mission file can have, with its exact text: users read these.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_errors_test {

TEST(LoadErrors, AreNoneForTheShortestMission) { EXPECT_EQ(ErrorsOf(kShortest), ""); }

TEST(LoadErrors, AreAllReportedInTheOrderOfTheFile) {
  EXPECT_EQ(ErrorsOf(R"([mission]
tick_s = 0.1
colour = 3
[comms]
comms_range = "far"
[[vehicle]]
length_m = -3
name = "all"
)"),
            "1:1: mission lacks 'duration_s'; for example: duration_s = 600\n"
            "3:1: unknown key 'colour'; known here: name, description, seed, tick_s, duration_s, "
            "start_utime, origin, op_area, backgrounds, collisions, grounding, on_loss, "
            "participant_timeout_s, shore_broker\n"
            "5:15: comms_range must be 0 to 10000000 or \"nolimit\", not the string 'far'\n"
            "7:12: length_m = -3 is out of range; allowed: greater than 0, at most 500\n"
            "8:8: 'all' is reserved, as local, unc and all are: choose another\n");
}

TEST(LoadErrors, EndAfterAHundred) {
  std::string junk;
  for (int i = 0; i < 150; ++i) junk += "junk" + std::to_string(i) + " = 1\n";
  const auto errors = LoadMissionText(std::string(kShortest) + junk, "m.toml").errors;
  ASSERT_EQ(errors.size(), 101U);
  EXPECT_EQ(errors.back(), "m.toml: and 50 more errors");
}

TEST(LoadErrors, ReportTheFirstSyntaxErrorOnly) {
  EXPECT_EQ(ErrorsOf("[mission]\nseed = \nname = \n"),
            "2:8: not TOML: Error while parsing key-value pair: expected value, saw '\\n'\n");
  EXPECT_EQ(ErrorsOf("[mission]\nseed = 1\nseed = 2\n"),
            "3:8: not TOML: Error while parsing key-value pair: cannot redefine existing integer "
            "'seed'\n");
  EXPECT_EQ(ErrorsOf("name = \"\xff\"\n"), "1:8: not TOML: Encountered invalid utf-8 sequence\n");
}

TEST(LoadErrors, SuggestTheKeyThatWasMeant) {
  EXPECT_EQ(ErrorsAfter("[[vehicle.task]]\nkind = \"waypoints\"\npoints = [[1, 2]]\nsped = 2\n"),
            "8:1: unknown key 'sped' (did you mean 'speed_mps'?)\n");
  EXPECT_EQ(ErrorsAfter("[[fleat]]\n"), "5:3: unknown key 'fleat' (did you mean 'fleet'?)\n");
}

TEST(LoadErrors, ReportWrongTypes) {
  EXPECT_EQ(ErrorsAfter(R"(length_m = "3"
color = 7
group = ["a"]
start = 5
helm = true
[vehicle.helm_options]
deploy_at_start = 1
[vehicle.reporter]
extra = {A = 1}
rate_hz = 2020-01-01
[[vehicle.task]]
kind = "waypoints"
points = [[1, 2, 3], 4, ["x", 2]]
laps = 1.5
)"),
            "5:12: length_m must be a number, not the string '3'\n"
            "6:9: color must be a string in quotes, not a whole number\n"
            "7:9: group must be a string in quotes, not an array\n"
            "8:9: start must be a table, not a whole number\n"
            "9:8: helm must be a string in quotes, not true; one of: shoal, hand, none\n"
            "11:19: deploy_at_start must be true or false, not a whole number\n"
            "13:14: 'A' must be a string in quotes, not a whole number\n"
            "14:11: rate_hz must be a number, not a date or time\n"
            "17:11: element 1 of points must be two numbers like [10, 20], not an array of 3\n"
            "17:22: element 2 of points must be two numbers like [10, 20], not a whole number\n"
            "17:26: the first number of element 3 of points must be a number, not the string 'x'\n"
            "18:8: laps must be a whole number, not 1.5\n");
}

TEST(LoadErrors, ReportWrongBrackets) {
  EXPECT_EQ(ErrorsOf("[[mission]]\nduration_s = 60\n[vehicle]\nname = \"alpha\"\n"),
            "1:1: there is one table mission, not several: write [mission] in single brackets\n"
            "3:1: there may be several tables vehicle: write [[vehicle]] in double brackets\n");
  EXPECT_EQ(ErrorsAfter("[fleet]\ncount = 3\n[[template]]\n"),
            "5:1: there may be several tables fleet: write [[fleet]] in double brackets\n"
            "7:1: templates have names: write [template.NAME]\n");
}

TEST(LoadErrors, RefuseInvalidNumbers) {
  EXPECT_EQ(ErrorsAfter("start = {x_m = nan, y_m = -inf, heading_deg = 361}\n"),
            "5:16: x_m = nan is out of range; allowed: -1000000 to 1000000\n"
            "5:27: y_m = -inf is out of range; allowed: -1000000 to 1000000\n"
            "5:47: heading_deg = 361 is out of range; allowed: -360 to 360\n");
}

TEST(LoadErrors, DemandWholeTicksAndMicroseconds) {
  const auto with = [](const std::string& lines) {
    return ErrorsOf("[mission]\n" + lines + "[[vehicle]]\nname = \"a\"\n");
  };
  EXPECT_EQ(with("duration_s = 10.05\n"),
            "2:14: duration_s = 10.05 is not a whole number of ticks of 0.1 s; the nearest are 10 "
            "and 10.1\n");
  EXPECT_EQ(
      with("duration_s = 0.05\n"),
      "2:14: duration_s = 0.05 is not a whole number of ticks of 0.1 s; the shortest is 0.1\n");
  EXPECT_EQ(with("duration_s = 0\n"),
            "2:14: duration_s = 0 is out of range; allowed: greater than 0, at most 10000000\n");
  EXPECT_EQ(with("duration_s = 10\ntick_s = 0.0005\n"),
            "3:10: tick_s = 0.0005 is out of range; allowed: 0.001 to 10\n");
  EXPECT_EQ(with("duration_s = 10\ntick_s = 11\n"),
            "3:10: tick_s = 11 is out of range; allowed: 0.001 to 10\n");
  EXPECT_EQ(
      with("duration_s = 10\ntick_s = 0.0010004\n"),
      "3:10: tick_s = 0.0010004 is not a whole number of microseconds; the nearest is 0.001\n");
}

TEST(LoadErrors, ReportBadVehicleNames) {
  const auto named = [](const std::string& name) {
    return ErrorsAfter("[[vehicle]]\nname = \"" + name + "\"\n");
  };
  EXPECT_EQ(named(""), "6:8: a name must not be empty\n");
  EXPECT_EQ(named("b-1"), "6:8: the name 'b-1' may hold only letters, digits and '_'\n");
  EXPECT_EQ(named("b{n}"), "6:8: the name 'b{n}' may hold only letters, digits and '_'\n");
  EXPECT_EQ(named(std::string(33, 'b')), "6:8: the name '" + std::string(33, 'b') +
                                             "' has 33 characters; allowed: at most 32\n");
  EXPECT_EQ(named("UNC"), "6:8: 'UNC' is reserved, as local, unc and all are: choose another\n");
  EXPECT_EQ(named("ALPHA"),
            "6:8: a vehicle 'alpha' exists already; names must differ in more than case\n");
  EXPECT_EQ(ErrorsAfter("[[vehicle]]\n"),
            "5:1: vehicle lacks 'name'; for example: name = \"alpha\"\n");
}

TEST(LoadErrors, ReportBadParticipantNames) {
  const auto named = [](const std::string& name) {
    return ErrorsAfter("[[participant]]\nname = \"" + name + "\"\n");
  };
  EXPECT_EQ(named("my_planner"), "");
  EXPECT_EQ(named("helm_bravo"), "");
  for (const std::string own : {"shoal", "shore_broker", "Recorder", "helm_alpha", "HELM_Alpha",
                                "vehicle_sim_alpha", "node_reporter_alpha"}) {
    EXPECT_EQ(named(own), "6:8: the name '" + own + "' is shoal's own: choose another\n");
  }
  EXPECT_EQ(ErrorsAfter("[[participant]]\nname = \"a\"\n[[participant]]\nname = \"A\"\n"),
            "8:8: a participant 'A' exists already; names must differ in more than case\n");
}

TEST(LoadErrors, ReportUnknownVehiclesTasksAndCommands) {
  EXPECT_EQ(ErrorsAfter(R"([[event]]
at_s = 1
vehicle = "alfa"
command = "retrun"
[[event]]
at_s = 61
vehicle = "zulu"
sim_command = "pause"
[[event]]
at_s = 2
vehicle = "alpha"
command = "task"
argument = "survey"
[[event]]
at_s = 2
vehicle = "alpha"
command = "goto"
values = [1]
[[event]]
at_s = 2
vehicle = "alpha"
command = "deploy"
values = [1]
argument = "now"
[[event]]
at_s = 2
)"),
            "7:11: unknown vehicle 'alfa' (did you mean 'alpha'?)\n"
            "8:11: unknown command 'retrun' (did you mean 'return'?)\n"
            "10:8: at_s = 61 is out of range; allowed: 0 to 60\n"
            "11:11: unknown vehicle 'zulu'; the mission has alpha, or \"all\"\n"
            "17:12: alpha has no task 'survey'\n"
            "22:10: goto needs values = [x_m, y_m]\n"
            "27:10: deploy takes no values\n"
            "28:12: deploy takes no argument; only task and set do\n"
            "29:1: an event needs one of command, sim_command, rule and message, and only one\n");
}

TEST(LoadErrors, ReportUnknownKinds) {
  EXPECT_EQ(ErrorsAfter("[[vehicle.task]]\nkind = \"waypoint\"\nanything = 1\n"),
            "6:8: unknown kind 'waypoint' (did you mean 'waypoints'?)\n");
  EXPECT_EQ(
      ErrorsAfter("[[expect]]\nkind = \"glory\"\n"),
      "6:8: unknown kind 'glory'; one of: arrival, separation, reports, helm, laps, track, "
      "distance, altitude, swarm, closest_approach, encounter_score, coverage, navigation_error, "
      "messages, acks, "
      "packets\n");
  EXPECT_EQ(ErrorsAfter("[[expect]]\n"),
            "5:1: expect lacks 'kind'; for example: kind = \"arrival\"\n");
}

TEST(LoadErrors, ReportExpectationsThatCanNeverHold) {
  EXPECT_EQ(ErrorsAfter(R"([[expect]]
kind = "arrival"
vehicle = "all"
by_s = 60.1
[[expect]]
kind = "reports"
at_least = 10
at_most = 9
[[expect]]
kind = "laps"
vehicle = "alpha"
task = "survey"
[[expect]]
kind = "helm"
vehicle = "alpha"
[[expect]]
kind = "reports"
cause = "deliverd"
[[expect]]
kind = "separation"
)"),
            "8:8: by_s = 60.1 is out of range; allowed: greater than 0, at most 60\n"
            "12:11: at_most = 9 is less than at_least = 10: this can never hold\n"
            "16:8: alpha has no task 'survey'\n"
            "17:1: an expectation of a helm needs state or task\n"
            "20:1: an expectation of reports needs one of at_least, at_most, at_least_pct, "
            "at_most_pct, or several\n"
            "22:9: unknown cause 'deliverd' (did you mean 'delivered'?)\n"
            "23:1: expect lacks 'min_m'; for example: min_m = 5\n");
}

TEST(LoadErrors, ReportInvalidTasks) {
  EXPECT_EQ(ErrorsAfter(R"([[vehicle.task]]
kind = "waypoints"
points = []
[[vehicle.task]]
kind = "waypoints"
points = [[1e6, 0]]
[[vehicle.task]]
kind = "station_keep"
outer_radius_m = 4
[[vehicle.task]]
kind = "loiter"
num_points = 2
)"),
            "7:10: points must hold at least one point, like [[100, 0]]\n"
            "8:1: a task 'waypoints' of this vehicle exists already; give each a name of its own\n"
            "13:18: outer_radius_m must be greater than inner_radius_m\n"
            "14:1: task lacks 'center'; for example: center = [100, -50]\n"
            "16:14: num_points = 2 is out of range; allowed: 3 to 360\n");
}

TEST(LoadErrors, ReportInvalidThrustMaps) {
  const auto with = [](const std::string& map) {
    return ErrorsAfter("surface_craft = {thrust_map = " + map + "}\n");
  };
  EXPECT_EQ(with("[[-100, -2], [0, 0], [50, 3], [100, 5]]"), "");
  EXPECT_EQ(
      with("[]"),
      "5:31: thrust_map must end with a point of positive thrust and speed, like [[100, 5]]\n");
  EXPECT_EQ(with("[[50, 3], [50, 4]]"),
            "5:31: thrust_map must rise: thrust from point to point, and speed must not fall\n");
  EXPECT_EQ(
      with("[[-50, 3], [50, 4]]"),
      "5:31: thrust_map must give speed ahead for positive thrust, astern for negative, 0 for "
      "0\n");
}

TEST(LoadErrors, RefuseControlCharactersAndEndlessTexts) {
  EXPECT_EQ(ErrorsAfter("color = \"a\\u001bb\"\ngroup = \"" + std::string(100, 'g') + "\"\n"),
            "5:9: color must not hold control characters\n"
            "6:9: group is 100 bytes long; allowed: at most 64\n");
}

}  // namespace shoal::load_errors_test

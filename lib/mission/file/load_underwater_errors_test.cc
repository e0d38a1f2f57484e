// Every error of [environment], of [vehicle.remus100] and of the tasks of underwater vehicles, with
// its exact text: users read these.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_underwater_errors_test {

/// An underwater vehicle and its swarm; what a test appends begins in line 9.
constexpr std::string_view kSwarm = R"([mission]
duration_s = 60
[[vehicle]]
name = "bravo"
model = "remus100"
[[vehicle]]
name = "alpha"
model = "remus100"
)";

std::string ErrorsInSwarm(std::string_view more, const std::vector<std::string>& overrides = {}) {
  return ErrorsOf(std::string(kSwarm) + std::string(more), overrides);
}

/// Errors of alpha's task of a kind, whose keys begin in line 11.
std::string ErrorsOfTask(std::string_view kind, std::string_view keys) {
  return ErrorsInSwarm("[[vehicle.task]]\nkind = \"" + std::string(kind) + "\"\n" +
                       std::string(keys));
}

std::string ErrorsOfPath(std::string_view keys) { return ErrorsOfTask("path_follow", keys); }
std::string ErrorsOfTrack(std::string_view keys) { return ErrorsOfTask("target_track", keys); }

TEST(LoadUnderwaterErrors, AreNoneForTasksWithNothingButWhatTheyNeed) {
  EXPECT_EQ(ErrorsOfPath("points = [[100, 0, 20]]\n"), "");
  EXPECT_EQ(ErrorsOfTrack("target = \"BRAVO\"\n"), "");
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nlaw = \"constant_bearing\"\nlookahead_m = 20\n"),
            "");
}

TEST(LoadUnderwaterErrors, ReportPathsWithoutPoints) {
  EXPECT_EQ(ErrorsOfPath(""),
            "9:1: task lacks 'points'; for example: points = [[0, 0, 10], [100, 0, 20]]\n");
  EXPECT_EQ(ErrorsOfPath("points = []\n"),
            "11:10: points must hold at least one point, like [[100, 0, 20]]\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidPoints) {
  EXPECT_EQ(
      ErrorsOfPath("points = [[1, 2], 3, [1, 2, \"x\"]]\n"),
      "11:11: element 1 of points must be three numbers like [10, 20, 5], not an array of 2\n"
      "11:19: element 2 of points must be three numbers like [10, 20, 5], not a whole number\n"
      "11:29: the third number of element 3 of points must be a number, not the string 'x'\n");
  const std::string far =
      "11:10: points are [x, y, depth], with x and y within 1000 km of the origin and depths from "
      "0 to 20000 m\n";
  EXPECT_EQ(ErrorsOfPath("points = [[0, 0, -1]]\n"), far);
  EXPECT_EQ(ErrorsOfPath("points = [[0, 0, 20001]]\n"), far);
  EXPECT_EQ(ErrorsOf(R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
model = "remus100"
start = {x_m = 900_000}
[[vehicle.task]]
kind = "path_follow"
points_frame = "start"
points = [[200_000, 0, 10]]
)"),
            "10:10: points are [x, y, depth], with x and y within 1000 km of the origin and depths "
            "from 0 to 20000 m\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidWordsAndNumbersOfAPath) {
  EXPECT_EQ(ErrorsOfPath(R"(points = [[100, 0, 20]]
points_frame = "here"
speed_mps = 0
propeller_rpm = -1
waypoint_switch = "circles"
end = "quit"
lookahead_m = 0
crab_gain = 2
guard_crab = 1
hold_radius_m = 5
acceptance_radius_m = 10
)"),
            "12:16: unknown points_frame 'here'; one of: mission, start\n"
            "13:13: speed_mps = 0 is out of range; allowed: greater than 0, at most 50\n"
            "14:17: propeller_rpm = -1 is out of range; allowed: 0 to 10000\n"
            "15:19: unknown waypoint_switch 'circles' (did you mean 'circle'?)\n"
            "16:7: unknown end 'quit'; one of: done, go_on, hold, return_to_first, surface, "
            "loiter\n"
            "17:15: lookahead_m = 0 is out of range; allowed: greater than 0, at most 10000\n"
            "18:13: crab_gain = 2 is out of range; allowed: 0 to 1\n"
            "19:14: guard_crab must be true or false, not a whole number\n"
            "20:17: hold_radius_m must not be less than acceptance_radius_m\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidWaysToFlyAPath) {
  EXPECT_EQ(ErrorsOfPath(R"(points = [[100, 0, 20]]
turn_radius_m = -1
approach = 1
depth_rule = "glide"
passed_line_within_m = -1
)"),
            "12:17: turn_radius_m = -1 is out of range; allowed: 0 to 10000\n"
            "13:12: approach must be true or false, not a whole number\n"
            "14:14: unknown depth_rule 'glide'; one of: next, slope\n"
            "15:24: passed_line_within_m = -1 is out of range; allowed: 0 to 1000000\n");
}

TEST(LoadUnderwaterErrors, AreNoneForPathsOfEachKindOfPart) {
  EXPECT_EQ(ErrorsOfPath(R"(path = [
  {kind = "points", points = [[0, 0, 5]]},
  {kind = "yoyo", to = [600, 0]},
  {kind = "helix", center = [600, 100]},
  {kind = "lawnmower", polygon = [[0, 0], [200, 0], [200, 100], [0, 100]]},
  {kind = "random"},
  {kind = "random", start = [0, 0, 5], start_heading_deg = 90, insert_at = 0},
]
)"),
            "");
}

TEST(LoadUnderwaterErrors, ReportPathsThatCannotBeJoined) {
  EXPECT_EQ(ErrorsOfPath("path = []\n"),
            "11:8: a path is joined of 1 to 100 parts, like path = [{kind = \"points\", points = "
            "[[100, 0, 20]]}]\n");
  EXPECT_EQ(ErrorsOfPath("path = [{kind = \"helix\", center = [0, 0]}]\npoints = [[0, 0, 1]]\n"),
            "12:10: a path_follow has points or a path: write these as a part {kind = \"points\", "
            "points = ...} of the path\n");
  EXPECT_EQ(ErrorsOfPath("path = [{kind = \"spiral\"}]\n"),
            "11:17: unknown kind 'spiral'; one of: points, random, lawnmower, helix, yoyo\n");
  EXPECT_EQ(ErrorsOfPath("path = [{points = [[0, 0, 1]]}]\n"),
            "11:9: path lacks 'kind'; for example: kind = \"points\"\n");
  EXPECT_EQ(ErrorsOfPath("path = [{kind = \"points\"}]\n"),
            "11:9: path lacks 'points'; for example: points = [[0, 0, 10], [100, 0, 20]]\n");
  EXPECT_EQ(ErrorsOfPath("path = [{kind = \"points\", points = [[0, 0, 1]], insert_at = 1}]\n"),
            "11:61: insert_at = 1 is beyond the path so far, which has 0 points, the first of them "
            "0: leave it out to go on at the end\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidRandomParts) {
  EXPECT_EQ(ErrorsOfPath(R"([[vehicle.task.path]]
kind = "random"
num_points = 0
start = [0, 0, -1]
start_heading_deg = 400
min_turn_deg = 20
max_turn_deg = 10
min_leg_m = 300
min_depth_m = 200
)"),
            "11:1: max_depth_m = 100 must not be less than min_depth_m = 200\n"
            "11:1: max_leg_m = 200 must not be less than min_leg_m = 300\n"
            "13:14: num_points = 0 is out of range; allowed: 1 to 10000\n"
            "14:9: start must be [x, y, depth], with x and y within 1000 km of the origin and a "
            "depth from 0 to 20000 m\n"
            "15:21: start_heading_deg = 400 is out of range; allowed: -360 to 360\n"
            "17:16: max_turn_deg = 10 must not be less than min_turn_deg = 20\n");
  EXPECT_EQ(ErrorsOfPath(R"([[vehicle.task.path]]
kind = "random"
num_points = 1000
min_leg_m = 90_000
max_leg_m = 100_000
min_turn_deg = 0
max_turn_deg = 0
)"),
            "11:1: the path leads more than 1000 km from the origin: shorten its legs, or give it "
            "fewer points\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidLawnmowersHelicesAndYoyos) {
  EXPECT_EQ(ErrorsOfPath(R"([[vehicle.task.path]]
kind = "lawnmower"
polygon = [[0, 0], [10, 0]]
[[vehicle.task.path]]
kind = "helix"
radius_m = 0
turns = 0
end_depth_m = -1
[[vehicle.task.path]]
kind = "yoyo"
top_m = 40
bottom_m = 30
glide_deg = 0
)"),
            "13:11: a polygon needs three corners or more, like [[0, 0], [200, 0], [200, 100]]\n"
            "14:1: path lacks 'center'; for example: center = [100, -50]\n"
            "16:12: radius_m = 0 is out of range; allowed: greater than 0, at most 100000\n"
            "17:9: turns = 0 is out of range; allowed: greater than 0, at most 1000\n"
            "18:15: end_depth_m = -1 is out of range; allowed: 0 to 20000\n"
            "19:1: path lacks 'to'; for example: to = [400, 0]\n"
            "22:12: bottom_m = 30 must be more than top_m = 40\n"
            "23:13: glide_deg = 0 is out of range; allowed: 1 to 60\n");
  EXPECT_EQ(ErrorsOfPath("path = [{kind = \"helix\", center = [0, 0], turns = 999}]\n"),
            "11:51: turns = 999 at radius_m = 50 takes 31969 points; allowed: at most 10000\n");
  EXPECT_EQ(
      ErrorsOfPath("path = [{kind = \"yoyo\", start = [0, 0, 1], to = [100_000, 0], top_m = 1, "
                   "bottom_m = 2}]\n"),
      "11:49: the yo-yo to here has 26798 turning points; allowed: at most 10000: glide less "
      "steeply, or between depths farther apart\n");
}

std::vector<std::string> WarningsOfPath(std::string_view keys) {
  return WarningsBesideConduct(LoadMissionText(
      std::string(kSwarm) + "[[vehicle.task]]\nkind = \"path_follow\"\n" + std::string(keys), "m"));
}

TEST(LoadUnderwaterWarnings, StateWhatAVehicleCannotDoOnItsPath) {
  EXPECT_EQ(WarningsOfPath("points = [[0, 0, 20], [100, 0, 20]]\n"), std::vector<std::string>{});
  const auto expect_one = [](std::string_view keys, const std::string& part) {
    const std::vector<std::string> warnings = WarningsOfPath(keys);
    ASSERT_EQ(warnings.size(), 1U) << keys;
    EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
  };
  EXPECT_EQ(WarningsOfPath("points = [[0, 0, 20], [300, 0, 20]]\n"), std::vector<std::string>{})
      << "nothing waits for its end";
  expect_one(
      "points = [[0, 0, 20], [300, 0, 20]]\n[[expect]]\nkind = \"laps\"\nvehicle = "
      "\"alpha\"\ntask = \"path_follow\"\n",
      "the path is 300 m long and takes 150 s at 2 m/s, but the mission ends after 60 s: "
      "raise duration_s or speed_mps");
  expect_one("points = [[0, 0, 20]]\nspeed_mps = 12\n", "speed_mps = 12 is more than the ");
  expect_one("points = [[0, 0, 20]]\npropeller_rpm = 5000\n",
             "propeller_rpm = 5000 is more than the propeller's 1525");
  expect_one("points = [[0, 0, 120]]\n",
             "the path goes down to 120 m, but the vehicle's max_depth_m is 100: it stays above");
  expect_one("points = [[0, 0, 20], [50, 0, 70]]\ndepth_rule = \"slope\"\n",
             "a leg is 45 degrees steep; beyond 18 the vehicle lags behind the slope");
  expect_one("points = [[0, 0, 20]]\nturn_radius_m = 10\n",
             "turn_radius_m = 10 is tighter than the 22.5 m");
}

TEST(LoadUnderwaterErrors, ReportInvalidTargets) {
  EXPECT_EQ(ErrorsOfTrack(""), "9:1: task lacks 'target'; for example: target = \"alpha\"\n");
  EXPECT_EQ(ErrorsOfTrack("target = \"Alpha\"\n"), "11:10: a vehicle cannot follow itself\n");
  EXPECT_EQ(ErrorsOfTrack("target = \"zulu\"\n"),
            "11:10: unknown vehicle 'zulu'; the mission has bravo, alpha\n");
  EXPECT_EQ(ErrorsOfTrack("target = \"brava\"\ngroup = [\"bravo\", \"alfa\"]\n"),
            "11:10: unknown vehicle 'brava' (did you mean 'bravo'?)\n"
            "12:9: unknown vehicle 'alfa' (did you mean 'alpha'?)\n");
}

TEST(LoadUnderwaterErrors, ReportUnknownLawsAndLayers) {
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nlaw = \"cascades\"\nswarm = \"relayed\"\n"),
            "12:7: unknown law 'cascades' (did you mean 'cascade'?)\n"
            "13:9: unknown swarm 'relayed'; one of: direct, acoustic\n");
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nlayers = [\"formations\", \"survival\"]\n"),
            "12:10: unknown layer 'formations' (did you mean 'formation'?); there are: survival, "
            "sonar, survival_and_sonar, formation, feed_forward\n");
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nlayers = []\n"),
            "12:10: a cascade needs a layer: survival, sonar, survival_and_sonar, formation, "
            "feed_forward\n");
}

TEST(LoadUnderwaterErrors, ReportWhatIsWrongWithTheLayersOfAPath) {
  const std::string points = "points = [[100, 0, 20]]\n";
  EXPECT_EQ(ErrorsOfPath(points + "layers = [\"survival\"]\ngroup = [\"Bravo\"]\n"), "");
  EXPECT_EQ(ErrorsOfPath(points + "layers = [\"formation\"]\n"),
            "12:10: unknown layer 'formation'; there are: survival, sonar, survival_and_sonar\n");
  EXPECT_EQ(ErrorsOfPath(points + "layers = [\"sonar\"]\n"),
            "12:10: the layers that keep away from what a sonar sees need one: write "
            "[vehicle.sonar] under the [[vehicle]]\n");
  EXPECT_EQ(ErrorsOfPath(points + "r_safe_m = 5\n"),
            "12:1: unknown key 'r_safe_m' (it is for layers: write layers = [\"survival\"] as "
            "well)\n");
  EXPECT_EQ(ErrorsOfPath(points + "layers = [\"survival\"]\nalpha = 1.5\nr_pass_m = -1\n"),
            "13:9: alpha = 1.5 is out of range; allowed: 0 to 1\n"
            "14:12: r_pass_m = -1 is out of range; allowed: 0 to 100000\n");
  EXPECT_EQ(ErrorsOfPath(points + "layers = [\"survival\"]\nspeed_mps = 3\nu_max_mps = 2\n"),
            "14:13: u_max_mps = 2, which the layers share, must not be less than speed_mps = 3\n");
  EXPECT_EQ(
      ErrorsOfPath(points + "layers = [\"survival\"]\nswarm = \"acoustic\"\n"),
      "13:9: swarm = \"acoustic\" is for members of [swarm], and alpha is none: name it there, "
      "or write swarm = \"direct\"\n");
}

TEST(LoadUnderwaterErrors, ReportRadiiOutOfOrder) {
  EXPECT_EQ(ErrorsOfTrack(R"(target = "bravo"
r_safe_m = 30
r_avoid_m = 30
r_inner_m = 20
r_follow_m = 15
)"),
            "13:13: r_avoid_m = 30 must be more than r_safe_m = 30\n"
            "14:13: r_inner_m = 20 must be more than r_safe_m = 30\n"
            "15:14: r_follow_m = 15 must be more than r_inner_m = 20\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidNumbersOfATrack) {
  EXPECT_EQ(ErrorsOfTrack(R"(target = "bravo"
u_max_mps = 0
z_max_m = 0
z_min_m = -1
z_safe_m = 0
climb_mps = -1
max_pitch_deg = 91
)"),
            "12:13: u_max_mps = 0 is out of range; allowed: greater than 0, at most 50\n"
            "13:11: z_max_m = 0 is out of range; allowed: greater than 0, at most 20000\n"
            "14:11: z_min_m = -1 is out of range; allowed: 0 to 20000\n"
            "15:12: z_safe_m = 0 is out of range; allowed: greater than 0, at most 20000\n"
            "16:13: climb_mps = -1 is out of range; allowed: 0 to 50\n"
            "17:17: max_pitch_deg = 91 is out of range; allowed: greater than 0, at most 90\n");
}

TEST(LoadUnderwaterErrors, ReportKeysOfTheOtherLaw) {
  const std::string errors =
      ErrorsOfTrack("target = \"bravo\"\nlaw = \"constant_bearing\"\nr_avoid_m = 3\n");
  EXPECT_TRUE(errors.starts_with("13:1: unknown key 'r_avoid_m'; known here: ")) << errors;
}

TEST(LoadUnderwaterErrors, ReportAnInvalidVehicle) {
  EXPECT_EQ(ErrorsInSwarm(R"([vehicle.remus100]
parameters = "fosen"
model_step_s = 0.5
cruise_depth_m = -1
max_depth_m = 0
seabed_clearance_m = 1001
depth_filter_s = -1
max_propeller_rate_rpmps = nan
)"),
            "10:14: unknown parameters 'fosen' (did you mean 'fossen'?)\n"
            "11:16: model_step_s = 0.5 is out of range; allowed: 0.0001 to 0.2\n"
            "12:18: cruise_depth_m = -1 is out of range; allowed: 0 to 20000\n"
            "13:15: max_depth_m = 0 is out of range; allowed: greater than 0, at most 20000\n"
            "14:22: seabed_clearance_m = 1001 is out of range; allowed: 0 to 1000\n"
            "15:18: depth_filter_s = -1 is out of range; allowed: 0 to 1000\n"
            "16:28: max_propeller_rate_rpmps = nan is out of range; allowed: 0 to 1000000\n");
}

TEST(LoadUnderwaterErrors, ReportTasksThatASurfaceCraftCannotDo) {
  EXPECT_EQ(ErrorsAfter("[[vehicle.task]]\nkind = \"path_follow\"\npoints = [[1, 2, 3]]\n"),
            "6:8: path_follow is a task of underwater vehicles: write model = \"remus100\" in the "
            "[[vehicle]], or kind = \"waypoints\"\n");
  EXPECT_EQ(ErrorsAfter("start = {depth_m = 3}\n"),
            "5:9: only a vehicle of model = \"remus100\" can start under water\n");
}

TEST(LoadUnderwaterErrors, ReportATickTooSlowToSteerBy) {
  EXPECT_EQ(ErrorsInSwarm("", {"mission.tick_s=0.2"}), "");
  EXPECT_EQ(ErrorsOf("[mission]\nduration_s = 60\ntick_s = 0.25\n[[vehicle]]\nname = \"alpha\"\n"
                     "model = \"remus100\"\n"),
            "6:9: a remus100 must be steered every 0.2 s or faster: write tick_s = 0.1 in "
            "[mission]\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidCurrents) {
  EXPECT_EQ(ErrorsAfter(R"([environment.current]
speed_mps = "slow"
direction_deg = 361
speed_deviation_mps = "0.5..0.1"
direction_deviation_deg = "-1..1"
speed_half_period_s = 0
direction_half_period_s = "1e400"
)"),
            "6:13: speed_mps = 'slow' is impossible; write a number from 0 to 50, two like "
            "\"0.1..0.4\", or one of: dead, typical, moderate, swift, fast, any\n"
            "7:17: direction_deg = '361' is impossible; write a number from -360 to 360, two like "
            "\"0.1..0.4\", or one of: east, northeast, north, northwest, west, southwest, south, "
            "southeast, any\n"
            "8:23: speed_deviation_mps = '0.5..0.1' is impossible; write a number from 0 to 50, "
            "two like \"0.1..0.4\", or one of: constant, steady, varied, unsteady, any\n"
            "9:27: direction_deviation_deg = '-1..1' is impossible; write a number from 0 to 180, "
            "two like \"0.1..0.4\", or one of: constant, steady, varied, unsteady, any\n"
            "10:23: speed_half_period_s = '0' is impossible; write a number from 0.001 to 1e+09, "
            "two like \"0.1..0.4\", or one of: calm, smooth, regular, choppy, any\n"
            "11:27: direction_half_period_s = '1e400' is impossible; write a number from 0.001 to "
            "1e+09, two like \"0.1..0.4\", or one of: calm, smooth, regular, choppy, any\n");
}

TEST(LoadUnderwaterErrors, ReportWordsThatOnlyLookLikeNumbers) {
  for (const char* word :
       {"\"\"", "\"..\"", "\"1..\"", "\"..1\"", "\"1..2..3\"", "\"1 m/s\"", "\"nan\"", "\"inf\"",
        "\"1\\u00002\"", "nan", "inf", "true", "-1", "\"-1..0\"", "\"1...2\""}) {
    const std::string errors =
        ErrorsAfter("[environment]\ncurrent = {speed_mps = " + std::string(word) + "}\n");
    EXPECT_TRUE(errors.starts_with("6:24: speed_mps")) << word << ": " << errors;
  }
}

TEST(LoadUnderwaterErrors, ReportUnknownPresets) {
  EXPECT_EQ(ErrorsAfter("[environment]\ncurrent = {preset = \"stormi\"}\n"),
            "6:21: unknown preset 'stormi' (did you mean 'stormy'?)\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidFloors) {
  EXPECT_EQ(ErrorsAfter(R"([environment.floor]
style = "shelves"
depth_m = -1
range_m = 20_001
size_m = 0
scale_m = 0
slope_east = 11
slope_north = -11
grid_is_depth = 1
grid_origin = [1]
)"),
            "6:9: unknown style 'shelves' (did you mean 'shelf'?)\n"
            "7:11: depth_m = -1 is out of range; allowed: 0 to 20000\n"
            "8:11: range_m = 20001 is out of range; allowed: 0 to 20000\n"
            "9:10: size_m = 0 is out of range; allowed: 1 to 1000000\n"
            "10:11: scale_m = 0 is out of range; allowed: 1 to 1000000\n"
            "11:14: slope_east = 11 is out of range; allowed: -10 to 10\n"
            "12:15: slope_north = -11 is out of range; allowed: -10 to 10\n"
            "13:17: grid_is_depth must be true or false, not a whole number\n"
            "14:15: grid_origin must be two numbers like [10, 20], not an array of 1\n");
}

TEST(LoadUnderwaterErrors, ReportAGridWithoutAPath) {
  EXPECT_EQ(ErrorsAfter("[environment]\nfloor = {style = \"grid\"}\n"),
            "6:18: style = \"grid\" needs grid = \"bay.asc\", an ESRI ASCII file, or \"bay.nc\"\n");
  EXPECT_EQ(ErrorsAfter("[environment]\nfloor = {grid = \"\"}\n"),
            "6:17: grid must not be empty\n");
}

TEST(LoadUnderwaterErrors, ReportAMissingOrInvalidGrid) {
  EXPECT_EQ(ErrorsAfter("[environment]\nfloor = {grid = \"no/such/bay.asc\"}\n"),
            "6:9: no/such/bay.asc: cannot be read: No such file or directory; a grid's path counts "
            "from the mission file's folder\n");
  EXPECT_EQ(ErrorsAfter("[environment]\nfloor = {grid = \"/\"}\n"),
            "6:9: /: is a directory; name the grid's file in it\n");
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "load_underwater_errors_test.asc";
  std::ofstream(path) << "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n-10 deep\n";
  const std::string errors =
      ErrorsAfter("[environment]\nfloor = {grid = \"" + path.string() + "\"}\n");
  EXPECT_TRUE(errors.starts_with("6:9: " + path.string() + ":6: ")) << errors;
  EXPECT_NE(errors.find("'deep'"), std::string::npos) << errors;
  std::filesystem::remove(path);
}

TEST(LoadUnderwaterErrors, ReportAGridThatIsAPipeOrADevice) {
  const std::string pipe = testing::TempDir() + "load_underwater_errors_test.pipe";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {std::string("/dev/zero"), pipe}) {
    EXPECT_EQ(ErrorsAfter("[environment]\nfloor = {grid = \"" + path + "\"}\n"),
              "6:9: " + path +
                  ": is not a regular file; a grid's path counts from the mission file's folder\n");
  }
  std::filesystem::remove(pipe);
}

TEST(LoadUnderwaterErrors, ReportExpectationsThatCanNeverHold) {
  EXPECT_EQ(ErrorsInSwarm("[[expect]]\nkind = \"track\"\nvehicle = \"alpha\"\nmax_m = 0\n"
                          "from_s = 61\n"),
            "12:9: max_m = 0 is out of range; allowed: greater than 0, at most 100000\n"
            "13:10: from_s = 61 is out of range; allowed: 0 to 60\n");
  EXPECT_EQ(ErrorsInSwarm("[[expect]]\nkind = \"distance\"\nvehicle = \"alpha\"\n"),
            "9:1: an expectation of a distance needs min_m, max_m or both\n"
            "9:1: expect lacks 'to'; for example: to = \"alpha\", or \"all\"\n");
  EXPECT_EQ(ErrorsInSwarm("[[expect]]\nkind = \"distance\"\nvehicle = \"all\"\nto = \"bravo\"\n"
                          "min_m = 5\nmax_m = 4\n"),
            "14:9: max_m is less than min_m: this can never hold\n");
  EXPECT_EQ(ErrorsInSwarm("[[expect]]\nkind = \"altitude\"\nvehicle = \"alpha\"\nmin_m = 5\n"),
            "9:1: there is no altitude without a sea floor: write [environment] floor = {style "
            "= \"flat\", depth_m = 50}\n");
}

TEST(LoadUnderwaterErrors, ReportMoreLapsThanATaskHas) {
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nname = \"follow\"\n[[expect]]\nkind = \"laps\"\n"
                          "vehicle = \"alpha\"\ntask = \"follow\"\n"),
            "16:8: 'follow' of alpha is a target_track, which has no laps\n");
  EXPECT_EQ(ErrorsOfPath("points = [[9, 9, 9]]\nname = \"path\"\n[[expect]]\nkind = \"laps\"\n"
                         "vehicle = \"alpha\"\ntask = \"path\"\nat_least = 2\n"),
            "17:12: at_least = 2 can never hold: 'path' of alpha ends after 1 lap\n");
}

TEST(LoadUnderwaterErrors, ReportLayersThatNeedASonar) {
  const std::string text = "target = \"bravo\"\nlayers = [\"survival_and_sonar\"]\n";
  EXPECT_EQ(ErrorsOfTrack(text),
            "12:10: the layers that keep away from what a sonar sees need one: write "
            "[vehicle.sonar] under the [[vehicle]]\n");
  EXPECT_EQ(ErrorsOfTrack(text + "[vehicle.sonar]\n"), "");
}

TEST(LoadUnderwaterErrors, ReportFloorsThatAVehicleCannotKnow) {
  EXPECT_EQ(
      ErrorsInSwarm("[vehicle.remus100]\nfloor_from = \"chart\"\n"),
      "10:14: floor_from = \"chart\" needs a sea floor: write floor = {style = \"linear\"} in "
      "[environment], or floor_from = \"altimeter\"\n");
  EXPECT_EQ(ErrorsInSwarm("[vehicle.remus100]\nfloor_from = \"sonar\"\n"),
            "10:14: floor_from = \"sonar\" needs one: write [vehicle.sonar] under the [[vehicle]], "
            "or floor_from = \"altimeter\"\n");
  EXPECT_EQ(ErrorsInSwarm("[vehicle.remus100]\nfloor_from = \"sonar\"\n[vehicle.sonar]\n"), "");
  EXPECT_EQ(ErrorsInSwarm("[vehicle.remus100]\nfloor_from = \"chart\"\n"
                          "[environment]\nfloor = {style = \"flat\"}\n"),
            "");
}

TEST(LoadUnderwaterErrors, ReportBuoyanciesThatNoFinHolds) {
  EXPECT_EQ(ErrorsInSwarm("[vehicle.remus100]\nbuoyancy_by_weight = 2\n"),
            "10:22: buoyancy_by_weight = 2 is out of range; allowed: 0.9 to 1.1\n");
}

TEST(LoadUnderwaterErrors, ReportDepthLimitsThatLeaveNoWater) {
  EXPECT_EQ(ErrorsOfTrack("target = \"bravo\"\nz_min_m = 30\nz_max_m = 20\n"),
            "12:11: z_min_m = 30 must be less than z_max_m = 20\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidInstruments) {
  EXPECT_EQ(ErrorsInSwarm("[vehicle.sonar]\nazimuth_beams = 0\nbeams = 3\n"),
            "10:17: azimuth_beams = 0 is out of range; allowed: 1 to 256\n"
            "11:1: unknown key 'beams' (did you mean 'azimuth_beams'?)\n");
  EXPECT_EQ(ErrorsInSwarm("[vehicle.sensors]\nposition_noise_m = -1\n"),
            "10:20: position_noise_m = -1 is out of range; allowed: 0 to 10000\n");
}

TEST(LoadUnderwaterErrors, ReportInvalidPlumes) {
  EXPECT_EQ(ErrorsInSwarm("[environment]\nplume = {source = [0, 0, -3]}\n"),
            "10:19: source is [x, y, depth], with a depth from 0 to 20000 m\n");
  EXPECT_EQ(ErrorsInSwarm("[environment]\ncontact = \"bounce\"\n"),
            "10:11: unknown contact 'bounce'; one of: ignore, stop\n");
}

}  // namespace shoal::load_underwater_errors_test

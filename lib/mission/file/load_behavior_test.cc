// [[vehicle.behavior]], [[vehicle.mode]], [vehicle.variables], [vehicle.domain] and [[obstacle]].
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_behavior_test {

constexpr std::string_view kWhole = R"([mission]
duration_s = 60
[[obstacle]]
id = "rock"
polygon = [[40, -10], [60, -10], [60, 10], [40, 10]]
[[vehicle]]
name = "alpha"
[vehicle.helm_options]
deploy_at_start = true
decide_every_s = 0.5
goals_mandatory = true
[vehicle.variables]
DEPLOY = true
DEPTH = 2.5
PLACE = "harbour"
[vehicle.domain]
speed = [0, 5, 51]
[[vehicle.mode]]
set = "MODE = ACTIVE"
condition = "DEPLOY = true"
else = "INACTIVE"
[[vehicle.behavior]]
kind = "waypoint"
name = "survey"
condition = ["MODE = ACTIVE", "DEPTH < 3"]
endflag = "DEPLOY = false"
updates = "SURVEY"
duration = 100
points = [[0, 0], [100, 0]]
speed = 2
wptflag = ["PLACE = $[OSX]"]
[[vehicle.behavior]]
kind = "loiter"
polygon = "radial:: x=0, y=0, radius=30, pts=4, snap=1"
clockwise = "best"
speed = 1
[[vehicle.behavior]]
kind = "avoid_collision"
templating = "spawn"
ignore_group = ["blue"]
[[vehicle.behavior]]
kind = "avoid_obstacle"
id = "rock"
[[vehicle.task]]
kind = "station_keep"
pwt = 20
[[vehicle]]
name = "bravo"
start = {x_m = 50, y_m = 50}
[[vehicle.behavior]]
kind = "trail"
contact = "ALPHA"
)";

TEST(Behaviors, AreReadWithWhatTheyDependOn) {
  const LoadedMission loaded = LoadMissionText(kWhole, "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  const Mission& mission = loaded.mission;
  ASSERT_EQ(mission.obstacles.size(), 1U);
  EXPECT_EQ(mission.obstacles[0].polygon_m.size(), 4U);
  const Vehicle& alpha = mission.vehicles.at(0);
  EXPECT_EQ(alpha.helm_options.decide_every_s, 0.5);
  EXPECT_TRUE(alpha.helm_options.goals_mandatory);
  EXPECT_EQ(alpha.variables.at("DEPLOY"), VariableValue("true"));
  EXPECT_EQ(alpha.variables.at("DEPTH"), VariableValue(2.5));
  EXPECT_EQ(alpha.domain.speed_mps, (Axis{.first = 0, .step = 0.1, .count = 51}));
  EXPECT_EQ(alpha.domain.depth_m.count, 0);
  ASSERT_EQ(alpha.modes.size(), 1U);
  EXPECT_EQ(alpha.modes[0], (ModeOptions{"MODE = ACTIVE", {"DEPLOY = true"}, "INACTIVE"}));
  EXPECT_EQ(alpha.tasks.at(0).pwt, 20);
  ASSERT_EQ(alpha.behaviors.size(), 4U);
  const BehaviorOptions& survey = alpha.behaviors[0];
  EXPECT_EQ(survey.name, "survey");
  EXPECT_EQ(survey.condition.size(), 2U);
  EXPECT_EQ(survey.flags.endflag, std::vector<std::string>{"DEPLOY = false"});
  EXPECT_EQ(survey.duration, 100);
  EXPECT_EQ(std::get<WaypointOptions>(survey.what).points.size(), 2U);
  const auto& loiter = std::get<LoiterOptions>(alpha.behaviors[1].what);
  EXPECT_EQ(alpha.behaviors[1].name, "loiter");
  EXPECT_EQ(alpha.behaviors[1].duration, std::nullopt);
  EXPECT_EQ(loiter.polygon.front(), Eigen::Vector2d(21, 21));
  EXPECT_EQ(loiter.clockwise, "best");
  EXPECT_EQ(alpha.behaviors[2].templating, Templating::kSpawn);
  EXPECT_EQ(std::get<TrailOptions>(mission.vehicles[1].behaviors.at(0).what).contact.contact,
            "alpha");
}

TEST(Behaviors, OfVehiclesThatDiveDecideAboutDepth) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest) + R"(
model = "remus100"
[[vehicle.behavior]]
kind = "constant_depth"
depth = 10
)",
                                               "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_EQ(loaded.mission.vehicles[0].domain.depth_m.count, 101);
}

TEST(Behaviors, OfATemplateAreThoseOfItsVehicles) {
  const LoadedMission loaded = LoadMissionText(R"([mission]
duration_s = 60
[template.boat]
[[template.boat.behavior]]
kind = "constant_speed"
speed = 1
[template.boat.variables]
DEPLOY = "true"
[[vehicle]]
name = "alpha"
template = "boat"
)",
                                               "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_EQ(loaded.mission.vehicles[0].behaviors.at(0).name, "constant_speed");
  EXPECT_EQ(loaded.mission.vehicles[0].variables.size(), 1U);
}

TEST(Behaviors, ThatAreRecipesHaveANameThatOthersCanBeAddedTo) {
  const LoadedMission loaded = LoadMissionText(R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
[[vehicle.behavior]]
kind = "colregs"
templating = "spawn"
[[vehicle.behavior]]
kind = "avoid_collision"
templating = "spawn"
name = "avd"
[[vehicle.behavior]]
kind = "avoid_obstacle"
templating = "none"
polygon = [[0, 0], [10, 0], [10, 10]]
)",
                                               "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  const std::vector<BehaviorOptions>& behaviors = loaded.mission.vehicles[0].behaviors;
  EXPECT_EQ(behaviors.at(0).name, "colregs_");
  EXPECT_EQ(behaviors.at(1).name, "avd");
  EXPECT_EQ(behaviors.at(2).name, "avoid_obstacle");
}

TEST(BehaviorErrors, StateWhatIsWrongAndWhere) {
  EXPECT_EQ(ErrorsAfter(R"([[vehicle.behavior]]
kind = "waypiont"
[[vehicle.behavior]]
kind = "waypoint"
capture = 3
[[vehicle.behavior]]
kind = "loiter"
polygon = [[0, 0], [10, 0], [2, 2], [0, 10]]
condition = "DEPLOY"
[[vehicle.behavior]]
kind = "station_keep"
endflag = ["RETURN"]
[[vehicle.behavior]]
kind = "avoid_collision"
pwt_inner_dist = 300
[[vehicle.behavior]]
kind = "op_region"
[[vehicle.behavior]]
kind = "max_speed"
max_speed = 1
lead = 3
)"),
            "6:8: unknown kind 'waypiont' (did you mean 'waypoint'?)\n"
            "7:1: behavior lacks 'points'; for example: points = [[0, 0], [100, 0]]\n"
            "9:1: unknown key 'capture' (here it is 'capture_radius')\n"
            "12:11: polygon is not convex: give at least three corners that all turn to the same "
            "side\n"
            "13:13: condition 'DEPLOY': 'DEPLOY' compares nothing; write it like DEPLOY = true\n"
            "14:1: station_keep needs station_pt = [0, 0], or center_activate = true to stay where "
            "it begins\n"
            "16:11: flag 'RETURN': write it as VARIABLE = value\n"
            "19:18: pwt_inner_dist must be less than pwt_outer_dist\n"
            "20:1: op_region needs a limit: core_poly = [[-50, -50], [50, -50], [50, 50], [-50, "
            "50]], max_depth, min_altitude or max_time\n"
            "25:1: unknown key 'lead'; known here: kind, name, pwt, condition, runflag, runxflag, "
            "idleflag, activeflag, inactiveflag, endflag, spawnflag, spawnxflag, configflag, "
            "duration, duration_idle_decay, duration_reset, duration_status, nostarve, "
            "nostarve_s, perpetual, updates, templating, max_spawnings, max_speed, tolerance, "
            "speed_slack_var\n");
}

TEST(BehaviorErrors, AreFoundBetweenTables) {
  EXPECT_EQ(ErrorsAfter(R"([[vehicle.behavior]]
kind = "constant_speed"
name = "go"
[[vehicle.behavior]]
kind = "constant_speed"
name = "go"
[[vehicle.behavior]]
kind = "constant_heading"
name = "go_on"
[[vehicle.behavior]]
kind = "constant_depth"
[[vehicle.behavior]]
kind = "trail"
contact = "henry"
[[vehicle.behavior]]
kind = "shadow"
contact = "alpha"
[[vehicle.behavior]]
kind = "avoid_obstacle"
id = "rock"
)"),
            "7:8: the name 'go' is the beginning of 'go_on': pages and updates would mix them up; "
            "give it another\n"
            "10:8: a behavior 'go' of this vehicle exists already; give each a name of its own\n"
            "15:8: constant_depth is about depth, and a surface_craft does not dive: take another "
            "model or leave it out\n"
            "18:11: unknown vehicle 'henry'; the mission has alpha\n"
            "21:11: a vehicle is not a contact of its own\n"
            "24:6: no [[obstacle]] has the id 'rock'\n");
}

TEST(BehaviorErrors, OfAHysteresisWithoutEffect) {
  constexpr std::string_view kHysteresis =
      "[[vehicle.behavior]]\nkind = \"hysteresis\"\nmemory_time = 20\nmax_window_utility = ";
  EXPECT_EQ(ErrorsAfter(std::string(kHysteresis) + "0.1\n"), "");
  EXPECT_EQ(ErrorsAfter(std::string(kHysteresis) + "100\n"), "");
  const std::string refused = ErrorsAfter(std::string(kHysteresis) + "0\n");
  EXPECT_NE(refused.find("max_window_utility"), std::string::npos) << refused;
}

TEST(BehaviorErrors, OfModesDomainVariablesAndObstacles) {
  EXPECT_EQ(ErrorsAfter(R"([vehicle.domain]
speed = [1, 5, 41]
depth = [0, 100, 2.5]
course = 360
[vehicle.variables]
"A B" = 2
[[vehicle.mode]]
set = "ACTIVE"
[[vehicle.mode]]
set = "MODE = ACTIVE"
condition = ["A = 1 and B = 2"]
[[obstacle]]
id = "rock"
polygon = [[0, 0], [1, 0], [1, 1]]
[[obstacle]]
id = "rock"
)"),
            "6:9: the first speed must be 0, so that a vessel can stop\n"
            "7:9: depth must be [first, last, number of points]: first less than last, last at "
            "most 20000, 2 to 10001 points\n"
            "8:1: unknown key 'course' (courses are always whole degrees)\n"
            "9:1: 'A B' is not a name of a variable: letters, digits and _ . - are, as in DEPLOY\n"
            "12:7: set = \"ACTIVE\": write it as \"MODE = ACTIVE\"\n"
            "15:13: condition 'A = 1 and B = 2': put each comparison in parentheses, (A = 1) and "
            "(B = 2), or text with the words and, or in quotes\n"
            "19:1: obstacle lacks 'polygon'; for example: polygon = [[40, -10], [60, -10], "
            "[60, 10], [40, 10]]\n"
            "20:6: an obstacle 'rock' exists already; give each an id of its own\n");
}

std::string WarningsAfter(std::string_view more) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kShortest) + std::string(more), "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  std::string all;
  for (const std::string& warning : WarningsBesideConduct(loaded)) all += warning + "\n";
  return all;
}

TEST(BehaviorFile, TakesAvoidanceWithoutAContactForEveryContact) {
  for (const std::string kind : {"colregs", "avoid_collision"}) {
    const LoadedMission loaded = LoadMissionText(
        std::string(kShortest) + "behavior = [{kind = \"" + kind + "\"}]\n", "m.toml");
    ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
    const BehaviorOptions& behavior = loaded.mission.vehicles.at(0).behaviors.at(0);
    EXPECT_EQ(behavior.templating, Templating::kSpawn);
    EXPECT_EQ(behavior.name, kind + "_");
  }
  const LoadedMission one =
      LoadMissionText(std::string(kShortest) +
                          "[[vehicle]]\nname = \"henry\"\n"
                          "behavior = [{kind = \"colregs\", contact = \"alpha\"}]\n",
                      "m.toml");
  ASSERT_TRUE(one.errors.empty()) << one.errors.front();
  EXPECT_EQ(one.mission.vehicles.at(1).behaviors.at(0).templating, Templating::kNone);
}

TEST(BehaviorWarnings, NameWhatCanNeverHappen) {
  EXPECT_EQ(
      WarningsAfter(R"([[vehicle.behavior]]
kind = "constant_heading"
condition = "GO = true"
[[vehicle.behavior]]
kind = "avoid_collision"
templating = "spawn"
[[vehicle.behavior]]
kind = "avoid_obstacle"
templating = "spawn"
)"),
      "m.toml:5:1: warning: no task and no behavior gives this vehicle a speed, so it never "
      "moves: add a waypoint, a loiter, a constant_speed ...\n"
      "m.toml:7:13: warning: nothing in the file sets GO, so 'GO = true' is false until a "
      "user does: write it in [vehicle.variables], or in an [[event]] with command = "
      "\"set\"\n"
      "m.toml:8:1: warning: avoid_collision_ never has a contact: no other vehicle reports "
      "its position\n"
      "m.toml:11:1: warning: avoid_obstacle_ never begins: the mission has no [[obstacle]]\n");
  EXPECT_EQ(WarningsAfter(R"([[vehicle.behavior]]
kind = "waypoint"
points = [[100, 0]]
[[vehicle.behavior]]
kind = "timer"
templating = "spawn"
)"),
            "m.toml:5:1: warning: waypoint has speed = 0, so it leads nowhere\n"
            "m.toml:10:14: warning: timer_ never begins: only avoid_collision, colregs and "
            "avoid_obstacle do by themselves; write updates = \"VARIABLE\", and name = ... in its "
            "texts\n");
}

TEST(BehaviorWarnings, KnowWhatSetsAVariable) {
  EXPECT_EQ(WarningsAfter(R"toml([vehicle.variables]
A = "x"
[[vehicle.mode]]
set = "B = ON"
condition = "A = x"
[[vehicle.behavior]]
kind = "constant_speed"
speed = 1
runflag = "C = 1"
condition = ["A = x", "B = ON", "!(C = 2)", "D = 1", "E = 1", "!(WPT_INDEX > 3)", "NAV_X > 3"]
[[event]]
at_s = 3
vehicle = "alpha"
command = "set"
argument = "D = 1"
[[event]]
at_s = 3
message = {src_node = "alpha", dest_node = "all", var_name = "E", double_val = 1}
)toml"),
            "");
}

TEST(BehaviorWarnings, KnowVariablesThatBehaviorsPostUnderNamesOfTheMission) {
  EXPECT_EQ(WarningsAfter(R"toml([[vehicle.behavior]]
kind = "waypoint"
name = "leg"
points = [[0, 0], [100, 0]]
speed = 1
post_suffix = "A"
index_var = "PLACE"
dist_to_next_var = "TO_GO"
dist_to_prev_var = "GONE"
[[vehicle.behavior]]
kind = "constant_speed"
speed = 1
speed_mismatch_var = "OFF"
condition = ["PLACE_A > 0", "TO_GO < 25", "GONE > 20", "OFF < 1"]
)toml"),
            "");
}

TEST(BehaviorWarnings, NameVariablesThatOnlyBeginAsReportedOnes) {
  for (const char* name : {"NAV_YAW", "NAV_SPEED_OVER_GROUND", "WPT_DIST_TO_NEXT"}) {
    const std::string warnings =
        WarningsAfter("[[vehicle.behavior]]\nkind = \"constant_speed\"\nspeed = 1\ncondition = \"" +
                      std::string(name) + " > 1\"\n");
    EXPECT_NE(warnings.find("nothing in the file sets " + std::string(name)), std::string::npos)
        << warnings;
  }
}

}  // namespace shoal::load_behavior_test

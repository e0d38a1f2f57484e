#include "lib/tools/moos/import.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/file/load.h"
#include "lib/tools/moos/quoted_csv_testing.h"

namespace shoal::import_test {

constexpr std::string_view kShore = R"(ServerHost = localhost
ServerPort = 9000
Community = shoreside
MOOSTimeWarp = 10
LatOrigin = 54.4
LongOrigin = 10.2

ProcessConfig = ANTLER
{
  MSBetweenLaunches = 200
  Run = MOOSDB @ NewConsole = false
  Run = uFldNodeComms @ NewConsole = false ~ unc
  Run = myApp @ NewConsole = false
}

ProcessConfig = uFldNodeComms
{
  AppTick        = 4
  COMMS_RANGE    = 250       // metres
  stale_time     = 8
  pulse_colour   = red
  stealth        = vname=ABE, stealth=0.8
  earange        = vname=ben, earange=4.5
  earange        = vname=zoe, earange=2
}

ProcessConfig = pMarineViewer
{
  tiff_file = here.tif
}
)";

std::string Vehicle(const std::string& name) {
  return "Community = " + name + R"(
ProcessConfig = uSimMarineV22
{
  start_pos   = x=10, y=-20, heading=180, speed=0.5
  turn_rate   = 40
  thrust_map  = 0:0, 60:3, 20:1
  drift_vector = 90, 0.25
  turn_loss = 7
  sim_pause   = true
}
ProcessConfig = pMarinePIDV22
{
  yaw_pid_kp = 1.2
}
ProcessConfig = pNodeReporter
{
  AppTick = 4
  platform_type = heron
  platform_aspect = CREW=none, yet
  group = survey
  rider = var=FOO
}
)";
}

LoadedMission Loaded(const MoosImport& import) {
  LoadedMission loaded = LoadMissionText(import.mission, "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>()) << import.mission;
  return loaded;
}

MoosImport Import(std::vector<MoosSource> sources) { return ImportMoos(sources); }

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool Warns(const MoosImport& import, const std::string& part) {
  return std::any_of(import.warnings.begin(), import.warnings.end(),
                     [&](const std::string& warning) { return Has(warning, part); });
}

TEST(ImportMoos, MergesShoreAndVehiclesIntoOneMission) {
  const MoosImport import = Import({{"shore.moos", std::string(kShore)},
                                    {"abe.moos", Vehicle("abe")},
                                    {"ben.moos", Vehicle("ben")}});
  EXPECT_EQ(import.num_vehicles, 2U);
  const Mission mission = Loaded(import).mission;
  EXPECT_EQ(mission.origin_lat_deg, 54.4);
  EXPECT_EQ(mission.origin_lon_deg, 10.2);
  EXPECT_EQ(mission.comms.comms_range_m, 250);
  EXPECT_EQ(mission.comms.stale_time_s, 8);
  ASSERT_EQ(mission.vehicles.size(), 2U);
  const shoal::Vehicle& abe = mission.vehicles[0];
  EXPECT_EQ(abe.name, "abe");
  EXPECT_EQ(abe.type, "heron");
  EXPECT_EQ(abe.group, "survey");
  EXPECT_EQ(abe.start, (StartPose{10, -20, 180, 0.5}));
  EXPECT_EQ(abe.link_factors.stealth, 0.8);
  EXPECT_EQ(mission.vehicles[1].link_factors.earange, 4.5);
  EXPECT_EQ(std::get<SurfaceCraftParams>(abe.model).turn_rate_degps, 40);
  EXPECT_EQ(std::get<SurfaceCraftParams>(abe.model).thrust_map,
            (std::vector<ThrustPoint>{{0, 0}, {20, 1}, {60, 3}}));
  EXPECT_EQ(abe.autopilot.heading_kp, 1.2);
  EXPECT_EQ(abe.reporter_options.rate_hz, 4);
  EXPECT_EQ(abe.reporter_options.extra.at("CREW"), "none, yet");
  ASSERT_EQ(mission.events.size(), 2U);
  const auto& drift = std::get<SimCommandEvent>(mission.events[0].what);
  EXPECT_EQ(drift.vehicle, "abe");
  EXPECT_NEAR(drift.values.at(0), 0.25, 1e-12);
  EXPECT_NEAR(drift.values.at(1), 0, 1e-12);
}

TEST(ImportMoos, CommentsEveryLineWithoutACounterpart) {
  const MoosImport import =
      Import({{"shore.moos", std::string(kShore)}, {"abe.moos", Vehicle("abe")}});
  for (const char* comment :
       {"# shore.moos:21: pulse_colour = red: no counterpart in shoal\n",
        "# shore.moos:13: Run = myApp @ NewConsole = false: no counterpart in shoal; ",
        "# shore.moos:29: tiff_file = here.tif: no counterpart in shoal\n",
        "# shore.moos:4: MOOSTimeWarp = 10: shoal run --warp 10\n",
        "# abe.moos:9: sim_pause = true: no counterpart in shoal\n",
        "# abe.moos:21: rider = var=FOO: no counterpart in shoal\n"}) {
    EXPECT_TRUE(Has(import.mission, comment)) << comment << import.mission;
  }
}

TEST(ImportMoos, NamesTheLineOfEverySetting) {
  const MoosImport import = Import({{"shore.moos", std::string(kShore)}});
  EXPECT_TRUE(Has(import.mission, "\ncomms_range = 250  # shore.moos:19\n")) << import.mission;
  EXPECT_TRUE(Has(import.mission, "# shore.moos:5, shore.moos:6\n"));
}

TEST(ImportMoos, WarnsOfWhatShoalRefuses) {
  const MoosImport import = Import({{"abe.moos", Vehicle("abe")}});
  EXPECT_TRUE(Warns(import, "abe.moos:8: turn_loss = 7: ")) << import.mission;
  EXPECT_TRUE(Has(import.mission, "# abe.moos:8: turn_loss = 7: "));
}

TEST(ImportMoos, WarnsOfValuesOfTheWrongKind) {
  const MoosImport import =
      Import({{"a.moos",
               "ProcessConfig = uFldNodeComms\n{\ncomms_range = far\ngroups = 2\n"
               "stealth = 0.5\nmax_msg_length = 12.5\n}\nLatOrigin = 5\n"}});
  Loaded(import);
  EXPECT_TRUE(Warns(import, "a.moos:3: comms_range = far: not a number or nolimit"));
  EXPECT_TRUE(Warns(import, "a.moos:4: groups = 2: not true or false"));
  EXPECT_TRUE(Warns(import, "a.moos:5: stealth = 0.5: not vname=NAME, stealth=NUMBER"));
  EXPECT_TRUE(Warns(import, "a.moos:6: max_msg_length = 12.5: "));
  EXPECT_TRUE(Warns(import, "a.moos:8: an origin needs LatOrigin and LongOrigin"));
}

TEST(ImportMoos, TakesEveryRuleOfTheBroker) {
  const MoosImport import =
      Import({{"a.moos",
               "ProcessConfig = uFldNodeComms\n{\n comms_range = nolimit\n critical_range = 31\n"
               " stale_time = 6\n groups = TRUE\n msg_groups = true\n ignore_group = g\n"
               " min_rpt_interval = -1\n min_msg_interval = 7\n max_msg_length = 0\n"
               " drop_percentage = 12.5\n shared_node_reports = true\n pulse_duration = 3\n"
               " view_node_rpt_pulses = false\n msg_color = red\n msg_repeat_color = blue\n}\n"}});
  const RoutingRules rules = Loaded(import).mission.comms;
  EXPECT_LT(rules.comms_range_m, 0);
  EXPECT_EQ(rules.critical_range_m, 31);
  EXPECT_EQ(rules.stale_time_s, 6);
  EXPECT_TRUE(rules.groups);
  EXPECT_TRUE(rules.msg_groups);
  EXPECT_EQ(rules.ignore_group, "g");
  EXPECT_LT(rules.min_rpt_interval_s, 0);
  EXPECT_EQ(rules.min_msg_interval_s, 7);
  EXPECT_EQ(rules.max_msg_length_bytes, 0);
  EXPECT_EQ(rules.drop_percentage, 12.5);
  EXPECT_EQ(rules.shared_node_reports_s, kSharedReportsInterval_s);
  EXPECT_EQ(rules.pulse_duration_s, 3);
  EXPECT_FALSE(rules.view_node_rpt_pulses);
  EXPECT_EQ(rules.msg_color, "red");
  EXPECT_EQ(rules.msg_repeat_color, "blue");
}

TEST(ImportMoos, MakesUpVehiclesWhereNoFileHasOne) {
  const MoosImport named = Import({{"shore.moos", std::string(kShore)}});
  EXPECT_EQ(named.num_vehicles, 0U);
  EXPECT_TRUE(Warns(named, "no file describes a vehicle"));
  EXPECT_EQ(Loaded(named).mission.vehicles.size(), 3U);
  EXPECT_EQ(Loaded(named).mission.vehicles[0].name, "ABE");
  const MoosImport empty = Import({{"a.moos", ""}});
  EXPECT_EQ(Loaded(empty).mission.vehicles.at(0).name, "alpha");
  EXPECT_EQ(Loaded(Import({})).mission.vehicles.size(), 1U);
}

TEST(ImportMoos, GivesEveryVehicleALegalNameOfItsOwn) {
  const MoosImport import = Import({{"x/meta.moos", Vehicle("$(VNAME)")},
                                    {"b.moos", Vehicle("a-1")},
                                    {"c.moos", Vehicle("A_1")},
                                    {"d.moos", Vehicle("all")},
                                    {"e.moos", Vehicle(std::string(500, 'n'))}});
  std::vector<std::string> names;
  for (const auto& vehicle : Loaded(import).mission.vehicles) names.push_back(vehicle.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"meta", "a_1", "A_1_2", "all_2", std::string(28, 'n')}));
  EXPECT_TRUE(Warns(import, "x/meta.moos:1: 'Community = $(VNAME)' is for nsplug"));
  EXPECT_TRUE(Warns(import, "b.moos: the vehicle is named a_1"));
}

TEST(ImportMoos, ReadsAllWaysToWriteAStart) {
  const auto start = [](const std::string& lines) {
    const MoosImport import =
        Import({{"a.moos", "Community=a\nProcessConfig = uSimMarine\n{\n" + lines + "\n}\n"}});
    return Loaded(import).mission.vehicles.at(0).start;
  };
  EXPECT_EQ(start("START_POS = 1,2,3,4,0"), (StartPose{1, 2, 3, 4}));
  EXPECT_EQ(start("start_pos = 1, 2, heading=90"), (StartPose{1, 2, 90, 0}));
  EXPECT_EQ(start("start_x = 5\nstart_heading = 7"), (StartPose{5, 0, 7, 0}));
  EXPECT_EQ(start("start_pos = here"), StartPose{});
}

TEST(ImportMoos, MakesAThrustMapOfAThrustFactor) {
  const MoosImport import =
      Import({{"a.moos", "Community=a\nProcessConfig = uSimMarine\n{\nthrust_factor = 20\n}\n"}});
  EXPECT_EQ(std::get<SurfaceCraftParams>(Loaded(import).mission.vehicles.at(0).model).thrust_map,
            (std::vector<ThrustPoint>{{100, 5}}));
}

TEST(ImportMoos, WritesTheSameTextForTheSameFiles) {
  const std::vector<MoosSource> sources = {{"s", std::string(kShore)}, {"a", Vehicle("abe")}};
  EXPECT_EQ(ImportMoos(sources).mission, ImportMoos(sources).mission);
}

std::string Helm(const std::string& name, const std::string& behaviors = "a.bhv") {
  return "Community = " + name +
         "\nProcessConfig = uSimMarine\n{\n}\nProcessConfig = pHelmIvP\n{\n" +
         "Behaviors = " + behaviors +
         "\nDomain = course:0:359:360\nDomain = speed:0:5:26\nstart_in_drive = true\n}\n";
}

constexpr const char* kSurvey =
    "initialize DEPLOY = false, N = 2\n"
    "set MODE = ACTIVE {\n DEPLOY = true\n} INACTIVE\n"
    "Behavior = BHV_Waypoint\n{\n name = survey\n condition = MODE == ACTIVE\n"
    " endflag = DEPLOY = false\n updates = UP\n speed = 2\n points = 0,0:100,0\n radius = 5\n}\n"
    "Behavior = BHV_AvdColregsV22\n{\n name = avoid_\n templating = spawn\n"
    " contact = to-be-set\n pwt = 200\n pwt_outer_dist = 80\n}\n";

TEST(ImportMoos, GivesAVehicleTheBehaviorsOfItsFile) {
  const MoosImport import = Import({{"a.moos", Helm("abe")}, {"a.bhv", kSurvey}});
  EXPECT_EQ(import.warnings, std::vector<std::string>());
  const shoal::Vehicle abe = Loaded(import).mission.vehicles.at(0);
  EXPECT_FALSE(abe.helm_options.deploy_at_start);
  EXPECT_EQ(abe.domain.speed_mps.count, 26);
  EXPECT_EQ(abe.domain.speed_mps.Last(), 5);
  EXPECT_EQ(abe.variables.at("DEPLOY"), VariableValue("false"));
  EXPECT_EQ(abe.variables.at("N"), VariableValue(2.0));
  ASSERT_EQ(abe.modes.size(), 1U);
  EXPECT_EQ(abe.modes[0].otherwise, "INACTIVE");
  ASSERT_EQ(abe.behaviors.size(), 2U);
  EXPECT_EQ(abe.behaviors[0].name, "survey");
  EXPECT_EQ(abe.behaviors[0].flags.endflag, (std::vector<std::string>{"DEPLOY = false"}));
  const auto& waypoint = std::get<WaypointOptions>(abe.behaviors[0].what);
  EXPECT_EQ(waypoint.capture_radius, 5);
  EXPECT_EQ(waypoint.points.size(), 2U);
  EXPECT_EQ(abe.behaviors[1].templating, Templating::kSpawn);
  const auto& colregs = std::get<ColregsOptions>(abe.behaviors[1].what);
  EXPECT_LT(colregs.pwt_inner_dist, colregs.pwt_outer_dist) << "90 by default, beyond 80";
}

TEST(ImportMoos, FindsTheBehaviorsOfEachVehicleByName) {
  const std::string timer = "Behavior = BHV_Timer\n{\n name = ";
  const MoosImport import = Import({{"x/a.moos", Helm("abe", "targ_abe.bhv")},
                                    {"x/b.moos", Helm("ben", "other.bhv")},
                                    {"x/b.bhv", timer + "of_ben\n}\n"},
                                    {"y/meta_abe.bhv", timer + "of_abe\n}\n"},
                                    {"y/c.bhv", timer + "of_none\n}\n"}});
  const Mission mission = Loaded(import).mission;
  EXPECT_EQ(mission.vehicles.at(0).behaviors.at(0).name, "of_abe");
  EXPECT_EQ(mission.vehicles.at(1).behaviors.at(0).name, "of_ben");
  EXPECT_TRUE(Warns(import, "y/c.bhv: no vehicle has these behaviors"));
}

TEST(ImportMoos, WarnsOfAVehicleWithoutBehaviors) {
  EXPECT_TRUE(Warns(Import({{"a.moos", Helm("abe")}}),
                    "a.moos:7: Behaviors = a.bhv: no behaviors are there: abe stays where it is"));
}

TEST(ImportMoos, ReadsATemplateOnceForEachVehicle) {
  const std::vector<MoosSource> sources = {
      {"v.moos", "Community = $(VNAME)\nProcessConfig = uSimMarine\n{\nstart_x = $(X)\n}\n"},
      {"v.bhv",
       "Behavior = BHV_StationKeep\n{\n name = keep_$(VNAME)\n station_pt = $(X),$(Y:=7)\n}\n"}};
  const MoosImport import =
      ImportMoos(sources, {.defines = {{"X", "1"}},
                           .vehicles = {{{"VNAME", "abe"}}, {{"VNAME", "ben"}, {"X", "2"}}},
                           .find = {}});
  EXPECT_EQ(import.warnings, std::vector<std::string>());
  const Mission mission = Loaded(import).mission;
  ASSERT_EQ(mission.vehicles.size(), 2U);
  EXPECT_EQ(mission.vehicles[0].start.x_m, 1);
  EXPECT_EQ(mission.vehicles[1].start.x_m, 2);
  EXPECT_EQ(mission.vehicles[1].behaviors.at(0).name, "keep_ben");
  EXPECT_EQ(std::get<StationKeepOptions>(mission.vehicles[1].behaviors[0].what).station_pt,
            Eigen::Vector2d(2, 7));
}

TEST(ImportMoos, LeavesOutABehaviorWhoseConditionIsRefused) {
  const MoosImport import = Import({{"a.moos", Helm("abe")},
                                    {"a.bhv",
                                     "Behavior = BHV_Loiter\n{\n name = l\n condition = (A\n"
                                     " polygon = 0,0:9,0:9,9\n speed = 1\n}\n"
                                     "Behavior = BHV_Timer\n{\n name = t\n pwt = -1\n}\n"}});
  const shoal::Vehicle abe = Loaded(import).mission.vehicles.at(0);
  ASSERT_EQ(abe.behaviors.size(), 1U) << "one that always runs would be another";
  EXPECT_EQ(abe.behaviors[0].name, "t");
  EXPECT_EQ(abe.behaviors[0].pwt, 100) << "a weight that is refused is left out alone";
  EXPECT_TRUE(Warns(import, "a.bhv:4: condition = (A: "));
  EXPECT_TRUE(Warns(import, "a.bhv:11: pwt = -1: "));
}

TEST(ImportMoos, SetsVariablesOfBehaviorsByTimerScripts) {
  const MoosImport import = Import({{"shore.moos",
                                     "ProcessConfig = uTimerScript\n{\n"
                                     "event = var=UP_ABE, val=\"speed=1 # points=1,2\", time=5\n"
                                     "event = var=N_ALL, val=3, time=6\n"
                                     "event = var=DEPLOY_ABE, val=false, time=7\n"
                                     "event = var=DEPLOY_ABE, val=true, time=8\n"
                                     "event = var=OTHER_ABE, val=true, time=9\n}\n"},
                                    {"a.moos", Helm("abe")},
                                    {"a.bhv", kSurvey}});
  const Mission mission = Loaded(import).mission;
  ASSERT_EQ(mission.events.size(), 4U);
  const auto& update = std::get<CommandEvent>(mission.events[0].what);
  EXPECT_EQ(update.vehicle, "abe");
  EXPECT_EQ(update.command, "set");
  EXPECT_EQ(update.argument, "UP=speed=1 # points=1,2");
  EXPECT_EQ(std::get<CommandEvent>(mission.events[1].what).vehicle, "all");
  EXPECT_EQ(std::get<CommandEvent>(mission.events[2].what).argument, "DEPLOY=false");
  EXPECT_EQ(std::get<CommandEvent>(mission.events[3].what).command, "deploy");
  EXPECT_FALSE(Warns(import, "OTHER_ABE"));
  EXPECT_NE(import.mission.find("OTHER_ABE, val=true, time=9: no line and no behavior reads it"),
            std::string::npos);
}

RC_GTEST_PROP(ImportMoos, WritesAMissionThatLoadsWhateverBehaviorsItReads, ()) {
  const auto lines = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "Behavior = BHV_Waypoint {", "Behavior = BHV_Loiter {", "Behavior = BHV_AvdColregsV22 {",
      "Behavior = BHV_OpRegion {", "Behavior = BHV_GoToDepth {", "Behavior = BHV_AvoidObstacle {",
      "}", "}", "name = a", "name = ab", "name = b!", "pwt = -1", "pwt = 1e300",
      "condition = A = b", "condition = (A", "condition = not A", "endflag = X",
      "endflag = X = $[UTC]", "points = 0,0", "points = 1e300,0", "polygon = 0,0:9,0:9,9",
      "polygon = 0,0:9,9:9,0:0,9", "speed = 2", "speed = -2", "duration = -1", "templating = spawn",
      "contact = c", "nostarve = A,-2", "repeat = 1.5", "updates = a b", "pwt_outer_dist = 1",
      "completed_dist = 0", "depth = 1,-1", "set M = A {", "M = B", "} C", "initialize A = 1, B!=2",
      "initialize A = x", "\xff\x01"));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const MoosImport import = Import({{"a.moos", Helm("abe")}, {"a.bhv", text}});
  RC_ASSERT(LoadMissionText(import.mission, "m").errors == std::vector<std::string>());
}

RC_GTEST_PROP(ImportMoos, WritesAMissionThatLoadsWhateverItReads, ()) {
  const auto words = *rc::gen::resize(
      30, rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
              "ProcessConfig = uFldNodeComms\n{\n", "ProcessConfig = uSimMarine\n{\n",
              "ProcessConfig = pNodeReporter\n{\n", "}\n", "\n", "\n", "comms_range = ",
              "stale_time = ", "start_pos = ", "thrust_map = ", "stealth = vname=", "AppTick = ",
              "Community = ", "platform_aspect = ", "drift_x = ", "LatOrigin = ", "LongOrigin = ",
              "blackout_variance = ", "platform_type = ", "1", "-1", "1e300", "nan", ",", ":",
              "a\"b\\", "\xff", "\x01", "\xC3\xA9", "=", "$(X)", "#", "all", "]", "stealth=3")));
  std::string text;
  for (const std::string& word : words) text += word;
  const MoosImport import = Import({{"a\n.moos", text}, {"", text}});
  const LoadedMission loaded = LoadMissionText(import.mission, "m");
  RC_ASSERT(loaded.errors == std::vector<std::string>());
}

/// Returns true where `text` names line `number` of `file`.
bool NamesLine(const std::string& text, const std::string& file, size_t number) {
  const std::string line = file + ":" + std::to_string(number);
  for (size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1)) {
    const char next = text[std::min(at + line.size(), text.size() - 1)];
    if (next < '0' || next > '9') return true;
  }
  return false;
}

RC_GTEST_PROP(ImportMoos, NamesEveryLineThatIsNotEmpty, ()) {
  const auto lines = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "ProcessConfig = uFldNodeComms", "ProcessConfig = uSimMarine", "ProcessConfig = X",
      "ProcessConfig = pNodeReporter", "ProcessConfig = ANTLER", "{", "}", "{", "}",
      "comms_range = 5", "comms_range = 6", "comms_range = x", "stealth = vname=a, stealth=0.5",
      "earange = vname=a", "start_x = 4", "start_depth = 0", "start_pos = 1,2,3,4,5",
      "thrust_map = 1:2", "thrust_factor = 20", "thrust_factor = -1", "drift_x = 1",
      "drift_vector = 1", "turn_rate = 500", "platform_aspect = A=b", "platform_aspect = A",
      "Run = pHelmIvP @ x", "Community = a", "LatOrigin = 1", "LongOrigin = 2", "MOOSTimeWarp = 3",
      "color = $(C)", "#include x", "junk"));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const MoosImport import = Import({{"f", text}});
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() == 1 || lines[i].starts_with("ProcessConfig")) continue;
    RC_ASSERT(NamesLine(import.mission, "f", i + 1));
  }
}

TEST(ImportMoos, StartsEveryGoldenPoseWhereUSimMarineStartsItAndNamesWhatThatRefuses) {
  for (const GoldenRow& row : ReadQuotedCsv("moos_import/start_pos.csv")) {
    SCOPED_TRACE(row.at("start_pos"));
    const MoosImport import = ImportMoos(std::vector<MoosSource>{
        {.name = "ida.moos",
         .text = "Community = ida\nProcessConfig = uSimMarineV22\n{\n  start_pos = " +
                 row.at("start_pos") + "\n}\n"}});
    const StartPose start = Loaded(import).mission.vehicles.front().start;
    EXPECT_EQ(start.x_m, Number(row, "x_m"));
    EXPECT_EQ(start.y_m, Number(row, "y_m"));
    const bool is_warned =
        std::any_of(import.warnings.begin(), import.warnings.end(),
                    [](const std::string& text) { return text.find("start_pos") != text.npos; });
    const std::string& text = row.at("start_pos");
    const bool is_odd = text.find("abc") != text.npos || text.find(",,") != text.npos;
    EXPECT_EQ(is_warned, row.at("result") == "refused" || is_odd);
  }
}

/// Imports a template with plugged lines for one vehicle, with values of macros.
Mission Plugged(const std::string& sim, const std::string& bhv, const MoosDefines& defines) {
  const FindMoosFile find = [](std::string_view name,
                               std::string_view) -> std::optional<MoosSource> {
    if (name != "plug.moos") return std::nullopt;
    return MoosSource{.name = "plug.moos",
                      .text =
                          "<tag><other>\nProcessConfig = pShare\n{\n}\n<tag><sim>\n"
                          "ProcessConfig = uSimMarineV22\n{\nstart_pos = $(START)\n}\n"};
  };
  const MoosImport import = ImportMoos(
      std::vector<MoosSource>{
          {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n" + sim},
          {.name = "ida.bhv", .text = bhv}},
      {.defines = defines, .vehicles = {}, .find = find});
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  return Loaded(import).mission;
}

TEST(ImportMoos, TakesTheSectionOfAPlugFileThatIsAskedFor) {
  const Mission mission = Plugged("#include plug.moos <sim>\n", "Behavior = BHV_Timer\n{\n}\n",
                                  {{"START", "40,-30,90"}});
  EXPECT_EQ(mission.vehicles.front().start,
            (StartPose{.x_m = 40, .y_m = -30, .heading_deg = 90, .speed_mps = 0, .depth_m = 0}));
}

TEST(ImportMoos, TakesAnEmptyMacroAsLaunchScriptsMeanIt) {
  const Mission mission =
      Plugged("ProcessConfig = pNodeReporter\n{\nplatform_type = $(KIND=kayak)\n}\n",
              "#ifdef AWAY\ninitialize FAR = true\n#else\ninitialize NEAR = true\n#endif\n"
              "Behavior = BHV_Waypoint\n{\npoints = 0,0\nspeed = $(SPD:=1.5)\n}\n",
              {{"AWAY", ""}, {"SPD", ""}});
  EXPECT_EQ(mission.vehicles.front().type, "kayak");
  EXPECT_TRUE(mission.vehicles.front().variables.contains("NEAR"));
  EXPECT_FALSE(mission.vehicles.front().variables.contains("FAR"));
}

constexpr std::string_view kWaypointBhv =
    "Behavior = BHV_Waypoint\n{\ncondition = DEPLOY = true\ncondition = PATROL = true\n"
    "speed = 1\npoints = 0,0\n}\n";

/// A vehicle's file with such a line in pHelmIvP, and the shore's with such buttons.
MoosImport WithButtons(const std::string& helm_line, const std::string& buttons) {
  return ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos",
       .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n" + helm_line + "\n}\n"},
      {.name = "ida.bhv", .text = std::string(kWaypointBhv)},
      {.name = "shore.moos",
       .text = "Community = shore\nProcessConfig = pMarineViewer\n{\n" + buttons + "}\n"}});
}

TEST(ImportMoos, MakesDeployAVariableWhereOnlyConditionsNameIt) {
  const shoal::Vehicle ida = Loaded(WithButtons("", "")).mission.vehicles.front();
  EXPECT_EQ(ida.variables,
            (std::map<std::string, VariableValue>{{"DEPLOY", std::string("false")}}));
}

TEST(ImportMoos, SetsWithDeployWhatTheButtonSets) {
  const MoosImport import =
      WithButtons("",
                  "button_one = DEPLOY # DEPLOY_ALL=true # PATROL_IDA=true # color=pink\n"
                  "button_one = MOOS_MANUAL_OVERRIDE_ALL=false # RETURN_ALL=false # OTHER=1\n");
  const shoal::Vehicle ida = Loaded(import).mission.vehicles.front();
  ASSERT_EQ(ida.behaviors.size(), 2U);
  EXPECT_EQ(ida.behaviors[1].name, "deploy_button");
  EXPECT_EQ(ida.variables.at("PATROL"), VariableValue("true"));
  EXPECT_NE(import.mission.find("runflag = [\"PATROL = true\"]"), std::string::npos);
}

TEST(ImportMoos, TakesTheButtonOfTheVehicleWhereEachHasItsOwn) {
  const MoosImport import = WithButtons("",
                                        "button_one = ZOE # DEPLOY_ZOE=true # PATROL_ZOE=false\n"
                                        "button_two = IDA # DEPLOY_IDA=true # PATROL_IDA=true\n");
  EXPECT_NE(import.mission.find("runflag = [\"PATROL = true\"]"), std::string::npos);
  EXPECT_EQ(import.mission.find("PATROL = false"), std::string::npos);
}

TEST(ImportMoos, LosesAnAppOnceAndABehaviorOnce) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos",
       .text = "Community = ida\nProcessConfig = ANTLER\n{\nRun = myApp @ X = 1 ~ b\n}\n"
               "ProcessConfig = pHelmIvP\n{\n}\nProcessConfig = myApp\n{\na = 1\nb = 2\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_Scout\n{\nname = w\nptx = 1\n}\n"
               "Behavior = BHV_HSLine\n{\nname = d\n}\n"
               "Behavior = BHV_Waypoint\n{\nname = v\nspeed = 1\npoints = none\n}\n"}});
  const std::string nearest =
      "ida.bhv:1: Behavior = BHV_Scout: no kind of behavior in shoal; the nearest is "
      "waypoint";
  ASSERT_EQ(import.lost.size(), 3U);
  EXPECT_EQ(import.lost[0], nearest);
  EXPECT_TRUE(import.lost[1].starts_with("ida.bhv:10: Behavior = BHV_Waypoint: ida.bhv:14: points"))
      << import.lost[1];
  EXPECT_EQ(import.lost[2], "ida.moos:4: app myApp: no counterpart in shoal");
  EXPECT_EQ(import.warnings.front(), nearest);
  EXPECT_NE(import.mission.find("BHV_HSLine: draws only: nothing is lost"), std::string::npos);
  ASSERT_EQ(import.outlooks.size(), 1U);
  EXPECT_EQ(import.outlooks[0].why, "it has no behaviors");
}

TEST(ImportMoos, TakesTheSimpleWaypointThatBehaviorsOfOthersBeginWith) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_SimpleWaypoint\n{\nname = w\nspeed = 2\nptx = 100\npty = -50\n"
               "ipf_type = reflector\n}\n"}});
  EXPECT_EQ(import.warnings,
            std::vector<std::string>{"ida.bhv:1: Behavior = BHV_SimpleWaypoint: taken as that of "
                                     "moos-ivp-extend: a waypoint of one point"});
  EXPECT_EQ(import.lost, std::vector<std::string>{});
  const shoal::Vehicle ida = Loaded(import).mission.vehicles.at(0);
  const auto& waypoint = std::get<WaypointOptions>(ida.behaviors.at(0).what);
  EXPECT_EQ(waypoint.points, std::vector<Eigen::Vector2d>({{100, -50}}));
  EXPECT_EQ(waypoint.capture_radius, 10);
  EXPECT_EQ(waypoint.slip_radius, 0);
  EXPECT_EQ(waypoint.ipf_type, "roc");
}

TEST(ImportMoos, DeploysByAnEventWhereItIsToldTo) {
  const std::vector<MoosSource> sources = {
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv", .text = std::string(kWaypointBhv)}};
  EXPECT_EQ(Loaded(ImportMoos(sources)).mission.events.size(), 0U);
  const Mission mission = Loaded(ImportMoos(sources, {.deploys = true})).mission;
  ASSERT_EQ(mission.events.size(), 1U);
  EXPECT_EQ(std::get<CommandEvent>(mission.events[0].what),
            (CommandEvent{.vehicle = "all", .command = "deploy", .argument = "", .values = {}}));
}

TEST(ImportMoos, DoesNotDeployAVehicleThatOnlyStartsInDrive) {
  const MoosImport import = WithButtons("start_in_drive = true", "");
  EXPECT_FALSE(Loaded(import).mission.vehicles.front().helm_options.deploy_at_start);
}

constexpr std::string_view kHelmMoos = "Community = $(VNAME)\nProcessConfig = pHelmIvP\n{\n}\n";
constexpr std::string_view kTimerBhv = "Behavior = BHV_Timer\n{\nname = b\n}\n";

TEST(ImportMoos, MakesEachVehicleOfTheTemplateThatItNamesOrThatIsInItsPlace) {
  const std::vector<MoosSource> sources = {
      {.name = "boat.moos",
       .text =
           std::string(kHelmMoos) + "ProcessConfig = pNodeReporter\n{\nplatform_type = kayak\n}\n"},
      {.name = "fish.moos",
       .text =
           std::string(kHelmMoos) + "ProcessConfig = pNodeReporter\n{\nplatform_type = ship\n}\n"},
      {.name = "v.bhv", .text = std::string(kTimerBhv)}};
  const auto types = [&](const std::vector<MoosDefines>& vehicles) {
    const MoosImport import =
        ImportMoos(sources, {.defines = {}, .vehicles = vehicles, .find = {}});
    std::string text;
    for (const shoal::Vehicle& vehicle : Loaded(import).mission.vehicles) {
      text += vehicle.name + " " + vehicle.type + ", ";
    }
    return text + std::to_string(import.warnings.size());
  };
  EXPECT_EQ(types({{{"VNAME", "ida"}}, {{"VNAME", "jon"}}}), "ida kayak, jon ship, 1");
  EXPECT_EQ(types({{{"VNAME", "ida"}, {"TEMPLATE", "fish.moos"}},
                   {{"VNAME", "jon"}, {"TEMPLATE", "boat.moos"}},
                   {{"VNAME", "kai"}, {"TEMPLATE", "boat.moos"}}}),
            "jon kayak, kai kayak, ida ship, 0");
  EXPECT_EQ(types({{{"VNAME", "ida"}}, {{"VNAME", "jon"}}, {{"VNAME", "kai"}}}),
            "ida kayak, jon kayak, kai kayak, 1");
}

TEST(ImportMoos, MakesObstaclesOfThoseThatAreGivenAndOfAFile) {
  const FindMoosFile find = [](std::string_view name, std::string_view) {
    return name == "o.txt"
               ? std::optional(MoosSource{.name = "o.txt",
                                          .text = "region = pts={0,0:0,9:9,9}\n"
                                                  "poly = pts={10,0:10,9:19,9},label=ob_0\n"
                                                  "poly = pts={30,0:30,9:39,9},label=ob 1\n"})
               : std::nullopt;
  };
  const MoosImport import = ImportMoos(
      std::vector<MoosSource>{
          {.name = "a.moos",
           .text =
               "Community = a\nProcessConfig = pHelmIvP\n{\n}\nProcessConfig = pObstacleMgr\n{\n"
               "given_obstacle = pts={80,-40:90,-40:90,-20:80,-20}, label=rock\n"
               "given_obstacle = nothing\n}\nProcessConfig = uFldObstacleSim\n{\n"
               "obstacle_file = o.txt\n}\n"},
          {.name = "a.bhv", .text = std::string(kTimerBhv)}},
      {.defines = {}, .vehicles = {}, .find = find});
  std::vector<std::string> ids;
  for (const Obstacle& obstacle : Loaded(import).mission.obstacles) ids.push_back(obstacle.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"rock", "ob_0", "ob_1"}));
  ASSERT_EQ(import.warnings.size(), 1U);
  EXPECT_TRUE(import.warnings[0].starts_with("a.moos:8: given_obstacle = nothing: "));
}

TEST(ImportMoos, HasOneWarningForABehaviorThatIsLostAndForABlockWithoutAHead) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "a.moos", .text = "Community = a\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "a.bhv",
       .text = std::string(kTimerBhv) +
               "//Behavior = BHV_Waypoint\n{\nname = off\nspeed = 1\n}\n"
               "Behavior = BHV_Waypoint\n{\nname = lost\nodd = 1\npoints = none\nspeed = x\n}\n"
               "Behavior = BHV_Loiter\n{\nname = none\nspeed = 1\nradius = 5\n}\n"}});
  ASSERT_EQ(import.warnings.size(), 3U);
  EXPECT_TRUE(import.warnings[0].starts_with("a.bhv:14: points = none: ")) << import.warnings[0];
  EXPECT_TRUE(import.warnings[1].starts_with("a.bhv:6: '{' begins a block")) << import.warnings[1];
  EXPECT_TRUE(import.warnings[2].starts_with("a.bhv:17: ")) << import.warnings[2];
  EXPECT_TRUE(import.warnings[2].ends_with("; all 4 lines of [[vehicle.behavior]] are left out"))
      << import.warnings[2];
}

TEST(ImportMoos, KeepsAConditionAboutTheContactOfATemplate) {
  const auto import_of = [](std::vector<MoosDefines> vehicles) {
    return ImportMoos(
        std::vector<MoosSource>{
            {.name = "v.moos", .text = std::string(kHelmMoos)},
            {.name = "v.bhv",
             .text =
                 "Behavior = BHV_Trail\n{\nname = follow_\ntemplating = spawn\n"
                 "condition = MARKED_$[CONTACT] = true\nupdates = C\ncontact = to-be-set\n}\n"}},
        {.defines = {}, .vehicles = std::move(vehicles), .find = {}});
  };
  const MoosImport import = import_of({{{"VNAME", "ida"}}});
  const shoal::Vehicle ida = Loaded(import).mission.vehicles.at(0);
  ASSERT_EQ(ida.behaviors.size(), 1U);
  EXPECT_EQ(ida.behaviors[0].name, "follow_");
  EXPECT_EQ(ida.behaviors[0].templating, Templating::kSpawn);
  EXPECT_EQ(ida.behaviors[0].condition, std::vector<std::string>{"MARKED_$[CONTACT] = true"});
}

TEST(ImportMoos, MakesATemplateAboutContactsOneBehaviorForEachOtherVehicle) {
  const MoosImport import = ImportMoos(
      std::vector<MoosSource>{
          {.name = "v.moos", .text = std::string(kHelmMoos)},
          {.name = "v.bhv",
           .text = "Behavior = BHV_Trail\n{\nname = near_\ntemplating = spawn\nupdates = C\n"
                   "condition = MARKED_$[CONTACT] = true\nno_alert_request = false\n}\n"}},
      {.defines = {}, .vehicles = {{{"VNAME", "ida"}}, {{"VNAME", "jon"}}}, .find = {}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const shoal::Vehicle ida = Loaded(import).mission.vehicles.at(0);
  ASSERT_EQ(ida.behaviors.size(), 1U);
  EXPECT_EQ(ida.behaviors[0].name, "near_jon");
  EXPECT_EQ(ida.behaviors[0].condition, (std::vector<std::string>{"MARKED_JON = true"}));
  EXPECT_EQ(std::get<TrailOptions>(ida.behaviors[0].what).contact.contact, "jon");
}

TEST(ImportMoos, LetsACutRangeTemplateBeginWhatItsAlertsAskFor) {
  for (const bool is_off : {false, true}) {
    const MoosImport import = ImportMoos(
        std::vector<MoosSource>{
            {.name = "v.moos", .text = std::string(kHelmMoos)},
            {.name = "v.bhv",
             .text = "Behavior = BHV_CutRange\n{\nname = cut_\ntemplating = spawn\nupdates = C\n"
                     "duration = 10\npwt_outer_dist = 80\n" +
                     std::string(is_off ? "no_alert_request = true\n" : "") + "}\n"}},
        {.defines = {}, .vehicles = {{{"VNAME", "ida"}}, {{"VNAME", "jon"}}}, .find = {}});
    const shoal::Vehicle ida = Loaded(import).mission.vehicles.at(0);
    ASSERT_EQ(ida.behaviors.size(), 1U);
    EXPECT_EQ(ida.behaviors[0].templating, Templating::kSpawn);
    const auto& cut_range = std::get<CutRangeOptions>(ida.behaviors[0].what);
    EXPECT_EQ(cut_range.contact.alert_range, is_off ? -1 : 80);
  }
}

TEST(ImportMoos, LimitsNoRangeWherePShareTakesReportsFromVehicleToVehicle) {
  const auto range = [](const std::string& more) {
    const std::string share =
        "ProcessConfig = pShare\n{\nOutput = src_name=NODE_REPORT_LOCAL, "
        "dest_name=NODE_REPORT, route=localhost:9302\n}\n";
    const MoosImport import = ImportMoos(
        std::vector<MoosSource>{
            {.name = "v.moos", .text = std::string(kHelmMoos) + share},
            {.name = "v.bhv", .text = std::string(kTimerBhv)},
            {.name = "s.moos",
             .text = "Community = shore\nProcessConfig = pLogger\n{\n}\n" + more}},
        {.defines = {}, .vehicles = {{{"VNAME", "ida"}}, {{"VNAME", "jon"}}}, .find = {}});
    return import.mission.find("comms_range = \"nolimit\"") != std::string::npos;
  };
  EXPECT_TRUE(range(""));
  EXPECT_FALSE(range("ProcessConfig = uFldNodeComms\n{\n}\n"));
}

TEST(ImportMoos, MakesAnObstacleOfWhatAScriptMakesKnown) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "s.moos",
       .text = "Community = shore\nProcessConfig = uTimerScript\n{\n"
               "event = var=KNOWN_OBSTACLE_ALL, val=\"pts={0,0:9,0:9,9},label=rock\", time=5\n"
               "event = var=GIVEN_OBSTACLE, val=pts={20,0:29,0:29,9},label=reef, time=5\n"
               "event = var=KNOWN_OBSTACLE, val=nothing, time=5\n}\n"}});
  const Mission mission = Loaded(import).mission;
  ASSERT_EQ(mission.obstacles.size(), 2U);
  EXPECT_EQ(mission.obstacles[0].id, "rock");
  EXPECT_EQ(mission.obstacles[1].id, "reef");
  EXPECT_EQ(mission.obstacles[1].polygon_m.size(), 3U);
  EXPECT_TRUE(Warns(import, "s.moos:6: event = var=KNOWN_OBSTACLE, val=nothing"));
  EXPECT_FALSE(Warns(import, "s.moos:4:"));
}

TEST(ImportMoos, WritesTheDefaultsOfUSimMarine) {
  const auto craft = [](const std::string& lines) {
    const MoosImport import = ImportMoos(std::vector<MoosSource>{
        {.name = "v.moos",
         .text = "Community = ida\nProcessConfig = uSimMarineV22\n{\n" + lines + "}\n"}});
    return std::get<SurfaceCraftParams>(Loaded(import).mission.vehicles.at(0).model);
  };
  const SurfaceCraftParams plain = craft("");
  EXPECT_EQ(plain.turn_speed_loss, 0.85);
  EXPECT_EQ(plain.turn_rate_degps, 70);
  EXPECT_EQ(plain.full_turn_speed_mps, 5);
  EXPECT_EQ(plain.full_turn_thrust_pct, 50);
  EXPECT_EQ(plain.max_acceleration_mps2, 100);
  EXPECT_EQ(plain.max_deceleration_mps2, 0.5);
  EXPECT_EQ(plain.max_rudder_rate_degps, 100'000);
  const SurfaceCraftParams given = craft("turn_spd_loss = 0.5\nmax_deceleration = 0\n");
  EXPECT_EQ(given.turn_speed_loss, 0.5);
  EXPECT_EQ(given.max_deceleration_mps2, 100);
}

TEST(ImportMoos, LetsTheThrustAloneTurnAVesselOfTheFirstUSimMarine) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "v.moos",
       .text = "Community = ida\nProcessConfig = uSimMarine\n{\nturn_rate = 60\n}\n"
               "ProcessConfig = pMarinePID\n{\nspeed_factor = 20\n}\n"}});
  const shoal::Vehicle ida = Loaded(import).mission.vehicles.at(0);
  const auto& craft = std::get<SurfaceCraftParams>(ida.model);
  EXPECT_EQ(craft.turn_rate_degps, 60);
  EXPECT_EQ(craft.full_turn_speed_mps, 0.01);
  EXPECT_EQ(craft.full_turn_thrust_pct, 50);
  EXPECT_EQ(ida.autopilot.speed_kp, 0);
  EXPECT_EQ(ida.autopilot.speed_ki, 0);
}

TEST(ImportMoos, AccountsForEveryLine) {
  const std::vector<MoosSource> sources = {
      {.name = "v.moos",
       .text =
           "ServerHost = localhost\nCommunity = ida\nOdd = 1\nLatOrigin = 54\nLongOrigin = 10\n"
           "ProcessConfig = ANTLER\n{\nRun = pHelmIvP @ NewConsole = false\nRun = myApp\n}\n"
           "ProcessConfig = myApp\n{\nodd = 1\n}\n#ifdef NIGHT\n#endif\n#elseif X\n"
           "ProcessConfig = uSimMarineV22\n{\nstart_pos = 1,2\nturn_rate = 60\nodd = 2\n}\n"
           "ProcessConfig = pHelmIvP\n{\nbehaviors = v.bhv\ndomain = speed:0:3:31\nodd = 3\n}\n"
           "ProcessConfig = pObstacleMgr\n{\ngiven_obstacle = pts={8,8:9,8:9,9},label=a\n"
           "given_obstacle = x\n}\nno block\nProcessConfig = pMarineViewer\n{\n"
           "button_one = DEPLOY # DEPLOY=true # GO=true\nbutton_two = X # GO=false\n"
           "tiff_file = a.tif\n}\nProcessConfig = uFldShoreBroker\n{\n"
           "bridge = src=UP_$N, alias=UP\nqbridge = DEPLOY\n}\n"
           "ProcessConfig = uTimerScript\n{\nrandvar = varname=X, min=0, max=1, key=at_post\n"
           "randvar = odd\nevent = var=GO, val=true, time=5\nevent = var=NO, val=$[X]\n"
           "event = quit\nreset_max = 1\nreset_time = 50\npaused = false\ncondition = A = b\n}\n"},
      {.name = "v.bhv",
       .text = "initialize DEPLOY = false\nset MODE = ON {\nDEPLOY = true\n} OFF\nwhat is this\n"
               "Behavior = BHV_Waypoint\n{\nname = w\ncondition = GO = true\npoints = 0,0:5,5\n"
               "speed = fast\nodd = 4\nvisual_hints = x=1\n}\n{\nname = headless\n}\n"
               "Behavior = BHV_None\n{\nname = n\n}\nBehavior = BHV_Loiter\n{\nspeed = 1\n"
               "polygon = none\n}\n"}};
  const MoosImport import = ImportMoos(sources);
  for (const MoosSource& source : sources) {
    std::istringstream text(source.text);
    int number = 1;
    for (std::string line; std::getline(text, line); ++number) {
      const std::string origin = source.name + ":" + std::to_string(number);
      const bool is_frame = line == "{" || line == "}" || line == "#endif" ||
                            line.starts_with("ProcessConfig") || line.starts_with("} ");
      if (is_frame) continue;
      bool is_there = false;
      for (size_t at = import.mission.find(origin); at != std::string::npos;
           at = import.mission.find(origin, at + 1)) {
        is_there = is_there || !IsDigit(import.mission[at + origin.size()]);
      }
      EXPECT_TRUE(is_there) << origin << ": " << line;
    }
  }
}

}  // namespace shoal::import_test

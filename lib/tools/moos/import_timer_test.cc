#include "lib/tools/moos/import_timer.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/tools/moos/import.h"
#include "lib/tools/moos/moos_bridges.h"

namespace shoal::import_timer_test {

TimerScript Read(const std::string& lines, const std::string& vehicle = "") {
  const MoosFile file = ParseMoosFile("ProcessConfig = uTimerScript\n{\n" + lines + "\n}\n", "f");
  const std::vector<std::string> vehicles = {"abe", "ben"};
  return ReadTimerScript(file.blocks.at(0), {.vehicle = vehicle, .vehicles = vehicles});
}

/// Returns "10: vehicle = "abe", command = "deploy"", or the reason.
std::string Event(const std::string& line, const std::string& vehicle = "") {
  const TimerScript script = Read("event = " + line, vehicle);
  const TimerEvent& event = script.events.at(0);
  if (event.keys.empty()) return event.reason;
  std::string text = std::to_string(static_cast<int>(event.at_s)) + ":";
  for (const auto& [key, value] : event.keys) text += " " + key + "=" + value;
  return text;
}

TEST(TimerScript, DeploysAndReturnsVehicles) {
  EXPECT_EQ(Event("var=DEPLOY_ALL, val=true, time=10"), "10: vehicle=\"all\" command=\"deploy\"");
  EXPECT_EQ(Event("var=RETURN_ABE, val=TRUE, time=300"), "300: vehicle=\"abe\" command=\"return\"");
  EXPECT_EQ(Event("var=DEPLOY, val=true", "ben"), "0: vehicle=\"ben\" command=\"deploy\"");
  EXPECT_EQ(Event("var=STATION_KEEP, val=true, time=5", "ben"),
            "5: vehicle=\"ben\" command=\"station_keep\"");
  EXPECT_EQ(Event("var=MOOS_MANUAL_OVERIDE_ALL, val=true, time=5"),
            "5: vehicle=\"all\" command=\"park\"");
  EXPECT_EQ(Event("var=DEPLOY, val=true"), "no counterpart in shoal") << "DEPLOY of the shore";
  EXPECT_EQ(Event("var=DEPLOY_ZOE, val=true"), "no counterpart in shoal");
  EXPECT_EQ(Event("var=DEPLOY, val=false", "ben"),
            "only true has a counterpart; deploy, park and station_keep are commands here");
}

TEST(TimerScript, ChangesRulesOfTheBroker) {
  EXPECT_EQ(Event("var=UNC_COMMS_RANGE, val=50, time=60"), "60: rule=\"comms_range\" value=50");
  EXPECT_EQ(Event("var=UNC_STEALTH, val=\"vname=abe, stealth=0.5\", time=60"),
            "60: rule=\"stealth\" vehicle=\"abe\" value=0.5");
  EXPECT_EQ(Event("var=UNC_SHARED_NODE_REPORTS, val=TRUE"),
            "0: rule=\"shared_node_reports\" value=true");
  EXPECT_EQ(Event("var=UNC_STEALTH, val=0.5"), "not vname=NAME, stealth=NUMBER");
}

TEST(TimerScript, SendsNodeMessages) {
  EXPECT_EQ(Event("var=NODE_MESSAGE_LOCAL, val=\"src_node=abe,dest_node=ben,var_name=SPEED,"
                  "double_val=2\", time=7"),
            "7: message={src_node = \"abe\", dest_node = \"ben\", var_name = \"SPEED\", "
            "double_val = 2}");
  EXPECT_EQ(Event("var=NODE_MESSAGE_LOCAL, val=src_node=abe, time=7"),
            "dest_node and dest_group are missing; write dest_node=<vehicle> or all");
}

TEST(TimerScript, PushesVehicles) {
  EXPECT_EQ(Event("var=DRIFT_VECTOR, val=\"90,0.5\", time=7", "ben"),
            "7: vehicle=\"ben\" sim_command=\"drift\" values=[0.5, 0]");
}

TEST(TimerScript, StatesWhyAnEventIsNone) {
  EXPECT_EQ(Event("var=SENSOR, val=$[ANGLE], time=7"),
            "holds a macro, which has no value here: write an [[event]] by hand");
  EXPECT_EQ(Event("var=SENSOR, val=1, time=soon"),
            "'time=soon' makes no sense; write var=NAME, val=VALUE, time=SECONDS");
  const TimerScript script =
      Read("event = quit\nevent = var=MOOS_MANUAL_OVERIDE_ALL, val=false\nevent = var=X, val=1");
  ASSERT_EQ(script.events.size(), 3U);
  EXPECT_TRUE(script.events[0].is_needless);
  EXPECT_TRUE(script.events[1].is_needless);
  EXPECT_FALSE(script.events[2].is_needless);
}

TEST(TimerScript, CountsTimeAsTheScriptDoes) {
  const TimerScript script = Read(
      "delay_start = 10\ntime_warp = 2\nevent = var=DEPLOY_ALL, val=true, time=20:40\n"
      "condition = GO=true\nreset_max = nolimit\n");
  EXPECT_GE(script.events.at(0).at_s, 15) << "(20 + 10) / 2";
  EXPECT_LT(script.events.at(0).at_s, 25) << "(40 + 10) / 2";
  EXPECT_EQ(script.events.at(0).assumed, "drawn as uTimerScript draws it, once for all runs");
  EXPECT_GT(script.events.size(), 20U);
  EXPECT_TRUE(Read("event = var=VIEW_POINT, val=\"x=1\"").events.at(0).is_needless);
  ASSERT_EQ(script.losses.size(), 2U);
  EXPECT_EQ(script.losses[0].second, "taken as if it held from the start");
  EXPECT_TRUE(script.losses[1].second.starts_with("the script is repeated: its "))
      << script.losses[1].second;
  const TimerScript paused = Read("paused = true\nevent = var=DEPLOY_ALL, val=true");
  EXPECT_TRUE(paused.events.at(0).keys.empty());
  EXPECT_EQ(paused.losses.size(), 1U);
}

/// Returns what a vehicle's script sets and when: "5.0 A=1, ".
std::string Posts(const std::string& lines) {
  const MoosFile file = ParseMoosFile("ProcessConfig = uTimerScript\n{\n" + lines + "\n}\n", "f");
  const std::vector<std::string> vehicles = {"abe", "ben"};
  const auto all = [](std::string_view, std::string_view) { return true; };
  std::string text;
  for (const TimerEvent& event :
       ReadTimerScript(file.blocks.at(0),
                       {.vehicle = "abe", .vehicles = vehicles, .has_variable = all})
           .events) {
    const std::string argument = event.keys.empty() ? event.reason : event.keys.back().second;
    text += std::to_string(event.at_s).substr(0, 4) + " " + argument + ", ";
  }
  return text;
}

// The times and values that MOOS-IvP's uTimerScript posts of these scripts.
TEST(TimerScript, PostsWhatUTimerScriptPosts) {
  EXPECT_EQ(
      Posts("event = var=ECHO, val=late order, time=8\nevent = var=ALPHA, val=\"x y\", time=5"),
      "5.00 \"ALPHA=x y\", 8.00 \"ECHO=lateorder\", ");
  EXPECT_EQ(
      Posts("event = var=TICK, val=$[COUNT], time=1\nevent = var=TOCK, val=$[TCOUNT], time=3\n"
            "event = var=NEVER, val=1, time=9\nreset_max = 3\nreset_time = 5\n"
            "delay_start = 4\ndelay_reset = 2"),
      "5.00 \"TICK=0\", 8.00 \"TICK=0\", 10.0 \"TOCK=2\", 13.0 \"TICK=0\", 15.0 \"TOCK=4\", "
      "18.0 \"TICK=0\", 20.0 \"TOCK=6\", ");
  EXPECT_EQ(
      Posts("event = var=M, val=id$[IDX], time=1, amt=2\nevent = var=M, val=id$(IDX)v=$[VNAME], "
            "time=4, amt=0\ntime_warp = 2"),
      "0.50 \"M=id000\", 0.50 \"M=id001\", 2.00 \"M=id002v=abe\", ");
  EXPECT_EQ(Posts("event = var=A, val={2*3}, time=1\nevent = var=B, val={{2+3}-1}, time=2\n"
                  "event = var=C, val={1+2+3}, time=3"),
            "1.00 \"A=6\", 2.00 \"B=4\", 3.00 \"C={1+2+3}\", ");
  EXPECT_EQ(Posts("event = var=A, val=$[UTC], time=1"),
            "1.00 holds a macro, which has no value here: write an [[event]] by hand, ");
}

TEST(TimerScript, DrawsRandomVariablesWhenTheirKeySaysSo) {
  std::vector<std::string> u;
  std::vector<std::string> v;
  const MoosFile file = ParseMoosFile(
      "ProcessConfig = uTimerScript\n{\nrandvar = varname=U, min=10, max=20, key=at_start\n"
      "randvar = varname=V, min=10, max=20, snap=5, key=at_reset\n"
      "randvar = varname=BAD, min=0, max=1\n"
      "event = var=U, val=$[U], time=1\nevent = var=V, val=$(V), time=2\n"
      "reset_max = 30\nreset_time = 10\n}\n",
      "f");
  const std::vector<std::string> vehicles = {"abe"};
  const auto all = [](std::string_view, std::string_view) { return true; };
  const TimerScript script = ReadTimerScript(
      file.blocks.at(0), {.vehicle = "abe", .vehicles = vehicles, .has_variable = all});
  ASSERT_EQ(script.events.size(), 62U);
  for (const TimerEvent& event : script.events) {
    (event.keys.back().second[1] == 'U' ? u : v).push_back(event.keys.back().second);
  }
  EXPECT_EQ(std::set<std::string>(u.begin(), u.end()).size(), 1U);
  EXPECT_EQ(std::set<std::string>(v.begin(), v.end()),
            (std::set<std::string>{"\"V=10\"", "\"V=15\"", "\"V=20\""}));
  ASSERT_EQ(script.losses.size(), 1U);
  EXPECT_EQ(script.losses[0].first, 5);
}

TEST(TimerScript, FollowsTheBridgesOfTheShore) {
  MoosBridges bridges;
  EXPECT_TRUE(bridges.Add({.text = "", .key = "bridge", .value = "src=UP_RING_$N, alias=UP_RING"}));
  EXPECT_TRUE(bridges.Add({.text = "", .key = "bridge", .value = "src=GO_$V, alias=GO"}));
  EXPECT_TRUE(bridges.Add({.text = "", .key = "Bridge", .value = "src=ANY, alias=SOME"}));
  EXPECT_FALSE(bridges.Add({.text = "", .key = "qbridge", .value = "DEPLOY"}));
  const std::vector<std::string> vehicles = {"abe", "ben"};
  EXPECT_EQ(bridges.Find("UP_RING_2", vehicles), "UP_RING_BEN");
  EXPECT_EQ(bridges.Find("UP_RING_3", vehicles), "");
  EXPECT_EQ(bridges.Find("GO_ABE", vehicles), "GO_ABE");
  EXPECT_EQ(bridges.Find("ANY", vehicles), "SOME_ALL");
}

constexpr const char* kAbe = R"(Community = abe
ProcessConfig = pHelmIvP
{
  Behaviors = meta_abe.bhv
  Domain = course:0:359:360
  Domain = depth:0:80:81
}
ProcessConfig = uSimMarine
{
  start_x = 5
  start_depth = 12
  max_speed = 2
  turn_rate = 40
}
ProcessConfig = pNodeReporter
{
  platform_type = TYPE
}
)";

MoosImport ImportOf(const std::string& type, const std::string& shore) {
  std::string abe = kAbe;
  abe.replace(abe.find("TYPE"), 4, type);
  const std::vector<MoosSource> sources = {{"abe.moos", abe}, {"shore.moos", shore}};
  return ImportMoos(sources);
}

Mission Loaded(const MoosImport& import) {
  const LoadedMission loaded = LoadMissionText(import.mission, "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>()) << import.mission;
  return loaded.mission;
}

TEST(ImportMoos, MakesEventsOfTimerScriptsAndWarnsOfThoseThatAreLost) {
  const MoosImport import = ImportOf("kayak",
                                     "ProcessConfig = uTimerScript\n{\n"
                                     "event = var=DEPLOY_ALL, val=true, time=10\n"
                                     "event = var=USM_ENABLED, val=3, time=1000\n"
                                     "event = var=RETURN_ALL, val=true, time=900\n"
                                     "event = quit\n}\n");
  const Mission mission = Loaded(import);
  ASSERT_EQ(mission.events.size(), 2U);
  EXPECT_EQ(mission.events[0].at_s, 10);
  EXPECT_EQ(std::get<CommandEvent>(mission.events[1].what).command, "return");
  EXPECT_EQ(mission.duration_s, 960) << "no event lies behind the end";
  EXPECT_EQ(
      import.warnings,
      (std::vector<std::string>{
          "shore.moos:4: event = var=USM_ENABLED, val=3, time=1000: no counterpart in shoal",
          "abe.moos:4: Behaviors = meta_abe.bhv: no behaviors are there: abe stays where it is; "
          "name its .bhv file too, or write a [[vehicle.behavior]] or [[vehicle.task]]"}));
}

TEST(ImportMoos, LeavesMacrosOfViewersAndScriptsToThem) {
  const MoosImport import =
      ImportOf("kayak",
               "ProcessConfig = pMarineViewer\n{\nleft_context = P=$(XPOS),$(YPOS)\n}\n"
               "ProcessConfig = uTimerScript\n{\nevent = var=X, val=$(UTC)\n}\n"
               "ProcessConfig = uFldNodeComms\n{\ncomms_range = $(RANGE)\n}\n");
  std::string all;
  for (const std::string& warning : import.warnings) all += warning + "\n";
  EXPECT_EQ(all.find("shore.moos:3"), std::string::npos) << all;
  EXPECT_NE(all.find("shore.moos:7: event = var=X, val=$(UTC): holds a macro"), std::string::npos)
      << all;
  EXPECT_NE(all.find("shore.moos:11: 'comms_range = $(RANGE)' is for nsplug"), std::string::npos)
      << all;
}

TEST(ImportMoos, MakesARemus100OfAnUnderwaterVehicleAndWarns) {
  const MoosImport import = ImportOf("UUV", "");
  const Mission mission = Loaded(import);
  const auto* remus = std::get_if<Remus100Options>(&mission.vehicles.at(0).model);
  ASSERT_NE(remus, nullptr) << import.mission;
  EXPECT_EQ(remus->max_depth_m, 80);
  EXPECT_EQ(mission.vehicles[0].start.x_m, 5);
  EXPECT_EQ(mission.vehicles[0].start.depth_m, 12);
  EXPECT_EQ(import.warnings.at(0),
            "abe.moos:17: platform_type = UUV: abe becomes a Remus 100 (model = \"remus100\"), "
            "shoal's only underwater vehicle: what uSimMarine and pMarinePID set for its motion is "
            "left out");
  EXPECT_NE(import.mission.find(
                "# abe.moos:12: max_speed = 2: the Remus 100 has motion and autopilots of its own"),
            std::string::npos)
      << import.mission;
}

TEST(ImportMoos, LimitsTheThrustMapToTheFastestSpeed) {
  const auto map = [](const std::string& lines) {
    const std::vector<MoosSource> sources = {
        {"a.moos", "Community = a\nProcessConfig = uSimMarine\n{\n" + lines + "\n}\n"}};
    return std::get<SurfaceCraftParams>(Loaded(ImportMoos(sources)).vehicles.at(0).model)
        .thrust_map;
  };
  EXPECT_EQ(map("max_speed = 2"), (std::vector<ThrustPoint>{{40, 2}, {100, 2}}));
  EXPECT_EQ(map("thrust_map = -100:-2, 0:0, 20:1, 60:3, 100:5\nmax_speed = 2"),
            (std::vector<ThrustPoint>{{-100, -2}, {0, 0}, {20, 1}, {40, 2}, {60, 2}, {100, 2}}));
  EXPECT_EQ(map("max_speed = 9\nthrust_factor = 20"), (std::vector<ThrustPoint>{{100, 5}}));
}

/// Imports a vehicle with a script and a behavior that goes by GO.
MoosImport WithScript(const std::string& lines, const std::string& reporter = "") {
  return ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos",
       .text = "Community = ida\nProcessConfig = pHelmIvP\n{\nDomain = depth:0:20:21\n}\n"
               "ProcessConfig = uTimerScript\n{\n" +
               lines + "\n}\nProcessConfig = pNodeReporter\n{\n" + reporter + "}\n"},
      {.name = "ida.bhv",
       .text = "initialize READY = false\nBehavior = BHV_Waypoint\n{\nname = leg\n"
               "condition = GO = true\nspeed = 1\npoints = 0,0\n}\n" +
               std::string(
                   reporter.empty() ? "" : "Behavior = BHV_PeriodicSurface\n{\nname = up\n}\n")}});
}

TEST(ImportMoos, LetsAScriptWaitForWhatBehaviorsKnow) {
  const MoosImport import = WithScript(
      "condition = READY = true\ncondition = TIME_AT_SURFACE > 3\ndelay_start = 5\n"
      "event = var=GO, val=true, time=10\nevent = var=READY, val=no, time=20");
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{}) << import.mission;
  const auto& behaviors = loaded.mission.vehicles.front().behaviors;
  ASSERT_EQ(behaviors.size(), 3U) << import.mission;
  EXPECT_EQ(behaviors[1].name, "script_001");
  EXPECT_EQ(behaviors[1].condition,
            (std::vector<std::string>{"READY = true", "TIME_AT_SURFACE > 3"}));
  EXPECT_EQ(behaviors[1].duration, 15);
  EXPECT_FALSE(behaviors[1].duration_idle_decay) << "its clock stands while they do not hold";
  EXPECT_FALSE(behaviors[1].perpetual);
  EXPECT_EQ(behaviors[1].flags.endflag, std::vector<std::string>{"GO=true"});
  EXPECT_EQ(behaviors[2].flags.endflag, std::vector<std::string>{"READY=no"});
  EXPECT_TRUE(loaded.mission.events.empty());
}

TEST(ImportMoos, LetsARepeatedScriptBeginAgainAfterItsConditionsHaveFailed) {
  const MoosImport import = WithScript(
      "condition = TIME_AT_SURFACE > 3\nreset_max = nolimit\nreset_time = end\n"
      "event = var=GPS_UPDATE_RECEIVED, val=1, time=2",
      "platform_type = uuv\n");
  ASSERT_EQ(import.warnings.size(), 1U);
  EXPECT_NE(import.warnings[0].find("becomes a Remus 100"), std::string::npos);
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  const auto& behaviors = loaded.mission.vehicles.front().behaviors;
  ASSERT_EQ(behaviors.size(), 3U) << import.mission;
  EXPECT_TRUE(behaviors[2].perpetual);
}

TEST(ImportMoos, WarnsOfRoundsOfAScriptWithConditionsThatTimersCannotCount) {
  const MoosImport import = WithScript(
      "condition = READY = true\nreset_max = 3\nscript_atomic = true\ndelay_start = -5\n"
      "event = var=GO, val=true, time=10");
  EXPECT_EQ(import.warnings,
            (std::vector<std::string>{
                "ida.moos:9: reset_max = 3: repeated each time that its conditions have failed, "
                "without end",
                "ida.moos:10: script_atomic = true: its clock stands while its conditions do not "
                "hold",
                "ida.moos:11: delay_start = -5: not SECONDS or LOW:HIGH"}));
}

TEST(ImportMoos, LetsARepeatedScriptThatSwitchesAVariableBeEvents) {
  const auto num_behaviors = [](const std::string& more) {
    const MoosImport import = WithScript(
        "condition = READY = true\nevent = var=GO, val=true, time=10\n"
        "event = var=GO, val=false, time=20\n" +
        more);
    EXPECT_EQ(import.warnings.empty(), more.empty());
    return LoadMissionText(import.mission, "m.toml").mission.vehicles.front().behaviors.size();
  };
  EXPECT_EQ(num_behaviors(""), 3U);
  EXPECT_EQ(num_behaviors("reset_max = nolimit\nreset_time = 100"), 1U);
}

TEST(ImportMoos, MakesNoMoreThanAHundredTimersOfAScript) {
  const auto num_behaviors = [](int amount) {
    const MoosImport import =
        WithScript("condition = READY = true\nevent = var=GO, val=true, time=1, amt=" +
                   std::to_string(amount));
    EXPECT_EQ(import.warnings.empty(), amount <= 100);
    return LoadMissionText(import.mission, "m.toml").mission.vehicles.front().behaviors.size();
  };
  EXPECT_EQ(num_behaviors(100), 101U);
  EXPECT_EQ(num_behaviors(101), 1U);
}

TEST(TimerScript, NamesRoundsThatAreNoNumber) {
  for (const char* line : {"reset_max = -1", "reset_max = many", "reset_time = -4"}) {
    const TimerScript script = Read(std::string(line) + "\nevent = var=DEPLOY_ALL, val=true");
    ASSERT_EQ(script.losses.size(), 1U) << line;
    EXPECT_TRUE(script.losses[0].second.starts_with("not ")) << script.losses[0].second;
    ASSERT_EQ(script.events.size(), 1U) << line;
    EXPECT_FALSE(script.events[0].keys.empty());
  }
}

TEST(ImportMoos, TakesAVariableThatOnlyBeginsAsTheVesselsForUnknown) {
  const MoosImport import =
      WithScript("condition = NAV_YAW > 1\nevent = var=GO, val=true, time=10");
  EXPECT_EQ(import.warnings,
            std::vector<std::string>{
                "ida.moos:8: condition = NAV_YAW > 1: taken as if it held from the start"});
}

TEST(ImportMoos, TakesAConditionThatBehaviorsDoNotKnowAsIfItHeldAndWarns) {
  const MoosImport import =
      WithScript("condition = WIND = true\nevent = var=GO, val=true, time=10");
  ASSERT_EQ(import.warnings.size(), 1U);
  EXPECT_EQ(import.warnings[0],
            "ida.moos:8: condition = WIND = true: taken as if it held from the start");
  EXPECT_EQ(LoadMissionText(import.mission, "m.toml").mission.events.size(), 1U);
}

TEST(TimerScript, DoesNotNameTheConditionsOfEventsThatAreLostAnyway) {
  EXPECT_TRUE(Read("condition = WIND = true\nevent = var=SENSOR, val=1").losses.empty());
  EXPECT_EQ(Read("condition = WIND = true\nevent = var=DEPLOY_ALL, val=true").losses.size(), 1U);
}

TEST(TimerScript, LosesNothingByWhatIsOnlyASound) {
  const TimerScript script = Read("event = var=SAY_MOOS, val=\"text={one}\", time=1");
  EXPECT_TRUE(script.events.at(0).keys.empty());
  EXPECT_TRUE(script.events.at(0).is_needless);
}

TEST(TimerScript, AddsDriftsUpFromWhatUSimMarineBeginsWith) {
  const MoosFile file = ParseMoosFile(
      "ProcessConfig = uTimerScript\n{\nevent = var=DRIFT_VECTOR_ADD, val=\"90,0.5\", time=4\n"
      "event = var=DRIFT_VECTOR_ADD, val=\"0,1\", time=2\nevent = var=DRIFT_X, val=3, time=6\n"
      "event = var=DRIFT_VECTOR_MULT, val=2, time=8\nevent = var=DRIFT_VECTOR, val=\"180,1\", "
      "time=9\nevent = var=DRIFT_Y, val=a, time=9\n}\n",
      "f");
  const std::vector<std::string> vehicles = {"abe"};
  const TimerScript script = ReadTimerScript(
      file.blocks.at(0),
      {.vehicle = "abe", .vehicles = vehicles, .first_drift_mps = [](std::string_view) {
         return Eigen::Vector2d(1, 1);
       }});
  std::string text;
  for (const TimerEvent& event : script.events) {
    text += event.keys.empty() ? event.reason : event.keys.at(2).second + " ";
  }
  EXPECT_EQ(text, "[1, 2] [1.5, 2] [3, 2] [6, 4] [0, -1] not a vehicle's number");
}

constexpr char kScriptBhv[] =
    "initialize DEPLOY = false\nBehavior = BHV_Waypoint\n{\nname = leg\nspeed = 1\n"
    "points = 0,0\nupdates = UP\ncondition = DEPLOY = true\nrunflag = LATER = false\n}\n";

/// Imports a vehicle abe with a script, and a shore with `shore`.
MoosImport ImportScript(const std::string& script, const std::string& shore = "",
                        const std::string& antler = "") {
  return ImportMoos(std::vector<MoosSource>{
      {.name = "abe.moos",
       .text = "Community = abe\n" + antler + "ProcessConfig = pHelmIvP\n{\n}\n" + script},
      {.name = "abe.bhv", .text = kScriptBhv},
      {.name = "shore.moos", .text = "Community = shore\n" + shore}});
}

TEST(ImportMoos, LeavesOutAScriptWhoseLineOfAntlerIsAComment) {
  const std::string script =
      "ProcessConfig = uTimerScript\n{\nevent = var=UP, val=speed=2, time=5\n}\n";
  const std::string antler = "ProcessConfig = ANTLER\n{\nRun = pHelmIvP @ NewConsole = false\n";
  constexpr char kRun[] = "Run = uTimerScript @ NewConsole = false\n";
  for (const std::string run : {"", "// ", "//x "}) {
    const MoosImport import = ImportScript(script, "", antler + run + kRun + "}\n");
    EXPECT_EQ(import.warnings, std::vector<std::string>{});
    EXPECT_EQ(Loaded(import).events.size(), run == "// " ? 0U : 1U) << run;
  }
}

TEST(ImportMoos, ReadsAScriptUnderTheNameThatAntlerGivesIt) {
  const MoosImport import = ImportScript(
      "ProcessConfig = uTS_Later\n{\nevent = var=UP, val=speed=2, time=5\n}\n", "",
      "ProcessConfig = ANTLER\n{\nRun = uTimerScript @ NewConsole = false ~ uTS_Later\n}\n");
  EXPECT_EQ(import.lost, std::vector<std::string>{});
  EXPECT_EQ(Loaded(import).events.size(), 1U);
}

TEST(ImportMoos, LeavesOutAScriptThatWaitsForAButton) {
  const std::string viewer = "ProcessConfig = pMarineViewer\n{\naction = GUSTS = true\n}\n";
  const MoosImport import = ImportScript(
      "ProcessConfig = uTimerScript\n{\ncondition = GUSTS = true\nreset_max = 3\n"
      "event = var=DRIFT_X, val=1, time=5\n}\n",
      viewer);
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  EXPECT_EQ(Loaded(import).events.size(), 0U);
  ASSERT_FALSE(import.lost.empty());
  EXPECT_EQ(import.lost.front(),
            "abe.moos:7: condition = GUSTS = true: only a button sets it: the script's events are "
            "left out");
}

TEST(ImportMoos, TakesAScriptThatWaitsForWhatTheButtonThatDeploysSets) {
  const MoosImport import =
      ImportScript("",
                   "ProcessConfig = pMarineViewer\n{\nbutton_one = GO # DEPLOY_ALL=true\n"
                   "button_two = AGAIN # DEPLOY_ALL=true\n}\n"
                   "ProcessConfig = uTimerScript\n{\ncondition = DEPLOY_ALL = true\n"
                   "event = var=UP_ABE, val=speed=2, time=5\n}\n");
  EXPECT_EQ(Loaded(import).events.size(), 1U);
  EXPECT_EQ(import.lost, std::vector<std::string>{});
}

TEST(ImportMoos, LetsAPausedScriptBeginWhereABehaviorSetsItsVariable) {
  const MoosImport import = ImportScript(
      "ProcessConfig = uTimerScript\n{\npaused = true\npause_var = LATER\n"
      "event = var=UP, val=speed=2, time=70\n}\n");
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const Mission mission = Loaded(import);
  ASSERT_EQ(mission.vehicles.at(0).behaviors.size(), 2U);
  EXPECT_EQ(mission.vehicles[0].behaviors[1].condition, std::vector<std::string>{"LATER = false"});
  EXPECT_EQ(mission.vehicles[0].behaviors[1].duration, 70);
}

TEST(ImportMoos, WarnsOnlyOfPostsThatSomethingReads) {
  const std::string script =
      "ProcessConfig = uTimerScript\n{\nevent = var=LEVEL, val=2, time=5\n}\n";
  EXPECT_EQ(ImportScript(script).warnings, std::vector<std::string>{});
  EXPECT_EQ(ImportScript(script, "ProcessConfig = pLogger\n{\nlog = LEVEL @ 0\n}\n").warnings,
            std::vector<std::string>{});
  EXPECT_EQ(ImportScript(script + "ProcessConfig = myApp\n{\ninput = LEVEL\n}\n").warnings,
            std::vector<std::string>{
                "abe.moos:7: event = var=LEVEL, val=2, time=5: no counterpart in shoal"});
}

TEST(ImportMoos, MakesObstaclesOfPointsAsPObstacleMgrDoes) {
  const std::string points =
      "ProcessConfig = uTimerScript\n{\nevent = var=TRACKED_FEATURE, val=\"x=0,y=0,label=a\"\n"
      "event = var=TRACKED_FEATURE, val=\"x=10,y=0,label=a\"\n"
      "event = var=TRACKED_FEATURE, val=\"x=10,y=10,label=a\"\n"
      "event = var=TRACKED_FEATURE, val=\"x=9,y=2,label=a\"\n"
      "event = var=TRACKED_FEATURE, val=\"x=50,y=50,label=b\"\n}\n";
  const std::string manager = "ProcessConfig = pObstacleMgr\n{\n";
  const MoosImport import = ImportScript(points + manager + "}\n");
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const Mission hulls = Loaded(import);
  ASSERT_EQ(hulls.obstacles.size(), 2U);
  EXPECT_EQ(hulls.obstacles[0].id, "a");
  EXPECT_EQ(hulls.obstacles[0].polygon_m.size(), 3U) << "one lies inside";
  EXPECT_EQ(hulls.obstacles[1].polygon_m.size(), 8U);
  EXPECT_NEAR((hulls.obstacles[1].polygon_m[0] - Eigen::Vector2d(50, 50)).norm(), 0.5, 0.02);
  const Mission lasso =
      Loaded(ImportScript(points + manager + "lasso = true\nlasso_points = 6\n}\n"));
  ASSERT_EQ(lasso.obstacles.size(), 2U);
  ASSERT_EQ(lasso.obstacles[0].polygon_m.size(), 6U);
  EXPECT_NEAR((lasso.obstacles[0].polygon_m[0] - Eigen::Vector2d(7.25, 3)).norm(), 5, 0.02);
}

TEST(ImportMoos, LetsVehiclesTouchWhereTheyStart) {
  const auto start = [](const std::string& name, const std::string& x) {
    return MoosSource{.name = name + ".moos",
                      .text = "Community = " + name +
                              "\nProcessConfig = uSimMarine\n{\nstart_pos = " + x + ",0\n}\n"};
  };
  const auto collisions = [&](const std::string& x) {
    return Loaded(ImportMoos(std::vector<MoosSource>{start("abe", "0"), start("ben", x)}))
        .collisions;
  };
  EXPECT_EQ(collisions("1"), CollisionVerdict::kAllowed);
  EXPECT_EQ(collisions("50"), CollisionVerdict::kFail);
}

}  // namespace shoal::import_timer_test

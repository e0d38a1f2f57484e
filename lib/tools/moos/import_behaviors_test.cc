#include "lib/tools/moos/import_behaviors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/mission/file/load.h"
#include "lib/tools/moos/bhv_keys.h"
#include "lib/tools/moos/import.h"
#include "lib/tools/moos/quoted_csv_testing.h"

namespace shoal::import_behaviors_test {

BhvImport Import(const std::string& text) {
  return ImportBhv(ParseBhvFile(Plug({.name = "a", .text = text}, {}, {})));
}

/// Returns the settings of all tables, and "# TEXT" for comments.
std::string Text(const BhvImport& import) {
  std::string text;
  for (const BhvTable& table : import.tables) {
    text += table.header + "\n";
    for (const DraftLine& line : table.lines) {
      text += line.key.empty() ? "# " + line.text + "\n" : line.key + " = " + line.value + "\n";
    }
  }
  return text;
}

/// Returns the settings of one behavior of this type, without its kind.
std::string Behavior(const std::string& type, const std::string& lines) {
  const BhvImport import = Import("Behavior = BHV_" + type + "\n{\n" + lines + "\n}\n");
  std::string text = Text(import);
  const size_t kind = text.find("kind = ");
  return kind == std::string::npos ? text : text.substr(text.find('\n', kind) + 1);
}

std::vector<std::string> Warnings(const std::string& type, const std::string& lines) {
  return Import("Behavior = BHV_" + type + "\n{\n" + lines + "\n}\n").warnings;
}

TEST(ImportBhv, WritesVariablesModesAndBehaviors) {
  const BhvImport import = Import(
      "initialize DEPLOY = false, N = 5, T = \"7\"\n"
      "set MODE = ACTIVE {\n DEPLOY = true\n (A > 1) or (B = x)\n} INACTIVE\n"
      "Behavior = BHV_Waypoint\n{\n name = survey\n pwt = 100\n condition = MODE == ACTIVE\n"
      " condition = RETURN = false\n endflag = RETURN = true\n endflag = DONE=$[UTC]\n"
      " updates = WPT_UPDATE\n perpetual = TRUE\n speed = 2.0\n points = 0,0:10,0\n}\n");
  EXPECT_EQ(import.warnings, std::vector<std::string>());
  EXPECT_EQ(import.num_behaviors, 1U);
  EXPECT_EQ(Text(import),
            "[vehicle.variables]\n"
            "DEPLOY = \"false\"\n"
            "N = 5\n"
            "T = \"7\"\n"
            "RETURN = \"false\"\n"
            "[[vehicle.mode]]\n"
            "set = \"MODE = ACTIVE\"\n"
            "condition = [\"DEPLOY = true\", \"(A > 1) or (B = x)\"]\n"
            "else = \"INACTIVE\"\n"
            "[[vehicle.behavior]]\n"
            "kind = \"waypoint\"\n"
            "name = \"survey\"\n"
            "pwt = 100\n"
            "condition = [\"MODE == ACTIVE\", \"RETURN = false\"]\n"
            "endflag = [\"RETURN = true\", \"DONE=$[UTC]\"]\n"
            "updates = \"WPT_UPDATE\"\n"
            "perpetual = true\n"
            "speed = 2\n"
            "points = [[0, 0], [10, 0]]\n");
  EXPECT_TRUE(import.variables.contains("WPT_UPDATE"));
  EXPECT_TRUE(import.variables.contains("MODE"));
  EXPECT_TRUE(import.variables.contains("DEPLOY"));
}

TEST(ImportBhv, KeepsTheLastOfTwoValues) {
  EXPECT_EQ(Text(Import("initialize A = 1\ninitialize A = 2\n")),
            "[vehicle.variables]\n# initialize A = 1\nA = 2\n");
  EXPECT_EQ(Behavior("Timer", "pwt = 1\npwt = 2"), "# pwt = 1\npwt = 2\n");
}

TEST(ImportBhv, KnowsTheVersionsOfATypeAndNoOther) {
  EXPECT_EQ(KindOfBhv("BHV_AvdColregsV22"), "colregs");
  EXPECT_EQ(KindOfBhv("bhv_avdcolregsv17"), "colregs");
  EXPECT_EQ(KindOfBhv("Waypoint"), "waypoint");
  EXPECT_EQ(KindOfBhv("BHV_AvoidObstacle"), "avoid_obstacle");
  EXPECT_EQ(KindOfBhv("BHV_AvoidObstacleV24"), "avoid_obstacle");
  EXPECT_EQ(KindOfBhv("BHV_OpRegionV24"), "op_region");
  EXPECT_EQ(KindOfBhv("BHV_OpRegionMagic"), "");
  EXPECT_EQ(KindOfBhv("BHV_WaypointX"), "");
  EXPECT_EQ(KindOfBhv(""), "");
}

TEST(ImportBhv, HasATypeForEveryKindOfBehavior) {
  std::set<std::string_view> kinds;
  for (const BhvType& type : AllBhvTypes()) kinds.insert(type.kind);
  const std::set<std::string_view> wanted = {
      WaypointOptions::kKind,       LoiterOptions::kKind,          StationKeepOptions::kKind,
      AvoidCollisionOptions::kKind, ConstantDepthOptions::kKind,   ColregsOptions::kKind,
      ConstantSpeedOptions::kKind,  ConstantHeadingOptions::kKind, AvoidObstacleOptions::kKind,
      TimerOptions::kKind,          PeriodicSurfaceOptions::kKind, TrailOptions::kKind,
      MaxDepthOptions::kKind,       MaxSpeedOptions::kKind,        CutRangeOptions::kKind,
      ConvoyOptions::kKind,         GoToDepthOptions::kKind,       LegRunOptions::kKind,
      OpRegionOptions::kKind,       MemoryTurnLimitOptions::kKind, PeriodicSpeedOptions::kKind,
      ShadowOptions::kKind,         FixedTurnOptions::kKind,       ZigzagOptions::kKind,
      FullStopOptions::kKind,       TestFailureOptions::kKind,     MaintainHeadingOptions::kKind,
      HeadingBiasOptions::kKind,    HysteresisOptions::kKind,      MinAltitudeOptions::kKind,
      RubberBandOptions::kKind};
  EXPECT_EQ(kinds, wanted);
}

TEST(ImportBhv, TakesTheKeysOfEveryType) {
  const std::map<std::pair<std::string, std::string>, std::string> settings = {
      {{"Waypoint", "polygon = 1,2"}, "points = [[1, 2]]"},
      {{"Waypoint", "nm_radius = 9"}, "slip_radius = 9"},
      {{"Waypoint", "capture_line = absolute"}, "capture_line = true\ncapture_line_only = true"},
      {{"Waypoint", "capture_line = true"}, "capture_line = true"},
      {{"Waypoint", "repeat = forever"}, "repeat = -1"},
      {{"Waypoint", "repeat = 3"}, "repeat = 3"},
      {{"Waypoint", "crs_spd_zaic_ratio = 70"}, "patience = 70"},
      {{"Waypoint", "wptflag = A = $[X]\nwptflag = B = 2"}, "wptflag = [\"A = $[X]\", \"B = 2\"]"},
      {{"Loiter", "clockwise = Best"}, "clockwise = \"best\""},
      {{"Loiter", "nm_radius = 15\nradius = 8"}, "slip_radius = 15\nradius = 8"},
      {{"Loiter", "polygon = 0,0:2,0:2,2:0,2\ncenter_assign = 10,20"},
       "# center_assign = 10,20\npolygon = [[9, 21], [11, 21], [11, 19], [9, 19]]"},
      {{"Loiter", "polygon = 0,0:2,0:2,2:0,2\nxcenter_assign = 5"},
       "# xcenter_assign = 5\npolygon = [[4, 2], [6, 2], [6, 0], [4, 0]]"},
      {{"Loiter", "center_assign = present_position"}, "center_activate = true"},
      {{"StationKeep", "station_pt = 5,6\nextra_speed = 2"},
       "station_pt = [5, 6]\ntransit_speed = 2"},
      {{"ConstantDepth", "depth = 20\nduration = no-time-limit"},
       "# duration = no-time-limit\ndepth = 20"},
      {{"ConstantHeading", "heading = 20\nduration = 60"}, "heading = 20\nduration = 60"},
      {{"ConstantSpeed", "speed = 2\nduration = 5\nsummit_delta = 3"},
       "speed = 2\nduration = 5\nsummitdelta = 3"},
      {{"AvoidCollision", "contact = to-be-set\ntemplating = spawn\nmatch_group = a, b:c"},
       "# contact = to-be-set\ntemplating = \"spawn\"\nmatch_group = [\"a\", \"b\", \"c\"]"},
      {{"AvoidCollision", "contact = ben\ncollision_distance = 9"},
       "contact = \"ben\"\nmin_util_cpa_dist = 9"},
      {{"AvdColregsV19", "giveway_bow_dist = 20\npwt_grade = Linear"},
       "giveway_bow_dist = 20\npwt_grade = \"linear\""},
      {{"AvoidObstacleV21", "templating = spawn\npoly = to-be-set\nid = x\nallowable_ttc = 5"},
       "# poly = to-be-set\n# id = x\ntemplating = \"spawn\"\nallowable_ttc = 5"},
      {{"AvoidObstacleV24", "polygon = 0,0:1,0:1,1"}, "polygon = [[0, 0], [1, 0], [1, 1]]"},
      {{"PeriodicSurface", "ascent_grade = fullspeed"}, "ascent_grade = \"fullspeed\""},
      {{"Trail", "trail_angle_type = Absolute\ncontact = a"},
       "trail_angle_type = \"absolute\"\ncontact = \"a\""},
      {{"MaxDepth", "max_depth = 9"}, "max_depth = 9\ntolerance = 100"},
      {{"MaxDepth", "basewidth = 4"}, "tolerance = 4"},
      {{"MaxSpeed", "max_speed = 2"}, "max_speed = 2"},
      {{"CutRange", "pursueflag = P = 1\ngiveup_dist = 4"},
       "pursueflag = [\"P = 1\"]\ngiveup_dist = 4"},
      {{"ConvoyV21X", "ideal_convoy_range = 20\ninter_mark_range = 4"},
       "range = 20\nmark_spacing = 4"},
      {{"GoToDepth", "depth = 5,60 : 10,30 : 0"}, "depths = [[5, 60], [10, 30], [0, 0]]"},
      {{"LegRun", "vx1 = 1,2\np2 = x=3,y=4\nturn_rad = 9"},
       "# p2 = x=3,y=4\np1 = [1, 2]\nturn1_rad = 9\nturn2_rad = 9"},
      {{"LegRun", "vx1 = 1,2\nleg_spds = 1, 2:3"}, "p1 = [1, 2]\nleg_spds = [1, 2, 3]"},
      {{"OpRegion", "polygon = 0,0:9,0:9,9"},
       "core_poly = [[0, 0], [9, 0], [9, 9]]\ntrigger_on_poly_entry = false"},
      {{"OpRegion", "trigger_entry_time = 2"}, "trigger_entry_time = 2"},
      {{"OpRegionV24", "save_dist = 5\nsavex_flag = A = b"},
       "save_dist = 5\nsavex_flag = [\"A = b\"]"},
      {{"MemoryTurnLimit", "memory_time = 5\nturn_range = 30"}, "memory_time = 5\nturn_range = 30"},
      {{"PeriodicSpeed", "summit_delta = 3\ninitially_busy = true"},
       "summitdelta = 3\ninitially_busy = true"},
      {{"Shadow", "heading_peakwidth = 5"}, "heading_peakwidth = 5"},
      {{"FixedTurn", "turn_dir = star\nspeed = auto"}, "turn_dir = \"starboard\"\nspeed = -1"},
      {{"ZigZag", "max_zig_zags = 3\nzig_first = star"},
       "max_zig_legs = 6\nzig_first = \"starboard\""},
      {{"FullStop", "duration = 5"}, "duration = 5"},
      {{"MaintainHeading", "peakwidth = 5"}, "peakwidth = 5"},
      {{"HeadingBias", "bias = left"}, "bias = \"left\""},
      {{"Hysteresis", "memory_time = 20\nmax_heading_window = 40"},
       "memory_time = 20\nmax_heading_window = 40"},
      {{"MinAltitudeX", "min_altitude = 8"}, "min_altitude = 8"},
      {{"RubberBand", "point = 1,2\nstiffness = 0.2"}, "point = [1, 2]\nstiffness = 0.2"},
      {{"TimeOut", "max_time = 900"}, "max_time = 900"},
      {{"TestFailure", "failure_type = burn,4.5"}, "failure_type = \"burn\"\nburn_time = 4.5"},
      {{"Timer", "nostarve = A, B, 20"}, "nostarve = [\"A\", \"B\"]\nnostarve_s = 20"},
      {{"Timer", "run_flag = A = 1\nspawnxflag = B = 2"},
       "runflag = [\"A = 1\"]\nspawnxflag = [\"B = 2\"]"},
      {{"Timer", "condition = DEPLOY, true"}, "condition = [\"DEPLOY = true\"]"},
      {{"Timer", "templating = disallowed"}, "# templating = disallowed"},
  };
  for (const auto& [behavior, text] : settings) {
    const auto& [type, lines] = behavior;
    if (type == "LegRun" && lines.find("x=3") != std::string::npos) continue;
    EXPECT_EQ(Behavior(type, lines), text + "\n") << type << ": " << lines;
  }
}

TEST(ImportBhv, LeavesOutABehaviorWithoutWhatItIsAbout) {
  const BhvImport import =
      Import("Behavior = BHV_Waypoint\n{\n speed = 2\n points = format=zigzag, x=2\n}\n");
  EXPECT_EQ(import.num_behaviors, 0U);
  EXPECT_EQ(Text(import),
            "[[vehicle.behavior]]\n# Behavior = BHV_Waypoint\n# points = format=zigzag, x=2\n"
            "# speed = 2\n");
  ASSERT_EQ(import.warnings.size(), 1U);
  EXPECT_TRUE(import.warnings[0].starts_with("a:4: points = format=zigzag, x=2: "));
  EXPECT_TRUE(import.warnings[0].ends_with(": the behavior is left out"));
}

TEST(ImportBhv, TakesBehaviorsThatAreACaseOfOthers) {
  const std::string abort = Text(Import(
      "Behavior = BHV_AbortToPoint\n{\n name = abort\n point = 1,2\n speed = 2\n radius = 9\n}\n"));
  EXPECT_NE(abort.find("kind = \"waypoint\""), std::string::npos) << abort;
  EXPECT_NE(abort.find("capture_radius = 9"), std::string::npos) << abort;
  EXPECT_NE(abort.find("slip_radius = 200"), std::string::npos) << abort;
  const std::string recover = Text(Import(
      "Behavior = BHV_OpRegionRecover\n{\n polygon = 0,0:0,50:50,50:50,0\n buffer_dist = 8\n}\n"));
  EXPECT_NE(recover.find("kind = \"op_region\""), std::string::npos) << recover;
  EXPECT_NE(recover.find("save_dist = 8"), std::string::npos) << recover;
}

TEST(ImportBhv, NamesEveryLineOfABehaviorThatIsNotThere) {
  const BhvImport import = Import("Behavior = BHV_Magic\n{\n name = m\n wand = 2\n}\n");
  EXPECT_EQ(import.num_behaviors, 0U);
  EXPECT_EQ(Text(import),
            "# a:1: a behavior that is left out.\n# Behavior = BHV_Magic\n# name = m\n"
            "# wand = 2\n");
  EXPECT_EQ(import.warnings,
            (std::vector<std::string>{"a:1: Behavior = BHV_Magic: no kind of behavior in shoal"}));
}

TEST(ImportBhv, WarnsOfWhatChangesABehaviorAndNotOfItsDrawing) {
  EXPECT_EQ(Warnings("Loiter", "visual_hints = edge_color=red\nuse_refinery = true"),
            std::vector<std::string>());
  EXPECT_EQ(Warnings("Loiter", "wand = 2"),
            (std::vector<std::string>{"a:3: wand = 2: no key of loiter in shoal"}));
  EXPECT_EQ(Warnings("Trail", "velocity_filter = 2").size(), 1U);
  EXPECT_EQ(Warnings("Waypoint", "speed = fast"),
            (std::vector<std::string>{"a:3: speed = fast: not a number"}));
  EXPECT_EQ(Warnings("ConstantHeading", "heading = 5"),
            (std::vector<std::string>{
                "a:1: Behavior = BHV_ConstantHeading: has no duration: MOOS-IvP ends it at once, "
                "here it lasts without end"}));
}

TEST(ImportBhv, BoundsHowMuchThereIs) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "Behavior = BHV_Timer {\n}\n";
  const BhvImport import = Import(text);
  EXPECT_EQ(import.num_behaviors, 200U);
  EXPECT_EQ(
      import.warnings,
      (std::vector<std::string>{"a:401: behaviors are left out from here on: 200 are the most"}));
}

TEST(BhvKeys, HaveOneMeaningForEachKindAndName) {
  std::set<std::pair<std::string_view, std::string_view>> seen;
  for (const BhvKey& row : AllBhvKeys()) {
    EXPECT_TRUE(seen.emplace(row.kinds, row.moos_key).second) << row.moos_key;
    EXPECT_FALSE(row.key.empty());
  }
}

TEST(BhvKeys, AreInTheDocumentation) {
  std::ifstream in(std::string(SHOAL_SOURCE_DIR) + "/docs/reference/import_bhv.md");
  std::map<std::string, std::string> row_of_kind;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("| all | |")) row_of_kind["*"] = line;
    if (line.starts_with("| those about a contact | |")) row_of_kind["@"] = line;
    for (const BhvType& type : AllBhvTypes()) {
      const std::string kind = "| `" + std::string(type.kind) + "` |";
      if (line.find(kind) != std::string::npos) row_of_kind[std::string(type.kind)] = line;
    }
  }
  for (const BhvKey& row : AllBhvKeys()) {
    std::istringstream kinds{std::string(row.kinds)};
    for (std::string kind; kinds >> kind;) {
      EXPECT_NE(row_of_kind[kind].find("`" + std::string(row.moos_key) + "`"), std::string::npos)
          << kind << " " << row.moos_key;
    }
  }
}

RC_GTEST_PROP(ImportBhv, NamesEveryLineThatIsNotEmpty, ()) {
  const auto lines = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "Behavior = BHV_Waypoint", "Behavior = BHV_Magic", "Behavior = BHV_AvdColregsV22",
      "Behavior = BHV_Loiter", "{", "}", "{", "}", "name = x", "pwt = y", "points = 0,0",
      "polygon = 0,0:1,1:2,0", "speed = 2", "wand = 2", "visual_hints = a=b", "condition = A = b",
      "center_assign = 1,2", "templating = spawn", "contact = c", "nostarve = A,2",
      "capture_line = absolute", "duration = no-time-limit", "junk"));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const BhvImport import = Import(text);
  std::string named;
  for (const BhvTable& table : import.tables) {
    for (const DraftLine& line : table.lines) named += line.origin + " ";
    for (const DraftLine& line : table.lines) named += line.reason + " ";
  }
  named += " ";
  for (char& c : named) c = c == ',' ? ' ' : c;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() == 1) continue;
    RC_ASSERT(named.find("a:" + std::to_string(i + 1) + " ") != std::string::npos);
  }
}

TEST(ImportBhv, PutsThePointsOfEveryGoldenKeyWhereTheBehaviorHasThem) {
  for (const GoldenRow& row : ReadQuotedCsv("moos_import/points.csv")) {
    const std::string& reader = row.at("read_by");
    if (reader.starts_with("lib_")) continue;
    SCOPED_TRACE(row.at("number") + " " + reader + " " + row.at("key") + " = " + row.at("text"));
    const std::string type = reader == "waypoint"        ? "Waypoint"
                             : reader == "loiter"        ? "Loiter"
                             : reader == "station_keep"  ? "StationKeep"
                             : reader == "op_region"     ? "OpRegion"
                             : reader == "op_region_v24" ? "OpRegionV24"
                                                         : "LegRun";
    std::string lines = row.at("key") + " = " + row.at("text") + "\n";
    if (reader == "leg_run") {
      lines = row.at("text") + "\n";
      std::replace(lines.begin(), lines.end(), ';', '\n');
    }
    const MoosImport import = ImportMoos(std::vector<MoosSource>{
        {.name = "a.moos", .text = "Community = a\nProcessConfig = pHelmIvP\n{\n}\n"},
        {.name = "a.bhv",
         .text = "Behavior = BHV_" + type + "\n{\nname = b\nupdates = U\n" + lines + "}\n"}});
    // Where the behavior refuses the text, the import warns of it.
    const bool is_sound = row.at("result") == "ok";
    EXPECT_EQ(import.warnings.empty(), is_sound) << import.mission;
    if (!is_sound || row.at("vertices").empty()) continue;
    std::vector<Eigen::Vector2d> wanted_m;
    std::istringstream vertices(row.at("vertices"));
    for (std::string vertex; vertices >> vertex;) {
      wanted_m.emplace_back(std::stod(vertex), std::stod(vertex.substr(vertex.find(',') + 1)));
    }
    const AnyBehavior what =
        LoadMissionText(import.mission, "m").mission.vehicles.at(0).behaviors.at(0).what;
    std::vector<Eigen::Vector2d> points_m;
    if (const auto* waypoint = std::get_if<WaypointOptions>(&what)) points_m = waypoint->points;
    if (const auto* loiter = std::get_if<LoiterOptions>(&what)) points_m = loiter->polygon;
    if (const auto* region = std::get_if<OpRegionOptions>(&what)) points_m = region->core_poly;
    if (const auto* keep = std::get_if<StationKeepOptions>(&what)) points_m = {*keep->station_pt};
    if (const auto* leg = std::get_if<LegRunOptions>(&what)) points_m = {*leg->p1, *leg->p2};
    ASSERT_EQ(points_m.size(), wanted_m.size());
    for (size_t i = 0; i < points_m.size(); ++i) {
      EXPECT_LT((points_m[i] - wanted_m[i]).norm(), 1.5e-3) << i;
    }
  }
}

TEST(ImportMoos, KeepsABehaviorWhosePointsComeWithAnUpdate) {
  for (const char* type : {"Waypoint", "Loiter", "StationKeep"}) {
    const MoosImport import = ImportMoos(std::vector<MoosSource>{
        {.name = "a.moos", .text = "Community = a\nProcessConfig = pHelmIvP\n{\n}\n"},
        {.name = "a.bhv",
         .text = std::string("Behavior = BHV_") + type + "\n{\nname = b\nupdates = U\n}\n"}});
    EXPECT_EQ(import.warnings, std::vector<std::string>{});
    EXPECT_EQ(LoadMissionText(import.mission, "m").mission.vehicles.at(0).behaviors.size(), 1U);
  }
}

TEST(ImportMoos, GivesABehaviorAnotherNameWhereAnothersBeginsWithIt) {
  const std::string leg = "speed = 1\npoints = 0,0\n}\n";
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_Waypoint\n{\nname = leg\n" + leg +
               "Behavior = BHV_Waypoint\n{\nname = leg2\n" + leg +
               "Behavior = BHV_Waypoint\n{\nname = leg_1\n" + leg}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  const auto& behaviors = loaded.mission.vehicles.front().behaviors;
  ASSERT_EQ(behaviors.size(), 3U);
  EXPECT_EQ(behaviors[0].name, "leg_2");
  EXPECT_EQ(behaviors[1].name, "leg2");
  EXPECT_EQ(behaviors[2].name, "leg_1");
  EXPECT_NE(import.mission.find("another behavior's name begins with it"), std::string::npos);
}

TEST(ImportMoos, LetsAWaypointPostUnderTheNamesOfItsFile) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_Waypoint\n{\nname = leg\nspeed = 1\npoints = 0,0\n"
               "wpt_dist_to_prev = BEHIND\nwpt_dist_to_next = AHEAD\nwpt_index_var = PLACE\n"
               "wpt_status = Silent\n}\n"
               "Behavior = BHV_ConstantSpeed\n{\nname = slow\nspeed = 1\nduration = 9\n"
               "condition = (AHEAD < 20) or (BEHIND < 20)\n}\n"}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  const auto& leg = std::get<WaypointOptions>(loaded.mission.vehicles.front().behaviors[0].what);
  EXPECT_EQ(leg.dist_to_prev_var, "BEHIND");
  EXPECT_EQ(leg.dist_to_next_var, "AHEAD");
  EXPECT_EQ(leg.index_var, "PLACE");
  EXPECT_EQ(leg.status_var, "");
}

TEST(ImportMoos, WarnsOfAVariableThatIsNotPostedOnlyWhereAConditionReadsIt) {
  for (const bool is_read : {false, true}) {
    const MoosImport import = ImportMoos(std::vector<MoosSource>{
        {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
        {.name = "ida.bhv",
         .text = "initialize GO = true\nBehavior = BHV_OpRegion\n{\nname = region\n"
                 "polygon = 0,0:9,0:9,9\ntime_remaining_var = LEFT\n}\n"
                 "Behavior = BHV_Waypoint\n{\nname = leg\nspeed = 1\npoints = 0,0\n"
                 "condition = " +
                 std::string(is_read ? "LEFT" : "GO") + " != 0\n}\n"}});
    EXPECT_EQ(import.warnings,
              is_read ? std::vector<std::string>({"ida.bhv:6: time_remaining_var = LEFT: is not "
                                                  "posted here, and a condition reads it"})
                      : std::vector<std::string>());
  }
}

TEST(ImportMoos, CountsDepthsThatAreReachedAsMoosIvPDoes) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos",
       .text = "Community = ida\nProcessConfig = pNodeReporter\n{\nplatform_type = auv\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_GoToDepth\n{\nname = dive\ndepth = 40,60:30,45\n"
               "arrival_flag = THERE\n}\n"}});
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  const auto& dive = std::get<GoToDepthOptions>(loaded.mission.vehicles.front().behaviors[0].what);
  EXPECT_EQ(dive.capture_flag, std::vector<std::string>{"GTD_THERE = $[CTR]"});
}

TEST(ImportMoos, TakesTheCaptureLineOfALegRun) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_LegRun\n{\nname = legs\nvx1 = 0,0\nvx2 = 90,0\nspeed = 1\n"
               "turn_rad = 20\ncapture_line = absolute\n}\n"}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{});
  const LoadedMission loaded = LoadMissionText(import.mission, "m.toml");
  const auto& legs = std::get<LegRunOptions>(loaded.mission.vehicles.front().behaviors[0].what);
  EXPECT_TRUE(legs.capture_line);
  EXPECT_TRUE(legs.capture_line_only);
}

TEST(ImportMoos, LimitsThePatienceOfCutRangeAsMoosIvpDoes) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos", .text = "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n"},
      {.name = "ida.bhv",
       .text = "Behavior = BHV_CutRange\n{\nname = cut\ntemplating = spawn\nupdates = C\n"
               "no_alert_request = true\npatience = 100\n}\n"
               "Behavior = BHV_BearingLine\n{\nname = line\n}\n"}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{}) << "a bearing line only draws";
  EXPECT_NE(import.mission.find("patience = 85"), std::string::npos) << import.mission;
}

TEST(ImportMoos, LetsAVesselStopWhoseSpeedsBeginAboveZeroAndWarns) {
  const MoosImport import = ImportMoos(std::vector<MoosSource>{
      {.name = "ida.moos",
       .text = "/------ a line of strokes\nCommunity = ida\nProcessConfig = pHelmIvP\n{\n"
               "domain = speed:1:5:9\n}\n"},
      {.name = "ida.bhv", .text = "Behavior = BHV_Timer\n{\nname = t\n}\n"}});
  EXPECT_EQ(import.warnings, std::vector<std::string>{
                                 "ida.moos:5: domain = speed:1:5:9: taken from 0 m/s on, so that "
                                 "a vessel can stop"});
  EXPECT_NE(import.mission.find("speed = [0, 5, 11]"), std::string::npos) << import.mission;
}

}  // namespace shoal::import_behaviors_test

#include "apps/shoal_import/import_command.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"
#include "lib/mission/file/load.h"
#include "shoal/nav_t.hpp"
#include "sim/simulation.h"

namespace shoal::import_command_test {

class Import : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) {
    WriteBytes(directory_.File(name), Bytes(text.begin(), text.end()));
    return directory_.File(name);
  }

  static constexpr const char* kBlock = "ProcessConfig = uSimMarine\n{\n}\n";
  TestDirectory directory_;
};

TEST_F(Import, WritesAMissionThatLoads) {
  const std::string moos = Write("a.moos", "Community = abe\nProcessConfig = uSimMarine\n{\n}\n");
  const std::string toml = directory_.File("a.toml");
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = toml}), kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.mission.vehicles.at(0).name, "abe");
}

TEST_F(Import, ReadsAFolderAsItsLaunchScriptPlugsIt) {
  std::filesystem::create_directory(directory_.File("m"));
  Write("m/launch.sh", "#!/bin/bash\ntouch " + directory_.File("run") +
                           "\nfor N in ida jon; do\nnsplug meta.moos targ_$N.moos -f VNAME=$N\n"
                           "nsplug meta.bhv targ_$N.bhv -f NAME=b_$N\ndone\n"
                           "nsplug ../secret.moos targ_s.moos\npAntler targ_ida.moos\n");
  Write("secret.moos", kBlock);
  Write("m/meta.moos",
        "Community = $(VNAME)\nProcessConfig = pHelmIvP\n{\n"
        "behaviors = targ_$(VNAME).bhv\n}\n");
  Write("m/meta.bhv", "Behavior = BHV_Timer\n{\nname = $(NAME)\n}\n");
  const std::string toml = directory_.File("a.toml");
  EXPECT_EQ(RunImport({.files = {directory_.File("m")}, .out_path = toml}), kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  ASSERT_EQ(loaded.mission.vehicles.size(), 2U);
  EXPECT_EQ(loaded.mission.vehicles[1].name, "jon");
  EXPECT_EQ(loaded.mission.vehicles[1].behaviors.at(0).name, "b_jon");
  EXPECT_FALSE(std::filesystem::exists(directory_.File("run"))) << "nothing of it is run";
}

TEST_F(Import, ReadsAFolderWithoutALaunchScript) {
  std::filesystem::create_directory(directory_.File("m"));
  EXPECT_EQ(RunImport({.files = {directory_.File("m")}, .out_path = ""}), kExitUsage);
  Write("m/ida.moos", "Community = ida\nProcessConfig = pHelmIvP\n{\n}\n");
  Write("m/ida.bhv", "Behavior = BHV_Timer\n{\nname = b\n}\n");
  const std::string toml = directory_.File("a.toml");
  EXPECT_EQ(RunImport({.files = {directory_.File("m/")}, .out_path = toml}), kExitOk);
  EXPECT_EQ(LoadMission(toml).mission.vehicles.at(0).behaviors.size(), 1U);
}

TEST_F(Import, NamesNoScriptThatTheOneItReadsCalls) {
  std::filesystem::create_directory(directory_.File("m"));
  Write("m/launch_all.sh", "./launch_shoreside.sh\n./launch_vehicle.sh ida\n");
  Write("m/launch_shoreside.sh", "nsplug shore.moos targ_shore.moos -f\n");
  Write("m/launch_vehicle.sh",
        "nsplug meta.moos targ_$1.moos VNAME=$1 -f\nnsplug meta.bhv targ_$1.bhv -f\n");
  Write("m/shore.moos", "Community = shore\n");
  Write("m/meta.moos", "Community = $(VNAME)\nProcessConfig = pHelmIvP\n{\n}\n");
  Write("m/meta.bhv", "Behavior = BHV_Timer\n{\nname = b\n}\n");
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunImport({.files = {directory_.File("m")}, .out_path = directory_.File("a.toml")}),
            kExitOk);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(Import, ReadsAFolderWhoseShoreAndVehiclesHaveAScriptEach) {
  std::filesystem::create_directory(directory_.File("m"));
  Write("m/launch_shoreside.sh", "nsplug shore.moos targ_shore.moos -f\n");
  Write("m/launch_vehicle.sh",
        "nsplug meta.moos targ_ida.moos VNAME=ida\nnsplug meta.bhv targ_ida.bhv\n");
  Write("m/launch_vehicle_two.sh",
        "nsplug meta.moos targ_jon.moos VNAME=jon\nnsplug meta.bhv targ_jon.bhv\n");
  Write("m/shore.moos",
        "Community = shore\nProcessConfig = uFldNodeComms\n{\ncomms_range = 70\n}\n");
  Write("m/meta.moos", "Community = $(VNAME)\nProcessConfig = pHelmIvP\n{\n}\n");
  Write("m/meta.bhv", "Behavior = BHV_Timer\n{\nname = b\n}\n");
  const std::string toml = directory_.File("a.toml");
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(RunImport({.files = {directory_.File("m")}, .out_path = toml}), kExitOk);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "launch_vehicle_two.sh: not read, since launch_vehicle.sh launches a vehicle already; "
            "write a launch.sh that calls both\n");
  const LoadedMission loaded = LoadMission(toml);
  ASSERT_EQ(loaded.mission.vehicles.size(), 1U) << "each script starts a mission of its own";
  EXPECT_EQ(loaded.mission.vehicles[0].name, "ida");
  EXPECT_EQ(loaded.mission.vehicles[0].behaviors.size(), 1U);
  EXPECT_EQ(loaded.mission.comms.comms_range_m, 70);
}

TEST_F(Import, TakesFilesThatOthersIncludeForNoMissions) {
  std::filesystem::create_directory(directory_.File("m"));
  Write("m/ida.moos",
        "Community = ida\n#include plug_origin.moos\n#include plug_helm.moos <x>  // its helm\n"
        "#include \"plug_radio.moos\"\n#include ida.moos\n");
  Write("m/plug_radio.moos", "ProcessConfig = pHelmIvP\n{\n}\n");
  Write("m/plug_origin.moos", "LatOrigin = 54\nLongOrigin = 10\n");
  Write("m/plug_helm.moos", "<tag><x>\nProcessConfig = pHelmIvP\n{\n}\n");
  Write("m/plug_alone.moos", "MOOSTimeWarp = 3\n");
  const std::string toml = directory_.File("a.toml");
  EXPECT_EQ(RunImport({.files = {directory_.File("m")}, .out_path = toml}), kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  ASSERT_EQ(loaded.mission.vehicles.size(), 1U);
  EXPECT_EQ(loaded.mission.vehicles[0].name, "ida");
}

TEST_F(Import, LeavesAnExistingMissionAlone) {
  const std::string moos = Write("a.moos", kBlock);
  const std::string toml = Write("a.toml", "mine");
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = toml}), kExitUsage);
  EXPECT_EQ(TextOfFile(toml), "mine");
}

TEST_F(Import, RefusesAFileThatItCannotRead) {
  EXPECT_EQ(RunImport({.files = {directory_.File("none.moos")}, .out_path = ""}), kExitUsage);
  EXPECT_EQ(RunImport({.files = {directory_.File("")}, .out_path = ""}), kExitUsage);
  const std::string moos = Write("a.moos", kBlock);
  EXPECT_EQ(RunImport({.files = {moos}, .out_path = "/dev/null/x"}), kExitEnvironment);
}

TEST_F(Import, RefusesWhatIsNoMoosMission) {
  const std::string toml = Write("a.toml", "[mission]\nduration_s = 5\n");
  const std::string binary = Write("b.moos", std::string("\x7F"
                                                         "ELF\0\1\2",
                                                         7));
  EXPECT_EQ(RunImport({.files = {toml}, .out_path = ""}), kExitUsage);
  EXPECT_EQ(RunImport({.files = {binary}, .out_path = ""}), kExitUsage);
}

const std::string kExamples = std::string(SHOAL_SOURCE_DIR) + "/examples/moos/";

ImportOptions PlainExample(const std::string& out_path) {
  return {.files = {kExamples + "shoreside.moos", kExamples + "meta_abe.moos",
                    kExamples + "meta_ben.moos", kExamples + "meta_abe.bhv",
                    kExamples + "meta_ben.bhv"},
          .out_path = out_path};
}

TEST_F(Import, TakesTheExampleOfTheDocumentation) {
  const std::string toml = directory_.File("mine.toml");
  ASSERT_EQ(RunImport(PlainExample(toml)), kExitOk);
  const LoadedMission loaded = LoadMission(toml);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  ASSERT_EQ(loaded.mission.vehicles.size(), 2U);
  const Vehicle& ben = loaded.mission.vehicles[1];
  EXPECT_EQ(ben.name, "ben");
  EXPECT_EQ(ben.start.x_m, 40);
  EXPECT_EQ(loaded.mission.comms.comms_range_m, 250);
  ASSERT_EQ(ben.behaviors.size(), 2U);
  EXPECT_EQ(ben.modes.size(), 2U);
  EXPECT_EQ(std::get<LoiterOptions>(ben.behaviors[0].what).polygon.size(), 8U);
  EXPECT_EQ(loaded.mission.vehicles[0].behaviors.size(), 2U);
}

/// The command of docs/reference/import_bhv.md.
ImportOptions AvoidExample(const std::string& out_path) {
  const std::string folder = kExamples + "avoid/";
  return {.files = {folder + "meta_shoreside.moos", folder + "meta_vehicle.bhv",
                    folder + "meta_vehicle.moos"},
          .out_path = out_path,
          .defines = {},
          .vehicles = {"VNAME=gil COLOR=orange START_POS=0,-20,180 HOME=0,-20 CIRCLE=x=0,y=-60",
                       "VNAME=hal START_POS=130,-20,180 HOME=130,-20 CIRCLE=x=130,y=-60"},
          .paths = {}};
}

TEST_F(Import, TakesTheExampleWithAvoidanceWhole) {
  const std::string toml = directory_.File("avoid.toml");
  ::testing::internal::CaptureStderr();
  ASSERT_EQ(RunImport(AvoidExample(toml)), kExitOk);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  const LoadedMission loaded = LoadMission(toml);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.warnings, std::vector<std::string>());
  const Mission& mission = loaded.mission;
  EXPECT_EQ(mission.origin_lat_deg, 54.4) << "of an included file";
  ASSERT_EQ(mission.vehicles.size(), 2U);
  const Vehicle& hal = mission.vehicles[1];
  EXPECT_EQ(hal.color, "yellow");
  EXPECT_EQ(mission.vehicles[0].color, "orange");
  ASSERT_EQ(hal.behaviors.size(), 4U);
  EXPECT_EQ(hal.behaviors[1].templating, Templating::kSpawn);
  EXPECT_EQ(std::get<ColregsOptions>(hal.behaviors[1].what).max_util_cpa_dist, 26);
  EXPECT_EQ(hal.variables.size(), 4U);
  EXPECT_EQ(hal.modes.size(), 3U);
  ASSERT_EQ(mission.events.size(), 6U);
  EXPECT_EQ(std::get<CommandEvent>(mission.events[1].what).argument,
            "UP_CIRCLE=center_assign=130,-60");
}

TEST_F(Import, LeavesOutWhatItsMacrosLeaveOut) {
  const std::string toml = directory_.File("calm.toml");
  ImportOptions options = AvoidExample(toml);
  options.defines = {"AVOIDANCE=none"};
  ASSERT_EQ(RunImport(options), kExitOk);
  EXPECT_EQ(LoadMission(toml).mission.vehicles.at(0).behaviors.size(), 3U);
}

/// What two vessels did.
struct Tracks {
  std::map<std::string, std::vector<Eigen::Vector2d>> positions_m;  ///< One each second.
  double closest_m = std::numeric_limits<double>::infinity();
};

Tracks TracksOf(const std::string& toml) {
  Result<Simulation> opened = Simulation::Open({.mission_file = toml});
  EXPECT_TRUE(opened.ok()) << (opened.ok() ? "" : opened.error());
  Tracks tracks;
  std::map<std::string, Eigen::Vector2d> now_m;
  for (const Vehicle& vehicle : opened->mission().vehicles) {
    Subscribe(opened->bus(), channels::Nav(vehicle.name), [&now_m, &vehicle](const nav_t& nav) {
      now_m[vehicle.name] = {nav.x_m, nav.y_m};
    });
  }
  while (opened->Step()) {
    if (now_m.size() < 2) continue;
    const double apart_m = (now_m.begin()->second - now_m.rbegin()->second).norm();
    tracks.closest_m = std::min(tracks.closest_m, apart_m);
    if (opened->step() % 10 != 0) continue;
    for (const auto& [name, position_m] : now_m) tracks.positions_m[name].push_back(position_m);
  }
  return tracks;
}

bool IsNear(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, double limit_m) {
  return (a_m - b_m).norm() < limit_m;
}

TEST_F(Import, MakesVesselsOfTheExampleExchangeTheirCirclesAndAvoidEachOther) {
  const std::string toml = directory_.File("avoid.toml");
  ASSERT_EQ(RunImport(AvoidExample(toml)), kExitOk);
  const Tracks tracks = TracksOf(toml);
  const Eigen::Vector2d west_m(0, -60);
  const Eigen::Vector2d east_m(130, -60);
  constexpr double kRadius_m = 40;
  EXPECT_TRUE(IsNear(tracks.positions_m.at("gil").at(100), west_m, kRadius_m));
  EXPECT_TRUE(IsNear(tracks.positions_m.at("hal").at(100), east_m, kRadius_m));
  EXPECT_TRUE(IsNear(tracks.positions_m.at("gil").at(300), east_m, kRadius_m));
  EXPECT_TRUE(IsNear(tracks.positions_m.at("hal").at(300), west_m, kRadius_m));
  EXPECT_TRUE(IsNear(tracks.positions_m.at("gil").back(), {0, -20}, 12)) << "home";
  EXPECT_TRUE(IsNear(tracks.positions_m.at("hal").back(), {130, -20}, 12)) << "home";
  EXPECT_GT(tracks.closest_m, 24) << "max_util_cpa_dist is 26";
}

TEST_F(Import, MakesThemMeetWhereTheyDoNotAvoidEachOther) {
  const std::string toml = directory_.File("calm.toml");
  ImportOptions options = AvoidExample(toml);
  options.defines = {"AVOIDANCE=none"};
  ASSERT_EQ(RunImport(options), kExitOk);
  EXPECT_LT(TracksOf(toml).closest_m, 5);
}

TEST_F(Import, MakesTheExampleOfTheDocumentationRun) {
  const std::string toml = directory_.File("mine.toml");
  ASSERT_EQ(RunImport(PlainExample(toml)), kExitOk);
  const Tracks tracks = TracksOf(toml);
  const auto& abe = tracks.positions_m.at("abe");
  for (const Eigen::Vector2d& point_m : {Eigen::Vector2d(60, -40), Eigen::Vector2d(60, -100),
                                         Eigen::Vector2d(110, -100), Eigen::Vector2d(110, -40)}) {
    EXPECT_TRUE(std::any_of(abe.begin(), abe.end(), [&](const Eigen::Vector2d& position_m) {
      return IsNear(position_m, point_m, 7);
    })) << point_m.transpose();
  }
  EXPECT_TRUE(IsNear(abe.back(), {0, -20}, 6)) << "the way back";
  const auto& ben = tracks.positions_m.at("ben");
  EXPECT_TRUE(IsNear(ben.at(250), {60, -150}, 35)) << "on its circle";
  EXPECT_TRUE(IsNear(ben.back(), {40, -20}, 14)) << "on its station";
}

TEST_F(Import, ReadsIncludedFilesOnlyBelowNamedFolders) {
  std::filesystem::create_directories(directory_.File("in"));
  std::filesystem::create_directories(directory_.File("plugs"));
  Write("secret", "Community = stolen\n");
  Write("plugs/p.moos", "Community = found\n");
  const auto name_with = [&](const std::string& line, const std::vector<std::string>& paths) {
    const std::string moos = Write("in/a.moos", line + "\nProcessConfig = uSimMarine\n{\n}\n");
    const std::string toml = directory_.File("out.toml");
    std::filesystem::remove(toml);
    EXPECT_EQ(
        RunImport(
            {.files = {moos}, .out_path = toml, .defines = {}, .vehicles = {}, .paths = paths}),
        kExitOk);
    return LoadMission(toml).mission.vehicles.at(0).name;
  };
  EXPECT_EQ(name_with("#include ../secret", {}), "a");
  EXPECT_EQ(name_with("#include " + directory_.File("secret"), {}), "a");
  EXPECT_EQ(name_with("#include /dev/zero", {}), "a");
  EXPECT_EQ(name_with("#include p.moos", {}), "a");
  EXPECT_EQ(name_with("#include p.moos", {directory_.File("plugs")}), "found");
  EXPECT_EQ(name_with("#include ../plugs/p.moos", {directory_.File("plugs")}), "found");
  std::filesystem::create_symlink(directory_.File("secret"), directory_.File("in/link"));
  EXPECT_EQ(name_with("#include link", {}), "a");
}

TEST_F(Import, RefusesDefinesThatAreNone) {
  const std::string moos = Write("a.moos", kBlock);
  for (const char* text : {"", "=1", "A B=1"}) {
    EXPECT_EQ(
        RunImport(
            {.files = {moos}, .out_path = "", .defines = {text}, .vehicles = {}, .paths = {}}),
        kExitUsage)
        << text;
  }
  EXPECT_EQ(
      RunImport(
          {.files = {moos}, .out_path = "", .defines = {}, .vehicles = {"A=1 =B"}, .paths = {}}),
      kExitUsage);
}

TEST_F(Import, RefusesBehaviorsAlone) {
  const std::string bhv = Write("a.bhv", "Behavior = BHV_Timer\n{\n}\n");
  EXPECT_EQ(RunImport({.files = {bhv}, .out_path = ""}), kExitUsage);
  EXPECT_EQ(RunImport({.files = {Write("b.moos", kBlock), Write("c.bhv", "none")}, .out_path = ""}),
            kExitUsage);
}

}  // namespace shoal::import_command_test

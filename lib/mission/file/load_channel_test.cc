// The keys of [acoustics.channel].
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "lib/mission/file/data_files.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/load_testing.h"
#include "lib/mission/file/water_files.h"
#include "lib/sea/acoustics/ray_channel.h"

namespace shoal::load_channel_test {

namespace fs = std::filesystem;

constexpr std::string_view kModem = "[acoustics]\nmodem = \"whoi_micromodem2\"\n";

LoadedMission LoadWith(const std::string& channel, const std::string& more = "",
                       const std::string& name = "m.toml") {
  return LoadMissionText(
      std::string(kShortest) + std::string(kModem) + "[acoustics.channel]\n" + channel + more, name,
      {});
}

const RayChannelOptions& RaysOf(const LoadedMission& loaded) {
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  static const RayChannelOptions none;
  const auto& rays = loaded.mission.acoustics.options.rays;
  EXPECT_TRUE(rays.has_value());
  return rays ? *rays : none;
}

std::string FirstError(const LoadedMission& loaded) {
  return loaded.errors.empty() ? "" : loaded.errors.front();
}

TEST(LoadChannel, HasStraightSoundUnlessRaysAreNamed) {
  EXPECT_FALSE(LoadMissionText(std::string(kShortest) + std::string(kModem), "m.toml", {})
                   .mission.acoustics.options.rays.has_value());
  const LoadedMission straight = LoadWith("model = \"straight\"\n");
  EXPECT_TRUE(straight.errors.empty());
  EXPECT_FALSE(straight.mission.acoustics.options.rays.has_value());
}

TEST(LoadChannel, ReadsEachKey) {
  const LoadedMission loaded = LoadWith(
      "model = \"rays\"\nprofile = [[0, 1520], [30, 1490]]\nbottom_depth_m = 30\n"
      "bottom = \"mud\"\nwind_mps = 8\nmax_launch_deg = 45\nwindow_s = 0.02\n"
      "significant_db = 15\nmax_doppler_mps = 3\ncell_m = 0.5\n"
      "packet_errors = [[0, 1], [10, 0]]\n");
  const RayChannelOptions& rays = RaysOf(loaded);
  EXPECT_EQ(rays.profile, (std::vector<SpeedPoint>{{0, 1520}, {30, 1490}}));
  EXPECT_EQ(rays.bottom_depth_m, 30);
  EXPECT_FALSE(rays.follows_floor);
  EXPECT_EQ(rays.bottom, *FindBottomType("mud"));
  EXPECT_EQ(rays.wind_mps, 8);
  EXPECT_EQ(rays.max_launch_deg, 45);
  EXPECT_EQ(rays.window_s, 0.02);
  EXPECT_EQ(rays.significant_db, 15);
  EXPECT_EQ(rays.max_doppler_mps, 3);
  EXPECT_EQ(rays.cell_m, 0.5);
  EXPECT_EQ(rays.packet_errors, (std::vector<PacketErrorPoint>{{0, 1}, {10, 0}}));
  // One speed for what needs one: the mean of the column.
  EXPECT_NEAR(loaded.mission.acoustics.options.sound_speed_mps, 1505, 0.1);
}

TEST(LoadChannel, TakesTheBottomOfTheMissionsFloor) {
  const std::string channel = "model = \"rays\"\n";
  EXPECT_EQ(RaysOf(LoadWith(channel, "[environment.floor]\nstyle = \"flat\"\ndepth_m = 42\n"))
                .bottom_depth_m,
            42);
  const LoadedMission shelf = LoadWith(channel, "[environment.floor]\nstyle = \"shelf\"\n");
  EXPECT_TRUE(RaysOf(shelf).follows_floor);
  EXPECT_NE(FirstError(LoadWith(channel)).find("rays need a bottom"), std::string::npos);
}

TEST(LoadChannel, RefusesWhatCannotBeWithTheRemedy) {
  EXPECT_NE(FirstError(LoadWith("model = \"ray\"\n")).find("rays"), std::string::npos);
  EXPECT_NE(FirstError(LoadWith("model = \"rays\"\nbottom_depth_m = 50\n"
                                "profile = [[0, 1500], [0, 1490]]\n"))
                .find("depths must grow"),
            std::string::npos);
  EXPECT_NE(FirstError(LoadWith("model = \"rays\"\nbottom_depth_m = 50\nbottom = \"lava\"\n"))
                .find("sand"),
            std::string::npos);
  EXPECT_NE(
      FirstError(LoadWith("model = \"rays\"\nbottom_depth_m = 50\nprofile_file = \"no.csv\"\n"))
          .find("no.csv"),
      std::string::npos);
  EXPECT_NE(
      FirstError(LoadMissionText(std::string(kShortest) + "[acoustics.channel]\nmodel = \"rays\"\n"
                                                          "bottom_depth_m = 50\n",
                                 "m.toml", {}))
          .find("only a modem knows"),
      std::string::npos);
}

TEST(LoadChannel, WarnsOfWhatHasNoEffect) {
  const LoadedMission loaded =
      LoadWith("model = \"rays\"\nbottom_depth_m = 50\nprofile = [[0, 1500], [20, 1490]]\n",
               "[acoustics.sea]\nspreading_exponent = 2\n");
  const auto warns = [&](std::string_view text) {
    return std::ranges::any_of(loaded.warnings, [&](const std::string& warning) {
      return warning.find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(warns("the profile ends at 20 m"));
  EXPECT_TRUE(warns("spreading_exponent has no effect"));
}

/// A folder with files, removed at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("shoal_channel_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  std::string mission() const { return (path_ / "m.toml").string(); }

 private:
  fs::path path_;
};

TEST(LoadChannel, ReadsCastsTablesAndArrivalsBesideTheMission) {
  const Folder folder;
  folder.Write("cast.csv", "Depth (m),Temperature,Salinity\n0,20,35\n50,12,35\n");
  folder.Write("per.csv", "snr_db;loss\n0;1\n12;0\n");
  folder.Write("bay.arr", "'2D'\n25000\n1 30\n1 60\n1 1000\n1\n1\n1e-3 0 0.7 0 1.5 2.5 0 1\n");
  const LoadedMission loaded = LoadWith(
      "model = \"rays\"\nbottom_depth_m = 50\nprofile_file = \"cast.csv\"\n"
      "packet_errors_file = \"per.csv\"\narrivals_file = \"bay.arr\"\n",
      "", folder.mission());
  const RayChannelOptions& rays = RaysOf(loaded);
  ASSERT_EQ(rays.profile.size(), 2U);
  EXPECT_NEAR(rays.profile[0].speed_mps, 1521.5, 0.1);
  EXPECT_EQ(rays.packet_errors.size(), 2U);
  EXPECT_EQ(DataFilesOf(loaded.mission),
            (std::vector<std::string>{"cast.csv", "per.csv", "bay.arr"}));
  const LoadedMission twice = LoadWith(
      "model = \"rays\"\nbottom_depth_m = 50\nprofile_file = \"cast.csv\"\n"
      "profile = [[0, 1500]]\n",
      "", folder.mission());
  EXPECT_NE(FirstError(twice).find("remove one of them"), std::string::npos);
  folder.Write("bay.arr", "'2D'\n25000\n1 30\n");
  EXPECT_NE(
      FirstError(LoadWith("model = \"rays\"\narrivals_file = \"bay.arr\"\n", "", folder.mission()))
          .find("bay.arr:4: "),
      std::string::npos);
}

TEST(LoadChannel, StandsInCommsRulesWithItsFloor) {
  LoadedMission loaded = LoadWith("model = \"rays\"\nprofile = [[0, 1520], [30, 1490]]\n",
                                  "[environment.floor]\nstyle = \"shelf\"\ndepth_m = 60\n");
  RaysOf(loaded);
  const MediaSetup setup = MediaOf(loaded.mission);
  ASSERT_TRUE(setup.floor.has_value());
  const std::string text = ExplainMedia(setup);
  const LoadedMedia again = LoadMediaText(text, "COMMS_RULES");
  EXPECT_TRUE(again.errors.empty()) << again.errors.front() << "\n" << text;
  EXPECT_EQ(again.setup, setup);
  // Without rays the text is what it was.
  const std::string straight = ExplainMedia(
      MediaOf(LoadMissionText(std::string(kShortest) + std::string(kModem), "m.toml", {}).mission));
  EXPECT_EQ(straight.find("channel]"), std::string::npos);
  EXPECT_EQ(straight.find("floor"), std::string::npos);
}

}  // namespace shoal::load_channel_test

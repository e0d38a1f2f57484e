// Vehicles of model = "track" in mission files.
#include "lib/mission/file/track_of.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lib/mission/file/data_files.h"
#include "lib/mission/file/load.h"

namespace shoal::track_of_test {

/// A folder of its own with a track, and missions that replay it.
class TracksOfMissions : public testing::Test {
 protected:
  TracksOfMissions()
      : folder_(std::filesystem::path(testing::TempDir()) /
                (std::string("track_of_test_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
    Write("ferry.csv", "t_s,x_m,y_m\n100,10,20\n110,30,20\n200,30,20\n");
  }
  ~TracksOfMissions() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  LoadedMission Load(const std::string& vehicle, const std::string& mission = "") const {
    return LoadMissionText("[mission]\nduration_s = 60\n" + mission +
                               "\n[[vehicle]]\nname = \"ferry\"\nmodel = \"track\"\n" + vehicle,
                           (folder_ / "m.toml").string());
  }
  ReplayState StateAt(const LoadedMission& loaded, double mission_s) const {
    const auto& options = std::get<TrackOptions>(loaded.mission.vehicles.at(0).model);
    const Result<MissionTrack> track = TrackOf(loaded.mission, options);
    EXPECT_TRUE(track.ok()) << track.error();
    return track->At(mission_s);
  }
  std::string ErrorOf(const LoadedMission& loaded) const {
    return loaded.errors.empty() ? "no error" : loaded.errors.front();
  }
  bool Warns(const LoadedMission& loaded, const std::string& text) const {
    for (const std::string& warning : loaded.warnings) {
      if (warning.find(text) != std::string::npos) return true;
    }
    return false;
  }

  std::filesystem::path folder_;
};

TEST_F(TracksOfMissions, BeginWithTheMissionByDefault) {
  const LoadedMission loaded = Load("track = {file = \"ferry.csv\"}\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(loaded.mission.vehicles[0].start,
            (StartPose{.x_m = 10, .y_m = 20, .heading_deg = 90, .speed_mps = 2}));
  EXPECT_EQ(loaded.mission.vehicles[0].helm, Provider::kNone);
  EXPECT_EQ(loaded.mission.vehicles[0].type, "track");
  EXPECT_NEAR(StateAt(loaded, 5).position_m.x(), 20, 1e-12);
}

TEST_F(TracksOfMissions, CanBeDelayed) {
  const LoadedMission loaded = Load("track = {file = \"ferry.csv\", delay_s = 7}\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(StateAt(loaded, 7).position_m.x(), 10);
  EXPECT_NEAR(StateAt(loaded, 12).position_m.x(), 20, 1e-12);
  EXPECT_EQ(loaded.mission.vehicles[0].start.speed_mps, 0);
  const LoadedMission early = Load("track = {file = \"ferry.csv\", delay_s = -5}\n");
  EXPECT_NEAR(StateAt(early, 0).position_m.x(), 20, 1e-12);
}

TEST_F(TracksOfMissions, TakeTheMissionsOwnTimeWhereTheyAreAbsolute) {
  const LoadedMission loaded =
      Load("track = {file = \"ferry.csv\", time = \"absolute\"}\n", "start_utime = 95000000\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(StateAt(loaded, 5).position_m.x(), 10);
  EXPECT_NEAR(StateAt(loaded, 10).position_m.x(), 20, 1e-12);
}

TEST_F(TracksOfMissions, AreExplainedAsMissionsThatLoadEqual) {
  Write("auv.csv", "mmsi,t_s,x_m,y_m,depth_m\n7,0,0,0,-4\n8,0,5,5,-4\n7,90,9,9,-9\n");
  Write("auv.gpx",
        "<gpx><trk><trkpt lat=\"43.8\" lon=\"-70.3\"><time>2024-05-01T10:00Z</time></trkpt></trk>"
        "</gpx>");
  for (const char* keys :
       {"file = \"ferry.csv\", delay_s = -3.7, time = \"first\"",
        "file = \"auv.csv\", underwater = true, depth_positive = \"up\", name = \"7\"",
        "file = \"auv.gpx\", number = 1"}) {
    const LoadedMission loaded = Load(std::string("track = {") + keys + "}\n");
    ASSERT_EQ(loaded.errors, std::vector<std::string>{});
    const LoadedMission again =
        LoadMissionText(Explain(loaded.mission), (folder_ / "m.toml").string());
    ASSERT_EQ(again.errors, std::vector<std::string>{});
    EXPECT_TRUE(again.mission == loaded.mission) << Explain(again.mission);
  }
}

TEST_F(TracksOfMissions, AreRefusedAtTheirPlaceInTheMission) {
  const std::string path = folder_.string();
  EXPECT_NE(ErrorOf(Load("")).find("m.toml:4:1: model = \"track\" needs a file: write track = "),
            std::string::npos)
      << ErrorOf(Load(""));
  const LoadedMission missing = Load("track = {file = \"none.csv\"}\n");
  EXPECT_NE(ErrorOf(missing).find("m.toml:7:"), std::string::npos) << ErrorOf(missing);
  EXPECT_NE(ErrorOf(missing).find(path + "/none.csv: "), std::string::npos) << ErrorOf(missing);
  EXPECT_NE(ErrorOf(missing).find("counts from the mission file's folder"), std::string::npos);
  Write("torn.csv", "t_s,x_m,y_m\n0,1\n");
  const LoadedMission torn = Load("track = {file = \"torn.csv\"}\n");
  EXPECT_NE(ErrorOf(torn).find(path + "/torn.csv:2: this line has 2 cells"), std::string::npos)
      << ErrorOf(torn);
  EXPECT_NE(ErrorOf(Load("track = {file = \"ferry.kml\"}\n")).find("or GPX, .gpx: convert it"),
            std::string::npos);
  EXPECT_NE(ErrorOf(Load("track = {file = \"ferry.csv\", underwater = true}\n"))
                .find("underwater = true needs them"),
            std::string::npos);
}

TEST_F(TracksOfMissions, HaveNeitherHelmNorTasks) {
  const LoadedMission loaded = Load(
      "track = {file = \"ferry.csv\"}\n[[vehicle.task]]\nkind = \"loiter\"\ncenter = [0, 0]\n");
  EXPECT_NE(ErrorOf(loaded).find("is replayed and has no helm"), std::string::npos)
      << ErrorOf(loaded);
}

TEST_F(TracksOfMissions, WarnWhereTheyEndBeforeTheMissionOrNeverMove) {
  Write("short.csv", "t_s,x_m,y_m\n0,0,0\n30,30,0\n");
  EXPECT_TRUE(Warns(Load("track = {file = \"short.csv\"}\n"),
                    "the track ends at 30.0 s, before the mission at 60 s: ferry lies there"));
  EXPECT_FALSE(Warns(Load("track = {file = \"ferry.csv\"}\n"), "the track ends"));
  EXPECT_TRUE(Warns(Load("track = {file = \"ferry.csv\", time = \"absolute\"}\n"),
                    "from 100.0 to 200.0 s of the mission, so that ferry never moves"));
  EXPECT_TRUE(
      Warns(Load("track = {file = \"ferry.csv\"}\nstart = {x_m = 5}\n"), "start has no effect"));
}

TEST_F(TracksOfMissions, UnderWaterNeverFly) {
  Write("auv.csv",
        "time,lat,lon,depth\n2024-05-01T10:00:00Z,43.8253,-70.3304,-5\n"
        "2024-05-01T10:01:00Z,43.8263,-70.3304,-6\n");
  const LoadedMission above = Load("track = {file = \"auv.csv\", underwater = true}\n");
  EXPECT_NE(ErrorOf(above).find("auv.csv:3: this point is 6 m above the surface"),
            std::string::npos)
      << ErrorOf(above);
  EXPECT_NE(ErrorOf(above).find("write depth_positive = \"up\""), std::string::npos);
  const LoadedMission turned =
      Load("track = {file = \"auv.csv\", underwater = true, depth_positive = \"up\"}\n");
  ASSERT_EQ(turned.errors, std::vector<std::string>{});
  EXPECT_EQ(StateAt(turned, 30).position_m.z(), 5.5);
  EXPECT_EQ(turned.mission.vehicles[0].start.depth_m, 5);
  const LoadedMission afloat = Load("track = {file = \"auv.csv\", depth_positive = \"up\"}\n");
  EXPECT_TRUE(Warns(afloat, "depth_positive has no effect without underwater = true"));
  EXPECT_TRUE(Warns(afloat, "depth goes to -6 m, and does not count without underwater = true"));
}

TEST_F(TracksOfMissions, WarnAtTheirPlaceOfWhatTheirFilesHave) {
  Write("dup.csv", "t_s,x_m,y_m\n0,0,0\n5,5,0\n5,6,0\n70,10,0\n");
  const LoadedMission loaded = Load("track = {file = \"dup.csv\"}\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(StateAt(loaded, 5).position_m.x(), 6);
  EXPECT_TRUE(Warns(loaded, "m.toml:7:"));
  EXPECT_TRUE(Warns(loaded, "dup.csv:4: 1 of its points have the time of the point before"));
  Write("one.csv", "t_s,x_m,y_m\n0,0,0\n");
  const LoadedMission one = Load("track = {file = \"one.csv\"}\n");
  EXPECT_TRUE(Warns(one, "its points have one time in all: it lies still"));
  EXPECT_FALSE(Warns(one, "never moves")) << "one warning is enough";
}

TEST_F(TracksOfMissions, AreChosenByNameOrByNumber) {
  const auto track = [](const std::string& name, const std::string& lon) {
    return "<trk><name>" + name + "</name><trkseg>\n<trkpt lat=\"43.8253\" lon=\"" + lon +
           "\"><time>2024-05-01T10:00:00Z</time></trkpt>\n<trkpt lat=\"43.8263\" lon=\"" + lon +
           "\"><time>2024-05-01T10:01:00Z</time></trkpt></trkseg></trk>\n";
  };
  Write("two.gpx", "<gpx>\n" + track("Anna", "-70.3304") + track("Berta", "-70.3204") + "</gpx>");
  const LoadedMission both = Load("track = {file = \"two.gpx\"}\n");
  EXPECT_NE(ErrorOf(both).find("two.gpx:6: this track begins 60 s before the one in front of it "
                               "ends: choose one by name = \"...\" or number = N"),
            std::string::npos)
      << ErrorOf(both);
  for (const char* key : {"name = \"Berta\"", "number = 2"}) {
    const LoadedMission loaded = Load(std::string("track = {file = \"two.gpx\", ") + key + "}\n");
    ASSERT_EQ(loaded.errors, std::vector<std::string>{});
    EXPECT_NEAR(StateAt(loaded, 0).position_m.x(), 804, 2) << key;
  }
  EXPECT_NE(ErrorOf(Load("track = {file = \"two.gpx\", number = 3}\n")).find("1 'Anna' (2 points"),
            std::string::npos);
  EXPECT_NE(ErrorOf(Load("track = {file = \"two.gpx\", number = 1, name = \"Anna\"}\n"))
                .find("by its name or by its number: leave one out"),
            std::string::npos);
}

TEST_F(TracksOfMissions, OfTimesBefore1970BeginWithTheMission) {
  Write("old.csv", "time,x_m,y_m\n1969-05-01T10:00:00Z,0,0\n1969-05-01T10:01:00Z,60,0\n");
  const LoadedMission loaded = Load("track = {file = \"old.csv\"}\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(StateAt(loaded, 30).position_m.x(), 30);
  EXPECT_TRUE(Warns(Load("track = {file = \"old.csv\", time = \"absolute\"}\n"), "never moves"));
}

TEST_F(TracksOfMissions, AreAmongTheDataFilesOnce) {
  const LoadedMission loaded = Load(
      "track = {file = \"ferry.csv\"}\n[[vehicle]]\nname = \"b\"\nmodel = \"track\"\ntrack = {file "
      "= \"ferry.csv\"}\n");
  EXPECT_EQ(DataFilesOf(loaded.mission), std::vector<std::string>{"ferry.csv"});
}

}  // namespace shoal::track_of_test

#include "lib/mission/file/background_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "lib/mission/file/load.h"

namespace shoal::background_files_test {

namespace fs = std::filesystem;

class Backgrounds : public testing::Test {
 protected:
  Backgrounds() {
    fs::create_directories(folder_ / "charts");
    std::ofstream(folder_ / "coast.geojson") << "{}";
    std::ofstream(folder_ / "charts/bay.png") << "pixels";
    std::ofstream(folder_ / "charts/bay.pgw") << "1 0 0 -1 0 0";
    std::ofstream(folder_.string() + "-outside.json") << "secret";
    fs::create_symlink(folder_.string() + "-outside.json", folder_ / "link.json");
  }
  ~Backgrounds() override {
    fs::remove_all(folder_);
    fs::remove(folder_.string() + "-outside.json");
  }

  Mission MissionWith(std::vector<std::string> files) const {
    Mission mission;
    mission.file = (folder_ / "mine.toml").string();
    mission.backgrounds = std::move(files);
    return mission;
  }

  const fs::path folder_ = testing::TempDir() + "backgrounds-" + std::to_string(getpid());
};

TEST_F(Backgrounds, AreReadWithTheWorldFileBesideThem) {
  const BackgroundFolder found = BackgroundsOf(MissionWith({"coast.geojson", "charts/bay.png"}));
  EXPECT_EQ(*found.Read(0, false), "{}");
  EXPECT_EQ(*found.Read(1, false), "pixels");
  EXPECT_EQ(*found.Read(1, true), "1 0 0 -1 0 0");
  EXPECT_FALSE(found.Read(0, true).ok()) << "GeoJSON needs none";
  EXPECT_FALSE(found.Read(2, false).ok());
  EXPECT_FALSE(found.HasWorld(0));
  EXPECT_TRUE(found.HasWorld(1));
}

TEST_F(Backgrounds, NeverComeFromOutsideOfTheMissionsFolder) {
  for (const char* file : {"link.json", "../backgrounds-outside.json", "/etc/hostname", "charts"}) {
    EXPECT_FALSE(BackgroundsOf(MissionWith({file})).Read(0, false).ok()) << file;
  }
}

TEST_F(Backgrounds, AreCopiedIntoARecordingWhereTheyAreThere) {
  EXPECT_EQ(BackgroundFilesThere(MissionWith({"charts/bay.png", "missing.tif", "coast.geojson"})),
            (std::vector<std::string>{"charts/bay.pgw", "charts/bay.png", "coast.geojson"}));
}

TEST(BackgroundProblem, NamesWhatABackgroundCanBe) {
  for (const char* file : {"a.geojson", "charts/b.PNG", "c.tiff", "d.webp"}) {
    EXPECT_EQ(BackgroundProblem(file), "") << file;
  }
  for (const char* file : {"", "/a.png", "../a.png", "b/../../c.png", "a.svg", "a.toml"}) {
    EXPECT_NE(BackgroundProblem(file), "") << file;
  }
  EXPECT_EQ(WorldFileOf("a/b.jpeg"), "a/b.jgw");
}

TEST(MissionFile, NamesItsBackgrounds) {
  const std::string begin = "[mission]\nduration_s = 60\nbackgrounds = ";
  const std::string rest = "\n[[vehicle]]\nname = \"alpha\"\n";
  const LoadedMission good = LoadMissionText(begin + "[\"coast.geojson\"]" + rest, "m.toml");
  EXPECT_TRUE(good.errors.empty());
  EXPECT_EQ(good.mission.backgrounds, std::vector<std::string>{"coast.geojson"});
  const LoadedMission bad = LoadMissionText(begin + "[\"../a.png\"]" + rest, "m.toml");
  ASSERT_EQ(bad.errors.size(), 1u);
}

}  // namespace shoal::background_files_test

#include "lib/mission/file/background_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
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

TEST_F(Backgrounds, AreNamedWithWhatToDoWhereTheyAreMissing) {
  fs::create_directories(folder_ / "tiles");
  std::ofstream(folder_ / "bay.mbtiles") << "SQLite format 3";
  EXPECT_TRUE(MissingBackgrounds(MissionWith({"coast.geojson", "bay.mbtiles", "tiles/"})).empty());
  const std::vector<std::string> missing =
      MissingBackgrounds(MissionWith({"no.png", "link.json", "charts/bay.png/", "tiles"}));
  ASSERT_EQ(missing.size(), 4u);
  EXPECT_EQ(missing[0], "the background no.png: there is no no.png in " + folder_.string() +
                            ": put it there, or leave it out of backgrounds");
  EXPECT_EQ(missing[1], "the background link.json: a link leads out of " + folder_.string() +
                            ": put the file itself there");
  EXPECT_NE(missing[2].find("charts/bay.png/"), std::string::npos);
  EXPECT_EQ(missing[3].find("the background tiles: a background ends in"), 0u);

  const std::string text =
      "[mission]\nduration_s = 60\nbackgrounds = [\"coast.geojson\", \"no.png\"]\n"
      "[[vehicle]]\nname = \"alpha\"\n";
  const LoadedMission loaded = LoadMissionText(text, (folder_ / "mine.toml").string());
  EXPECT_TRUE(loaded.errors.empty());
  const auto names_it = [](const std::string& warning) {
    return warning.find("mine.toml:3:") != std::string::npos &&
           warning.find("there is no no.png") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(loaded.warnings.begin(), loaded.warnings.end(), names_it), 1);
}

TEST_F(Backgrounds, OfAFolderOfTilesLieBelowIt) {
  fs::create_directories(folder_ / "tiles/3/4");
  std::ofstream(folder_ / "tiles/3/4/5.png") << "pixels";
  fs::create_symlink(folder_.string() + "-outside.json", folder_ / "tiles/3/4/6.png");
  const BackgroundFolder found = BackgroundsOf(MissionWith({"tiles/"}));
  EXPECT_TRUE(found.Find(0, "3/4/5.png").ok());
  EXPECT_FALSE(found.Find(0, "3/4/6.png").ok()) << "a link out of the folder";
  EXPECT_FALSE(found.Find(0, "../../etc/passwd").ok());
  EXPECT_FALSE(found.Find(0, "3/4/7.png").ok());
}

TEST_F(Backgrounds, AreCopiedIntoARecordingWhereTheyAreThere) {
  EXPECT_EQ(BackgroundFilesThere(MissionWith({"charts/bay.png", "missing.tif", "coast.geojson"})),
            (std::vector<std::string>{"charts/bay.pgw", "charts/bay.png", "coast.geojson"}));
}

TEST(BackgroundProblem, NamesWhatABackgroundCanBe) {
  for (const char* file :
       {"a.geojson", "charts/b.PNG", "c.tiff", "d.webp", "e.mbtiles", "tiles/"}) {
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

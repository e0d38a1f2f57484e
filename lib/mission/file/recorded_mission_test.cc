#include "lib/mission/file/recorded_mission.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace shoal::recorded_mission_test {

namespace fs = std::filesystem;

/// The folder of a recording, which goes with the test.
class RecordedMissionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  RecordedMission Find() const { return FindMissionBeside(Path("mission.lcm")); }

 private:
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     (std::string("shoal_recorded_mission_") +
                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

constexpr const char* kMissionText = "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n";

TEST_F(RecordedMissionTest, IsNoneWhereThereIsNoFile) {
  const RecordedMission found = Find();
  EXPECT_FALSE(found.mission);
  EXPECT_TRUE(found.errors.empty());
}

TEST_F(RecordedMissionTest, TakesTheOverridesAndTheNameThatTheRunHad) {
  Write("mission.toml", kMissionText);
  Write("run.txt",
        "shoal_version 1\nmission_file /a/harbour.toml\nseed 3\nset mission.seed=3\nwarp max\n");
  const RecordedMission found = Find();
  ASSERT_TRUE(found.mission);
  EXPECT_EQ(found.mission->seed, 3U);
  EXPECT_EQ(found.mission->name, "harbour");
}

TEST_F(RecordedMissionTest, KeepsTheNameThatTheFileGives) {
  std::string text = kMissionText;
  text.insert(text.find("duration_s"), "name = \"regatta\"\n");
  Write("mission.toml", text);
  Write("run.txt", "mission_file /a/harbour.toml\n");
  EXPECT_EQ(Find().mission->name, "regatta");
}

TEST_F(RecordedMissionTest, StatesWhyItDoesNotLoad) {
  Write("mission.toml", "[mission]\nduration_s = -1\n[[vehicle]]\nname = \"alpha\"\n");
  const RecordedMission found = Find();
  EXPECT_FALSE(found.mission);
  ASSERT_FALSE(found.errors.empty());
  EXPECT_NE(found.errors[0].find("mission.toml:2"), std::string::npos);
}

TEST_F(RecordedMissionTest, RefusesARunTextThatNoRecordingHolds) {
  Write("mission.toml", kMissionText);
  const std::string path = Path("run.txt");
  const auto expect_refused = [&](const std::string& why) {
    const RecordedMission found = Find();
    EXPECT_FALSE(found.mission);
    EXPECT_EQ(found.errors, std::vector<std::string>{path + ": " + why});
    fs::remove(path);
  };
  Write("run.txt", std::string((size_t{4} << 20) + 1, 'x'));
  expect_refused("is larger than 4194304 bytes");
  fs::create_symlink("nothing", path);
  expect_refused("cannot be read: No such file or directory");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  expect_refused("is not a regular file");
  fs::create_symlink("/dev/zero", path);
  expect_refused("is not a regular file");
}

}  // namespace shoal::recorded_mission_test

#include "lib/mission/recorded_mission.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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
  RecordedMission Find() const { return FindMissionBeside((folder_ / "mission.lcm").string()); }

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

}  // namespace shoal::recorded_mission_test

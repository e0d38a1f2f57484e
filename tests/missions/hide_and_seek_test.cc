// Two groups, a referee in C, and every rule of the broker at work.
#include <gtest/gtest.h>

#include "tests/missions/shoal_process.h"

namespace shoal::hide_and_seek_test {

/// Returns the log of the mission, run with `extra` options.
std::string Log(const TestFolder& folder, const std::vector<std::string>& extra) {
  const std::string dir = (folder / "recorded").string();
  std::filesystem::remove_all(dir);
  std::vector<std::string> arguments = {"run", MissionFile("hide_and_seek.toml"), "--quiet",
                                        "--record", dir};
  arguments.insert(arguments.end(), extra.begin(), extra.end());
  const Finished finished = RunShoal(folder, arguments);
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  return ReadFile(dir + "/mission.lcm");
}

TEST(HideAndSeek, IsTheSameInBothLayoutsAndOnALossyBus) {
  const TestFolder folder;
  const std::string reference = Log(folder, {"--warp", "max"});
  ASSERT_GT(reference.size(), 1'000'000U);
  EXPECT_TRUE(reference ==
              Log(folder, {"--warp", "max", "--layout", "communities", "--lose", "0.0005"}));
}

TEST(HideAndSeek, FailsWhereTheRefereeRewardsNoPlayer) {
  const TestFolder folder;
  const Finished finished = RunShoal(
      folder, {"run", MissionFile("hide_and_seek.toml"), "--quiet", "--warp", "max", "--set",
               "participant.1.command=[\"referee\", \"hiders\", \"0\", \"0.4\"]"});
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find("FAIL at least 300 and at most 400 reports out_of_range from "
                                 "hider_2 to hider_3: 0, 300 too few"),
            std::string::npos)
      << finished.output;
}

TEST(HideAndSeek, IsRefusedByShoalSimWhichHasNoReferee) {
  const TestFolder folder;
  const Finished finished = RunShoal(folder, {"sim", MissionFile("hide_and_seek.toml")});
  EXPECT_EQ(finished.exit_code, 2) << finished.output;
  EXPECT_NE(finished.output.find("referee is not one of shoal's own processes, so the mission "
                                 "needs `shoal run`"),
            std::string::npos)
      << finished.output;
}

}  // namespace shoal::hide_and_seek_test

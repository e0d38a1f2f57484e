// missions/survey.toml: two vessels of a group share an area.
#include <gtest/gtest.h>

#include "tests/missions/shoal_process.h"

namespace shoal::survey_test {

TEST(Survey, IsCoveredByBothTogetherAndByNeitherAlone) {
  const TestFolder folder;
  const std::string mission = MissionFile("survey.toml");
  const Finished both = RunShoal(folder, {"sim", mission});
  EXPECT_EQ(both.exit_code, 0) << both.output;
  EXPECT_NE(both.output.find("pass at least 98 % of the surveyed area covered 20 m wide: "),
            std::string::npos)
      << both.output;
  for (const std::string name : {"alpha", "bravo"}) {
    const Finished one =
        RunShoal(folder, {"sim", mission, "--set", "expect.1.vehicles=[\"" + name + "\"]"});
    EXPECT_EQ(one.exit_code, 1) << one.output;
    EXPECT_NE(one.output.find("FAIL at least 98 % of the surveyed area covered 20 m wide by " +
                              name + ": "),
              std::string::npos)
        << one.output;
  }
}

TEST(Survey, IsTheSameInProcessesOfItsOwn) {
  const TestFolder folder;
  const std::string mission = MissionFile("survey.toml");
  const std::string log = (folder / "sim.lcm").string();
  const std::vector<std::string> shorter = {"--set", "mission.duration_s=60"};
  RunShoal(folder, {"sim", mission, "--log", log, shorter[0], shorter[1]});
  const std::string dir = (folder / "recorded").string();
  RunShoal(folder,
           {"run", mission, "--quiet", "--warp", "max", "--record", dir, shorter[0], shorter[1]});
  const std::string recorded = ReadFile(dir + "/mission.lcm");
  EXPECT_GT(recorded.size(), 100'000U);
  EXPECT_TRUE(ReadFile(log) == recorded);
}

}  // namespace shoal::survey_test

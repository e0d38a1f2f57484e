// A mission by several ranks that Slurm starts. Skipped where Slurm or MPI is not installed.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/campaigns/slurm_of_one_box.h"
#include "tests/missions/shoal_process.h"

namespace shoal::mpi_slurm_test {

TEST(MpiUnderSlurm, RunsByOneStepOfTwoTasks) {
  if (!IsInstalled("srun") || !IsInstalled("slurmctld") || !IsInstalled("slurmd")) {
    GTEST_SKIP() << "no Slurm: scripts/setup --with-tests installs it";
  }
  if (!std::filesystem::exists(Program("shoal-mpi"))) {
    GTEST_SKIP() << "no MPI: scripts/setup --with-tests installs it";
  }
  const TestFolder folder;
  const SlurmOfOneBox slurm(folder);
  if (!slurm.is_up()) {
    GTEST_SKIP() << "this machine cannot start Slurm: "
                 << ReadFile(folder.path() / "slurm" / "log" / "ctld.log");
  }
  const std::vector<std::string> mission = {MissionFile("acoustic_shared.toml"), "--set",
                                            "mission.duration_s=60", "--log"};
  std::vector<std::string> one = {"sim"};
  one.insert(one.end(), mission.begin(), mission.end());
  one.push_back((folder / "one.lcm").string());
  ASSERT_EQ(RunShoal(folder, one).exit_code, 1);  // Too short for what berta expects.
  std::vector<std::string> two = {"/usr/bin/env",      "srun", "-n", "2", "--mpi=pmix",
                                  Program("shoal-mpi")};
  two.insert(two.end(), mission.begin(), mission.end());
  two.push_back((folder / "two.lcm").string());
  const Finished finished = RunningProcess(folder, two).Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find(", 2 ranks"), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(folder / "one.lcm") == ReadFile(folder / "two.lcm"));
}

}  // namespace shoal::mpi_slurm_test

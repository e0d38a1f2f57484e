// Missions by several ranks under mpirun, as a user runs them.
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>

#include "lib/bus/record/log_reader.h"
#include "tests/campaigns/slurm_of_one_box.h"
#include "tests/missions/shoal_process.h"

namespace shoal::mpi_test {

/// Three vessels on parallel courses, 400 steps, with something to expect.
constexpr char kThreeVessels[] = R"([mission]
duration_s = 40
[template.boat]
helm_options = {deploy_at_start = true}
[[template.boat.task]]
name = "go"
kind = "waypoints"
points = [[400, 0]]
points_frame = "start"
speed_mps = 2
[[fleet]]
template = "boat"
count = 3
name = "boat_{n}"
spacing_m = 40
[[expect]]
kind = "reports"
from = "boat_1"
to = "boat_2"
at_least = 10
)";

/// Runs what needs mpirun. MPI is an option of the build: without it shoal-mpi is not built, and
/// there is nothing to test. The skip is shown by ctest; scripts/setup --with-tests installs MPI.
class Mpi : public testing::Test {
 protected:
  void SetUp() override {
    if (!IsInstalled("mpirun") || !std::filesystem::exists(Program("shoal-mpi"))) {
      GTEST_SKIP() << "no MPI: scripts/setup --with-tests installs it";
    }
    WriteFile(folder_ / "three.toml", kThreeVessels);
    // Open MPI leaves memory behind when it ends.
    setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
  }

  /// Returns the command line of `num_ranks` ranks, however few the cores are.
  static std::vector<std::string> Command(int num_ranks,
                                          const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {"/usr/bin/env",        "mpirun", "--oversubscribe",
                                        "--allow-run-as-root", "-n",     std::to_string(num_ranks),
                                        Program("shoal-mpi")};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return command;
  }

  Finished Run(int num_ranks, const std::vector<std::string>& arguments) const {
    return RunningProcess(folder_, Command(num_ranks, arguments)).Wait();
  }

  /// Expects that ranks write the log, the page and the exit code of `shoal sim`.
  void ExpectAsInOneProcess(const std::string& mission, std::vector<std::string> extra,
                            const std::vector<int>& nums_of_ranks) const {
    const auto with_log = [&](const std::string& name) {
      std::vector<std::string> arguments = {mission, "--log", (folder_ / name).string()};
      arguments.insert(arguments.end(), extra.begin(), extra.end());
      return arguments;
    };
    std::vector<std::string> arguments = with_log("one.lcm");
    arguments.insert(arguments.begin(), "sim");
    const Finished one = RunShoal(folder_, arguments);
    const std::string log = ReadFile(folder_ / "one.lcm");
    ASSERT_GT(log.size(), 10'000U) << one.output;
    for (const int num_ranks : nums_of_ranks) {
      const Finished ranks = Run(num_ranks, with_log("ranks.lcm"));
      EXPECT_EQ(ranks.exit_code, one.exit_code) << ranks.output;
      EXPECT_TRUE(ReadFile(folder_ / "ranks.lcm") == log) << mission << ", ranks: " << num_ranks;
      const std::string page = one.output.substr(one.output.find("\n\n"));
      EXPECT_NE(ranks.output.find(page), std::string::npos) << ranks.output;
    }
  }

  std::string Own() const { return (folder_ / "three.toml").string(); }
  /// A mission that goes on until something happens to it.
  std::vector<std::string> Endless() const {
    return {Own(), "--set", "mission.duration_s=10000000", "--log",
            (folder_ / "endless.lcm").string()};
  }
  bool AwaitLog(uintmax_t size) const {
    return AwaitThat([&] {
      std::error_code error;
      const auto found = std::filesystem::file_size(folder_ / "endless.lcm", error);
      return !error && found > size;
    });
  }

  const TestFolder folder_;
};

/// Returns the process of a rank that the first lines name.
pid_t ProcessOf(const RunningProcess& job, int rank) {
  const std::string begin = "rank " + std::to_string(rank) + " (host ";
  if (!job.WaitFor(begin)) return -1;
  const std::string output = job.Output();
  const size_t at = output.find("process ", output.find(begin));
  return static_cast<pid_t>(std::stol(output.substr(at + 8)));
}

TEST_F(Mpi, WritesTheLogAndThePageOfOneProcessForAnyNumberOfRanks) {
  ExpectAsInOneProcess(Own(), {}, {1, 2, 3, 4});
}

TEST_F(Mpi, WritesTheChosenChannels) {
  ExpectAsInOneProcess(Own(), {"--channels", "NAV_*", "--without", "NAV_BOAT_1"}, {2});
  EXPECT_EQ(ReadFile(folder_ / "one.lcm").find("NAV_BOAT_1"), std::string::npos);
  const Finished mistyped =
      Run(2, {Own(), "--log", (folder_ / "two.lcm").string(), "--channels", "NAVY_*"});
  EXPECT_EQ(mistyped.exit_code, 0) << mistyped.output;
  EXPECT_NE(mistyped.output.find("--channels 'NAVY_*' matches none of shoal's channels"),
            std::string::npos)
      << mistyped.output;
  const Finished without_log = Run(1, {Own(), "--channels", "NAV_*"});
  EXPECT_EQ(without_log.exit_code, 2) << without_log.output;
}

TEST_F(Mpi, WritesTheLogOfAcousticNetworks) {
  ExpectAsInOneProcess(MissionFile("acoustic_shared.toml"), {"--set", "mission.duration_s=60"},
                       {2, 3});
}

TEST_F(Mpi, WritesTheLogOfASwarm) {
  ExpectAsInOneProcess(MissionFile("swarm20.toml"),
                       {"--set", "mission.duration_s=60", "--set", "expect.2.from_s=0"}, {2, 4});
}

TEST_F(Mpi, WritesTheLogOfAFleetWhoseReportsSeveralRanksRoute) {
  std::string text = kThreeVessels;
  const std::string count = "count = 3";
  text.replace(text.find(count), count.size(), "count = 200");
  WriteFile(folder_ / "fleet.toml", "[comms]\ncomms_range = 130\neach_fate_up_to = 100\n" + text);
  const std::string fleet = (folder_ / "fleet.toml").string();
  ExpectAsInOneProcess(fleet, {}, {2, 3});
  const Finished ranks = Run(2, {fleet});
  EXPECT_NE(ranks.output.find("vehicles, verdict, part of the broker"), std::string::npos)
      << ranks.output;
  EXPECT_NE(ranks.output.find("vehicles, part of the broker"), std::string::npos) << ranks.output;
}

TEST_F(Mpi, WritesTheLogOfRecordedTracks) {
  ExpectAsInOneProcess(MissionFile("track_replay.toml"), {}, {2, 3});
}

TEST_F(Mpi, DrawsOneSeedForAllRanks) {
  const Finished ranks =
      Run(3, {Own(), "--set", "mission.seed=random", "--log", (folder_ / "ranks.lcm").string()});
  const size_t drawn = ranks.output.find("Drawn: --set mission.seed=");
  ASSERT_NE(drawn, std::string::npos) << ranks.output;
  const size_t begin = ranks.output.find("mission.seed", drawn);
  const std::string seed = ranks.output.substr(begin, ranks.output.find('\n', begin) - begin);
  RunShoal(folder_, {"sim", Own(), "--set", seed, "--log", (folder_ / "one.lcm").string()});
  EXPECT_TRUE(ReadFile(folder_ / "one.lcm") == ReadFile(folder_ / "ranks.lcm")) << seed;
}

TEST_F(Mpi, EndsWith3AndNamesARankThatDies) {
  RunningProcess job(folder_, Command(3, Endless()));
  const pid_t process = ProcessOf(job, 1);
  ASSERT_GT(process, 0) << job.Output();
  ASSERT_TRUE(AwaitLog(200'000)) << job.Output();
  kill(process, SIGKILL);
  const Finished finished = job.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("LOST: rank 1 (host "), std::string::npos) << finished.output;

  // All that is in the log is whole, and as in one process.
  Result<LogReader> reader = LogReader::Open((folder_ / "endless.lcm").string());
  ASSERT_TRUE(reader.ok());
  int64_t last_utime = 0;
  while (const auto event = reader->Next()) last_utime = event->utime;
  EXPECT_EQ(reader->error(), "");
  const std::string duration = "mission.duration_s=" + std::to_string(last_utime / 1'000'000 + 2);
  RunShoal(folder_, {"sim", Own(), "--set", duration, "--log", (folder_ / "one.lcm").string()});
  EXPECT_GT(last_utime, 1'000'000);
  EXPECT_TRUE(ReadFile(folder_ / "one.lcm").starts_with(ReadFile(folder_ / "endless.lcm")));
}

TEST_F(Mpi, NamesARankThatHangsAndGivesItUpAfterTheTimeout) {
  std::vector<std::string> arguments = Endless();
  arguments.insert(arguments.end(), {"--timeout", "5"});
  RunningProcess job(folder_, Command(3, arguments));
  const pid_t process = ProcessOf(job, 2);
  ASSERT_GT(process, 0) << job.Output();
  ASSERT_TRUE(AwaitLog(100'000)) << job.Output();
  kill(process, SIGSTOP);
  EXPECT_TRUE(job.WaitFor("s without an answer of rank 2 (host ")) << job.Output();
  const Finished finished = job.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("LOST: rank 2 (host "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("holds the mission up to step "), std::string::npos)
      << finished.output;
  Result<LogReader> reader = LogReader::Open((folder_ / "endless.lcm").string());
  ASSERT_TRUE(reader.ok());
  while (reader->Next()) {
  }
  EXPECT_EQ(reader->error(), "");
}

TEST_F(Mpi, RefusesWhatItCannotRunAndNamesIt) {
  const Finished program = Run(2, {MissionFile("hide_and_seek.toml")});
  EXPECT_EQ(program.exit_code, 2) << program.output;
  EXPECT_NE(program.output.find("referee is not one of shoal's own processes"), std::string::npos)
      << program.output;
  const Finished place = Run(2, {Own(), "--place", "1=nemo"});
  EXPECT_EQ(place.exit_code, 2) << place.output;
  EXPECT_NE(place.output.find("there is no vehicle 'nemo'"), std::string::npos) << place.output;
}

}  // namespace shoal::mpi_test

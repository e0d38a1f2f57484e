// What a user reads where a mission cannot start, or loses what it needs: one cause.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::failed_start_test {

constexpr char kOneVessel[] = R"(
[mission]
duration_s = 60
[[vehicle]]
name = "alpha"
)";

int CountOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Start, OfAProgramThatIsMissingStartsNothingAndNamesItOnce) {
  const TestFolder folder;
  const std::string file = (folder / "m.toml").string();
  WriteFile(file, std::string(kOneVessel) +
                      "[[participant]]\nname = \"planner\"\ncommand = [\"./no_such_program\"]\n");
  const std::string dir = (folder / "rec").string();
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"run", file, "--record", dir}, {"check", file}}) {
    const Finished finished = RunShoal(folder, command);
    EXPECT_EQ(finished.exit_code, 3) << finished.output;
    EXPECT_EQ(CountOf(finished.output, "planner: cannot find the program './no_such_program'"), 1)
        << finished.output;
    EXPECT_EQ(CountOf(finished.output, "correct the command of [[participant]] planner in " + file),
              1)
        << finished.output;
    EXPECT_EQ(CountOf(finished.output, "LOST"), 0) << finished.output;
    EXPECT_EQ(CountOf(finished.output, ": ok"), 0) << finished.output;
  }
  EXPECT_FALSE(std::filesystem::exists(dir)) << "the next run may record there";
}

TEST(Start, OfAFileThatIsNoProgramStatesWhatItLacks) {
  const TestFolder folder;
  const std::string file = (folder / "m.toml").string();
  const std::string script = (folder / "planner.py").string();
  WriteFile(file, std::string(kOneVessel) + "[[participant]]\nname = \"planner\"\ncommand = [\"" +
                      script + "\"]\n");
  WriteFile(script, "#!/no/such/interpreter\n");
  const Finished not_executable = RunShoal(folder, {"check", file});
  EXPECT_EQ(not_executable.exit_code, 3) << not_executable.output;
  EXPECT_EQ(CountOf(not_executable.output, script + " is not executable: `chmod +x` it"), 1)
      << not_executable.output;
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const Finished no_interpreter = RunShoal(folder, {"run", file});
  EXPECT_EQ(no_interpreter.exit_code, 3) << no_interpreter.output;
  EXPECT_EQ(CountOf(no_interpreter.output, "cannot execute " + script +
                                               ": the interpreter that its first line names is "
                                               "missing"),
            1)
      << no_interpreter.output;
}

TEST(Start, ThatFailsNamesItsCauseAndNotWhatShoalEnded) {
  const TestFolder folder;
  const std::string file = (folder / "m.toml").string();
  WriteFile(file, std::string(kOneVessel) +
                      "[[participant]]\nname = \"planner\"\ncommand = [\"/bin/sh\", \"-c\", "
                      "\"echo the chart is missing; exit 7\"]\n"
                      "[[participant]]\nname = \"idle\"\ncommand = [\"sleep\", \"100\"]\n");
  const Finished finished = RunShoal(folder, {"run", file});
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "LOST: planner"), 1) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "LOST"), 1) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "    the chart is missing"), 1) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "\n"), 4) << finished.output;
}

TEST(Ports, ThatAnotherProcessHasClaimedAreNamedWithTheRemedy) {
  const TestFolder folder;
  const Result<int> base = ClaimPorts(0, 3);  // By this process; no socket is bound to them yet.
  ASSERT_TRUE(base.ok()) << base.error();
  const Finished finished =
      RunShoal(folder, {"run", MissionFile("alpha.toml"), "--port", std::to_string(*base)});
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "another process has claimed some of the UDP ports " +
                                         std::to_string(*base) + " to "),
            1)
      << finished.output;
  EXPECT_EQ(CountOf(finished.output, "choose others with --port, or leave it out"), 1)
      << finished.output;
}

/// True where this user can make a network of its own, for a test without one.
bool CanBeWithoutNetwork(const TestFolder& folder) {
  return RunningProcess(folder, {"/usr/bin/unshare", "-rn", "/bin/true"}).Wait().exit_code == 0;
}

TEST(Network, ThatIsMissingIsTheOnlyThingThatIsReported) {
  const TestFolder folder;
  if (!CanBeWithoutNetwork(folder))
    GTEST_SKIP() << "this machine cannot give this user a network namespace (unshare -rn)";
  RunningProcess process(
      folder, {"/usr/bin/unshare", "-rn", Program("shoal"), "run", MissionFile("alpha.toml")});
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_TRUE(finished.output.starts_with("shoal: multicast does not work on this machine"))
      << finished.output;
  EXPECT_NE(finished.output.find("sudo ip route add 224.0.0.0/4 dev lo"), std::string::npos);
  EXPECT_EQ(CountOf(finished.output, "\n"), 2) << finished.output;
}

TEST(Network, ThatFailsDuringAMissionIsNamedFirstAndLast) {
  const TestFolder folder;
  if (!CanBeWithoutNetwork(folder))
    GTEST_SKIP() << "this machine cannot give this user a network namespace (unshare -rn)";
  const std::string script = "ip link set lo up multicast on; ip route add 224.0.0.0/4 dev lo; " +
                             Program("shoal") + " run " + MissionFile("berta.toml") +
                             " --set mission.participant_timeout_s=2 & " + "while ! test -e " +
                             (folder / "fail").string() + "; do sleep 0.05; done; " +
                             "ip route del 224.0.0.0/4 dev lo; wait $!";
  RunningProcess process(folder, {"/usr/bin/unshare", "-rn", "/bin/sh", "-c", script});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  WriteFile(folder / "fail", "");
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "LOST"), 0) << finished.output;
  EXPECT_EQ(CountOf(finished.output, "multicast does not work on this machine"), 2)
      << finished.output;
  EXPECT_EQ(CountOf(finished.output, "after the end"), 0)
      << "processes that shoal itself killed: " << finished.output;
  const size_t last = finished.output.rfind("Cause: multicast does not work");
  ASSERT_NE(last, std::string::npos) << finished.output;
  EXPECT_EQ(CountOf(finished.output.substr(last), "\n"), 2) << finished.output;
}

}  // namespace shoal::failed_start_test

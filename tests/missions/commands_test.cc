// The launcher and its tools as a user runs them in a shell.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <utility>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::commands_test {

constexpr char kOneVessel[] = R"(
[mission]
duration_s = 60
[[vehicle]]
name = "alpha"
start = { x_m = 0, y_m = 0, heading_deg = 0 }
)";

TEST(Send, ReachesAVehicleAndShowsWhatItDoes) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("berta.toml")});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  const Finished sent = RunShoal(folder, {"send", "alpha", "goto", "10", "-20"});
  EXPECT_EQ(sent.exit_code, 0) << sent.output;
  EXPECT_NE(sent.output.find("alpha: DRIVE goto"), std::string::npos) << sent.output;
  const Finished rule = RunShoal(folder, {"send", "comms_range", "nolimit"});
  EXPECT_EQ(rule.exit_code, 0) << rule.output;
  const std::string page = AwaitStatus(folder, "shore_broker", {"Comms Range: nolimit"});
  EXPECT_NE(page.find("Comms Range: nolimit"), std::string::npos) << page;

  const Finished refused = RunShoal(folder, {"send", "alpha", "speed", "-1"});
  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_NE(refused.output.find("alpha refused: speed"), std::string::npos) << refused.output;
  EXPECT_EQ(RunShoal(folder, {"send", "alhpa", "return"}).exit_code, 2);
  const Finished unknown = RunShoal(folder, {"send", "alpha", "fly"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.output.find("unknown command 'fly'"), std::string::npos) << unknown.output;
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_NE(finished.output.find("Reproducible: no"), std::string::npos) << finished.output;
}

TEST(Send, StatesThatAVehicleHasNoHelm) {
  const TestFolder folder;
  const std::string file = (folder / "m.toml").string();
  WriteFile(file,
            "[mission]\nduration_s = 600\n[[vehicle]]\nname = \"alpha\"\n"
            "[[vehicle]]\nname = \"bravo\"\nhelm = \"none\"\n");
  const RunningProcess process(folder, {Program("shoal"), "run", file, "--quiet"});
  AwaitStatus(folder, "helm_alpha", {"State: PARK"});
  const Finished alone = RunShoal(folder, {"send", "bravo", "deploy"});
  EXPECT_EQ(alone.exit_code, 2) << alone.output;
  EXPECT_NE(alone.output.find("bravo has no helm (helm = \"none\")"), std::string::npos)
      << alone.output;
  EXPECT_EQ(alone.output.find("helms have published"), std::string::npos) << alone.output;
  const Finished all = RunShoal(folder, {"send", "all", "deploy"});
  EXPECT_EQ(all.exit_code, 0) << all.output;
  EXPECT_NE(all.output.find("alpha: DRIVE"), std::string::npos) << all.output;
  EXPECT_NE(all.output.find("bravo has no helm"), std::string::npos) << all.output;
}

TEST(Send, ChangesRulesAndSendsMessages) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("berta.toml")});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  const Finished rule = RunShoal(folder, {"send", "stealth", "alpha", "0.5"});
  EXPECT_EQ(rule.exit_code, 0) << rule.output;
  EXPECT_NE(rule.output.find("sent UNC_STEALTH of alpha = 0.5"), std::string::npos) << rule.output;
  AwaitStatus(folder, "shore_broker", {"Known Vehicles: 2"});
  const Finished message = RunShoal(
      folder, {"send", "alpha", "message", "bravo", "MAX_SPEED", "-2.5", "--double", "--ack"});
  EXPECT_EQ(message.exit_code, 0) << message.output;
  const std::string broker = AwaitStatus(folder, "shore_broker", {"ALPHA: stealth 0.5, earange 1"});
  EXPECT_NE(broker.find("ALPHA: stealth 0.5, earange 1"), std::string::npos) << broker;
  const std::string reporter =
      AwaitStatus(folder, "node_reporter_alpha", {"(MAX_SPEED) is acknowledged"});
  EXPECT_NE(reporter.find("(MAX_SPEED) is acknowledged"), std::string::npos) << reporter;

  const Finished impossible = RunShoal(folder, {"send", "stealth", "alpha", "1.5"});
  EXPECT_EQ(impossible.exit_code, 2) << impossible.output;
  EXPECT_NE(impossible.output.find("stealth VEHICLE 0.5 (0 to 1)"), std::string::npos);
  EXPECT_EQ(RunShoal(folder, {"send", "stealth", "0.5"}).exit_code, 2);
  EXPECT_EQ(RunShoal(folder, {"send", "alpha", "message", "bravo", "MAX_SPEED"}).exit_code, 2);
  const Finished unknown = RunShoal(folder, {"send", "comms_rnage", "5"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.output.find("did you mean 'comms_range'?"), std::string::npos)
      << unknown.output;
}

TEST(Status, ListsEveryParticipantAndShowsItsPage) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("berta.toml")});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  const Finished list = RunShoal(folder, {"status"});
  EXPECT_EQ(list.exit_code, 0) << list.output;
  for (const char* name : {"helm_alpha", "helm_bravo", "node_reporter_alpha", "shoal",
                           "shore_broker", "vehicle_sim_bravo"}) {
    EXPECT_NE(list.output.find(name), std::string::npos) << name << "\n" << list.output;
  }
  const Finished page = RunShoal(folder, {"status", "vehicle_sim_alpha"});
  EXPECT_NE(page.output.find("Position:"), std::string::npos) << page.output;
  const Finished url = RunShoal(folder, {"url", "alpha"});
  EXPECT_EQ(url.output.rfind("udpm://239.255.76.67:", 0), 0U) << url.output;
}

TEST(Status, StatesThatNothingRuns) {
  const TestFolder folder;
  const Finished finished = RunShoal(folder, {"status"});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_NE(finished.output.find("no mission is running"), std::string::npos) << finished.output;
}

TEST(RunFolder, ThatAnotherUserCouldHavePreparedIsNotUsed) {
  const TestFolder folder;
  const std::string file = (folder / "one.toml").string();
  WriteFile(file, kOneVessel);
  WriteFile(folder / "victim", "precious");
  std::filesystem::create_directory(folder / "run");
  std::filesystem::permissions(folder / "run", std::filesystem::perms::all);
  std::filesystem::create_symlink(folder / "victim", folder / "run/24140.run.new");
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"run", file, "--warp", "max", "--port", "24140"},
                                             {"status"},
                                             {"send", "all", "stop"}}) {
    const Finished finished = RunShoal(folder, command);
    EXPECT_EQ(finished.exit_code, 3) << finished.output;
    EXPECT_NE(finished.output.find("SHOAL_RUN_DIR=~/.shoal"), std::string::npos) << finished.output;
  }
  EXPECT_EQ(ReadFile(folder / "victim"), "precious");
}

TEST(Command, GoesToNoMissionThatAnotherFolderHasStartedUnlessItsPortIsNamed) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("berta.toml")});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  const auto elsewhere = [&](const std::string& arguments) {
    return RunningProcess(folder, {"/bin/sh", "-c", "cd / && " + Program("shoal") + arguments})
        .Wait();
  };
  for (const char* command : {" send alpha return", " message --from alpha --to bravo A b"}) {
    const Finished refused = elsewhere(command);
    EXPECT_EQ(refused.exit_code, 3) << refused.output;
    EXPECT_NE(refused.output.find("name its port:\n  --port "), std::string::npos)
        << refused.output;
  }
  const Finished status = elsewhere(" status shore_broker");
  EXPECT_EQ(status.exit_code, 0) << status.output;
  const std::string chosen = "berta (" + MissionFile("berta.toml") + "), ports from ";
  EXPECT_NE(status.output.find(chosen), std::string::npos) << status.output;
  const size_t port = status.output.find(chosen) + chosen.size();
  const std::string option =
      " send --port " + status.output.substr(port, status.output.find(',', port) - port);
  const Finished named = elsewhere(option + " alpha return");
  EXPECT_EQ(named.exit_code, 0) << named.output;
  EXPECT_NE(named.output.find(chosen), std::string::npos) << named.output;
}

TEST(MissionFile, WithErrorsIsRefusedByRunSimAndCheckAlike) {
  const TestFolder folder;
  const std::string file = (folder / "bad.toml").string();
  WriteFile(file, "[mission]\nduration_s = 60\nsped = 3\n[[vehicle]]\nname = \"unc\"\n");
  for (const char* command : {"run", "sim", "check"}) {
    const Finished finished = RunShoal(folder, {command, file});
    EXPECT_EQ(finished.exit_code, 2) << finished.output;
    EXPECT_NE(finished.output.find("bad.toml:3:1: unknown key 'sped'"), std::string::npos)
        << finished.output;
    EXPECT_NE(finished.output.find("bad.toml:5:8:"), std::string::npos) << finished.output;
  }
}

TEST(Expectation, ThatIsMissedEndsWithFailAndByHowMuch) {
  const TestFolder folder;
  const std::string file = (folder / "miss.toml").string();
  WriteFile(file, std::string(kOneVessel) +
                      "[[expect]]\nkind = \"arrival\"\nvehicle = \"alpha\"\npoint = [100, 0]\n"
                      "within_m = 5\nby_s = 60\n");
  for (const char* command : {"run", "sim"}) {
    std::vector<std::string> arguments = {command, file};
    if (arguments[0] == "run") arguments.insert(arguments.end(), {"--warp", "max"});
    const Finished finished = RunShoal(folder, arguments);
    EXPECT_EQ(finished.exit_code, 1) << finished.output;
    EXPECT_NE(finished.output.find("FAIL"), std::string::npos) << finished.output;
    EXPECT_NE(finished.output.find("100.0 m"), std::string::npos) << finished.output;
  }
}

TEST(Recording, KeepsWhatIsNeededToRunAgainAndIsNeverOverwritten) {
  const TestFolder folder;
  const std::string file = (folder / "one.toml").string();
  WriteFile(file, kOneVessel);
  const std::string dir = (folder / "rec").string();
  const std::vector<std::string> arguments = {"run",      file, "--warp", "max",
                                              "--record", dir,  "--set",  "mission.seed=9"};
  const Finished first = RunShoal(folder, arguments);
  EXPECT_EQ(first.exit_code, 0) << first.output;
  EXPECT_EQ(ReadFile(dir + "/mission.toml"), kOneVessel);
  EXPECT_NE(ReadFile(dir + "/run.txt").find("seed 9\nset mission.seed=9\n"), std::string::npos);
  EXPECT_NE(ReadFile(dir + "/summary.txt").find("PASS"), std::string::npos);
  const std::string log = ReadFile(dir + "/mission.lcm");
  const Finished second = RunShoal(folder, arguments);
  EXPECT_EQ(second.exit_code, 3) << second.output;
  EXPECT_NE(second.output.find("is not empty"), std::string::npos) << second.output;
  EXPECT_EQ(ReadFile(dir + "/mission.lcm"), log);
}

TEST(Recording, WorksBesideLcmLogger) {
  const TestFolder folder;
  const std::string file = (folder / "one.toml").string();
  WriteFile(file, kOneVessel);
  const std::string dir = (folder / "rec").string();
  const Finished finished =
      RunShoal(folder, {"run", file, "--warp", "60", "--record", dir, "--lcm-logger"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  size_t loggers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) {
    if (!entry.path().filename().string().starts_with("lcm-logger-")) continue;
    ++loggers;
    const Finished info = RunShoal(folder, {"log", "info", entry.path().string()});
    EXPECT_NE(info.output.find("NAV_ALPHA"), std::string::npos) << info.output;
  }
  EXPECT_EQ(loggers, 1U);
}

TEST(Recording, WithoutASummaryDoesNotClaimOne) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  RunningProcess process(folder,
                         {Program("shoal"), "run", MissionFile("berta.toml"), "--record", dir});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  std::filesystem::create_directory(dir + "/summary.txt");  // As good as a full disk.
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("cannot write " + dir + "/summary.txt"), std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("run.txt, logs/"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("\nCause: cannot write "), std::string::npos) << finished.output;
}

TEST(Words, ThatNameNoCommandAreQuotedWithASuggestionAndTheList) {
  const TestFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> kSlips = {
      {{"veiw"},
       "shoal: unknown command 'veiw' (did you mean 'view'?)\nCommands: run, group, sim, "},
      {{"rum", "x.toml"}, "shoal: unknown command 'rum' (did you mean 'run'?)\nCommands: run, "},
      {{"log", "inf"}, "shoal log: unknown command 'inf' (did you mean 'info'?)\nCommands: info, "},
      {{"xyzzy", "--help"}, "shoal: unknown command 'xyzzy'\nCommands: run, group, sim, "}};
  for (const auto& [words, text] : kSlips) {
    const Finished finished = RunShoal(folder, words);
    EXPECT_EQ(finished.exit_code, 2) << finished.output;
    EXPECT_TRUE(finished.output.starts_with(text)) << finished.output;
  }
}

TEST(Words, ThatAreMissingPrintTheList) {
  const TestFolder folder;
  const Finished all = RunShoal(folder, {});
  EXPECT_EQ(all.exit_code, 2);
  for (const char* command : {"run", "sim", "doctor", "message"}) {
    EXPECT_NE(all.output.find("\n  " + std::string(command) + " "), std::string::npos)
        << all.output;
  }
  const Finished log = RunShoal(folder, {"log"});
  EXPECT_EQ(log.exit_code, 2);
  EXPECT_NE(log.output.find("\n  diff "), std::string::npos) << log.output;
}

TEST(Quiet, LeavesTheResultAndOnlyTheProgressOutOfRunAndSim) {
  const TestFolder folder;
  const std::string file = (folder / "one.toml").string();
  WriteFile(file, kOneVessel);
  const Finished run = RunShoal(folder, {"run", file, "--warp", "max", "--quiet"});
  EXPECT_NE(run.output.find("s of mission in"), std::string::npos) << run.output;
  const Finished sim = RunShoal(folder, {"sim", file, "--quiet"});
  EXPECT_NE(sim.output.find("s of mission in"), std::string::npos) << sim.output;
  EXPECT_NE(sim.output.find("PASS"), std::string::npos) << sim.output;
}

TEST(Helm, CanBeStartedByAUser) {
  const TestFolder folder;
  const std::string file = (folder / "hand.toml").string();
  WriteFile(file, std::string(kOneVessel) + "helm = \"hand\"\n");
  RunningProcess mission(folder, {Program("shoal"), "run", file, "--warp", "max"});
  ASSERT_TRUE(mission.WaitFor("waiting for helm_alpha")) << mission.Output();
  RunningProcess helm(folder, {Program("helm"), "--mission", file, "--vehicle", "alpha"});
  const Finished finished = mission.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_EQ(helm.Wait().exit_code, 0);
}

TEST(CPlanner, SteersAVesselAsAParticipantOfItsOwn) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  const Finished finished = RunShoal(folder, {"run", MissionFile("c_planner.toml"), "--warp", "max",
                                              "--record", dir, "--lose", "0.002"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
}

TEST(AcousticPing, SendsAcousticallyFromTwoProgramsInC) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  const Finished finished = RunShoal(folder, {"run", MissionFile("acoustic_ping.toml"), "--warp",
                                              "max", "--record", dir, "--lose", "0.002"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_NE(ReadFile(dir + "/logs/alpha_modem.txt").find("alpha receives pong 7 of bravo"),
            std::string::npos);
}

TEST(Output, ThatCannotBeWrittenIsAnError) {
  const TestFolder folder;
  for (const std::string& command :
       {"check --explain " + MissionFile("alpha.toml"), "sim " + MissionFile("alpha.toml"),
        std::string("--help"), std::string("log --help"), std::string("--version"),
        std::string()}) {
    RunningProcess process(folder,
                           {"/bin/sh", "-c", Program("shoal") + " " + command + " >/dev/full"});
    const Finished finished = process.Wait();
    EXPECT_EQ(finished.exit_code, 3) << finished.output;
    EXPECT_NE(finished.output.find("cannot write to standard output"), std::string::npos);
  }
}

TEST(Log, PlayedBackByLcmLogplayerDrivesAListenerAsTheMissionDid) {
  const TestFolder folder;
  const std::string log = (folder / "sim.lcm").string();
  ASSERT_EQ(RunShoal(folder, {"sim", MissionFile("alpha.toml"), "--log", log}).exit_code, 0);
  const Result<int> base = ClaimPorts(0, 3);
  ASSERT_TRUE(base.ok());
  const PortPlan plan(*base, Layout::kShared, {"alpha"});
  LcmBus listener(plan);
  int64_t received = 0;
  int64_t last_utime = -1;
  bool in_order = true;
  Subscribe(listener, channels::Nav("alpha"), [&](const nav_t& nav) {
    ++received;
    in_order = in_order && nav.utime > last_utime;
    last_utime = nav.utime;
  });
  RunningProcess player(
      folder, {"/usr/bin/lcm-logplayer", "-s", "200", "-l", LcmUrl(plan.shore_port()), log});
  const double begin = WallSeconds();
  while (received < 6001 && WallSeconds() - begin < kPatience_s) listener.Poll(10'000);
  EXPECT_EQ(received, 6001);
  EXPECT_TRUE(in_order);
  EXPECT_EQ(last_utime, 600'000'000);
}

TEST(EveryApp, AnswersHelpVersionExampleAndInterface) {
  const TestFolder folder;
  for (const char* app : {"vehicle_sim", "helm", "node_reporter", "shore_broker", "recorder"}) {
    for (const char* option :
         {"--help", "--version", "--example", "--interface", "-h", "-v", "-e", "-i"}) {
      RunningProcess process(folder, {Program(app), option});
      const Finished finished = process.Wait();
      EXPECT_EQ(finished.exit_code, 0) << app << " " << option;
      EXPECT_GT(finished.output.size(), 10U) << app << " " << option;
    }
    RunningProcess process(folder, {Program(app), "--no-such-option"});
    EXPECT_EQ(process.Wait().exit_code, 2) << app;
  }
}

TEST(Record, TakesTheChannelsThatAreChosen) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  const std::string file = (folder / "m.toml").string();
  WriteFile(file, kOneVessel);
  const Finished run =
      RunShoal(folder, {"run", file, "--warp", "max", "--set", "mission.duration_s=5", "--record",
                        dir, "--channels", "NAV_*", "--channels", "[DH]*", "--without", "DESIRED_*",
                        "--without", "NVA_*"});
  EXPECT_NE(run.output.find("--without 'NVA_*' matches none of shoal's channels"),
            std::string::npos)
      << run.output;
  const Finished info = RunShoal(folder, {"log", "info", dir});
  EXPECT_NE(info.output.find("NAV_ALPHA"), std::string::npos) << info.output;
  EXPECT_NE(info.output.find("HELM_STATE_ALPHA"), std::string::npos) << info.output;
  EXPECT_EQ(info.output.find("ACTUATORS"), std::string::npos) << info.output;
  EXPECT_EQ(info.output.find("DESIRED"), std::string::npos) << info.output;
}

TEST(Record, RefusesChannelsWithoutALog) {
  const TestFolder folder;
  const std::string berta = MissionFile("berta.toml");
  const Finished run = RunShoal(folder, {"run", berta, "--channels", "NAV_*"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.output.find("need --record DIR"), std::string::npos) << run.output;
  const Finished sim = RunShoal(folder, {"sim", berta, "--without", "NAV_*"});
  EXPECT_EQ(sim.exit_code, 2);
  EXPECT_NE(sim.output.find("need --log FILE"), std::string::npos) << sim.output;
  EXPECT_EQ(RunShoal(folder, {"run", berta, "--record", "x", "--plain", "--compress"}).exit_code,
            2);
}

TEST(Record, CompressesALogThatIsExpectedToBeLarge) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  RunningProcess process(
      folder, {Program("shoal"), "run", MissionFile("berta.toml"), "--record", dir, "--set",
               "mission.duration_s=1000000", "--set", "mission.tick_s=0.1"});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_NE(finished.output.find("it is compressed, mission.lcm.zst (--plain: mission.lcm)"),
            std::string::npos)
      << finished.output;
  EXPECT_TRUE(std::filesystem::is_regular_file(dir + "/mission.lcm.zst"));
  EXPECT_EQ(RunShoal(folder, {"log", "info", dir}).exit_code, 0);
}

}  // namespace shoal::commands_test

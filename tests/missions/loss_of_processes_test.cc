// Processes are killed and stopped mid-mission; nothing hangs, no process remains, logs stay
// readable.
#include <gtest/gtest.h>
#include <signal.h>

#include "lib/bus/record/log_reader.h"
#include "tests/missions/fair_stopwatch.h"
#include "tests/missions/shoal_process.h"

namespace shoal::loss_of_processes_test {

/// Starts berta, recorded, and waits until it is well under way. Losses are found by exits, and on
/// no machine by silence, unless a test sets another time-out.
struct Berta {
  explicit Berta(std::vector<std::string> extra = {}, const std::string& file = "berta.toml") {
    std::vector<std::string> argv = {Program("shoal"),
                                     "run",
                                     MissionFile(file),
                                     "--warp",
                                     "20",
                                     "--record",
                                     dir,
                                     "--set",
                                     "mission.participant_timeout_s=60"};
    argv.insert(argv.end(), extra.begin(), extra.end());
    process = std::make_unique<RunningProcess>(folder, argv);
    EXPECT_TRUE(AwaitThat([&] { return NumEvents() >= 200; })) << process->Output();
    participants = process->Participants();
  }
  /// Waits until more is recorded than now: what matters is that, not how quick the machine is.
  bool GoesOn() const {
    const int64_t before = NumEvents();
    return AwaitThat([&] { return NumEvents() > before; });
  }
  /// Returns how many whole events the log holds.
  int64_t NumEvents() const;

  TestFolder folder;
  std::string dir = (folder / "rec").string();
  std::unique_ptr<RunningProcess> process;
  std::map<std::string, pid_t> participants;
};

int64_t Berta::NumEvents() const {
  Result<LogReader> reader = LogReader::Open(dir + "/mission.lcm");
  if (!reader.ok()) return 0;
  int64_t events = 0;
  while (reader->Next()) ++events;
  return reader->error().empty() ? events : -1;
}

const std::vector<std::string> kParticipants = {
    "helm_alpha", "helm_bravo",   "node_reporter_alpha", "node_reporter_bravo",
    "recorder",   "shore_broker", "vehicle_sim_alpha",   "vehicle_sim_bravo"};

class AnyParticipant : public testing::TestWithParam<std::string> {};

TEST_P(AnyParticipant, IsNamedWithinASecondWhenItIsKilledAndTheMissionEnds) {
  Berta berta;
  ASSERT_TRUE(berta.participants.contains(GetParam())) << berta.process->Output();
  const FairStopwatch since_kill;
  kill(berta.participants.at(GetParam()), SIGKILL);
  ASSERT_TRUE(berta.process->WaitFor("LOST: " + GetParam())) << berta.process->Output();
  EXPECT_LT(since_kill.Seconds(), 1.0);
  const Finished finished = berta.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("was killed by signal 9"), std::string::npos) << finished.output;
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200) << "the log must stay readable";
}

INSTANTIATE_TEST_SUITE_P(EachOne, AnyParticipant, testing::ValuesIn(kParticipants),
                         [](const auto& each) { return each.param; });

TEST(StoppedParticipant, IsNamedAfterTheTimeOutAndTheMissionEnds) {
  // The others have this long too; no machine is so busy that they need it.
  constexpr double kTimeOut_s = 3;
  Berta berta({"--set", "mission.participant_timeout_s=3"});
  const FairStopwatch since_stop;
  const double stopped_at = WallSeconds();
  kill(berta.participants.at("helm_bravo"), SIGSTOP);
  ASSERT_TRUE(berta.process->WaitFor("LOST: helm_bravo has not answered"))
      << berta.process->Output();
  EXPECT_LT(since_stop.Seconds(), kTimeOut_s + 1);
  EXPECT_GT(WallSeconds() - stopped_at, kTimeOut_s / 2) << "it has the time-out to answer";
  EXPECT_EQ(berta.process->Wait().exit_code, 3);
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200);
}

TEST(LostParticipant, DoesNotEndAMissionThatShallGoOn) {
  Berta berta({"--set", "mission.on_loss=continue", "--warp", "max"});
  kill(berta.participants.at("node_reporter_bravo"), SIGKILL);
  const Finished finished = berta.process->Wait();
  EXPECT_NE(finished.output.find("the mission goes on without node_reporter_bravo"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: no"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find("INCOMPLETE"), std::string::npos) << finished.output;
  EXPECT_TRUE(AllGone(berta.participants));
}

TEST(LostParticipant, IsStartedAgainWhereTheMissionDemandsIt) {
  Berta berta({"--set", "mission.on_loss=restart"});
  kill(berta.participants.at("shore_broker"), SIGKILL);
  ASSERT_TRUE(berta.process->WaitFor("shore_broker starts again")) << berta.process->Output();
  EXPECT_TRUE(berta.GoesOn()) << "the mission must go on";
  const auto again = berta.process->Participants();
  ASSERT_TRUE(again.contains("shore_broker"));
  EXPECT_NE(again.at("shore_broker"), berta.participants.at("shore_broker"));
  EXPECT_TRUE(berta.GoesOn()) << "and on, with the new one";
  berta.process->Signal(SIGINT);
  berta.process->Wait();
  EXPECT_TRUE(AllGone(again));
}

TEST(LostGroup, IsNamedInOneLineWithItsParticipantsAndTheMissionEnds) {
  Berta berta({"--grouping", "vehicle"});
  ASSERT_EQ(berta.participants.size(), 4U) << berta.process->Output();
  const FairStopwatch since_kill;
  kill(berta.participants.at("group-alpha"), SIGKILL);
  ASSERT_TRUE(berta.process->WaitFor("LOST: group-alpha")) << berta.process->Output();
  EXPECT_LT(since_kill.Seconds(), 1.0);
  const Finished finished = berta.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("was killed by signal 9 (Killed), and with it vehicle_sim_alpha, "
                                 "helm_alpha, node_reporter_alpha\n"),
            std::string::npos)
      << finished.output;
  EXPECT_EQ(finished.output.find("LOST"), finished.output.rfind("LOST")) << finished.output;
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200) << "the log must stay readable";
}

TEST(LostGroup, DoesNotEndAMissionThatShallGoOn) {
  Berta berta({"--grouping", "vehicle", "--set", "mission.on_loss=continue", "--warp", "max"});
  kill(berta.participants.at("group-bravo"), SIGKILL);
  const Finished finished = berta.process->Wait();
  EXPECT_NE(finished.output.find("the mission goes on without group-bravo"), std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: no"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find("INCOMPLETE"), std::string::npos) << finished.output;
  EXPECT_TRUE(AllGone(berta.participants));
}

TEST(LostGroup, IsStartedAgainWhereTheMissionDemandsIt) {
  Berta berta({"--grouping", "host=1", "--set", "mission.on_loss=restart"});
  kill(berta.participants.at("group-1"), SIGKILL);
  ASSERT_TRUE(berta.process->WaitFor("group-1 starts again")) << berta.process->Output();
  EXPECT_TRUE(berta.GoesOn()) << "the mission must go on";
  const auto again = berta.process->Participants();
  ASSERT_TRUE(again.contains("group-1"));
  EXPECT_NE(again.at("group-1"), berta.participants.at("group-1"));
  EXPECT_TRUE(berta.GoesOn()) << "and on, with the new one";
  berta.process->Signal(SIGINT);
  berta.process->Wait();
  EXPECT_TRUE(AllGone(again));
}

TEST(StoppedGroup, IsNamedAfterTheTimeOutAndTheMissionEnds) {
  Berta berta({"--grouping", "vehicle", "--set", "mission.participant_timeout_s=3"});
  kill(berta.participants.at("group-bravo"), SIGSTOP);
  ASSERT_TRUE(berta.process->WaitFor("LOST: group-bravo has not answered"))
      << berta.process->Output();
  EXPECT_EQ(berta.process->Wait().exit_code, 3);
  EXPECT_TRUE(AllGone(berta.participants));
}

TEST(LostHelm, KeepsClearOfOthersAgainWhenItIsStartedAgain) {
  Berta crossing({"--set", "mission.on_loss=restart"}, "encounters/crossing_starboard_45.toml");
  kill(crossing.participants.at("helm_own"), SIGKILL);
  const Finished finished = crossing.process->Wait();
  EXPECT_NE(finished.output.find("helm_own starts again"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("PASS"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.exit_code, 0);
}

TEST(LostRecorder, EndsTheMissionWithAnyOnLossAndKeepsItsLog) {
  Berta berta({"--set", "mission.on_loss=restart"});
  const int64_t before = berta.NumEvents();
  kill(berta.participants.at("recorder"), SIGKILL);
  const Finished finished = berta.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("(cut short)"), std::string::npos) << finished.output;
  EXPECT_GE(berta.NumEvents(), before);
}

TEST(StoppedLauncher, GoesOnWhenItIsContinued) {
  constexpr double kTimeOut_s = 2;
  Berta berta({"--set", "mission.participant_timeout_s=2"});
  berta.process->Signal(SIGSTOP);
  ASSERT_TRUE(IsStopped(berta.process->pid()));
  SleepSeconds(1.5 * kTimeOut_s);  // To stand still for longer than the time-out is the test.
  berta.process->Signal(SIGCONT);
  EXPECT_TRUE(berta.GoesOn()) << berta.process->Output();
  berta.process->Signal(SIGINT);
  EXPECT_EQ(berta.process->Wait().output.find("LOST"), std::string::npos);
}

TEST(CtrlC, EndsEverythingWithinTwoSecondsAndClosesTheRecording) {
  Berta berta;
  const FairStopwatch since_signal;
  berta.process->Signal(SIGINT);
  const Finished finished = berta.process->Wait();
  EXPECT_LT(since_signal.Seconds(), 2.0);
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find("interrupted"), std::string::npos) << finished.output;
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200);
}

TEST(CtrlC, EndsEverythingEvenWhenAParticipantHangs) {
  Berta berta;
  kill(berta.participants.at("helm_alpha"), SIGSTOP);
  ASSERT_TRUE(IsStopped(berta.participants.at("helm_alpha")));
  const FairStopwatch since_signal;
  berta.process->Signal(SIGINT);
  berta.process->Wait();
  EXPECT_LT(since_signal.Seconds(), 2.5);
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200);
}

TEST(KilledLauncher, LeavesNoProcessBehind) {
  Berta berta;
  ASSERT_EQ(berta.participants.size(), kParticipants.size());
  berta.process->Signal(SIGKILL);
  berta.process->Wait();
  EXPECT_TRUE(AllGone(berta.participants));
  EXPECT_GE(berta.NumEvents(), 200);
}

}  // namespace shoal::loss_of_processes_test

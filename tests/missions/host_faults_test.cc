// What goes wrong on the way between home and a host, through the real `shoal run` and `shoal
// host`.
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <cstdlib>
#include <memory>

#include "lib/run/hosts/link_message.h"
#include "tests/missions/delaying_proxy.h"
#include "tests/missions/fair_stopwatch.h"
#include "tests/missions/host_farm.h"
#include "tests/missions/meddler.h"

namespace shoal::host_faults_test {

/// In the midst of a mission of some hundred steps.
constexpr int kChangedBatch = 100;

/// Returns a change of one batch, the hundredth, that sets `is_done`.
Meddler::Change Once(const Meddler::Change& change, std::atomic<bool>* is_done = nullptr) {
  return [change, is_done, number = 0](Bytes batch) mutable {
    if (number++ != kChangedBatch) return std::vector<Bytes>{std::move(batch)};
    if (is_done != nullptr) *is_done = true;
    return change(std::move(batch));
  };
}

Bytes Torn(Bytes batch) {
  batch[batch.size() / 2] ^= 1;
  return batch;
}

struct Fault {
  std::string name;
  std::function<std::vector<Bytes>(Bytes batch)> change;
  std::string refused;  ///< What the end that receives it shows.
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class BertaThroughAMeddler : public testing::Test {
 protected:
  /// Runs 20 s of berta through a meddler; its log must be that of `shoal sim`.
  void Run(const Meddler::Change& to_home, const Meddler::Change& to_host) {
    const Meddler meddler(farm_, to_home, to_host);
    const std::string mission =
        farm_.Placed("berta.toml", {"\"bravo\""}, kPatient, {meddler.address()});
    Shorten(mission, 20);
    const std::string dir = (farm_.folder / "rec").string();
    finished_ = farm_.Run(mission, {"--record", dir});
    EXPECT_NE(finished_.output.find("Reproducible: yes"), std::string::npos) << finished_.output;
    EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == LogOfSim(farm_.folder, mission));
  }

  HostFarm farm_{1};
  Finished finished_;
};

class OneFault : public BertaThroughAMeddler, public testing::WithParamInterface<Fault> {};

/// Counts the batches that begin a step or answer one.
Meddler::Change Counting(LinkKind kind, std::atomic<int>* count) {
  return [kind, count, intake = LinkIntake()](Bytes batch) mutable {
    const Result<LinkMessage> message = intake.Take(batch);
    if (message.ok() && message->kind == kind && message->step >= 0) ++*count;
    return std::vector<Bytes>{std::move(batch)};
  };
}

/// So that a step takes one round trip, however long that is.
TEST_F(BertaThroughAMeddler, NeedsOneBatchPerStepEachWay) {
  std::atomic<int> num_to_host = 0;
  std::atomic<int> num_to_home = 0;
  Run(Counting(LinkKind::kDone, &num_to_home), Counting(LinkKind::kTick, &num_to_host));
  constexpr int kTicks = 201 + 1;  // END is one more.
  EXPECT_EQ(num_to_host, kTicks);
  EXPECT_EQ(num_to_home, kTicks);
}

TEST_P(OneFault, OfAHostIsRefusedNamedAndCountedAndChangesNothing) {
  Run(Once(GetParam().change), {});
  EXPECT_NE(finished_.output.find("host host1 (tcp://127.0.0.1:"), std::string::npos);
  EXPECT_NE(finished_.output.find(" sent " + GetParam().refused), std::string::npos)
      << finished_.output;
  EXPECT_NE(finished_.output.find("; 1 batches refused\n"), std::string::npos) << finished_.output;
}

TEST_P(OneFault, OfHomeIsRefusedAndNamedAndChangesNothing) {
  Run({}, Once(GetParam().change));
  ASSERT_TRUE(farm_.hosts[0].process->WaitFor(" sent " + GetParam().refused))
      << farm_.hosts[0].process->Output();
  EXPECT_NE(finished_.output.find("; 0 batches refused\n"), std::string::npos) << finished_.output;
}

INSTANTIATE_TEST_SUITE_P(
    Links, OneFault,
    testing::Values(Fault{"ABatchThatComesTwice",
                          [](Bytes batch) {
                            return std::vector<Bytes>{batch, batch};
                          },
                          "a replayed batch: number 100, where 101 is next; refused"},
                    Fault{"ATornCopy",
                          [](Bytes batch) {
                            return std::vector<Bytes>{Torn(batch), batch};
                          },
                          "a torn batch: its digest does not fit its bytes; refused"},
                    Fault{"ABatchThatIsTooLarge",
                          [](Bytes batch) {
                            return std::vector<Bytes>{Bytes(kLargestLinkMessage_bytes + 1), batch};
                          },
                          "a batch of 67108865 bytes; the largest has 67108864; refused"}),
    [](const auto& each) { return each.param.name; });

/// Berta with bravo on a host behind a meddler that lets one batch go missing.
struct WithAGap {
  explicit WithAGap(bool is_to_home)
      : under(kPatient, [&](const HostFarm& farm) {
          const auto change = Once(
              [](Bytes batch) { return std::vector<Bytes>{Torn(std::move(batch))}; }, &is_torn);
          meddler = std::make_unique<Meddler>(farm, is_to_home ? change : nullptr,
                                              is_to_home ? nullptr : change);
          return meddler->address();
        }) {}

  std::atomic<bool> is_torn = false;
  std::unique_ptr<Meddler> meddler;
  MissionUnderWay under;
};

/// Waits until the batch is gone, then for `text`; this must come within a second.
void ExpectSoon(const WithAGap& gap, const RunningProcess& process, const std::string& text) {
  ASSERT_TRUE(AwaitThat([&] { return gap.is_torn.load(); }));
  const FairStopwatch since_torn;
  ASSERT_TRUE(process.WaitFor(text)) << process.Output();
  EXPECT_LT(since_torn.Seconds(), 1.0);
}

TEST(LinkWithAGap, OfAHostEndsTheMissionAndNamesTheBatch) {
  WithAGap gap(true);
  ExpectSoon(gap, *gap.under.process, "LOST: host host1");
  const Finished finished = gap.under.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find(" sent a torn batch: its digest does not fit its bytes; refused"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find(" sent batch number 101, where 100 is next: one was lost"),
            std::string::npos)
      << finished.output;
  EXPECT_GE(gap.under.NumEvents(), 200) << "the log must stay whole";
}

TEST(LinkWithAGap, OfHomeEndsTheMissionAndNamesTheBatch) {
  WithAGap gap(false);
  ExpectSoon(gap, *gap.under.process, "LOST: host host1");
  const Finished finished = gap.under.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("ends its part: home sent batch number 101, where 100 is next"),
            std::string::npos)
      << finished.output;
  RunningProcess& host = *gap.under.farm.hosts[0].process;
  ASSERT_TRUE(host.WaitFor("has ended after step")) << host.Output();
  EXPECT_NE(host.Output().find(" sent a torn batch: its digest"), std::string::npos)
      << host.Output();
  EXPECT_GE(gap.under.NumEvents(), 200);
}

TEST(HalfOpenLink, IsNamedWithinASecondByBothEnds) {
  std::unique_ptr<DelayingProxy> proxy;
  // With the time-out of a user who sets none, 0.9 s.
  MissionUnderWay under("", [&](const HostFarm& farm) {
    proxy = std::make_unique<DelayingProxy>(farm.PortOf(0), 0);
    return "tcp://127.0.0.1:" + std::to_string(proxy->port());
  });
  const auto participants = under.farm.hosts[0].process->Participants();
  EXPECT_TRUE(participants.contains("helm_bravo"));
  const FairStopwatch since_stall;
  proxy->Stall();
  ASSERT_TRUE(under.process->WaitFor("gave no sign of life for 0.9 s")) << under.process->Output();
  EXPECT_LT(since_stall.Seconds(), 1.0);
  const Finished finished = under.process->Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_GE(under.NumEvents(), 200);
  RunningProcess& host = *under.farm.hosts[0].process;
  EXPECT_TRUE(host.WaitFor("LOST: home gave no sign of life for 0.9 s")) << host.Output();
  EXPECT_TRUE(AllGone(participants));
}

TEST(SlowHost, IsNamedAndItsAnswerCountsAllTheSame) {
  MissionUnderWay under(kAttentive, {}, {"--grouping", "vehicle"});
  const pid_t group = under.farm.hosts[0].process->Participants().at("group-bravo");
  kill(group, SIGSTOP);
  EXPECT_TRUE(under.process->WaitFor(" has been slow for ")) << under.process->Output();
  kill(group, SIGCONT);
  const int64_t before = under.NumEvents();
  EXPECT_TRUE(AwaitThat([&] { return under.NumEvents() > before + 10; })) << "it goes on";
  under.process->Signal(SIGINT);
  const Finished finished = under.process->Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  const size_t at = finished.output.find(" ms (95 %), ");
  ASSERT_NE(at, std::string::npos) << finished.output;
  EXPECT_GE(std::atof(finished.output.c_str() + at + 12), 1000 * kAttentive_s / 2)
      << finished.output;
}

/// A vessel without simulator on a host, at the pace of the wall's clock; its driver is late in
/// five steps of a hundred, by 0.15 s after the tick of 0.1 s.
TEST(LateHardware, IsCountedInTheSummary) {
  HostFarm farm(1, {"--allow-programs"});
  const std::string mission = farm.Placed(
      "alpha.toml", {"\"alpha\""},
      std::string(kPatient) +
          "participants = [\"driver\"]\n[[participant]]\nname = \"driver\"\ncommand = [\"" +
          Program("late_driver") + "\", \"alpha\", \"20\", \"250\"]\n");
  TakeOutWhatComesLater(mission);
  const Finished finished = farm.Run(mission, {"--warp", "1", "--set", "mission.duration_s=10",
                                               "--set", "vehicle.alpha.vehicle_sim=none"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("Host host1: 101 steps"), std::string::npos) << finished.output;
  const size_t at = finished.output.find("late in ");
  ASSERT_NE(at, std::string::npos) << finished.output;
  int num_late = 0;
  double worst_ms = 0;
  ASSERT_EQ(std::sscanf(finished.output.c_str() + at, "late in %d steps, by %lf ms at worst",
                        &num_late, &worst_ms),
            2)
      << finished.output;
  EXPECT_GE(num_late, 5);
  EXPECT_LT(num_late, 101) << "in the other steps it is in time";
  EXPECT_GE(worst_ms, 150);
}

}  // namespace shoal::host_faults_test

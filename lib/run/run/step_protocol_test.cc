// The clock and participants together: what arrives is complete, in order, and the same whatever
// the network loses on the way.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/network_testing.h"
#include "lib/run/run/step_clock.h"
#include "lib/run/run/step_group.h"

namespace shoal::step_protocol_test {

constexpr int64_t kMissionId = 4711;
constexpr int64_t kLastStep = 40;
const std::vector<std::string> kNames = {"a", "b", "c"};

/// Publishes three messages per step and keeps a transcript of all that it receives.
class ChattyApp : public App {
 public:
  ChattyApp(std::string name, Bus& bus) : name_(std::move(name)), bus_(bus) {
    for (const Channel<unc_control_t>& channel : {First(), Second()}) {
      Subscribe(bus, channel, [this, channel](const unc_control_t& control) {
        transcript +=
            channel.name + ":" + control.vehicle + "=" + std::to_string(control.value) + " ";
      });
    }
  }
  void Tick(int64_t utime) override {
    transcript += "\n" + std::to_string(utime) + " ";
    for (int i = 0; i < 3; ++i) {
      unc_control_t message{};
      message.utime = utime;
      message.vehicle = name_;
      message.value = static_cast<double>(100 * step_ + i);
      Publish(bus_, i % 2 == 0 ? First() : Second(), message);
    }
    ++step_;
  }
  void End() override { transcript += "end"; }
  StatusPage Status() const override { return {}; }

  std::string transcript;

 private:
  static Channel<unc_control_t> First() { return {"FIRST"}; }
  static Channel<unc_control_t> Second() { return {"SECOND"}; }
  std::string name_;
  Bus& bus_;
  int step_ = 0;
};

struct Outcome {
  std::map<std::string, std::string> transcripts;
  RunCounters counters;
  std::string fault;
  std::vector<std::string> silent;
  StepClock::State state = StepClock::State::kGathering;
  int64_t wall_us = 0;
};

/// A process, with one participant or several.
struct Process {
  FakeNetwork::Node* node = nullptr;
  std::unique_ptr<StepGroup> group;
  std::vector<std::unique_ptr<ChattyApp>> apps;
};

Process Start(FakeNetwork& network, const std::vector<std::string>& names, int32_t pid,
              const int64_t& wall_us) {
  Process process{.node = &network.Add(), .group = nullptr, .apps = {}};
  process.group =
      std::make_unique<StepGroup>(StepGroupOptions{.mission_id = kMissionId, .pid = pid},
                                  PortPlan(7665, Layout::kShared, {}), *process.node);
  for (const std::string& name : names) {
    Bus& bus = process.group->Join(name);
    process.apps.push_back(std::make_unique<ChattyApp>(name, bus));
    process.group->Attach(name, process.apps.back().get());
  }
  process.group->Listen();
  process.node->receiver = [&wall_us, group = process.group.get()](
                               int port, std::string_view channel, std::span<const uint8_t> bytes) {
    group->OnDatagram(port, channel, bytes, wall_us);
  };
  return process;
}

ClockOptions Options(double warp = 0) {
  return {.mission_id = kMissionId,
          .warp = warp,
          .tick_us = 100'000,
          .start_utime = 0,
          .last_step = kLastStep,
          .timeout_us = 5'000'000};
}

/// Returns an answer as its participant sends it.
Bytes Sealed(const step_done_t& done) {
  Bytes bytes;
  EncodeInto(done, &bytes);
  AppendSeal({.publisher = done.participant,
              .mission_id = done.mission_id,
              .step = done.step,
              .sequence = 0},
             MissionSecret{}, topics::kStepDone, &bytes);
  return bytes;
}

using Meddle = std::function<void(int64_t, StepClock&, std::vector<Process>&)>;

/// Which participants run in which process.
using Processes = std::vector<std::vector<std::string>>;

/// Runs clock and participants over `network` in invented time.
Outcome RunOver(FakeNetwork& network, double warp = 0, const Meddle& meddle = {},
                const Processes& shares = {{"a"}, {"b"}, {"c"}}) {
  const PortPlan plan(7665, Layout::kShared, {});
  FakeNetwork::Node& clock_node = network.Add();
  StepClock clock(Options(warp), kNames, plan, clock_node);
  int64_t now = 0;
  clock_node.receiver = [&](int port, std::string_view channel, std::span<const uint8_t> bytes) {
    clock.OnDatagram(port, channel, bytes, now);
  };
  std::vector<Process> processes;
  for (const auto& names : shares) processes.push_back(Start(network, names, 1, now));
  Outcome outcome;
  for (; now < 60'000'000 && clock.state() != StepClock::State::kEnded; now += 5'000) {
    for (const Process& process : processes) process.group->OnTime(now);
    clock.OnTime(now);
    network.DeliverAll();
    if (meddle) meddle(now, clock, processes);
    if (!clock.fault().empty() || !clock.Silent(now).empty()) break;
  }
  network.DeliverAll();
  for (size_t i = 0; i < processes.size(); ++i) {
    for (size_t j = 0; j < shares[i].size(); ++j) {
      outcome.transcripts[shares[i][j]] = processes[i].apps[j]->transcript;
    }
  }
  outcome.counters = clock.counters();
  outcome.fault = clock.fault();
  outcome.silent = clock.Silent(now);
  outcome.state = clock.state();
  outcome.wall_us = now;
  return outcome;
}

/// The same apps in one process.
std::map<std::string, std::string> RunInMemory() {
  MemoryBus hub;
  std::vector<std::pair<Bus*, std::unique_ptr<ChattyApp>>> members;
  for (const std::string& name : kNames) {
    Bus& bus = hub.Join(name);
    members.emplace_back(&bus, std::make_unique<ChattyApp>(name, bus));
  }
  for (int64_t step = 0; step <= kLastStep; ++step) {
    hub.NextStep();
    for (auto& [bus, app] : members) {
      hub.Handle(*bus);
      app->Tick(step * 100'000);
    }
  }
  hub.NextStep();
  std::map<std::string, std::string> transcripts;
  for (size_t i = 0; i < members.size(); ++i) {
    hub.Handle(*members[i].first);
    members[i].second->End();
    transcripts[kNames[i]] = members[i].second->transcript;
  }
  return transcripts;
}

TEST(StepProtocol, GivesEveryoneTheSameMessagesAsOneProcessDoes) {
  FakeNetwork network;
  const Outcome outcome = RunOver(network);
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.transcripts, RunInMemory());
  EXPECT_EQ(outcome.counters.messages, 3 * 3 * (kLastStep + 1));
  EXPECT_EQ(outcome.counters.repeated, 0);
}

TEST(StepProtocol, RepairsWhatALossyNetworkTook) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    FakeNetwork network;
    std::mt19937 random(seed);
    network.set_loss([&](std::string_view) { return random() % 4 == 0; });
    const Outcome outcome = RunOver(network);
    EXPECT_EQ(outcome.state, StepClock::State::kEnded);
    EXPECT_EQ(outcome.transcripts, RunInMemory());
    EXPECT_GT(outcome.counters.repeated, 20);
    EXPECT_GT(outcome.counters.ticks_again, 5);
  }
}

TEST(StepProtocol, GivesTheSameMessagesToParticipantsThatShareAProcess) {
  for (const Processes& shares :
       {Processes{{"a", "b"}, {"c"}}, Processes{{"b"}, {"c", "a"}}, Processes{{"c", "b", "a"}}}) {
    FakeNetwork network;
    const Outcome outcome = RunOver(network, 0, {}, shares);
    EXPECT_EQ(outcome.state, StepClock::State::kEnded);
    EXPECT_EQ(outcome.transcripts, RunInMemory());
    EXPECT_EQ(outcome.counters.messages, 3 * 3 * (kLastStep + 1));
    EXPECT_EQ(outcome.counters.repeated, 0);
  }
}

TEST(StepProtocol, RepairsWhatWasLostBetweenProcessesOfSeveralParticipants) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    FakeNetwork network;
    std::mt19937 random(seed);
    network.set_loss([&](std::string_view) { return random() % 4 == 0; });
    const Outcome outcome = RunOver(network, 0, {}, {{"a", "b"}, {"c"}});
    EXPECT_EQ(outcome.state, StepClock::State::kEnded);
    EXPECT_EQ(outcome.transcripts, RunInMemory());
    EXPECT_GT(outcome.counters.repeated, 20);
  }
}

TEST(StepProtocol, AsksForNothingThatAParticipantOfTheSameProcessPublished) {
  FakeNetwork network;
  std::map<std::string, int> num_sent;
  network.set_loss([&](std::string_view channel) {
    ++num_sent[std::string(channel)];
    return channel == "FIRST" || channel == "SECOND";  // Each of them, always.
  });
  const Outcome outcome = RunOver(network, 0, {}, {{"a", "b", "c"}});
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  EXPECT_EQ(outcome.transcripts, RunInMemory());
  EXPECT_EQ(num_sent["FIRST"], 2 * 3 * (kLastStep + 1)) << "it is sent out all the same";
  EXPECT_EQ(num_sent["RESEND"], 0);
}

TEST(StepProtocol, AwaitsAllParticipantsOfAProcessThatIsStartedAgain) {
  FakeNetwork network;
  int64_t wall_us = 0;
  std::optional<Process> second;
  const Outcome outcome =
      RunOver(network, 1.0,
              [&](int64_t now, StepClock& clock, std::vector<Process>& processes) {
                wall_us = now;
                if (second) second->group->OnTime(now);
                if (clock.step() < 10 || second) return;
                processes[0].node->set_stopped(true);
                for (const std::string name : {"a", "b"}) clock.DropExited(name, now);
                second = Start(network, {"a", "b"}, 2, wall_us);
              },
              {{"a", "b"}, {"c"}});
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  ASSERT_TRUE(second);
  // Both see each other's first messages in the same step, and c sees both.
  for (const auto& app : second->apps) EXPECT_TRUE(app->transcript.ends_with("end"));
  EXPECT_EQ(second->apps[0]->transcript, second->apps[1]->transcript);
  const std::string& c = outcome.transcripts.at("c");
  const std::string first_of_both = "FIRST:a=0.000000 FIRST:a=2.000000 FIRST:b=0.000000";
  EXPECT_NE(c.find(first_of_both, c.find(first_of_both) + 1), std::string::npos) << c;
}

TEST(StepProtocol, NamesTheMessagesThatNeverArrive) {
  FakeNetwork network;
  network.set_loss([](std::string_view channel) { return channel == "SECOND"; });
  const Outcome outcome = RunOver(network);
  EXPECT_NE(outcome.fault.find("1 of 1 messages of b on SECOND in step 0 never reached a"),
            std::string::npos)
      << outcome.fault;
}

TEST(StepProtocol, NamesAPublisherOfMoreThanItAnnounced) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t, StepClock& clock, std::vector<Process>& processes) {
        if (clock.step() != 10) return;
        Bytes surplus;
        unc_control_t message{};
        message.vehicle = "a";
        EncodeInto(message, &surplus);
        AppendSeal({.publisher = "a", .mission_id = kMissionId, .step = 10, .sequence = 99},
                   MissionSecret{}, "SECOND", &surplus);
        const int shore = PortPlan(7665, Layout::kShared, {}).shore_port();
        processes[0].node->Send(shore, "SECOND", surplus);
      });
  EXPECT_NE(outcome.fault.find("a published 2 messages on SECOND in step 10 and announced 1"),
            std::string::npos)
      << outcome.fault;
}

TEST(StepProtocol, RefusesAnswersTicksAndRequestsWithoutTheSecret) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t, StepClock& clock, std::vector<Process>& processes) {
        if (clock.step() != 10) return;
        MissionSecret other;
        other.bytes[0] = 1;
        const PortPlan plan(7665, Layout::kShared, {});
        const auto send = [&](const auto& channel, const auto& message, bool is_sealed) {
          Bytes bytes;
          EncodeInto(message, &bytes);
          if (is_sealed) {
            AppendSeal({.publisher = "a", .mission_id = kMissionId, .step = 10, .sequence = 0},
                       other, channel.name, &bytes);
          }
          processes[0].node->Send(plan.PortOf(channel.name), channel.name, bytes);
        };
        step_done_t done{};
        done.mission_id = kMissionId;
        done.participant = "a";
        done.fault = "forged";
        step_dones_t dones{};
        dones.dones = {done};
        dones.num_dones = 1;
        tick_t tick{};
        tick.mission_id = kMissionId;
        tick.step = 1000;
        tick.kind = tick_t::END;
        for (const bool is_sealed : {false, true}) {
          send(channels::StepDone(), done, is_sealed);
          send(channels::Tick(), tick, is_sealed);
          send(channels::StepDones(), dones, is_sealed);
        }
      });
  EXPECT_EQ(outcome.fault, "");
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.transcripts, RunInMemory());
  EXPECT_GT(outcome.counters.refused, 0);
}

TEST(StepProtocol, NamesAParticipantThatDoesNotAnswer) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t, StepClock& clock, std::vector<Process>& processes) {
        processes[1].node->set_stopped(clock.step() >= 10);
      });
  EXPECT_EQ(outcome.silent, std::vector<std::string>{"b"});
  // One second of mission, then the time-out.
  EXPECT_NEAR(static_cast<double>(outcome.wall_us), 6.1e6, 0.2e6);
}

TEST(StepProtocol, GoesOnWithoutAParticipantThatWasDropped) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t now, StepClock& clock, std::vector<Process>& processes) {
        if (clock.step() != 10) return;
        processes[1].node->set_stopped(true);
        clock.Drop("b", now);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_TRUE(outcome.transcripts.at("a").ends_with("end"));
  EXPECT_FALSE(outcome.transcripts.at("b").ends_with("end"));
  EXPECT_EQ(outcome.transcripts.at("a"), outcome.transcripts.at("c"));
}

TEST(StepProtocol, RepairsALostAnswerToTheEnd) {
  FakeNetwork network;
  int num_answers = 0;
  // Each participant answers steps 0 to 40 and then END; the first answers to END are lost.
  network.set_loss([&](std::string_view channel) {
    if (channel != "STEP_DONE") return false;
    ++num_answers;
    return num_answers > 3 * 42 && num_answers <= 3 * 43;
  });
  const Outcome outcome = RunOver(network);
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_GE(outcome.counters.ticks_again, 1);
  EXPECT_EQ(outcome.transcripts, RunInMemory());
}

TEST(StepProtocol, LetsOneComeBackThatWasDropped) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t now, StepClock& clock, std::vector<Process>& processes) {
        if (clock.step() == 10) {
          processes[1].node->set_stopped(true);
          clock.Drop("b", now);
        }
        if (clock.step() == 20) processes[1].node->set_stopped(false);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  EXPECT_TRUE(outcome.transcripts.at("b").ends_with("end"));
}

TEST(StepProtocol, RefusesReplaysOfAProcessThatHasExited) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t now, StepClock& clock, std::vector<Process>& processes) {
        if (clock.step() < 10) return;
        if (clock.step() == 10) {
          processes[1].node->set_stopped(true);
          clock.DropExited("b", now);
        }
        step_done_t hello{};  // Recorded when the mission began.
        hello.mission_id = kMissionId;
        hello.step = -1;
        hello.participant = "b";
        hello.pid = 1;
        processes[0].node->Send(plan.done_port(), "STEP_DONE", Sealed(hello));
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  EXPECT_EQ(outcome.silent, std::vector<std::string>{});
  EXPECT_GT(outcome.counters.refused, 100);
}

TEST(StepProtocol, LosesNothingThatANewProcessPublishesFirst) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  std::optional<Process> second;
  int64_t wall_us = 0;
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t now, StepClock& clock, std::vector<Process>& processes) {
        wall_us = now;
        if (second) second->group->OnTime(now);
        if (clock.step() < 10 || second) return;
        processes[1].node->set_stopped(true);
        clock.Drop("b", now);
        second = Start(network, {"b"}, 2, wall_us);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->apps[0]->transcript.ends_with("end"));
  const std::string& received = outcome.transcripts.at("a");
  const std::string what_each_publishes_first = "FIRST:b=0.000000";
  const size_t of_first_process = received.find(what_each_publishes_first);
  ASSERT_NE(of_first_process, std::string::npos);
  EXPECT_NE(received.find(what_each_publishes_first, of_first_process + 1), std::string::npos)
      << received;
}

TEST(StepProtocol, RefusesASecondProcessOfTheSameName) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  FakeNetwork::Node& impostor = network.Add();
  impostor.receiver = [](int, std::string_view, std::span<const uint8_t>) {};
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t, StepClock& clock, std::vector<Process>&) {
        step_done_t done{};
        done.mission_id = kMissionId;
        done.step = clock.step();
        done.participant = "b";
        done.pid = 2;
        const Bytes bytes = Sealed(done);
        if (clock.step() == 5) impostor.Send(plan.done_port(), "STEP_DONE", bytes);
      });
  EXPECT_NE(outcome.fault.find("two processes call themselves b (pid 1 and 2)"), std::string::npos)
      << outcome.fault;
}

TEST(StepProtocol, AwaitsAgainAParticipantThatFallsSilentBeforeTheMission) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  StepClock clock(Options(1.0), {"a", "b"}, plan, network.Add());
  const auto send_hello = [&](const std::string& name, int32_t pid, int64_t wall_us) {
    step_done_t hello{};
    hello.mission_id = kMissionId;
    hello.step = -1;
    hello.participant = name;
    hello.pid = pid;
    clock.OnDatagram(plan.done_port(), "STEP_DONE", Sealed(hello), wall_us);
    clock.OnTime(wall_us);
  };
  send_hello("a", 1, 0);
  EXPECT_EQ(clock.Awaited(), std::vector<std::string>{"b"});
  clock.OnTime(3'000'000);  // Its user has ended it.
  EXPECT_EQ(clock.Awaited(), (std::vector<std::string>{"a", "b"}));
  send_hello("a", 2, 4'000'000);
  send_hello("b", 3, 4'100'000);
  EXPECT_EQ(clock.fault(), "");
  EXPECT_EQ(clock.state(), StepClock::State::kRunning);
}

TEST(StepProtocol, BlamesNoParticipantWhenTheClockItselfStoodStill) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  FakeNetwork::Node& node = network.Add();
  StepClock clock(Options(1.0), {"a"}, plan, node);
  step_done_t hello{};
  hello.mission_id = kMissionId;
  hello.step = -1;
  hello.participant = "a";
  clock.OnDatagram(plan.done_port(), "STEP_DONE", Sealed(hello), 0);
  clock.OnTime(0);
  ASSERT_EQ(clock.state(), StepClock::State::kRunning);
  clock.OnTime(60'000'000);  // The machine slept for a minute.
  EXPECT_TRUE(clock.Silent(60'000'000).empty());
  for (int64_t now = 60'000'000; now < 66'000'000; now += 50'000) clock.OnTime(now);
  EXPECT_EQ(clock.Silent(66'000'000), std::vector<std::string>{"a"});
}

TEST(StepProtocol, PacesStepsByTheWallClock) {
  FakeNetwork network;
  const Outcome outcome = RunOver(network, 2.0);
  // 40 steps of 0.1 s at twice real time.
  EXPECT_NEAR(static_cast<double>(outcome.wall_us), 2.0e6, 0.1e6);
}

/// Sends the clock a command, as from outside.
void Command(StepClock& clock, int64_t now, const std::string& word, double warp = 0) {
  clock_command_t command{};
  command.command = word;
  command.warp = warp;
  Bytes bytes;
  EncodeInto(command, &bytes);
  clock.OnDatagram(PortPlan(7665, Layout::kShared, {}).done_port(), "CLOCK_COMMAND", bytes, now);
}

TEST(StepProtocol, GivesEveryParticipantTheSameMessagesForAnyClockCommands) {
  for (const double warp : {0.0, 1.0, 20.0}) {
    FakeNetwork network;
    std::mt19937 random(4);
    const Outcome outcome =
        RunOver(network, warp, [&](int64_t now, StepClock& clock, std::vector<Process>&) {
          switch (random() % 20) {
            case 0:
              Command(clock, now, "pause");
              break;
            case 1:
              Command(clock, now, "warp", random() % 2 == 0 ? 0 : 5);
              break;
            case 2:
            case 3:
              Command(clock, now, "resume");
              break;
            default:
              break;
          }
        });
    EXPECT_EQ(outcome.state, StepClock::State::kEnded);
    EXPECT_EQ(outcome.transcripts, RunInMemory());
    EXPECT_EQ(outcome.counters.outside, 0);
  }
}

TEST(StepProtocol, HoldsAllStepsWhilePausedAndBlamesNoParticipant) {
  FakeNetwork network;
  int64_t paused_at_us = 0;
  constexpr int64_t kPause_us = 20'000'000;
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t now, StepClock& clock, std::vector<Process>&) {
        if (clock.step() == 10 && paused_at_us == 0) {
          paused_at_us = now;
          Command(clock, now, "pause");
        }
        if (!clock.paused()) return;
        EXPECT_EQ(clock.step(), 10);
        EXPECT_TRUE(clock.Silent(now).empty());
        if (now == paused_at_us + kPause_us) Command(clock, now, "resume");
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.transcripts, RunInMemory());
  EXPECT_EQ(outcome.counters.ticks_again, 0);
  EXPECT_NEAR(static_cast<double>(outcome.wall_us), 4.0e6 + kPause_us, 0.15e6);
}

TEST(StepProtocol, TakesNoTickThatNamesAFormerProcessOfItsName) {
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  FakeNetwork::Node& attacker = network.Add();
  attacker.Listen(plan.tick_port(), "TICK");
  std::vector<Bytes> ticks;
  attacker.receiver = [&](int, std::string_view, std::span<const uint8_t> bytes) {
    ticks.emplace_back(bytes.begin(), bytes.end());
  };
  int64_t wall_us = 0;
  std::vector<Process> later;  // The processes of b after the first.
  const auto start_another = [&] {
    if (!later.empty()) later.back().node->set_stopped(true);
    later.push_back(Start(network, {"b"}, 2 + static_cast<int32_t>(later.size()), wall_us));
  };
  int64_t paused_at_us = 0;
  const Outcome outcome =
      RunOver(network, 1.0, [&](int64_t now, StepClock& clock, std::vector<Process>& processes) {
        wall_us = now;
        if (!later.empty()) later.back().group->OnTime(now);
        if (clock.step() == 10 && later.empty()) {
          processes[1].node->set_stopped(true);
          clock.DropExited("b", now);
          start_another();
        }
        if (later.size() != 1 && !clock.paused()) return;
        if (later.size() == 1 && !later[0].apps[0]->transcript.empty()) {
          // In the very step that names the second process, the mission is paused and it dies.
          paused_at_us = now;
          Command(clock, now, "pause");
          clock.DropExited("b", now);
          start_another();
          for (const Bytes& tick : std::vector(ticks)) {
            attacker.Send(plan.tick_port(), "TICK", tick);
          }
        }
        if (paused_at_us != 0 && now == paused_at_us + 1'000'000) {
          EXPECT_EQ(later[1].apps[0]->transcript, "") << "the clock does not wait for it yet";
          Command(clock, now, "resume");
        }
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_EQ(outcome.fault, "");
  ASSERT_EQ(later.size(), 2U);
  EXPECT_TRUE(later[1].apps[0]->transcript.ends_with("end"));
}

TEST(StepProtocol, StepsInTheRhythmOfANewWarp) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t now, StepClock& clock, std::vector<Process>&) {
        if (clock.step() == 10) Command(clock, now, "warp", 0.5);
        if (clock.step() == 20) Command(clock, now, "warp", 0);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  // 10 steps at 1, 10 at 0.5, and the rest of 20 as fast as the test goes: 5 ms each.
  EXPECT_NEAR(static_cast<double>(outcome.wall_us), 1.0e6 + 2.0e6 + 0.1e6, 0.1e6);
}

TEST(StepProtocol, EndsEarlyWhenAskedAlsoWhilePaused) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t now, StepClock& clock, std::vector<Process>&) {
        if (clock.step() == 5 && !clock.paused()) Command(clock, now, "pause");
        if (now == 2'000'000) clock.Stop(now, 500'000);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  EXPECT_LT(outcome.wall_us, 2'100'000);
  for (const auto& [name, transcript] : outcome.transcripts) {
    EXPECT_TRUE(transcript.ends_with("end")) << name;
  }
}

TEST(StepProtocol, EndsEarlyWhenAskedAndStillCloses) {
  FakeNetwork network;
  const Outcome outcome =
      RunOver(network, 1.0, [](int64_t now, StepClock& clock, std::vector<Process>&) {
        if (clock.step() == 5) clock.Stop(now, 500'000);
      });
  EXPECT_EQ(outcome.state, StepClock::State::kEnded);
  for (const auto& [name, transcript] : outcome.transcripts) {
    EXPECT_TRUE(transcript.ends_with("end")) << name;
  }
  EXPECT_LT(outcome.wall_us, 1'000'000);
}

}  // namespace shoal::step_protocol_test

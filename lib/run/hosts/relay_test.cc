// Clock, participants and relays together, over networks in memory: a mission on three computers is
// the mission on one, whatever the networks lose.
#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <random>
#include <sstream>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/hosts/home_relay.h"
#include "lib/run/hosts/host_relay.h"
#include "lib/run/run/network_testing.h"
#include "lib/run/run/step_clock.h"
#include "lib/run/run/step_group.h"
#include "lib/run/run/step_inbox.h"

namespace shoal::relay_test {

constexpr int64_t kMissionId = 4711;
constexpr int64_t kLastStep = 30;
const std::vector<std::string> kNames = {"a", "b", "c", "d"};

/// Publishes two messages per step and keeps a transcript of all that it receives.
class TalkingApp : public App {
 public:
  TalkingApp(std::string name, Bus& bus) : name_(std::move(name)), bus_(bus) {
    for (const std::string channel : {"FIRST", "SECOND"}) {
      Subscribe(bus, Channel<unc_control_t>{channel},
                [this, channel](const unc_control_t& received) {
                  transcript +=
                      channel + ":" + received.vehicle + "=" + std::to_string(received.value) + " ";
                });
    }
  }
  void Tick(int64_t utime) override {
    transcript += "\n" + std::to_string(utime) + " ";
    for (const std::string channel : {"FIRST", "SECOND"}) {
      unc_control_t message{};
      message.utime = utime;
      message.vehicle = name_;
      message.value = static_cast<double>(utime);
      Publish(bus_, Channel<unc_control_t>{channel}, message);
    }
  }
  void End() override { transcript += "end"; }
  StatusPage Status() const override { return {}; }

  const std::string& name() const { return name_; }

  std::string transcript;

 private:
  std::string name_;
  Bus& bus_;
};

/// A process of one participant, or of several.
struct Process {
  FakeNetwork::Node* node = nullptr;
  std::unique_ptr<StepGroup> group;
  std::vector<std::unique_ptr<TalkingApp>> apps;
};

/// Of each computer the processes, of each process the names of its participants: "b d".
using Places = std::vector<std::vector<std::string>>;

std::vector<std::string> NamesIn(const std::string& process) {
  std::istringstream in(process);
  return {std::istream_iterator<std::string>(in), {}};
}

/// A mission whose participants are spread over computers: the first holds the clock.
class SpreadMission {
 public:
  explicit SpreadMission(const Places& places)
      : networks_(places.size()), clock_node_(networks_[0].Add()) {
    clock_ = std::make_unique<StepClock>(
        ClockOptions{.mission_id = kMissionId, .warp = 10, .last_step = kLastStep}, kNames, plan_,
        clock_node_);
    clock_node_.receiver = [this](int port, std::string_view channel, auto bytes) {
      clock_->OnDatagram(port, channel, bytes, now_);
    };
    std::vector<RelayedHost> hosts;
    for (size_t i = 1; i < places.size(); ++i) {
      hosts.push_back(
          {.participants = {}, .wants = [](std::string_view) { return true; }, .may_publish = {}});
      for (const std::string& process : places[i]) {
        for (const std::string& name : NamesIn(process)) hosts.back().participants.insert(name);
      }
      const auto& names = hosts.back().participants;
      hosts.back().may_publish = ChannelsFrom(kNames, {names.begin(), names.end()}, {});
    }
    const RelayOptions options{.name = "home", .mission_id = kMissionId};
    FakeNetwork::Node& home_node = networks_[0].Add();
    home_ = std::make_unique<HomeRelay>(options, plan_, home_node, hosts,
                                        [this](size_t host, LinkMessage message) {
                                          to_hosts_[host].push_back(std::move(message));
                                        });
    home_node.receiver = [this](int port, std::string_view channel, auto bytes) {
      home_->OnDatagram(port, channel, bytes, now_);
    };
    for (size_t i = 0; i < hosts.size(); ++i) AddHost(i, hosts[i]);
    for (size_t i = 0; i < places.size(); ++i) {
      for (const std::string& process : places[i]) AddProcess(i, process);
    }
  }

  /// Runs to the end, or until `meddle()` returns false.
  void Run(const std::function<bool()>& meddle = [] { return true; }) {
    for (; now_ < 60'000'000 && clock_->state() != StepClock::State::kEnded; now_ += 5'000) {
      for (const auto& [names, process] : processes_) process.group->OnTime(now_);
      clock_->OnTime(now_);
      home_->OnTime(now_);
      for (const auto& relay : relays_) relay->OnTime(now_);
      for (FakeNetwork& network : networks_) network.DeliverAll();
      for (bool any = true; any;) {
        any = DeliverLinks();
        for (FakeNetwork& network : networks_) network.DeliverAll();
      }
      if (!clock_->fault().empty() || !meddle()) break;
    }
  }

  std::map<std::string, std::string> Transcripts() const {
    std::map<std::string, std::string> transcripts;
    for (const auto& [names, process] : processes_) {
      for (const auto& app : process.apps) transcripts[app->name()] = app->transcript;
    }
    return transcripts;
  }
  /// Plays a process that hangs.
  void Silence(const std::string& process) { processes_.at(process).node->set_stopped(true); }
  StepClock& clock() { return *clock_; }
  HomeRelay& home() { return *home_; }
  HostRelay& relay(size_t host) { return *relays_[host]; }
  FakeNetwork& network(size_t computer) { return networks_[computer]; }
  int64_t now() const { return now_; }
  const PortPlan& plan() const { return plan_; }
  /// Messages that went over links, by kind.
  std::map<LinkKind, int> num_sent;

 private:
  void AddHost(size_t number, const RelayedHost& relayed) {
    FakeNetwork::Node& node = networks_[number + 1].Add();
    relays_.push_back(std::make_unique<HostRelay>(
        RelayOptions{.name = "host", .mission_id = kMissionId}, plan_, node, relayed.participants,
        [this, number](LinkMessage message) { to_home_[number].push_back(std::move(message)); }));
    node.receiver = [this, number](int port, std::string_view channel, auto bytes) {
      relays_[number]->OnDatagram(port, channel, bytes, now_);
    };
    home_->SetConnected(number, true);
  }

  void AddProcess(size_t computer, const std::string& names) {
    FakeNetwork::Node& node = networks_[computer].Add();
    Process process;
    process.node = &node;
    process.group = std::make_unique<StepGroup>(
        StepGroupOptions{.mission_id = kMissionId, .pid = 1}, plan_, node);
    for (const std::string& name : NamesIn(names)) {
      process.apps.push_back(std::make_unique<TalkingApp>(name, process.group->Join(name)));
      process.group->Attach(name, process.apps.back().get());
    }
    process.group->Listen();
    node.receiver = [this, group = process.group.get()](int port, std::string_view channel,
                                                        auto bytes) {
      group->OnDatagram(port, channel, bytes, now_);
    };
    processes_[names] = std::move(process);
  }

  bool DeliverLinks() {
    bool any = false;
    for (auto& [host, queue] : to_hosts_) {
      for (const LinkMessage& message : std::exchange(queue, {})) {
        ++num_sent[message.kind];
        EXPECT_EQ(relays_[host]->OnMessage(message, now_), "");
        any = true;
      }
    }
    for (auto& [host, queue] : to_home_) {
      for (const LinkMessage& message : std::exchange(queue, {})) {
        if (message.step >= 0) ++num_sent[message.kind];
        home_->OnMessage(host, message, now_);
        any = true;
      }
    }
    return any;
  }

  int64_t now_ = 0;
  const PortPlan plan_{7665, Layout::kShared, {}};
  std::vector<FakeNetwork> networks_;
  FakeNetwork::Node& clock_node_;
  std::unique_ptr<StepClock> clock_;
  std::unique_ptr<HomeRelay> home_;
  std::vector<std::unique_ptr<HostRelay>> relays_;
  std::map<std::string, Process> processes_;
  std::map<size_t, std::vector<LinkMessage>> to_hosts_;
  std::map<size_t, std::vector<LinkMessage>> to_home_;
};

std::map<std::string, std::string> OnOneComputer() {
  SpreadMission mission({kNames});
  mission.Run();
  EXPECT_EQ(mission.clock().state(), StepClock::State::kEnded);
  return mission.Transcripts();
}

const Places kThreeComputers = {{"a"}, {"b", "d"}, {"c"}};

/// The same participants, in processes of one or of several.
class EachPlacing : public testing::TestWithParam<Places> {};

INSTANTIATE_TEST_SUITE_P(Relays, EachPlacing,
                         testing::Values(kThreeComputers, Places{{"a"}, {"b d"}, {"c"}},
                                         Places{{"a d"}, {"b c"}}));

TEST_P(EachPlacing, GivesTheSameMessagesAsOneComputer) {
  SpreadMission mission(GetParam());
  mission.Run();
  EXPECT_EQ(mission.clock().state(), StepClock::State::kEnded);
  EXPECT_EQ(mission.Transcripts(), OnOneComputer());
  EXPECT_EQ(mission.home().num_refused() + mission.relay(0).num_refused(), 0);
}

TEST_P(EachPlacing, NeedsOneBatchPerStepEachWay) {
  SpreadMission mission(GetParam());
  mission.Run();
  constexpr int kTicks = kLastStep + 2;  // END is one more.
  const auto num_hosts = static_cast<int>(GetParam().size()) - 1;
  EXPECT_EQ(mission.num_sent[LinkKind::kTick], num_hosts * kTicks);
  EXPECT_EQ(mission.num_sent[LinkKind::kDone], num_hosts * kTicks);
  EXPECT_EQ(mission.home().timing(0).answer_us.size(), static_cast<size_t>(kTicks - 1));
}

TEST_P(EachPlacing, RepairsWhatEachBusLoses) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SpreadMission mission(GetParam());
    std::mt19937 random(seed);
    for (size_t i = 0; i < GetParam().size(); ++i) {
      mission.network(i).set_loss([&](std::string_view) { return random() % 6 == 0; });
    }
    mission.Run();
    EXPECT_EQ(mission.clock().fault(), "");
    EXPECT_EQ(mission.clock().state(), StepClock::State::kEnded);
    EXPECT_EQ(mission.Transcripts(), OnOneComputer());
    EXPECT_GT(mission.clock().counters().repeated, 20);
  }
}

TEST(Relays, HandMessagesFromOutsideToEachOtherBusOnce) {
  SpreadMission mission(kThreeComputers);
  FakeNetwork::Node& outsider = mission.network(1).Add();
  bool is_sent = false;
  mission.Run([&] {
    if (mission.clock().step() < 5 || is_sent) return true;
    is_sent = true;
    unc_control_t message{};
    message.vehicle = "outsider";
    Bytes bytes;
    EncodeInto(message, &bytes);
    outsider.Send(mission.plan().shore_port(), "FIRST", bytes);
    return true;
  });
  EXPECT_EQ(mission.clock().state(), StepClock::State::kEnded);
  for (const auto& [name, transcript] : mission.Transcripts()) {
    const std::string text = "FIRST:outsider=";
    const size_t at = transcript.find(text);
    ASSERT_NE(at, std::string::npos) << name;
    EXPECT_EQ(transcript.find(text, at + 1), std::string::npos) << name;
  }
}

TEST(Relays, SendTheAnswersOfTheOthersWhereOneIsSilent) {
  SpreadMission mission(kThreeComputers);
  int64_t silent_since = 0;
  FakeNetwork::Node& spy = mission.network(0).Add();
  std::set<std::string> answered;
  spy.receiver = [&](int, std::string_view, std::span<const uint8_t> bytes) {
    const Unsealed unsealed = Unseal(bytes);
    if (silent_since > 0 && unsealed.seal && unsealed.seal->step == mission.clock().step()) {
      answered.insert(std::string(unsealed.seal->publisher));
    }
  };
  spy.Listen(mission.plan().done_port(), std::string(topics::kStepDone));
  mission.Run([&] {
    if (mission.clock().step() >= 5 && silent_since == 0) {
      silent_since = mission.now();
      mission.Silence("d");
    }
    return silent_since == 0 || mission.now() < silent_since + 1'000'000;
  });
  EXPECT_EQ(answered, (std::set<std::string>{"a", "b", "c"}));
}

TEST(Relays, RefuseWhatAHostPublishesInAnothersName) {
  SpreadMission mission(kThreeComputers);
  mission.Run([&] { return mission.clock().step() < 5; });
  Bytes bytes;
  EncodeInto(unc_control_t{}, &bytes);
  AppendSeal({.publisher = "c", .mission_id = kMissionId, .step = 5, .sequence = 9}, {}, "FIRST",
             &bytes);
  LinkMessage batch{.kind = LinkKind::kDone, .mission_id = kMissionId, .step = 5};
  batch.parts.push_back({.name = "FIRST", .data = bytes});
  mission.home().OnMessage(0, batch, mission.now());
  EXPECT_EQ(mission.home().num_refused(), 1);
  mission.home().OnMessage(1, batch, mission.now());  // c is its own.
  EXPECT_EQ(mission.home().num_refused(), 1);
}

/// Returns a batch with one message of a host's, sealed by `publisher`; empty: without a seal.
LinkMessage BatchOn(std::string_view channel, const std::string& publisher) {
  Bytes bytes;
  EncodeInto(unc_control_t{}, &bytes);
  if (!publisher.empty()) {
    AppendSeal({.publisher = publisher, .mission_id = kMissionId, .step = 5, .sequence = 9}, {},
               channel, &bytes);
  }
  LinkMessage batch{.kind = LinkKind::kDone, .mission_id = kMissionId, .step = 5};
  batch.parts.push_back({.name = std::string(channel), .data = bytes});
  return batch;
}

TEST(Relays, DropWhatNoProcessOfAHostPublishes) {
  SpreadMission mission(kThreeComputers);
  mission.Run([&] { return mission.clock().step() < 5; });
  std::vector<std::string> on_bus;
  FakeNetwork::Node& spy = mission.network(0).Add();
  spy.receiver = [&](int, std::string_view channel, std::span<const uint8_t>) {
    on_bus.emplace_back(channel);
  };
  for (const int port : {mission.plan().tick_port(), mission.plan().done_port()}) {
    spy.ListenToAll(port);
  }
  spy.ListenToAll(mission.plan().shore_port());
  const std::vector<std::string> dropped = {
      "HELM_COMMAND", "HELM_COMMAND_C", "SIM_COMMAND_A", "CLOCK_COMMAND",   "TICK",
      "RESEND",       "COMMS_RULES",    "UNC_CONTROLS",  "COMMS_RULES_NOW", "NAV_C"};
  for (const std::string publisher : {"", "b"}) {
    for (const std::string& channel : dropped) {
      EXPECT_EQ(mission.home().OnMessage(0, BatchOn(channel, publisher), mission.now()), channel);
    }
  }
  mission.network(0).DeliverAll();
  EXPECT_EQ(on_bus, std::vector<std::string>());
  EXPECT_EQ(mission.home().num_dropped(0), static_cast<int64_t>(2 * dropped.size()));
  EXPECT_EQ(mission.home().num_dropped(1), 0);
  for (const std::string channel : {"NAV_B", "HELM_COMMAND_D", "NODE_REPORT_LOCAL", "MY_OWN"}) {
    EXPECT_EQ(mission.home().OnMessage(0, BatchOn(channel, ""), mission.now()), "");
    mission.network(0).DeliverAll();
    ASSERT_FALSE(on_bus.empty());
    EXPECT_EQ(on_bus.back(), channel);
  }
}

/// The channels of the shore that a host without programs may publish on.
TEST(ChannelsFrom, ForVehiclesAreTheirOwnAndThoseOfTheShoreThatTheyPublish) {
  const auto may = ChannelsFrom({"alpha", "bravo", "my_alpha"}, {"alpha"}, {});
  std::vector<std::string_view> shore;
  for (const ChannelRow& row : ChannelTable()) {
    if (row.home == ChannelHome::kShore && may("", row.topic)) shore.push_back(row.topic);
    if (row.home != ChannelHome::kVehicle) continue;
    EXPECT_TRUE(may("", std::string(row.topic) + "_ALPHA"));
    EXPECT_FALSE(may("", std::string(row.topic) + "_BRAVO"));
    EXPECT_FALSE(may("helm_alpha", std::string(row.topic) + "_MY_ALPHA"));
  }
  EXPECT_EQ(shore,
            (std::vector<std::string_view>{
                topics::kNodeReportLocal, topics::kNodeReport, topics::kNodeMessageLocal,
                topics::kNodeMessage, topics::kAckMessage, topics::kAcousticTx,
                topics::kAcousticTxOn, topics::kRelayTx, topics::kViewPoint, topics::kViewPolygon,
                topics::kViewSeglist, topics::kViewCircle, topics::kViewText}));
}

TEST(ChannelsFrom, ForProgramsAreAll) {
  const auto may = ChannelsFrom({"alpha", "bravo"}, {"alpha"}, {"driver"});
  EXPECT_TRUE(may("driver", "HELM_COMMAND_BRAVO"));
  EXPECT_TRUE(may("", "HELM_COMMAND"));
  EXPECT_FALSE(may("driver", "CLOCK_COMMAND"));
  EXPECT_FALSE(may("helm_alpha", "HELM_COMMAND_BRAVO"));
}

TEST(Relays, HandOnOfABatchAsMuchFromOutsideAsAStepTakes) {
  SpreadMission mission(kThreeComputers);
  mission.Run([&] { return mission.clock().step() < 5; });
  LinkMessage batch{.kind = LinkKind::kDone, .mission_id = kMissionId, .step = 5};
  batch.parts.resize(StepInbox::kMaxOutside + 3, {.name = "NAV_B", .data = {}});
  mission.home().OnMessage(0, batch, mission.now());
  EXPECT_EQ(mission.home().num_refused(), 3);
}

TEST(Relays, RefuseAnAnswerOfAHostForParticipantsOfOthers) {
  SpreadMission mission(kThreeComputers);
  mission.Run([&] { return mission.clock().step() < 5; });
  step_dones_t answers{};
  for (const std::string name : {"b", "c"}) {
    step_done_t& done = answers.dones.emplace_back();
    done.mission_id = kMissionId;
    done.step = 5;
    done.participant = name;
  }
  answers.num_dones = 2;
  Bytes bytes;
  EncodeInto(answers, &bytes);
  AppendSeal({.publisher = "b", .mission_id = kMissionId, .step = 5, .sequence = 0}, {},
             topics::kStepDones, &bytes);
  LinkMessage batch{.kind = LinkKind::kDone, .mission_id = kMissionId, .step = 5};
  batch.parts.push_back({.name = std::string(topics::kStepDones), .data = bytes});
  int num_on_bus = 0;
  FakeNetwork::Node& spy = mission.network(0).Add();
  spy.receiver = [&](int, std::string_view, std::span<const uint8_t>) { ++num_on_bus; };
  spy.Listen(mission.plan().done_port(), std::string(topics::kStepDones));
  mission.home().OnMessage(0, batch, mission.now());
  mission.network(0).DeliverAll();
  EXPECT_EQ(mission.home().num_refused(), 1);
  EXPECT_EQ(num_on_bus, 0);
}

TEST(Relays, RefuseABatchOfAStepThatHasBegun) {
  SpreadMission mission(kThreeComputers);
  mission.Run([&] { return mission.clock().step() < 5; });
  tick_t tick{};
  tick.mission_id = kMissionId;
  tick.step = 3;
  Bytes bytes;
  EncodeInto(tick, &bytes);
  AppendSeal({.publisher = "clock", .mission_id = kMissionId, .step = 3, .sequence = 0}, {},
             topics::kTick, &bytes);
  LinkMessage replay{.kind = LinkKind::kTick, .mission_id = kMissionId, .step = 3};
  EXPECT_EQ(mission.relay(0).OnMessage(replay, mission.now()),
            "a batch of step 3 without its TICK");
  replay.parts.push_back({.name = std::string(topics::kTick), .data = bytes});
  EXPECT_EQ(mission.relay(0).OnMessage(replay, mission.now()),
            "a batch of step 3, where step 5 has begun");
}

}  // namespace shoal::relay_test

// muNet's whole simulations over its acoustic network (tests/golden/munet/sim_fdma_*, sim_tdma_*),
// by shoal's vehicles, laws, messages, slots and water in the order of muNet's loop. Once as shoal
// is, and once with what is otherwise in muNet, to show that this is all that lies between them:
//
//   slots  members of fdma send one step after their slot, and one more by rounding
//   delay  a message is brought up to the time of its arrival, in the step after that; and each
//          step goes on from what the last one expected
//   start  followers know the leader's first waypoint before they have received it, and expect it
//          to set out
//
// Followers never come so near to each other that it matters where they expect each other: in
// fdma muNet does not add how long a report of a follower was under way, so it expects the follower
// behind where it is.
#include "tests/closed_loops/network_swarm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lib/comms/swarm/broadcast_message.h"
#include "tests/closed_loops/golden_track.h"

namespace shoal::network_swarm_test {

const VelocityCascade kByGroup{{SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}};

/// What the simulations share: no jitter, nothing lost or damaged but by collisions.
NetworkSwarmSetup AsMunet() {
  NetworkSwarmSetup setup;
  setup.water.jitter = JitterModel::kOff;
  setup.water.packet_loss_model = PacketLossModel::kOff;
  setup.water.bit_error_model = BitErrorModel::kOff;
  setup.water.bandwidth_khz = 30;
  setup.slots = {.tick_us = kMunetStep_us};
  setup.law = kByGroup;
  setup.path_m = {{0, 0, 20}, {200, 0, 25}, {300, 150, 30}, {300, 400, 20}};
  return setup;
}

NetworkSwarmSetup FdmaWithSonarInACurrent() {
  NetworkSwarmSetup setup = AsMunet();
  setup.law = VelocityCascade{};
  setup.has_sonar = true;
  setup.current_mps = 0.3 * Eigen::Vector3d(std::cos(2.0), std::sin(2.0), 0);
  setup.floor_z_m = 60;
  return setup;
}

NetworkSwarmSetup TdmaLf() {
  NetworkSwarmSetup setup = AsMunet();
  setup.water.access_mode = AccessMode::kTdmaLf;
  setup.slots.scheme = SwarmScheme::kTdmaLf;
  setup.slots.broadcast_us = 1'000'000;
  setup.slots.response_us = 1'000'000;
  setup.slots.answer_window_us = 1'000'000;
  return setup;
}

/// A run of muNet.
struct Golden {
  explicit Golden(const std::string& name) : tracks(ReadTracks("munet/" + name + ".csv")) {
    for (const GoldenRow& row : ReadGoldenCsv("munet/" + name + "_messages.csv")) {
      events.push_back({.is_send = row.at("ev") == "send",
                        .utime = std::llround(Number(row, "t") * 1e6),
                        .id = std::stoi(row.at("node")),
                        .channel = std::stoi(row.at("cid")),
                        .bytes = FromHex(row.at("hex"))});
    }
    for (const GoldenRow& row : tracks.begin()->second) start.push_back(StateIn(row));
  }

  GoldenTracks tracks;
  std::vector<SwarmEvent> events;
  std::vector<Remus100State> start;
};

double NearestFollowers_m(const NetworkSwarm& swarm) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int i = 1; i < swarm.num_members(); ++i) {
    for (int j = 1; j < i; ++j) {
      const Eigen::Vector3d between_m = swarm.auv(i).position_m() - swarm.auv(j).position_m();
      nearest_m = std::min(nearest_m, between_m.norm());
    }
  }
  return nearest_m;
}

/// Runs as long as muNet did. Returns how far its vehicles come from where muNet's are, at most.
double FarthestApart(const Golden& golden, NetworkSwarm* swarm) {
  double most_m = 0;
  const int64_t last_step = golden.tracks.rbegin()->first;
  for (int64_t step = 0; step <= last_step; ++step) {
    if (const auto found = golden.tracks.find(step); found != golden.tracks.end()) {
      for (int i = 0; i < swarm->num_members(); ++i) {
        const GoldenRow& row = found->second.at(static_cast<size_t>(i));
        most_m = std::max(most_m, (swarm->auv(i).position_m() - PositionIn(row)).norm());
      }
      EXPECT_GT(NearestFollowers_m(*swarm), SurvivalGroupLayer().r_avoid_m) << "it matters";
    }
    swarm->Step();
  }
  return most_m;
}

/// How far apart two tellings of the same events are.
struct EventsApart {
  int64_t latest_us = 0;    ///< How much later muNet's are, at most ...
  int64_t earliest_us = 0;  ///< ... and at least.
  double sent_m = 0;        ///< Positions in their messages.
  int num_swapped = 0;      ///< In another order than muNet's, within a step of it.
};

std::string TypeIn(const SwarmEvent& event) {
  return {event.bytes.begin(), event.bytes.begin() + 4};
}

bool AreAlike(const SwarmEvent& a, const SwarmEvent& b) {
  return a.is_send == b.is_send && a.id == b.id && a.channel == b.channel && TypeIn(a) == TypeIn(b);
}

/// Expects the same events in the same order. Where several are in one step of muNet, which is
/// first is up to microseconds.
EventsApart CompareEvents(const std::vector<SwarmEvent>& events, std::vector<SwarmEvent> golden) {
  EventsApart apart;
  EXPECT_EQ(events.size(), golden.size());
  for (size_t i = 0; i < std::min(events.size(), golden.size()); ++i) {
    const SwarmEvent& mine = events[i];
    for (size_t j = i; j < golden.size() && golden[j].utime == golden[i].utime; ++j) {
      if (!AreAlike(mine, golden[j])) continue;
      if (j != i) ++apart.num_swapped;
      std::swap(golden[i], golden[j]);
      break;
    }
    const std::vector<Eigen::Vector3d> sent_m = PositionsIn(mine.bytes);
    const std::vector<Eigen::Vector3d> golden_m = PositionsIn(golden[i].bytes);
    if (!AreAlike(mine, golden[i]) || sent_m.empty() || sent_m.size() != golden_m.size()) {
      ADD_FAILURE() << "event " << i << ": " << mine.utime << " us, " << mine.id << " "
                    << TypeIn(mine) << "; muNet's: " << golden[i].utime << " us, " << golden[i].id
                    << " " << TypeIn(golden[i]);
      break;
    }
    for (size_t j = 0; j < sent_m.size(); ++j) {
      apart.sent_m = std::max(apart.sent_m, (sent_m[j] - golden_m[j]).norm());
    }
    apart.latest_us = std::max(apart.latest_us, golden[i].utime - mine.utime);
    apart.earliest_us = std::min(apart.earliest_us, golden[i].utime - mine.utime);
  }
  return apart;
}

struct Likeness {
  double farthest_m = 0;  ///< Between a vehicle and muNet's.
  EventsApart events = {};
};

/// Runs `swarm` as long as muNet did and holds all that it did against it.
Likeness Compare(const Golden& golden, NetworkSwarm* swarm) {
  Likeness like;
  like.farthest_m = FarthestApart(golden, swarm);
  like.events = CompareEvents(swarm->events(), golden.events);
  for (int i = 0; i < swarm->num_members(); ++i) {
    EXPECT_EQ(swarm->counts(i).clean, swarm->counts(i).received) << i;
  }
  EXPECT_EQ(swarm->water().statistics().NumOf(AcousticFate::kCollided), 0);
  return like;
}

/// Expects a swarm without muNet's faults to be like it, but for what these make.
void ExpectLikeMunet(const Golden& golden, NetworkSwarm* swarm, int64_t latest_us) {
  constexpr double kNear_m = 0.25;
  const Likeness like = Compare(golden, swarm);
  EXPECT_LT(like.farthest_m, kNear_m);
  EXPECT_GT(like.farthest_m, 0.01) << "then muNet's faults no longer make a difference";
  EXPECT_LT(like.events.sent_m, kNear_m);
  EXPECT_GE(like.events.earliest_us, 0);
  EXPECT_LE(like.events.latest_us, latest_us);
}

/// The same swarm with muNet's faults.
class FaultySwarm : public NetworkSwarm {
 public:
  using NetworkSwarm::NetworkSwarm;

 protected:
  std::optional<DueMessage> Due(int index, int64_t now_us) override {
    if (setup().slots.scheme != SwarmScheme::kFdmaLf) return NetworkSwarm::Due(index, now_us);
    // As muNet's slots are: see above.
    double& slot_s = slots_s_.try_emplace(index, 0.5 * (index + 1)).first->second;
    const double now_s = static_cast<double>(now_us / kMunetStep_us) * kMunetStep_s;
    if (now_s - slot_s < kMunetStep_s) return std::nullopt;
    slot_s += 5;
    return DueMessage{.message = index == 0 ? SwarmMessage::kLeaderReport : SwarmMessage::kReport};
  }

  Others Expect(int index, int64_t now_us) override {
    Others others = NetworkSwarm::Expect(index, now_us);
    const auto [found, is_first] = leader_.try_emplace(index);
    if (is_first)
      found->second.report = {ReceiverOf(index).state.target->report.now, NextOfLeader()};
    others.target = Advance(&found->second);
    return others;
  }

  void OnReception(int index, const SwarmReception& reception, int64_t now_us) override {
    const GroupState& state = ReceiverOf(index).state;
    const bool is_from_leader =
        *reception.flag == kLeaderReportFlag || *reception.flag == kBroadcastFlag;
    if (state.is_leader || !is_from_leader) return;
    leader_[index] = {state.target->report,
                      static_cast<double>(now_us - state.target->reported_us) / 1e6};
  }

 private:
  struct Expected {
    MotionReport report = {};
    double delay_s = 0;  ///< To make up for in the next step.
  };

  static Motion Advance(Expected* expected) {
    const double step_s = expected->delay_s > kMunetStep_s ? expected->delay_s : kMunetStep_s;
    expected->delay_s = 0;
    Motion& now = expected->report.now;
    const Eigen::Vector3d way_m = expected->report.next.position_m - now.position_m;
    if (way_m.norm() == 0) return now;
    const Eigen::Vector3d ahead = way_m.normalized();
    const double v_i_mps = now.velocity_mps.dot(ahead);
    const double v_f_mps = expected->report.next.velocity_mps.dot(ahead);
    const double a_mps2 = (v_f_mps * v_f_mps - v_i_mps * v_i_mps) / (2 * way_m.norm());
    now.position_m += (v_i_mps * step_s + a_mps2 * step_s * step_s / 2) * ahead;
    now.velocity_mps += a_mps2 * step_s * ahead;
    return now;
  }

  std::map<int, Expected> leader_;  ///< As each follower has it.
  std::map<int, double> slots_s_;   ///< The next of each.
};

/// Two steps for the slots, and one where what was sent earlier just makes it into a step.
constexpr int64_t kFdmaLatest_us = 3 * kMunetStep_us;

TEST(NetworkSwarmAsMunet, ByFdmaSendsAndReceivesTheSameAtMostThreeStepsEarlierAndKeepsToItsTracks) {
  const Golden golden("sim_fdma_apf");
  NetworkSwarm swarm(AsMunet(), golden.start);
  ExpectLikeMunet(golden, &swarm, kFdmaLatest_us);
}

// The sonar sees the floor, but nothing so near that the layer would turn away from it.
TEST(NetworkSwarmAsMunet, ByFdmaWithSonarInACurrentItDoesSoToo) {
  const Golden golden("sim_fdma_apf_fls_current");
  NetworkSwarm swarm(FdmaWithSonarInACurrent(), golden.start);
  ExpectLikeMunet(golden, &swarm, kFdmaLatest_us);
  EXPECT_GT(swarm.nearest_echo_m(), SurvivalSonarLayer().r_avoid_m);
  EXPECT_LT(swarm.nearest_echo_m(), SonarParams().max_range_m);
}

TEST(NetworkSwarmAsMunet, ByTdmaSendsAndReceivesTheSameInTheSameStepsAndKeepsToItsTracks) {
  const Golden golden("sim_tdma_lf_apf");
  NetworkSwarm swarm(TdmaLf(), golden.start);
  ExpectLikeMunet(golden, &swarm, /*latest_us=*/0);
}

void ExpectMunet(const std::string& name, const NetworkSwarmSetup& setup) {
  const Golden golden(name);
  FaultySwarm swarm(setup, golden.start);
  const Likeness like = Compare(golden, &swarm);
  EXPECT_LT(like.farthest_m, 1e-6);
  EXPECT_LT(like.events.sent_m, 1e-5) << "the last digit of a float32";
  EXPECT_EQ(like.events.latest_us, 0);
  EXPECT_EQ(like.events.earliest_us, 0);
  EXPECT_EQ(like.events.num_swapped, 0);
}

TEST(NetworkSwarmWithMunetsFaults, SendsAndMovesExactlyTheSameByFdma) {
  ExpectMunet("sim_fdma_apf", AsMunet());
}

TEST(NetworkSwarmWithMunetsFaults, SendsAndMovesExactlyTheSameWithSonarInACurrent) {
  ExpectMunet("sim_fdma_apf_fls_current", FdmaWithSonarInACurrent());
}

TEST(NetworkSwarmWithMunetsFaults, SendsAndMovesExactlyTheSameByTdma) {
  ExpectMunet("sim_tdma_lf_apf", TdmaLf());
}

}  // namespace shoal::network_swarm_test

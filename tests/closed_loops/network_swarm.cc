#include "tests/closed_loops/network_swarm.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <variant>

#include "apps/acomms/swarm_bytes.h"
#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/any_message_testing.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {

namespace {

constexpr uint8_t kGroup = 'A';
constexpr int64_t kStepsPerPing = 5;

std::vector<AcousticNode> NodesOf(size_t num_members) {
  std::vector<AcousticNode> nodes;
  for (size_t i = 0; i < num_members; ++i) {
    const int id = static_cast<int>(i) + 1;
    nodes.push_back({.name = "v" + std::to_string(id), .address = id, .is_leader = i == 0});
  }
  return nodes;
}

SwarmReceiver ReceiverFor(size_t index, const std::vector<Remus100State>& start,
                          const SlotPlan& slots) {
  SwarmReceiver receiver;
  receiver.state.own_id = static_cast<uint32_t>(index) + 1;
  receiver.state.group_id = kGroup;
  receiver.state.is_leader = index == 0;
  receiver.state.episode_us = slots.episode_us;
  receiver.limits.late_start_us = slots.response_us;
  for (size_t other = 0; other < start.size(); ++other) {
    if (other == index) continue;
    const SwarmContact contact = PlacedContact(
        static_cast<uint32_t>(other) + 1, kGroup,
        {.position_m = start[other].eta.head<3>(), .velocity_mps = start[other].velocity_mps});
    if (other == 0) {
      receiver.state.target = contact;
    } else {
      receiver.state.members.push_back(contact);
    }
  }
  return receiver;
}

/// Where the leader is now, by the next waypoint that it reported, if it did.
std::optional<Motion> PredictTarget(const GroupState& state, int64_t now_us) {
  if (!state.target || !IsUsable(*state.target)) return std::nullopt;
  const SwarmContact& target = *state.target;
  if (!KnowsNext(target)) return PredictContact(target, now_us);
  return PredictLeader(target.report, std::max(0.0, SecondsBetween(target.reported_us, now_us)),
                       {});
}

}  // namespace

NetworkSwarm::NetworkSwarm(NetworkSwarmSetup setup, const std::vector<Remus100State>& start)
    : setup_(std::move(setup)),
      water_(setup_.water, /*seed=*/1, NodesOf(start.size())),
      floor_(FlatFloor(setup_.floor_z_m)),
      echoes_(start.size()),
      nearest_echo_m_(std::numeric_limits<double>::infinity()) {
  for (size_t i = 0; i < start.size(); ++i) {
    auvs_.emplace_back(start[i], start[i].eta[5], start[i].eta[2]);
    if (i > 0) auvs_.back().TakeTarget(setup_.law);
    receivers_.push_back(ReceiverFor(i, start, setup_.slots));
    schedules_.emplace_back(setup_.slots,
                            SwarmPlace{.is_leader = i == 0, .place = static_cast<int64_t>(i) + 1});
  }
  auvs_.front().TakePath(setup_.path_m, setup_.rpm);
}

void NetworkSwarm::Step() {
  const int64_t now_us = step_ * kMunetStep_us;
  for (int i = 0; i < num_members(); ++i) {
    if (const auto due = Due(i, now_us)) Send(i, *due, now_us);
    if (setup_.has_sonar && i > 0 && step_ % kStepsPerPing == 0) Ping(i);
    Decide(i, now_us);
    auvs_[static_cast<size_t>(i)].Step(
        {.current_mps = setup_.current_mps, .floor_z_m = setup_.floor_z_m});
  }
  Deliver(now_us);
  ++step_;
}

std::optional<DueMessage> NetworkSwarm::Due(int index, int64_t now_us) {
  return schedules_[static_cast<size_t>(index)].Due(now_us);
}

NetworkSwarm::Others NetworkSwarm::Expect(int index, int64_t now_us) {
  const GroupState& state = ReceiverOf(index).state;
  const std::optional<Motion> target = PredictTarget(state, now_us);
  SHOAL_CHECK(target.has_value(), "the start of the leader is known");
  Others others{.target = *target, .group = {}};
  for (const SwarmContact& member : state.members) {
    const std::optional<Motion> motion = PredictContact(member, now_us);
    SHOAL_CHECK(motion.has_value(), "the start of every member is known");
    others.group.push_back({static_cast<int>(member.id), motion->position_m, motion->velocity_mps});
  }
  return others;
}

Motion NetworkSwarm::MotionOf(int index) const {
  return {.position_m = auv(index).position_m(), .velocity_mps = auv(index).state.velocity_mps};
}

Motion NetworkSwarm::NextOfLeader() const {
  const size_t next = std::min(auv(0).leg + 1, setup_.path_m.size() - 1);
  return PredictAtPoint(MotionOf(0), setup_.path_m[next],
                        {.speed_mps = MunetSpeedFromRpm(setup_.rpm)});
}

void NetworkSwarm::Send(int index, const DueMessage& due, int64_t now_us) {
  const std::vector<uint8_t> bytes =
      SwarmBytes(due, {.own = MotionOf(index),
                       .next = index == 0 ? NextOfLeader() : Motion(),
                       .now_us = now_us,
                       .state = ReceiverOf(index).state});
  std::vector<Eigen::Vector3d> positions_m;
  for (const MunetAuv& each : auvs_) positions_m.push_back(each.position_m());
  std::vector<int> all(auvs_.size());
  std::iota(all.begin(), all.end(), 0);
  water_.Transmit(Seconds(now_us), index, positions_m, bytes, all);
  const AcousticChannel& channel = water_.plan().channel(water_.plan().SendsOn(index));
  events_.push_back(
      {.is_send = true, .utime = now_us, .id = index + 1, .channel = channel.id, .bytes = bytes});
}

void NetworkSwarm::Ping(int index) {
  const Remus100State& own = auv(index).state;
  std::vector<SonarTarget> others;
  for (int i = 0; i < num_members(); ++i) {
    if (i != index) others.push_back({.position_m = auv(i).position_m()});
  }
  std::vector<SonarBeam> beams(sonar_.beam_count());
  sonar_.Ping({own.eta.head<3>(), own.eta[3], own.eta[4], own.eta[5]},
              {.floor = floor_, .vehicles = others}, step_, beams);
  std::vector<SonarEcho>& echoes = echoes_[static_cast<size_t>(index)];
  echoes.clear();
  for (const SonarBeam& beam : beams) {
    if (!beam.is_echo) continue;
    echoes.push_back({.direction = beam.direction, .range_m = beam.range_m});
    nearest_echo_m_ = std::min(nearest_echo_m_, beam.range_m);
  }
}

void NetworkSwarm::Decide(int index, int64_t now_us) {
  MunetAuv& own = auvs_[static_cast<size_t>(index)];
  if (index == 0) {
    own.DecideOnPath();
    return;
  }
  const Others others = Expect(index, now_us);
  own.DecideOnTarget({.own = own.AsNeighbour(index + 1),
                      .target = Neighbour{1, others.target.position_m, others.target.velocity_mps},
                      .group = others.group,
                      .sonar = echoes_[static_cast<size_t>(index)],
                      .seabed_z_m = setup_.floor_z_m});
}

void NetworkSwarm::Deliver(int64_t now_us) {
  for (const Reception& arrived : water_.Deliver(Seconds(now_us))) {
    if (!HandsOver(arrived.fate)) continue;
    const int index = arrived.receiver;
    events_.push_back({.utime = now_us,
                       .id = index + 1,
                       .channel = water_.plan().channel(arrived.channel).id,
                       .bytes = {arrived.bytes.begin(), arrived.bytes.end()}});
    SwarmReceiver& receiver = receivers_[static_cast<size_t>(index)];
    const std::optional<ResponseRequest> before = receiver.state.request;
    const SwarmReception reception = Receive(arrived.bytes, now_us, &receiver);
    if (reception.result == ReceptionResult::kRejected) continue;
    const std::optional<ResponseRequest>& request = receiver.state.request;
    if (request && request != before) schedules_[static_cast<size_t>(index)].Take(*request);
    OnReception(index, reception, now_us);
  }
}

std::vector<Eigen::Vector3d> PositionsIn(const std::vector<uint8_t>& bytes) {
  std::vector<Eigen::Vector3d> positions_m;
  const auto add = [&](const Eigen::Vector3f& position_m) {
    positions_m.push_back(position_m.cast<double>());
  };
  const auto tell_leader = [&](const LeaderMotion& leader) {
    add(leader.position_m);
    add(leader.next_position_m);
  };
  const std::optional<AnySwarmMessage> message = DecodeAnyMessage(bytes);
  if (!message) return positions_m;
  if (const auto* report = std::get_if<ReportMessage>(&*message)) {
    add(report->position_m);
  } else if (const auto* leader = std::get_if<LeaderMessage>(&*message)) {
    tell_leader(leader->leader);
  } else if (const auto* broadcast = std::get_if<BroadcastMessage>(&*message)) {
    tell_leader(broadcast->leader);
    for (const BroadcastFollower& follower : broadcast->followers) add(follower.position_m);
  }
  return positions_m;
}

}  // namespace shoal

#include "lib/comms/swarm/recovery.h"

#include <algorithm>
#include <bit>

#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/schedule_repair.h"

namespace shoal {

namespace {

double SecondsOf(int64_t time_us) { return static_cast<double>(time_us) * 1e-6; }

const SwarmContact* ContactOf(const FieldSubject& subject, const GroupState& state) {
  if (subject.is_leader) return state.target ? &*state.target : nullptr;
  return subject.id ? FindMember(state, *subject.id) : nullptr;
}

std::optional<FieldValue> IfPlausible(const Eigen::Vector3d& vector, bool is_position,
                                      const FieldLimits& limits) {
  const std::span<const double> numbers(vector.data(), 3);
  const FieldFault fault =
      is_position ? CheckPosition(numbers, limits) : CheckVelocity(numbers, limits);
  if (fault != FieldFault::kNone) return std::nullopt;
  return vector;
}

std::optional<FieldValue> IfPlausible(int64_t time_us, const FieldLimits& limits) {
  const double time_s = SecondsOf(time_us);
  if (CheckTimeStamp(time_s, std::nullopt, limits) != FieldFault::kNone) return std::nullopt;
  return time_s;
}

/// The member that has been silent longest.
std::optional<FieldValue> PredictReporter(const GroupState& state) {
  const auto silent =
      std::min_element(state.members.begin(), state.members.end(),
                       [](const auto& a, const auto& b) { return a.reported_us < b.reported_us; });
  if (silent == state.members.end()) return std::nullopt;
  return int64_t{silent->id};
}

std::optional<FieldValue> PredictTime(const SwarmContact* contact, const RecoverySources& sources) {
  const int64_t episode_us = sources.state.episode_us;
  if (!contact || contact->log.entries.empty()) {
    return IfPlausible(std::max<int64_t>(0, sources.now_us - episode_us / 2), sources.limits);
  }
  const std::vector<TimedMotion> last = LastEntries(contact->log, 2);
  const int64_t period_us =
      last.size() == 2 ? last.back().time_us - last.front().time_us : episode_us;
  return IfPlausible(last.back().time_us + period_us, sources.limits);
}

/// Constant velocity since the last entry of the log.
std::optional<FieldValue> PredictPosition(const SwarmContact* contact,
                                          const RecoverySources& sources) {
  if (!contact || contact->log.entries.empty()) return std::nullopt;
  const TimedMotion& last = contact->log.entries.back();
  const double elapsed_s = SecondsOf(std::max<int64_t>(0, sources.now_us - last.time_us));
  return IfPlausible(PredictMember(last.motion, elapsed_s).position_m, true, sources.limits);
}

/// Constant acceleration, as between the last two entries of the log.
std::optional<FieldValue> PredictVelocity(const SwarmContact* contact,
                                          const RecoverySources& sources) {
  if (!contact || contact->log.entries.size() < 2) return std::nullopt;
  const std::vector<TimedMotion> last = LastEntries(contact->log, 2);
  const double between_s = SecondsOf(last[1].time_us - last[0].time_us);
  if (between_s <= 0) return std::nullopt;
  const double elapsed_s = SecondsOf(std::max<int64_t>(0, sources.now_us - last[1].time_us));
  const Eigen::Vector3d& velocity_mps = last[1].motion.velocity_mps;
  const Eigen::Vector3d change_mps = velocity_mps - last[0].motion.velocity_mps;
  return IfPlausible(velocity_mps + change_mps * (elapsed_s / between_s), false, sources.limits);
}

std::optional<FieldValue> Predict(const DamagedField& damaged, const RecoverySources& sources) {
  const GroupState& state = sources.state;
  const SwarmContact* contact = ContactOf(damaged.subject, state);
  switch (damaged.field) {
    case SwarmField::kType:
      return NearestFlag(std::get<MessageFlag>(damaged.value));
    case SwarmField::kGroupId:
      return state.group_id;
    case SwarmField::kReporterId:
      return PredictReporter(state);
    case SwarmField::kReporterPos:
    case SwarmField::kLeaderPos:
    case SwarmField::kFollowersPos:
      return PredictPosition(contact, sources);
    case SwarmField::kReporterVel:
    case SwarmField::kLeaderVel:
    case SwarmField::kFollowersVel:
      return PredictVelocity(contact, sources);
    case SwarmField::kTimeStamp:
    case SwarmField::kFollowersRspn:
      return PredictTime(contact, sources);
    case SwarmField::kNumFollowers: {
      const auto number = static_cast<int64_t>(state.members.size()) + (state.is_leader ? 0 : 1);
      if (CheckNumFollowers(number, sources.limits) != FieldFault::kNone) return std::nullopt;
      return number;
    }
    case SwarmField::kRspnSched:
      return RepairSchedule(std::get<std::vector<int64_t>>(damaged.value), state.response_order);
    case SwarmField::kRspnStart:
      if (state.response_start_us == 0 || state.episode_us == 0) return std::nullopt;
      return IfPlausible(state.response_start_us + state.episode_us, sources.limits);
    case SwarmField::kLeaderNextPos:
    case SwarmField::kLeaderNextVel:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<FieldValue> Previous(const DamagedField& damaged, const RecoverySources& sources) {
  const GroupState& state = sources.state;
  const FieldLimits& limits = sources.limits;
  const SwarmContact* contact = ContactOf(damaged.subject, state);
  const SwarmContact* target = state.target ? &*state.target : nullptr;
  if (contact && !contact->is_known) contact = nullptr;
  if (target && !target->is_known) target = nullptr;
  switch (damaged.field) {
    case SwarmField::kType:
    case SwarmField::kReporterId:
    case SwarmField::kNumFollowers:
      return std::nullopt;
    case SwarmField::kGroupId:
      if (contact) return contact->group_id;
      if (damaged.subject.id || !target) return std::nullopt;
      return target->group_id;
    case SwarmField::kReporterPos:
    case SwarmField::kLeaderPos:
    case SwarmField::kFollowersPos:
      if (!contact) return std::nullopt;
      return IfPlausible(contact->report.now.position_m, true, limits);
    case SwarmField::kReporterVel:
    case SwarmField::kLeaderVel:
    case SwarmField::kFollowersVel:
      if (!contact) return std::nullopt;
      return IfPlausible(contact->report.now.velocity_mps, false, limits);
    case SwarmField::kTimeStamp:
    case SwarmField::kFollowersRspn:
      if (!contact) return std::nullopt;
      return IfPlausible(contact->reported_us, limits);
    case SwarmField::kLeaderNextPos:
      if (!target) return std::nullopt;
      return IfPlausible(target->report.next.position_m, true, limits);
    case SwarmField::kLeaderNextVel:
      if (!target) return std::nullopt;
      return IfPlausible(target->report.next.velocity_mps, false, limits);
    case SwarmField::kRspnSched:
      if (state.response_order.empty()) return std::nullopt;
      return state.response_order;
    case SwarmField::kRspnStart:
      return IfPlausible(state.response_start_us, limits);
  }
  return std::nullopt;
}

/// muNet's numbering: the leader is 1, its followers 2 to N + 1.
std::vector<int64_t> NeutralSchedule(size_t num_followers) {
  std::vector<int64_t> ids(num_followers);
  for (size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<int64_t>(i) + 2;
  return ids;
}

FieldValue Neutral(const DamagedField& damaged, const RecoverySources& sources) {
  switch (damaged.field) {
    case SwarmField::kType:
      return MessageFlag{'0', '0', '0', '0'};
    case SwarmField::kGroupId:
      return uint8_t{'0'};
    case SwarmField::kReporterId:
      return int64_t{0};
    case SwarmField::kNumFollowers:
      return int64_t{1};
    case SwarmField::kTimeStamp:
    case SwarmField::kFollowersRspn:
    case SwarmField::kRspnStart:
      return SecondsOf(sources.now_us);
    case SwarmField::kRspnSched:
      return NeutralSchedule(std::get<std::vector<int64_t>>(damaged.value).size());
    case SwarmField::kReporterPos:
    case SwarmField::kLeaderPos:
    case SwarmField::kLeaderNextPos:
    case SwarmField::kFollowersPos:
      return sources.state.neutral.position_m;
    default:
      return sources.state.neutral.velocity_mps;
  }
}

FieldValue Sentinel(const DamagedField& damaged, const SentinelValues& sentinel) {
  constexpr auto kByte = static_cast<char>(0xFF);
  switch (damaged.field) {
    case SwarmField::kType:
      return MessageFlag{kByte, kByte, kByte, kByte};
    case SwarmField::kGroupId:
      return uint8_t{0xFF};
    case SwarmField::kReporterId:
    case SwarmField::kNumFollowers:
      return int64_t{-1};
    case SwarmField::kTimeStamp:
    case SwarmField::kFollowersRspn:
    case SwarmField::kRspnStart:
      return kSentinelTime_s;
    case SwarmField::kRspnSched:
      return std::vector<int64_t>(std::get<std::vector<int64_t>>(damaged.value).size(), -1);
    case SwarmField::kReporterPos:
    case SwarmField::kLeaderPos:
    case SwarmField::kLeaderNextPos:
    case SwarmField::kFollowersPos:
      return Eigen::Vector3d(Eigen::Vector3d::Constant(sentinel.position_m));
    default:
      return Eigen::Vector3d(Eigen::Vector3d::Constant(sentinel.speed_mps));
  }
}

}  // namespace

std::array<RecoveryOrder, kNumSwarmFields> RecoveryPlan::MuNetOrders() {
  using enum RecoveryStrategy;
  const RecoveryOrder known = {kPredict, kPrevious};
  const RecoveryOrder any = {kPredict, kPrevious, kNeutral};
  return {RecoveryOrder{kPredict},             // type
          known,                               // group_id
          RecoveryOrder{kPredict},             // reporter_id
          known,                               // reporter_pos
          any,                                 // reporter_vel
          any,                                 // time_stamp
          known,                               // leader_pos
          any,                                 // leader_vel
          RecoveryOrder{kPrevious},            // leader_next_pos
          RecoveryOrder{kPrevious, kNeutral},  // leader_next_vel
          RecoveryOrder{kSkip},                // num_followers
          known,                               // followers_pos
          any,                                 // followers_vel
          any,                                 // followers_rspn
          any,                                 // rspn_sched
          any};                                // rspn_start
}

std::optional<MessageFlag> NearestFlag(const MessageFlag& flag) {
  std::optional<MessageFlag> nearest;
  int fewest_bits = kFlagDistanceLimit_bits;
  for (const MessageFlag& known : {kReportFlag, kResponseFlag, kLeaderReportFlag, kBroadcastFlag}) {
    int bits = 0;
    for (size_t i = 0; i < flag.size(); ++i) {
      bits += std::popcount(static_cast<uint8_t>(flag[i] ^ known[i]));
    }
    if (bits >= fewest_bits) continue;
    fewest_bits = bits;
    nearest = known;
  }
  return nearest;
}

std::optional<FieldValue> RecoverBy(RecoveryStrategy strategy, const DamagedField& damaged,
                                    const RecoverySources& sources) {
  switch (strategy) {
    case RecoveryStrategy::kPredict:
      return Predict(damaged, sources);
    case RecoveryStrategy::kPrevious:
      return Previous(damaged, sources);
    case RecoveryStrategy::kNeutral:
      return Neutral(damaged, sources);
    case RecoveryStrategy::kSentinel:
      return Sentinel(damaged, sources.state.sentinel);
    case RecoveryStrategy::kSkipField:
      return damaged.value;
    case RecoveryStrategy::kSkip:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<RecoveredField> Recover(const RecoveryPlan& plan, const DamagedField& damaged,
                                      const RecoverySources& sources) {
  for (const RecoveryStrategy strategy : plan.of(damaged.field)) {
    if (strategy == RecoveryStrategy::kSkip) return std::nullopt;
    if (auto value = RecoverBy(strategy, damaged, sources)) {
      return RecoveredField{.value = *std::move(value), .strategy = strategy};
    }
  }
  return std::nullopt;
}

}  // namespace shoal

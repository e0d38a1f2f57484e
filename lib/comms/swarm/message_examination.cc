#include "lib/comms/swarm/message_examination.h"

#include <algorithm>

#include "lib/base/codec/little_endian.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal {

namespace {

/// A field as it is to be used.
template <class Value>
struct TakenField {
  Value value = {};
  bool is_left_out = false;  ///< By skip_field; `value` is what came.
};

std::span<const double> NumbersOf(const Eigen::Vector3d& vector) { return {vector.data(), 3}; }

template <class Value>
std::optional<Value> ValueOf(const TakenField<Value>& taken) {
  if (taken.is_left_out) return std::nullopt;
  return taken.value;
}

/// Reads one message against what is known, and changes nothing but `reception`.
class Examination {
 public:
  Examination(const SwarmReceiver& receiver, int64_t now_us, SwarmReception* reception)
      : receiver_(receiver),
        state_(receiver.state),
        now_us_(now_us),
        recover_at_us_(now_us),
        reception_(reception) {}

  /// Returns what to change; nothing where the message is rejected, `reception` holds the reason.
  std::optional<PendingUpdate> Examine(std::span<const uint8_t> message) {
    if (message.size() < std::tuple_size_v<MessageFlag>) {
      return Reject<PendingUpdate>(RejectReason::kTooShort);
    }
    MessageFlag raw;
    std::transform(message.begin(), message.begin() + raw.size(), raw.begin(),
                   [](uint8_t byte) { return static_cast<char>(byte); });
    const auto flag = Take(SwarmField::kType, CheckType(message.first(raw.size())), raw, {});
    if (!flag) return std::nullopt;
    std::vector<uint8_t> bytes(message.begin(), message.end());
    std::copy(flag->value.begin(), flag->value.end(), bytes.begin());
    if (CheckType(std::span(bytes).first(raw.size())) != FieldFault::kNone) {
      return Unrecoverable<PendingUpdate>(SwarmField::kType, FieldFault::kUnknownType);
    }
    reception_->flag = flag->value;
    if (flag->value == kLeaderReportFlag) return ExamineLeader(bytes);
    if (flag->value == kBroadcastFlag) return ExamineBroadcast(std::move(bytes));
    return ExamineReport(bytes);
  }

 private:
  template <class Result>
  std::optional<Result> Reject(RejectReason reason) {
    reception_->reason = reason;
    return std::nullopt;
  }

  template <class Result>
  std::optional<Result> Unrecoverable(SwarmField field, FieldFault fault) {
    reception_->field = field;
    reception_->fault = fault;
    return Reject<Result>(RejectReason::kUnrecoverable);
  }

  /// Returns the value itself if nothing is wrong with it, else what the plan makes of it.
  template <class Value>
  std::optional<TakenField<Value>> Take(SwarmField field, FieldFault fault, const Value& value,
                                        const FieldSubject& subject) {
    if (fault == FieldFault::kNone) return TakenField<Value>{.value = value};
    const auto recovered = Recover(receiver_.plan, {field, value, subject},
                                   {state_, receiver_.limits, recover_at_us_});
    if (!recovered) return Unrecoverable<TakenField<Value>>(field, fault);
    reception_->recoveries.push_back(
        {.field = field, .fault = fault, .strategy = recovered->strategy, .id = subject.id});
    return TakenField<Value>{.value = std::get<Value>(recovered->value),
                             .is_left_out = recovered->strategy == RecoveryStrategy::kSkipField};
  }

  std::optional<TakenField<Eigen::Vector3d>> TakePosition(SwarmField field,
                                                          const Eigen::Vector3f& wire_m,
                                                          const FieldSubject& subject) {
    const Eigen::Vector3d position_m = wire_m.cast<double>();
    return Take(field, CheckPosition(NumbersOf(position_m), receiver_.limits), position_m, subject);
  }

  std::optional<TakenField<Eigen::Vector3d>> TakeVelocity(SwarmField field,
                                                          const Eigen::Vector3f& wire_mps,
                                                          const FieldSubject& subject) {
    const Eigen::Vector3d velocity_mps = wire_mps.cast<double>();
    return Take(field, CheckVelocity(NumbersOf(velocity_mps), receiver_.limits), velocity_mps,
                subject);
  }

  /// Positions and velocities that are checked after this hold at this time, if it is valid.
  std::optional<TakenField<double>> TakeTime(SwarmField field, float time_s,
                                             const FieldSubject& subject) {
    const auto fault = CheckTimeStamp(time_s, now_us_, receiver_.limits);
    recover_at_us_ = now_us_;
    const auto taken = Take(field, fault, static_cast<double>(time_s), subject);
    if (fault == FieldFault::kNone) recover_at_us_ = Microseconds(time_s);
    return taken;
  }

  /// Returns whether the message is one of this vehicle's group.
  bool IsOfGroup(uint8_t group_id, const FieldSubject& subject) {
    const auto taken =
        Take(SwarmField::kGroupId, CheckGroupId(std::span(&group_id, 1)), group_id, subject);
    if (!taken) return false;
    if (taken->value == state_.group_id) return true;
    reception_->reason = RejectReason::kOtherGroup;
    return false;
  }

  std::optional<PendingUpdate> ExamineReport(std::span<const uint8_t> bytes) {
    const auto report = DecodeReport(bytes);
    if (!report || bytes.size() != kReportBytes) {
      return Reject<PendingUpdate>(RejectReason::kWrongLength);
    }
    const auto raw_id = int64_t{report->reporter_id};
    const FieldFault fault = CheckReporterId(raw_id, state_.own_id, receiver_.limits);
    if (fault == FieldFault::kOwnId) return Reject<PendingUpdate>(RejectReason::kOwnReport);
    const auto id = Take(SwarmField::kReporterId, fault, raw_id, {});
    if (!id) return std::nullopt;
    const FieldSubject subject{.id = id->value};
    if (!IsOfGroup(report->group_id, subject)) return std::nullopt;
    const SwarmContact* member = FindMember(state_, id->value);
    if (!member) return Reject<PendingUpdate>(RejectReason::kUnknownReporter);
    reception_->sender = id->value;

    const auto time_s = TakeTime(SwarmField::kTimeStamp, report->time_stamp_s, subject);
    if (!time_s) return std::nullopt;
    const auto position_m = TakePosition(SwarmField::kReporterPos, report->position_m, subject);
    if (!position_m) return std::nullopt;
    const auto velocity_mps = TakeVelocity(SwarmField::kReporterVel, report->velocity_mps, subject);
    if (!velocity_mps) return std::nullopt;
    PendingUpdate update{.reporter = id->value,
                         .report = {.position_m = ValueOf(*position_m),
                                    .velocity_mps = ValueOf(*velocity_mps),
                                    .time_s = ValueOf(*time_s)}};
    if (IsOutdated(update.report, *member)) return Reject<PendingUpdate>(RejectReason::kOutdated);
    return update;
  }

  /// Checks what LEADER-REPORT and BROADCAST/REQUEST have in common.
  std::optional<PendingReport> TakeLeader(uint8_t group_id, const LeaderMotion& leader,
                                          float time_stamp_s) {
    const FieldSubject subject{.is_leader = true};
    if (!IsOfGroup(group_id, subject)) return std::nullopt;
    if (!state_.target) return Reject<PendingReport>(RejectReason::kNoLeader);
    reception_->sender = int64_t{state_.target->id};
    const auto time_s = TakeTime(SwarmField::kTimeStamp, time_stamp_s, subject);
    if (!time_s) return std::nullopt;
    const auto position_m = TakePosition(SwarmField::kLeaderPos, leader.position_m, subject);
    if (!position_m) return std::nullopt;
    const auto velocity_mps = TakeVelocity(SwarmField::kLeaderVel, leader.velocity_mps, subject);
    if (!velocity_mps) return std::nullopt;
    const auto next_m = TakePosition(SwarmField::kLeaderNextPos, leader.next_position_m, subject);
    if (!next_m) return std::nullopt;
    const auto next_mps =
        TakeVelocity(SwarmField::kLeaderNextVel, leader.next_velocity_mps, subject);
    if (!next_mps) return std::nullopt;
    const PendingReport report{.position_m = ValueOf(*position_m),
                               .velocity_mps = ValueOf(*velocity_mps),
                               .next_position_m = ValueOf(*next_m),
                               .next_velocity_mps = ValueOf(*next_mps),
                               .time_s = ValueOf(*time_s)};
    if (IsOutdated(report, *state_.target)) return Reject<PendingReport>(RejectReason::kOutdated);
    return report;
  }

  std::optional<PendingUpdate> ExamineLeader(std::span<const uint8_t> bytes) {
    const auto message = DecodeLeaderReport(bytes);
    if (!message || bytes.size() != kLeaderReportBytes) {
      return Reject<PendingUpdate>(RejectReason::kWrongLength);
    }
    auto report = TakeLeader(message->group_id, message->leader, message->time_stamp_s);
    if (!report) return std::nullopt;
    return PendingUpdate{.report = *report};
  }

  /// Corrects the number that all later offsets depend on; the length of the message gives it.
  bool RecoverNumFollowers(std::vector<uint8_t>* bytes) {
    const std::span<const uint8_t> at_number = std::span(*bytes).subspan(kNumFollowersOffset);
    const auto raw = int64_t{LittleEndianReader(at_number).Take<uint32_t>()};
    FieldFault fault = CheckNumFollowers(raw, receiver_.limits);
    const auto fits = [&](int64_t number) {
      return number >= 0 && BroadcastBytes(static_cast<uint64_t>(number)) == bytes->size();
    };
    if (fault == FieldFault::kNone && !fits(raw)) fault = FieldFault::kWrongLength;
    const auto number = Take(SwarmField::kNumFollowers, fault, raw, {.is_leader = true});
    if (!number) return false;
    if (!fits(number->value)) {
      reception_->reason = RejectReason::kWrongLength;
      return false;
    }
    std::vector<uint8_t> digits;
    AppendLittleEndian(static_cast<uint32_t>(number->value), &digits);
    std::copy(digits.begin(), digits.end(),
              bytes->begin() + static_cast<std::ptrdiff_t>(kNumFollowersOffset));
    return true;
  }

  std::optional<PendingUpdate> ExamineBroadcast(std::vector<uint8_t> bytes) {
    if (bytes.size() < BroadcastBytes(0)) return Reject<PendingUpdate>(RejectReason::kWrongLength);
    if (!RecoverNumFollowers(&bytes)) return std::nullopt;
    const auto message = DecodeBroadcast(bytes);
    if (!message) return Reject<PendingUpdate>(RejectReason::kWrongLength);
    const auto leader = TakeLeader(message->group_id, message->leader, message->time_stamp_s);
    if (!leader) return std::nullopt;

    PendingUpdate update{.report = *leader, .is_request = true};
    recover_at_us_ = now_us_;
    std::vector<int64_t> ids;
    for (const BroadcastFollower& follower : message->followers) ids.push_back(follower.id);
    const auto order =
        Take(SwarmField::kRspnSched, CheckSchedule(ids, state_.own_id, receiver_.limits), ids, {});
    if (!order) return std::nullopt;
    if (order->value.size() != ids.size()) {
      return Unrecoverable<PendingUpdate>(SwarmField::kRspnSched, FieldFault::kWrongLength);
    }
    update.order = order->value;
    update.is_order_known =
        !order->is_left_out && !order->value.empty() && order->value.front() > 0;
    const auto start_s = double{message->response_start_s};
    const auto start = Take(SwarmField::kRspnStart,
                            CheckResponseStart(start_s, now_us_, receiver_.limits), start_s, {});
    if (!start) return std::nullopt;
    update.start_s = ValueOf(*start);
    for (size_t i = 0; i < message->followers.size(); ++i) {
      if (!TakeFollower(message->followers[i], update.order[i], &update)) {
        return std::nullopt;
      }
    }
    return update;
  }

  /// Checks what the leader reports of a member. What it reports of the receiver, of ids outside
  /// the group and of members that it never received from is not used. Returns false to reject the
  /// message.
  bool TakeFollower(const BroadcastFollower& follower, int64_t id, PendingUpdate* update) {
    if (!FindMember(state_, id) || follower.reported_s == 0) return true;
    const FieldSubject subject{.id = id};
    const auto time_s = TakeTime(SwarmField::kFollowersRspn, follower.reported_s, subject);
    if (!time_s) return false;
    const auto position_m = TakePosition(SwarmField::kFollowersPos, follower.position_m, subject);
    if (!position_m) return false;
    const auto velocity_mps =
        TakeVelocity(SwarmField::kFollowersVel, follower.velocity_mps, subject);
    if (!velocity_mps) return false;
    const PendingReport report{.position_m = ValueOf(*position_m),
                               .velocity_mps = ValueOf(*velocity_mps),
                               .time_s = ValueOf(*time_s)};
    update->followers.emplace_back(id, report);
    return true;
  }

  const SwarmReceiver& receiver_;
  const GroupState& state_;
  int64_t now_us_;
  int64_t recover_at_us_;  ///< When the values of the message held, as far as that is known.
  SwarmReception* reception_;
};

}  // namespace

std::optional<PendingUpdate> ExamineMessage(std::span<const uint8_t> message, int64_t now_us,
                                            const SwarmReceiver& receiver,
                                            SwarmReception* reception) {
  return Examination(receiver, now_us, reception).Examine(message);
}

}  // namespace shoal

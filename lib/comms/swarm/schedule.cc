#include "lib/comms/swarm/schedule.h"

#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

bool IsLength(int64_t length_us) {
  return length_us >= 0 && length_us <= SwarmSchedule::kLatestSlot_us;
}

SwarmMessage MessageOf(SwarmScheme scheme, bool is_leader) {
  if (!is_leader) return SwarmMessage::kReport;
  return scheme == SwarmScheme::kTdmaLf ? SwarmMessage::kBroadcastRequest
                                        : SwarmMessage::kLeaderReport;
}

}  // namespace

SwarmSchedule::SwarmSchedule(const SlotPlan& plan, const SwarmPlace& place)
    : plan_(plan), place_(place), first_us_(0) {
  SHOAL_CHECK(plan.tick_us > 0 && IsLength(plan.tick_us), "tick_us is from 1 to kLatestSlot_us");
  SHOAL_CHECK(plan.episode_us > 0 && IsLength(plan.episode_us),
              "episode_us is from 1 to kLatestSlot_us");
  if (plan.scheme == SwarmScheme::kTdmaLf) {
    SHOAL_CHECK(plan.response_us > 0 && IsLength(plan.response_us),
                "response_us is from 1 to kLatestSlot_us");
    SHOAL_CHECK(IsLength(plan.broadcast_us), "broadcast_us is from 0 to kLatestSlot_us");
    return;
  }
  SHOAL_CHECK(IsLength(plan.offset_us), "offset_us is from 0 to kLatestSlot_us");
  SHOAL_CHECK(
      place.place >= 0 && (plan.offset_us == 0 || place.place <= kLatestSlot_us / plan.offset_us),
      "place * offset_us is from 0 to kLatestSlot_us");
  first_us_ = plan.offset_us * place.place;
}

std::optional<DueMessage> SwarmSchedule::Due(int64_t utime) {
  return IsAsked() ? DueAnswer(utime) : DueByItself(utime);
}

std::optional<DueMessage> SwarmSchedule::DueByItself(int64_t utime) {
  if (utime < first_us_) return std::nullopt;
  const int64_t slot_us = utime - (utime - first_us_) % plan_.episode_us;
  if (utime - slot_us >= plan_.tick_us) return std::nullopt;  // It was sent one step ago or before.
  if (last_slot_us_ && slot_us <= *last_slot_us_) return std::nullopt;
  last_slot_us_ = slot_us;
  DueMessage due{.message = MessageOf(plan_.scheme, place_.is_leader), .slot_us = slot_us};
  if (due.message == SwarmMessage::kBroadcastRequest) {
    due.response_start_us = slot_us + plan_.broadcast_us;
  }
  return due;
}

std::optional<DueMessage> SwarmSchedule::DueAnswer(int64_t utime) {
  if (!asked_us_ || utime < *asked_us_) return std::nullopt;
  const int64_t slot_us = *std::exchange(asked_us_, std::nullopt);
  const int64_t late_us = utime - slot_us;
  if (late_us >= plan_.tick_us && late_us >= plan_.answer_window_us) {
    ++num_missed_;
    return std::nullopt;
  }
  last_slot_us_ = slot_us;
  return DueMessage{.message = SwarmMessage::kResponse, .slot_us = slot_us};
}

void SwarmSchedule::Take(const ResponseRequest& request) {
  if (!IsAsked() || request.start_us < 0 || request.start_us > kLatestSlot_us) return;
  if (request.slot < 0 || request.slot > kLatestSlot_us / plan_.response_us) return;
  const int64_t start_step = (request.start_us + plan_.tick_us / 2) / plan_.tick_us;
  const int64_t slot_us = start_step * plan_.tick_us + request.slot * plan_.response_us;
  if (last_slot_us_ && slot_us <= *last_slot_us_) return;
  if (asked_us_ && *asked_us_ != slot_us) ++num_missed_;
  asked_us_ = slot_us;
}

}  // namespace shoal

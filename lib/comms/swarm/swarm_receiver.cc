#include "lib/comms/swarm/swarm_receiver.h"

#include <algorithm>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/message_examination.h"

namespace shoal {

namespace {

constexpr EnumTable<RejectReason, std::string_view> kReasonTexts = {
    "nothing",
    "checksum is wrong",
    "shorter than a flag",
    "not the length of its type",
    "damaged beyond recovery",
    "sent by this vehicle itself",
    "of another group",
    "sender is not a member of the group",
    "this vehicle follows no leader",
    "older than what is known",
};

void TakeRequest(const PendingUpdate& update, GroupState* state) {
  state->request.reset();
  if (update.is_order_known) state->response_order = update.order;
  if (!update.start_s || *update.start_s < 0) return;
  state->response_start_us = Microseconds(*update.start_s);
  const auto own = std::find(update.order.begin(), update.order.end(), int64_t{state->own_id});
  if (own == update.order.end()) return;
  state->request = {.start_us = state->response_start_us,
                    .slot = static_cast<int>(own - update.order.begin())};
}

void ApplyUpdate(const PendingUpdate& update, int64_t now_us, GroupState* state) {
  if (update.reporter) {
    SwarmContact* reporter = FindMember(state, *update.reporter);
    ApplyReport(update.report, false, now_us, reporter);
    reporter->has_answered = true;
    return;
  }
  ApplyReport(update.report, true, now_us, &*state->target);
  for (const auto& [id, report] : update.followers) {
    SwarmContact* member = FindMember(state, id);
    // The vehicle may have received from the member itself, or the message may name it twice.
    if (!IsOutdated(report, *member)) ApplyReport(report, false, now_us, member);
  }
  if (update.is_request) TakeRequest(update, state);
}

void CountReception(const SwarmReception& reception, ReceptionCounts* counts) {
  switch (reception.result) {
    case ReceptionResult::kClean:
      ++counts->clean;
      return;
    case ReceptionResult::kRecovered:
      ++counts->recovered;
      for (const FieldRecovery& recovery : reception.recoveries) {
        ++counts->recovered_by[static_cast<size_t>(recovery.field)]
                              [static_cast<size_t>(recovery.strategy)];
      }
      return;
    case ReceptionResult::kRejected:
      ++counts->rejected;
      ++counts->rejected_for[static_cast<size_t>(reception.reason)];
      if (reception.field) ++counts->unrecoverable[static_cast<size_t>(*reception.field)];
      return;
  }
}

}  // namespace

std::string_view TextOf(RejectReason reason) { return kReasonTexts[reason]; }

SwarmReception Receive(std::span<const uint8_t> bytes, int64_t now_us, SwarmReceiver* receiver) {
  SwarmReception reception;
  std::optional<OpenedFrame> frame;
  if (receiver->has_frames) frame = OpenFrame(bytes);
  if (receiver->has_frames && !frame) {
    reception.reason = RejectReason::kBadFrame;
  } else {
    const auto message = frame ? frame->message : bytes;
    const auto update = ExamineMessage(message, now_us, *receiver, &reception);
    if (update) {
      ApplyUpdate(*update, now_us, &receiver->state);
      reception.result =
          reception.recoveries.empty() ? ReceptionResult::kClean : ReceptionResult::kRecovered;
    }
  }
  ReceptionCounts& counts = receiver->counts;
  ++counts.received;
  CountReception(reception, &counts);
  if (frame && reception.sender) {
    CountFrame(frame->sequence, &counts.frames[static_cast<uint32_t>(*reception.sender)]);
  }
  return reception;
}

}  // namespace shoal

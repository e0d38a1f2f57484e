// Bytes from the water, whatever they are: parsers, validation and recovery must neither crash nor
// let a number in that is none.
//
// An input is one byte of choices (bit 0: frames; bit 1: the vehicle leads; bits 2 to 4: muNet's
// plan, or one strategy for every field), then messages, each behind its length, a byte.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "lib/base/check/check.h"
#include "lib/comms/swarm/any_message_testing.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/group_testing.h"

namespace shoal {
namespace {

bool IsFinite(const SwarmContact& contact) {
  const MotionReport& report = contact.report;
  bool is_finite = report.now.position_m.allFinite() && report.now.velocity_mps.allFinite() &&
                   report.next.position_m.allFinite() && report.next.velocity_mps.allFinite();
  for (const TimedMotion& entry : contact.log.entries) {
    is_finite &= entry.motion.position_m.allFinite() && entry.motion.velocity_mps.allFinite();
  }
  return is_finite;
}

bool IsFinite(const GroupState& state) {
  return (!state.target || IsFinite(*state.target)) &&
         std::all_of(state.members.begin(), state.members.end(),
                     [](const SwarmContact& member) { return IsFinite(member); });
}

SwarmReceiver ReceiverOf(uint8_t choices) {
  SwarmReceiver receiver = FollowerThree();
  receiver.has_frames = (choices & 1) != 0;
  if ((choices & 2) != 0) {
    receiver.state.is_leader = true;
    receiver.state.target.reset();
  }
  const size_t plan = (choices >> 2) & 7;
  if (plan > 0 && plan <= kNumRecoveryStrategies) {
    receiver.plan.by_field.fill({static_cast<RecoveryStrategy>(plan - 1)});
  }
  return receiver;
}

void CheckMessage(std::span<const uint8_t> bytes, int64_t now_us, SwarmReceiver* receiver) {
  if (const auto message = DecodeAnyMessage(bytes)) {
    SHOAL_CHECK(message->index() < 3, "one of the three");
  }
  const GroupState before = receiver->state;
  const SwarmReception reception = Receive(bytes, now_us, receiver);
  const bool is_rejected = reception.result == ReceptionResult::kRejected;
  SHOAL_CHECK(!is_rejected || receiver->state == before, "a rejected message changes nothing");
  SHOAL_CHECK(IsFinite(receiver->state), "what is known is finite");
  const ReceptionCounts& counts = receiver->counts;
  SHOAL_CHECK(counts.received == counts.clean + counts.recovered + counts.rejected,
              "each message is counted once");
  for (const SwarmContact& member : receiver->state.members) {
    const auto motion = PredictContact(member, now_us + 3'600'000'000);
    SHOAL_CHECK(!motion || motion->position_m.allFinite(), "predictions are finite");
  }
}

}  // namespace
}  // namespace shoal

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::span<const uint8_t> input(data, size);
  if (input.empty()) return 0;
  shoal::SwarmReceiver receiver = shoal::ReceiverOf(input[0]);
  input = input.subspan(1);
  int64_t now_us = shoal::kTestNow_us;
  while (!input.empty()) {
    const size_t length = std::min<size_t>(input[0], input.size() - 1);
    shoal::CheckMessage(input.subspan(1, length), now_us, &receiver);
    input = input.subspan(1 + length);
    now_us += 1'000'000;
  }
  return 0;
}

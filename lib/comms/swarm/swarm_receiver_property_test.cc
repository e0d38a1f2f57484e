#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "lib/comms/swarm/group_testing.h"

namespace shoal::swarm_receiver_property_test {

bool IsFinite(const Motion& motion) {
  return motion.position_m.allFinite() && motion.velocity_mps.allFinite();
}

bool IsFinite(const SwarmContact& contact) {
  if (!IsFinite(contact.report.now) || !IsFinite(contact.report.next)) return false;
  for (const TimedMotion& entry : contact.log.entries) {
    if (!IsFinite(entry.motion)) return false;
  }
  return true;
}

bool IsFinite(const GroupState& state) {
  if (state.target && !IsFinite(*state.target)) return false;
  for (const SwarmContact& member : state.members) {
    if (!IsFinite(member)) return false;
  }
  return true;
}

/// A message as a vehicle may have sent it, with some of its bits damaged, or cut, or just noise.
std::vector<uint8_t> AnyBytes() {
  std::vector<uint8_t> bytes = *rc::gen::element(
      EncodeReport(ReportOfTwo()), EncodeLeaderReport(ReportOfTheLeader()),
      EncodeBroadcast(RequestToFour()), *rc::gen::arbitrary<std::vector<uint8_t>>());
  const int num_damaged = *rc::gen::element(0, 1, 2, 5, 20);
  for (int i = 0; i < num_damaged && !bytes.empty(); ++i) {
    const auto place = *rc::gen::inRange<size_t>(0, bytes.size());
    bytes[place] = *rc::gen::element<uint8_t>(
        0, 0xFF, 0x7F, static_cast<uint8_t>(bytes[place] ^ (1 << *rc::gen::inRange(0, 8))));
  }
  if (*rc::gen::inRange(0, 10) == 0) bytes.resize(*rc::gen::inRange<size_t>(0, bytes.size() + 2));
  return bytes;
}

RecoveryPlan AnyPlan() {
  RecoveryPlan plan;
  if (*rc::gen::inRange(0, 3) == 0) return plan;
  for (RecoveryOrder& order : plan.by_field) {
    order = {static_cast<RecoveryStrategy>(*rc::gen::inRange(0, 6)),
             static_cast<RecoveryStrategy>(*rc::gen::inRange(0, 6))};
  }
  return plan;
}

RC_GTEST_PROP(SwarmReceiver, IsNotHarmedByAnyBytes, ()) {
  SwarmReceiver receiver = FollowerThree();
  receiver.plan = AnyPlan();
  receiver.has_frames = *rc::gen::inRange(0, 4) == 0;
  int64_t now_us = kTestNow_us;
  for (int i = 0; i < 6; ++i) {
    std::vector<uint8_t> bytes = AnyBytes();
    const bool is_framed = receiver.has_frames && *rc::gen::inRange(0, 4) != 0;
    if (is_framed) bytes = EncodeFrame(bytes, *rc::gen::arbitrary<uint16_t>());
    const GroupState before = receiver.state;
    const SwarmReception reception = Receive(bytes, now_us, &receiver);
    RC_ASSERT(IsFinite(receiver.state));
    RC_ASSERT(receiver.state.members.size() == 3U);
    if (reception.result == ReceptionResult::kRejected) {
      RC_ASSERT(receiver.state == before);
      RC_ASSERT(reception.reason != RejectReason::kNone);
    } else {
      RC_ASSERT((reception.result == ReceptionResult::kClean) == reception.recoveries.empty());
      RC_ASSERT(reception.sender.has_value());
    }
    for (const SwarmContact& member : receiver.state.members) {
      RC_ASSERT(member.reported_us <= now_us);
      const auto motion = PredictContact(member, now_us + 1'000'000'000);
      RC_ASSERT(!motion || IsFinite(*motion));
    }
    now_us += *rc::gen::inRange<int64_t>(0, 5'000'000);
  }
}

RC_GTEST_PROP(SwarmReceiver, CountsEachMessageOnce, ()) {
  SwarmReceiver receiver = FollowerThree();
  receiver.plan = AnyPlan();
  int64_t num_recovered = 0;
  const int num_messages = *rc::gen::inRange(0, 8);
  for (int i = 0; i < num_messages; ++i) {
    const SwarmReception reception = Receive(AnyBytes(), kTestNow_us, &receiver);
    if (reception.result != ReceptionResult::kRecovered) continue;
    num_recovered += std::ssize(reception.recoveries);
  }
  const ReceptionCounts& counts = receiver.counts;
  RC_ASSERT(counts.received == num_messages);
  RC_ASSERT(counts.received == counts.clean + counts.recovered + counts.rejected);
  RC_ASSERT(counts.rejected ==
            std::accumulate(counts.rejected_for.begin(), counts.rejected_for.end(), int64_t{0}));
  int64_t num_counted = 0;
  for (const auto& by_strategy : counts.recovered_by) {
    num_counted += std::accumulate(by_strategy.begin(), by_strategy.end(), int64_t{0});
  }
  RC_ASSERT(num_counted == num_recovered);
}

RC_GTEST_PROP(SwarmReceiver, GivesTheSameForTheSame, ()) {
  SwarmReceiver one = FollowerThree();
  SwarmReceiver other = FollowerThree();
  const std::vector<uint8_t> bytes = AnyBytes();
  Receive(bytes, kTestNow_us, &one);
  Receive(bytes, kTestNow_us, &other);
  RC_ASSERT(one.state == other.state);
  RC_ASSERT(one.counts == other.counts);
}

}  // namespace shoal::swarm_receiver_property_test

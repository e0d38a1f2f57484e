// When a member of a swarm sends an acoustic message, so that messages do not overlap.
//
//   fdma_lf  every member on a channel of its own: the leader its LEADER-REPORT, the others their
//            REPORT, once per episode; place times `offset` after the beginning
//   tdma     the same on one channel: `offset` is the slot of each
//   tdma_lf  the leader its BROADCAST/REQUEST at the beginning of each episode; the followers their
//            RESPONSE, each in the slot that the request gave it
//
//       tdma_lf   | request  ............ | answer 0 | answer 1 | ... | answer n-1 |  | request ...
//                 |<----- broadcast ----->|<-------->| response                    |
//                 |<------------------------- episode --------------------------->|
//
//   SwarmSchedule schedule(plan, {.is_leader = false, .place = 2});
//   if (const auto due = schedule.Due(utime)) Send(due->message);            // in every step
//   schedule.Take(request);                                // tdma_lf: a follower was asked
//
// Times are microseconds since the mission's start, and whole numbers: no rounding adds up over
// episodes. A slot is taken in the first step that is not before it. It depends on the plan
// and the time alone: a process that was started again goes on with its next slot, and a slot in
// which it did not run is left out, never made up for.
#pragma once

#include <cstdint>
#include <optional>

#include "lib/comms/swarm/response_request.h"

namespace shoal {

enum class SwarmScheme : uint8_t { kFdmaLf, kTdma, kTdmaLf };

/// Whole steps each; lib/comms/swarm/slot_timing.h finds and checks them.
struct SlotPlan {
  SwarmScheme scheme = SwarmScheme::kFdmaLf;
  int64_t tick_us = 100'000;       ///< Length of a step.
  int64_t episode_us = 5'000'000;  ///< From a member's message, or the request, to the next.
  int64_t offset_us = 500'000;     ///< fdma_lf, tdma: from one place to the next.
  int64_t broadcast_us = 0;        ///< tdma_lf: from the request to the first slot.
  int64_t response_us = 0;         ///< tdma_lf: of a slot.
  /// tdma_lf: where the request comes late, a RESPONSE may begin less than this after its slot did.
  /// muNet: response_us, so that it runs into the next slot. A step later is always in time.
  int64_t answer_window_us = 0;

  bool operator==(const SlotPlan&) const = default;
};

/// The member that a schedule is for.
struct SwarmPlace {
  bool is_leader = false;
  int64_t place = 0;  ///< fdma_lf, tdma: its first slot begins at place * offset. muNet: its id.
};

enum class SwarmMessage : uint8_t { kReport, kLeaderReport, kBroadcastRequest, kResponse };

struct DueMessage {
  SwarmMessage message = SwarmMessage::kReport;
  int64_t slot_us = 0;            ///< When it should begin; at most one step ago, unless late.
  int64_t response_start_us = 0;  ///< kBroadcastRequest: when slot 0 begins.

  bool operator==(const DueMessage&) const = default;
};

class SwarmSchedule {
 public:
  /// The latest slot, 31 years: longer than any mission.
  static constexpr int64_t kLatestSlot_us = 1'000'000'000'000'000;

  /// @pre tick, episode and, for tdma_lf, response are positive, none is negative; place is at
  /// least 0; nothing is more than kLatestSlot_us.
  SwarmSchedule(const SlotPlan& plan, const SwarmPlace& place);

  /// Returns what has to be sent in the step at `utime`; one message at most. Asked twice for a
  /// step, or for an earlier one, it has nothing more.
  [[nodiscard]] std::optional<DueMessage> Due(int64_t utime);

  /// tdma_lf: a request has come that gives this member a slot. It replaces the one before; one for
  /// a slot that was used already, or that is later than kLatestSlot_us, does nothing. start_us was
  /// a float32 on its way: the nearest step is meant.
  void Take(const ResponseRequest& request);

  /// Slots that it was asked to answer in and did not: the request, or the step, came too late, or
  /// another request came before the slot.
  int64_t num_missed() const { return num_missed_; }

 private:
  [[nodiscard]] bool IsAsked() const {
    return plan_.scheme == SwarmScheme::kTdmaLf && !place_.is_leader;
  }
  std::optional<DueMessage> DueByItself(int64_t utime);
  std::optional<DueMessage> DueAnswer(int64_t utime);

  SlotPlan plan_;
  SwarmPlace place_;
  int64_t first_us_;                     ///< Its first slot, where no request is needed.
  std::optional<int64_t> asked_us_;      ///< The slot to answer in.
  std::optional<int64_t> last_slot_us_;  ///< The slot that was used last.
  int64_t num_missed_ = 0;
};

}  // namespace shoal

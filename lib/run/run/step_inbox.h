// What a participant received, step by step, until it is complete and in the fixed order.
//
//   inbox.Add(channel, datagram, mission_id);          // as datagrams come, in any order, repeated
//   if (inbox.Missing(tick).empty()) for (const Message& m : inbox.Take(tick)) handle(m);
//
// Pure: no bus, no clock.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/seal.h"
#include "shoal/tick_t.hpp"

namespace shoal {

/// Messages of which a tick announced more than came, or fewer.
struct MiscountedMessages {
  std::string publisher;
  std::string channel;
  int32_t expected = 0;
  int32_t received = 0;
};

struct InboxCounters {
  int64_t late = 0;     ///< Repeats of what was already there or of steps gone by; dropped.
  int64_t foreign = 0;  ///< Of another mission; rejected.
  int64_t forged = 0;   ///< Sealed by a program that does not know the mission's secret; refused.
  int64_t no_room = 0;  ///< Sealed messages beyond kMaxSealed or kMaxSealedBytes; refused.
  int64_t outside = 0;  ///< Without a seal; handled, in the step in which they arrived.
  int64_t dropped = 0;  ///< Of those from outside: more than a step holds; not handled.
};

class StepInbox {
 public:
  /// At most this many messages from outside, and this many bytes, are handled in a step; a flood
  /// must not exhaust the memory. Nor overload the bus: what a broker hands on has a seal, and is
  /// asked for again until it is there; 5,000 acks or messages in a step were seen to end missions.
  static constexpr size_t kMaxOutside = 2'000;
  static constexpr size_t kMaxOutsideBytes = size_t{64} * 1024 * 1024;
  /// Sealed messages that wait for their step. A fleet of 1,000 that all report to all publishes a
  /// million per step; a faulty participant must not exhaust the memory either.
  static constexpr size_t kMaxSealed = 2'000'000;
  static constexpr size_t kMaxSealedBytes = size_t{512} * 1024 * 1024;
  /// A participant is never more than one step behind another: this number of steps is kept at
  /// once.
  static constexpr int64_t kMaxSteps = 3;

  /// `wants(channel)` returns whether this participant subscribed to the channel.
  StepInbox(std::function<bool(std::string_view channel)> wants, const MissionSecret& secret);

  /// Makes `step` the first whose messages count: for a participant that joins or restarts in
  /// mid-mission.
  void StartAt(int64_t step);

  /// Stores a datagram as it came off the bus. Returns the step of a sealed message that is new.
  std::optional<int64_t> Add(std::string_view channel, std::span<const uint8_t> datagram,
                             int64_t mission_id);

  /// Returns what is still missing of the step before `tick`.
  [[nodiscard]] std::vector<MiscountedMessages> Missing(const tick_t& tick) const;

  /// Returns the messages of the step before `tick` that exceed the announced counts, which is a
  /// fault of their publisher. (A channel without a total is of a lost publisher, and not a fault.)
  [[nodiscard]] std::vector<MiscountedMessages> Excess(const tick_t& tick) const;

  /// A message with storage of its own.
  struct Stored {
    std::string channel;
    std::string publisher;  ///< Empty: from outside.
    uint32_t sequence = 0;
    size_t size = 0;  ///< Of `data`, once it has been taken too.
    Bytes data;
  };

  /// Takes out the messages of the step before `tick` that its totals name, and all from outside,
  /// in the fixed order: channel, publisher (outside first), sequence. Forgets older steps.
  [[nodiscard]] std::vector<Stored> Take(const tick_t& tick);

  /// Sealed messages that wait for their step.
  size_t num_sealed() const { return num_sealed_; }
  const InboxCounters& counters() const { return counters_; }
  /// The first forged message, as "NAV_ALPHA in the name of vehicle_sim_alpha"; empty: none.
  const std::string& first_forged() const { return first_forged_; }

 private:
  /// What one publisher published in one step.
  struct Published {
    std::map<uint32_t, Stored> by_sequence;
    std::map<std::string, int32_t, std::less<>> num_by_channel;
  };

  int32_t NumReceived(const tick_t& tick, const step_total_t& total) const;
  void ForgetBefore(int64_t step);

  std::function<bool(std::string_view)> wants_;
  const MissionSecret secret_;
  std::map<int64_t, std::map<std::string, Published, std::less<>>> steps_;
  std::vector<Stored> outside_;
  size_t outside_bytes_ = 0;
  size_t num_sealed_ = 0;
  size_t sealed_bytes_ = 0;
  int64_t next_step_ = -1;  ///< Messages of steps before this are late; -1: not known yet.
  std::string first_forged_;
  InboxCounters counters_;
};

}  // namespace shoal

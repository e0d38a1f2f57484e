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
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus.h"
#include "lib/bus/seal.h"
#include "shoal/tick_t.hpp"

namespace shoal {

/// Messages that a tick announced and that did not come.
struct MissingMessages {
  std::string publisher;
  std::string channel;
  int32_t expected = 0;
  int32_t received = 0;
};

struct InboxCounters {
  int64_t late = 0;     ///< Repeats of what was already there or of steps gone by; dropped.
  int64_t foreign = 0;  ///< Of another mission; rejected.
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

  /// `wants(channel)` returns whether this participant subscribed to the channel.
  explicit StepInbox(std::function<bool(std::string_view channel)> wants);

  /// Makes `step` the first whose messages count: for a participant that joins or restarts in
  /// mid-mission.
  void StartAt(int64_t step);

  /// Stores a datagram as it came off the bus.
  void Add(std::string_view channel, std::span<const uint8_t> datagram, int64_t mission_id);

  /// Returns what is still missing of the step before `tick`.
  [[nodiscard]] std::vector<MissingMessages> Missing(const tick_t& tick) const;

  /// A message with storage of its own.
  struct Stored {
    std::string channel;
    std::string publisher;  ///< Empty: from outside.
    uint32_t sequence = 0;
    Bytes data;
  };

  /// Takes out the messages of the step before `tick` that its totals name, and all from outside,
  /// in the fixed order: channel, publisher (outside first), sequence. Forgets older steps.
  [[nodiscard]] std::vector<Stored> Take(const tick_t& tick);

  const InboxCounters& counters() const { return counters_; }

 private:
  /// What one publisher published in one step.
  struct Published {
    std::map<uint32_t, Stored> by_sequence;
    std::map<std::string, int32_t, std::less<>> num_by_channel;
  };

  std::function<bool(std::string_view)> wants_;
  std::map<int64_t, std::map<std::string, Published, std::less<>>> steps_;
  std::vector<Stored> outside_;
  size_t outside_bytes_ = 0;
  int64_t next_step_ = -1;  ///< Messages of steps before this are late; -1: not known yet.
  InboxCounters counters_;
};

}  // namespace shoal

// The bounds of a link: how much is read off it in one turn, and how much waits for a peer that
// does not take it. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>

#include "lib/bus/bus/bus.h"

namespace shoal {

/// How much is read off links before signals and times are looked at again. A link in step brings
/// one or two messages a turn.
class LinkTurn {
 public:
  static constexpr size_t kMaxMessages = 64;
  static constexpr size_t kMaxBytes = size_t{4} << 20;
  static constexpr int64_t kLongest_us = 20'000;

  explicit LinkTurn(int64_t begin_us) : begin_us_(begin_us) {}

  bool IsOver(int64_t now_us) const {
    return num_ >= kMaxMessages || bytes_ >= kMaxBytes || now_us - begin_us_ >= kLongest_us;
  }
  void Count(size_t bytes) {
    ++num_;
    bytes_ += bytes;
  }

 private:
  int64_t begin_us_ = 0;
  size_t num_ = 0;
  size_t bytes_ = 0;
};

/// What waits for a peer that takes less than it is sent, in order.
class LinkOutbox {
 public:
  /// Far beyond what a link in step has under way.
  static constexpr size_t kMaxWaiting_bytes = size_t{128} << 20;

  enum class Sent { kYes, kLater, kGone };
  using SendNow = std::function<Sent(std::span<const uint8_t> bytes)>;

  /// Sends or keeps `bytes`. False where the peer is gone, or where too much waits, and it is taken
  /// to be stuck: from then on nothing is kept for it.
  bool Send(std::span<const uint8_t> bytes, const SendNow& send_now);
  void SendWaiting(const SendNow& send_now);

  bool is_stuck() const { return is_stuck_; }
  size_t waiting_bytes() const { return waiting_bytes_; }
  bool IsIdle() const { return waiting_.empty() && !is_stuck_; }

 private:
  std::deque<Bytes> waiting_;
  size_t waiting_bytes_ = 0;
  bool is_stuck_ = false;
};

}  // namespace shoal

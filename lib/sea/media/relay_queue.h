// What waits at a gateway to be forwarded: each once, not too many, not too fast, not too far.
//
//   RelayQueue<relay_t> queue({.size = 50, .rate_hz = 10, .max_hops = 3});
//   switch (queue.Offer(key, num_hops, relay)) { ... }
//   while (auto relay = queue.Take(utime)) { publish }
//
//   offered = taken + waiting + refused as repeated + refused for their hops + refused as too many
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace shoal {

struct RelayLimits {
  int64_t size = 50;     ///< At most this many wait.
  double rate_hz = 10;   ///< > 0: at most this many are taken in a second.
  int64_t max_hops = 3;  ///< What as many gateways have forwarded is not forwarded again.
};

enum class RelayOffer { kWaits, kRepeated, kTooManyHops, kFull };

/// Names a transmission of its maker: kind, maker, number.
using RelayKey = std::tuple<std::string, std::string, int64_t>;

template <class Relay>
class RelayQueue {
 public:
  /// The number of transmissions that are remembered, the last ones.
  static constexpr size_t kRemembered = 10'000;

  explicit RelayQueue(const RelayLimits& limits) : limits_(limits) {}

  /// Asks in this order: repeated, too many hops, full. What found no room is not remembered.
  RelayOffer Offer(RelayKey key, int num_hops, Relay relay) {
    if (seen_.contains(key)) return RelayOffer::kRepeated;
    if (num_hops >= limits_.max_hops) return RelayOffer::kTooManyHops;
    if (static_cast<int64_t>(waiting_.size()) >= limits_.size) return RelayOffer::kFull;
    waiting_.push_back(std::move(relay));
    recent_.push_back(key);
    seen_.insert(std::move(key));
    if (recent_.size() > kRemembered) {
      seen_.erase(recent_.front());
      recent_.pop_front();
    }
    return RelayOffer::kWaits;
  }

  /// Returns the first that waits, where the rate lets it go at `utime`; nothing otherwise. Times
  /// must not decrease.
  std::optional<Relay> Take(int64_t utime) {
    if (waiting_.empty() || utime < next_utime_) return std::nullopt;
    const auto interval_us = static_cast<int64_t>(std::llround(1e6 / limits_.rate_hz));
    // What a step is late is not lost, so that the rate holds whatever the step.
    next_utime_ = std::max(next_utime_, utime - interval_us) + interval_us;
    std::optional<Relay> first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }

  size_t num_waiting() const { return waiting_.size(); }

 private:
  RelayLimits limits_;
  std::deque<Relay> waiting_;
  std::deque<RelayKey> recent_;  ///< Oldest first.
  std::set<RelayKey> seen_;      ///< The same.
  int64_t next_utime_ = 0;
};

}  // namespace shoal

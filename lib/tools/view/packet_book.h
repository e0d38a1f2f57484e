// Recent acoustic packets and where they arrived: pages draw them as expanding rings.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/tools/view/fate_facts.h"

namespace shoal {

/// One transmission, as far as its fates are known.
struct AcousticPacket {
  struct Arrival {
    std::string name;
    int64_t utime = 0;  ///< The last byte was there, or would have been.
    Cause cause = Cause::kDelivered;
  };

  int64_t id = 0;     ///< Of source, kind and number; below 2^53.
  int64_t order = 0;  ///< Counts what was added to the book; grows with each further arrival.
  std::string source = {};
  Kind kind = Kind::kPacket;
  int64_t number = 0;
  int64_t sent_utime = 0;
  double air_s = 0;
  int64_t last_fate_utime = 0;  ///< Of the last fate.
  std::optional<std::pair<double, double>> from_m =
      {};  ///< Where the source was; absent: not known.
  std::vector<Arrival> to = {};
};

class PacketBook {
 public:
  static constexpr size_t kMaxPackets = 500;
  static constexpr size_t kMaxArrivals = 300;        ///< Of each.
  static constexpr int64_t kMemory_us = 10'000'000;  ///< Forgotten this long after the last fate.

  /// Takes a fate; those without a path are ignored.
  void Add(const FateView& fate, const std::optional<std::pair<double, double>>& from_m);

  /// Returns those with an order > `order` that are not forgotten at `utime`, the oldest first.
  std::vector<const AcousticPacket*> Since(int64_t order, int64_t utime) const;
  int64_t last_order() const { return last_order_; }

 private:
  std::deque<AcousticPacket> packets_;  ///< In the order of their first fates.
  int64_t last_order_ = 0;
};

}  // namespace shoal

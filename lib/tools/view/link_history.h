// The deliveries of one link over time, for its charts: of bounded size for any mission.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "lib/tools/view/fate_facts.h"

namespace shoal {

/// Fates of a stretch of time.
struct RatioBin {
  double begin_s = 0;
  int64_t received = 0;
  int64_t offered = 0;
};

/// A range that decided.
struct RangeSample {
  double t_s = 0;
  float range_m = 0;
  float limit_m = 0;  ///< Negative: no limit.
};

class LinkHistory {
 public:
  static constexpr size_t kMaxBins = 120;
  static constexpr size_t kMaxRanges = 300;

  /// Counts a fate at mission time `t_s`. Bins begin as 1 s each, from 0 on, and become twice as
  /// long whenever there are too many; times before 0 or after a year count as the nearest.
  void Add(const FateFacts& facts, double t_s);

  /// Those that have fates, in order of time.
  std::vector<RatioBin> Bins() const;
  /// The last ones, the oldest first.
  const std::deque<RangeSample>& ranges() const { return ranges_; }

 private:
  struct Counts {
    uint32_t received = 0;
    uint32_t offered = 0;
  };

  double bin_s_ = 1;
  std::vector<Counts> bins_;
  std::deque<RangeSample> ranges_;
};

}  // namespace shoal

// Statistics over time of an age that grows as time does and falls with each newer report: a saw
// tooth.
//
//   std::vector<AgeTooth> teeth = {{.taken_utime = 0, .begin_us = 0, .length_us = 10'000'000}};
//   MeanAge_s(teeth);               // 5
//   AgePercentile_s(teeth, 0.95);   // 9.5
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace shoal {

/// Time in which an age grew from `begin_us` on.
struct AgeTooth {
  int64_t taken_utime = 0;  ///< When it began.
  int64_t begin_us = 0;
  int64_t length_us = 0;
};

/// Return figures over the time that all teeth take together; the largest age where that is no
/// time. @pre teeth are not empty
[[nodiscard]] double MeanAge_s(std::span<const AgeTooth> teeth);
[[nodiscard]] double MaxAge_s(std::span<const AgeTooth> teeth);
/// Returns the age that was not exceeded for this share of the time. @pre 0 < share <= 1
[[nodiscard]] double AgePercentile_s(std::span<const AgeTooth> teeth, double share);

/// Returns what of the teeth is at `from_utime` and later.
[[nodiscard]] std::vector<AgeTooth> TeethFrom(std::span<const AgeTooth> teeth, int64_t from_utime);

}  // namespace shoal

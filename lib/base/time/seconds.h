// Microseconds, as times travel and are compared, and seconds, as formulas take them.
#pragma once

#include <cmath>
#include <cstdint>

namespace shoal {

/// Returns the seconds of a time or a duration in microseconds.
[[nodiscard]] constexpr double Seconds(int64_t time_us) {
  return static_cast<double>(time_us) / 1e6;
}

/// Returns the nearest whole microsecond. @pre it fits an int64_t.
[[nodiscard]] inline int64_t Microseconds(double time_s) { return std::llround(time_s * 1e6); }

/// Returns the seconds from one time to another; negative if the second is the earlier one.
/// @pre both are at most kLatest_us from 1970 (time_units.h)
[[nodiscard]] constexpr double SecondsBetween(int64_t from_us, int64_t to_us) {
  return Seconds(to_us - from_us);
}

}  // namespace shoal

// Mission and wall times are int64_t microseconds.
#pragma once

#include <cstdint>

namespace shoal {

inline constexpr int64_t kSecond_us = 1'000'000;

/// No time of a mission or of a running process is farther from 1970 than this, 31,700 years; the
/// difference of two such times fits an int64_t.
inline constexpr int64_t kLatest_us = 1'000'000'000'000'000'000;

/// Times farther from the epoch than this (3,170 years) are clamped to it, so that differences of
/// two never overflow.
inline constexpr int64_t kFarthest_us = 100'000'000'000'000'000;
[[nodiscard]] inline int64_t PlausibleUtime(int64_t utime) {
  return utime > kFarthest_us ? kFarthest_us : utime < -kFarthest_us ? -kFarthest_us : utime;
}

}  // namespace shoal

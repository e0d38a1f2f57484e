// The status pages of a mission's processes, as they answer: /api/status.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "shoal/appcast_t.hpp"

namespace shoal {

/// All functions may be called from any thread. Times `now_us` are wall time of any epoch.
class StatusBoard {
 public:
  static constexpr size_t kMostPages = 2'000;
  static constexpr size_t kMostText_bytes = 100'000;  ///< Of a page; the rest is cut off.

  /// `start_utime` is mission time at the mission's start.
  explicit StatusBoard(int64_t start_utime) : start_utime_(start_utime) {}

  void Take(const appcast_t& page, int64_t now_us);

  /// Returns all pages, those with warnings first, and notes that somebody looks.
  std::string Json(int64_t now_us);

  /// True where the processes should be asked again: once a second, while somebody looks.
  [[nodiscard]] bool WantsPages(int64_t now_us);

 private:
  struct Page {
    appcast_t appcast;
    int64_t taken_us = 0;
  };

  const int64_t start_utime_;
  std::mutex mutex_;
  std::map<std::string, Page> pages_;  ///< By app.
  int64_t looked_us_ = INT64_MIN;
  int64_t asked_us_ = INT64_MIN;
};

}  // namespace shoal

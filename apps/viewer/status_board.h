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
  static constexpr size_t kMaxPages = 2'000;
  static constexpr size_t kMaxText_bytes = 100'000;  ///< Of a page; the rest is cut off.
  static constexpr size_t kMax_bytes = 32'000'000;   ///< Of all pages; more are left out.

  /// `start_utime` is mission time at the mission's start.
  explicit StatusBoard(int64_t start_utime) : start_utime_(start_utime) {}

  void Take(const appcast_t& page, int64_t now_us);

  /// Returns all pages, those with warnings first, and notes that a client asks for them.
  std::string Json(int64_t now_us);

  /// True where the processes should be asked again: once a second, while a client asks for pages.
  [[nodiscard]] bool WantsPages(int64_t now_us);

  size_t num_pages() const;

 private:
  struct Page {
    appcast_t appcast;
    int64_t taken_us = 0;
  };

  /// True where a page of `size` bytes fits in.
  bool HasRoom(const std::string& app, size_t size) const;
  void DropSilent(int64_t now_us);

  const int64_t start_utime_;
  mutable std::mutex mutex_;
  std::map<std::string, Page> pages_;  ///< By app.
  size_t num_bytes_ = 0;               ///< Of all of them.
  int64_t dropped_us_ = INT64_MIN;
  int64_t looked_us_ = INT64_MIN;
  int64_t asked_us_ = INT64_MIN;
};

}  // namespace shoal

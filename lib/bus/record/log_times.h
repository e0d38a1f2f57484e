// The times of a whole log: its events on one line (recorded_timeline.h), whatever their clock did,
// and the places from which it can be read.
//
//   const LogTimes times = TimesOf(reader, ReadingBar(reader.path()));
//   const LogPlace& place = times.PlaceBefore(60'000'000);
//   reader.Seek(place.offset);
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/index_file.h"
#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/recorded_timeline.h"

namespace shoal {

/// Channels whose last message holds, however long ago it was published.
inline constexpr std::array<std::string_view, 2> kHoldingChannels = {topics::kCommsRules,
                                                                     topics::kModemStats};

/// A place from which the log can be read on.
struct LogPlace {
  uint64_t offset = 0;    ///< Of the first event behind it.
  RecordedTimeline line;  ///< After the events before it.
  /// For each of kHoldingChannels, the offset of its last message before the place; kNone: it has
  /// none.
  std::array<uint64_t, kHoldingChannels.size()> holding = {kNone, kNone};

  static constexpr uint64_t kNone = UINT64_MAX;
};

/// An event whose time is not near that of the one before.
struct TimeTrouble {
  int64_t number = 0;  ///< Of the event.
  uint64_t offset = 0;
  int64_t utime = 0;
  int64_t before_utime = 0;  ///< Of the last event whose time fits.
};

struct LogTimes {
  static constexpr size_t kMaxPlaces = 4096;
  static constexpr uint64_t kLeastGap_bytes = 1 << 20;  ///< Of the log, between places.
  static constexpr size_t kMaxChannels = 100'000;

  int64_t num_events = 0;
  int64_t zero_utime = 0;        ///< The line's 0 by the log's clock, as its first events have it.
  int64_t end_us = 0;            ///< On the line.
  std::vector<LogPlace> places;  ///< In order; the first is the log's begin.
  std::set<std::string, std::less<>> channels;  ///< The first kMaxChannels.
  std::optional<TimeTrouble> first_stray;       ///< A time that its neighbours do not share ...
  int64_t num_strays = 0;                       ///< ... and how many do not.
  std::optional<TimeTrouble> first_jump;        ///< From here on the clock is another ...
  int64_t num_jumps = 0;                        ///< ... so often.
  std::optional<TimeTrouble> longest_gap;       ///< Over an hour, in which nothing was recorded.

  /// The last place that holds nothing later than this. @pre !places.empty()
  const LogPlace& PlaceBefore(int64_t line_us) const;
};

/// Called now and then with the share of the log that has been read.
using ReadingProgress = std::function<void(double share)>;

/// Returns the times from the index beside the log; if it has none, reads the log and keeps them.
[[nodiscard]] LogTimes TimesOf(const LogReader& log, const ReadingProgress& progress,
                               uint64_t least_bytes = kLeastIndexedLog_bytes);

/// One line for each thing about the times that a user must know, with the remedy.
[[nodiscard]] std::vector<std::string> TimeWarnings(const LogTimes& times, const std::string& path);

}  // namespace shoal

// What the readers of tracks share: it takes points as a file has them, checks each against the one
// before, and makes a track of them. Errors are those of the file's user: "ferry.csv:7: ...".
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/track/replay_track.h"

namespace shoal {

/// Where a track comes from, and what it is read for.
struct TrackSource {
  std::string name = "track";         ///< Of the file, for messages.
  const LocalFrame* frame = nullptr;  ///< Of the mission. @pre not null
  bool underwater = false;            ///< Depths count, and must be there.
};

/// A fix farther from the mission's origin than this, or faster than from its neighbour, is refused
/// as an error of the file or of the origin.
inline constexpr double kFarthestFix_m = 1e6;
inline constexpr double kFastestFix_mps = 50;
inline constexpr double kDeepestFix_m = 20'000;

class TrackBuilder {
 public:
  explicit TrackBuilder(const TrackSource& source) : source_(source) {}

  /// Adds a point. Each returns what is wrong, empty: nothing.
  [[nodiscard]] std::string Add(const ReplayFix& fix);
  [[nodiscard]] std::string Add(ReplayFix fix, const GeoPoint& place);

  size_t size() const { return fixes_.size(); }
  /// Returns the track, or why there is none. @pre it is called once
  [[nodiscard]] Result<ReplayTrack> Finish(const ReplayColumns& columns);

 private:
  const TrackSource& source_;
  std::vector<ReplayFix> fixes_;
};

/// Returns a word of a file as it may stand in a message: short, printable, in quotes.
[[nodiscard]] std::string QuotedWord(std::string_view word);

}  // namespace shoal

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
#include "lib/mission/track/depth_positive.h"
#include "lib/mission/track/replay_track.h"

namespace shoal {

/// Where a track comes from, and what it is read for.
struct TrackSource {
  std::string name = "track";         ///< Of the file, for messages.
  const LocalFrame* frame = nullptr;  ///< Of the mission. @pre not null
  bool underwater = false;            ///< Depths count, and must be there.
  DepthPositive depth_positive = DepthPositive::kByForm;
  std::string vessel = "";  ///< Of several in one file; empty: none is chosen by name.
  int64_t number = 0;       ///< Of several tracks of GPX, from 1; 0: none is chosen by number.
};

/// A fix farther from the mission's origin than this, or faster than from its neighbour, is refused
/// as an error of the file or of the origin.
inline constexpr double kFarthestFix_m = 1e6;
inline constexpr double kFastestFix_mps = 50;
inline constexpr double kDeepestFix_m = 20'000;
/// Fixes of one time that are farther apart are of two vessels: what the fastest covers while a
/// clock shows the same second.
inline constexpr double kFarthestOfOneTime_m = kFastestFix_mps;
/// A depth that is less above the surface is noise of a sensor, in waves too.
inline constexpr double kHighestFix_m = 2;

class TrackBuilder {
 public:
  /// `of_form`: which way a file of this form counts, unless the source has it otherwise.
  TrackBuilder(const TrackSource& source, DepthPositive of_form)
      : source_(source),
        positive_(source.depth_positive == DepthPositive::kByForm ? of_form
                                                                  : source.depth_positive) {}

  /// Adds a point that `line` of the file has, z as the file counts it. Of points of one time the
  /// last one counts. Each returns what is wrong, empty: nothing.
  [[nodiscard]] std::string Add(ReplayFix fix, uint64_t line);
  /// Longitudes from -180 to 360.
  [[nodiscard]] std::string Add(ReplayFix fix, GeoPoint place, uint64_t line);

  size_t size() const { return fixes_.size(); }
  /// Returns the track, or why there is none; adds to `warnings` what is read, and probably meant
  /// otherwise. @pre it is called once
  [[nodiscard]] Result<ReplayTrack> Finish(const ReplayColumns& columns,
                                           std::vector<std::string>* warnings);

 private:
  /// Something that points of the file have: how many, and which line first.
  struct Found {
    size_t count = 0;
    uint64_t line = 0;

    void Note(uint64_t at_line) {
      if (count++ == 0) line = at_line;
    }
  };

  std::string AddToTime(const ReplayFix& fix, uint64_t line);
  void NoteDepth(double z_m, uint64_t line);
  std::string WhyFar(const GeoPoint& place) const;
  std::string WhyAboveSurface() const;
  void TakeSurface(std::vector<std::string>* warnings);
  void WarnOfRest(std::vector<std::string>* warnings) const;
  void WarnOfSpeeds(std::vector<std::string>* warnings) const;
  void WarnOfHeadings(std::vector<std::string>* warnings) const;

  const TrackSource& source_;
  const DepthPositive positive_;
  std::vector<ReplayFix> fixes_;
  Eigen::Vector3d first_of_time_m_ = Eigen::Vector3d::Zero();  ///< Of the last fix's time.
  Found equal_times_;
  Found null_places_;  ///< At latitude 0, longitude 0.
  Found above_;        ///< The surface.
  double highest_m_ = 0;
  uint64_t highest_line_ = 0;
  double deepest_m_ = 0;
  int64_t longest_gap_us_ = 0;
  uint64_t longest_gap_line_ = 0;  ///< Of its end.
};

/// Returns a word of a file as it may be in a message: short, printable, in quotes.
[[nodiscard]] std::string QuotedWord(std::string_view word);

}  // namespace shoal

// A recorded way through the sea: where a real vessel was at which time.
//
//   const Result<ReplayTrack> track = ParseCsvTrack(text, {.name = "ferry.csv", .frame = &frame});
//   const ReplayState state = track->At(track->first_us() + 2'500'000);
//
// Between two points the vessel goes straight, at a steady speed; before the first and after the
// last it lies where they are.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

/// One point of a recorded track.
struct ReplayFix {
  int64_t time_us = 0;  ///< Since 1970, or since any other moment: as the file has it.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  /// Clockwise from North; of tracks with headings. NaN: unknown, it follows from the points.
  double heading_rad = 0;
  double speed_mps = 0;  ///< Over ground, >= 0; of tracks with speeds. NaN: unknown, likewise.
};

/// What a track has beside times and positions. What it has not, follows from them.
struct ReplayColumns {
  bool depth = false;
  bool heading = false;
  bool speed = false;
};

/// Where the vessel is at one time, and how it moves.
struct ReplayState {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double heading_rad = 0;  ///< [0, 2 pi).
  double course_rad = 0;   ///< Over ground, [0, 2 pi); the heading where it lies still.
  double speed_mps = 0;    ///< Over ground.
  double descent_mps = 0;  ///< Down.
  double turn_radps = 0;   ///< Of the heading, clockwise.
};

/// A file with more points than this is refused.
inline constexpr size_t kMaxFixes = 10'000'000;

class ReplayTrack {
 public:
  /// @pre at least one fix, times increase strictly, all numbers that are not unknown are finite
  ReplayTrack(std::vector<ReplayFix> fixes, const ReplayColumns& columns);

  /// Returns the state at a time: position linear between two fixes; speed as recorded in both,
  /// linear between them too, else that of the way from one to the next; heading as recorded, by
  /// the shorter way round, else turning steadily from the mean direction of the ways that meet in
  /// one fix to that in the next. A vessel that has not moved yet heads where it will go first; one
  /// that never moves, North.
  [[nodiscard]] ReplayState At(int64_t time_us) const;

  int64_t first_us() const { return fixes_.front().time_us; }
  int64_t last_us() const { return fixes_.back().time_us; }
  const std::vector<ReplayFix>& fixes() const { return fixes_; }
  const ReplayColumns& columns() const { return columns_; }

 private:
  void FillInHeadings();

  std::vector<ReplayFix> fixes_;
  ReplayColumns columns_;
};

}  // namespace shoal

// How often a vessel swings to and fro.
//
//   SwingWatch watch;
//   for (...) watch.Look(heading_deg);
//   if (watch.num_swings() >= 3) ...
#pragma once

#include <optional>

namespace shoal {

/// Counts swings: changes of heading by more than `least_deg` from one turning point to the next.
/// To keep clear of one vessel takes two of them, away and back.
class SwingWatch {
 public:
  explicit SwingWatch(double least_deg = 40) : least_deg_(least_deg) {}

  /// Takes the heading, compass; from one look to the next it changes by less than 180 degrees.
  void Look(double heading_deg);

  [[nodiscard]] int num_swings() const { return num_swings_; }

 private:
  double least_deg_;
  std::optional<double> last_deg_;
  double turned_deg_ = 0;   ///< Since the first look, not wrapped; positive to starboard.
  double lowest_deg_ = 0;   ///< Since the last turning point.
  double highest_deg_ = 0;  ///< Likewise.
  int side_ = 0;            ///< Of the swing that goes on: +1 to starboard; 0: none yet.
  int num_swings_ = 0;
};

}  // namespace shoal

// An encounter of two vessels as it went: where it began, what each did, how close they came.
//
// An encounter begins when two vessels that both make way are closer than `entry_range_m`, close,
// and would come closer than `risk_m` if both held course and speed. It ends when they have opened
// for `open_s` without a break and are farther apart than `end_range_m`; when one of them is seen
// no more; or with the record. Motion is relative to the water, so that a uniform current changes
// nothing.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

/// When an encounter begins and ends, and the distances by which it is scored. The defaults suit
/// surface craft of 3 m at 3 m/s; for ships of 12 knots multiply all lengths by 30.
struct EncounterOptions {
  double entry_range_m = 150;
  double risk_m = 40;
  double end_range_m = 60;
  double open_s = 10;
  double preferred_m = 25;   ///< Passing at this distance or farther is scored in full.
  double acceptable_m = 10;  ///< Closer than this is not safe.
  double near_miss_m = 5;
  double least_speed_mps = 0.2;  ///< Slower vessels do not make way: they meet without rules.
  double same_depth_m = 5;       ///< Vessels farther apart in depth do not meet.
  ClassifyOptions classify = {};

  bool operator==(const EncounterOptions& other) const {
    return entry_range_m == other.entry_range_m && risk_m == other.risk_m &&
           end_range_m == other.end_range_m && open_s == other.open_s &&
           preferred_m == other.preferred_m && acceptable_m == other.acceptable_m &&
           near_miss_m == other.near_miss_m && least_speed_mps == other.least_speed_mps &&
           same_depth_m == other.same_depth_m &&
           classify.head_on_deg == other.classify.head_on_deg &&
           classify.sidelight_deg == other.classify.sidelight_deg;
  }
};

/// What a vessel did since an encounter began.
struct Conduct {
  /// When its course had changed by 5 degrees or its speed by 10 %, for the first time.
  std::optional<double> first_alteration_s;
  /// +1: its first alteration of course was to starboard, -1: to port, 0: it altered none.
  int altered_to = 0;
  double largest_course_change_deg = 0;   ///< From the course at entry; positive to starboard.
  double largest_speed_change_share = 0;  ///< Of the speed at entry; negative: slower.
  double held_course_change_deg = 0;      ///< Largest while it had to hold; >= 0.
  /// Likewise; >= 0. Of a vessel that is overtaken, what it went faster counts in extremis too.
  double held_speed_change_share = 0;
  std::optional<double> in_extremis_s;  ///< When the other alone could no longer avoid it.
  bool acted_in_extremis = false;       ///< Changed course by 10 degrees or speed by 20 % then.
  bool turned_to_port_in_extremis = false;
  /// It stood on, and turned 10 degrees to port while the other, which had to keep out of the way,
  /// was on its port side (rule 17 c). Turns for something else do not count: the one in which the
  /// encounter began, and those back to its way that begin while there is no risk of collision:
  /// they open, pass in less than 3 s, or would pass at risk_m or farther.
  bool turned_to_port_while_standing_on = false;
};

/// One vessel's part in an encounter.
struct EncounterSide {
  size_t vessel = 0;
  EncounterRole role = EncounterRole::kNone;  ///< By angles and motion at entry.
  RelativeGeometry entry = {};                ///< As this vessel saw the other.
  double entry_heading_deg = 0;
  double entry_speed_mps = 0;
  double beta_deg = 0;   ///< Of the other from this vessel at the closest approach, [0, 360).
  double alpha_deg = 0;  ///< Of this vessel from the other, likewise.
  Conduct conduct = {};  ///< Up to the closest approach.
  /// It crossed the other's course line ahead of the other, this far away; absent: it did not.
  std::optional<double> crossed_ahead_m;
  bool crossed_astern = false;
  /// While it should have stood on, it had to keep clear of a third vessel, or was in extremis
  /// toward one, from then on.
  std::optional<double> excused_s;
};

struct Encounter {
  double begin_s = 0;
  double end_s = 0;  ///< Of an encounter that is not over: the last look at it.
  bool is_over = false;
  double closest_m = 0;  ///< In the horizontal plane, between looks too.
  double closest_s = 0;
  bool has_touched = false;  ///< Centres closer than the mean of the lengths.
  double touch_m = 0;        ///< That mean.
  std::array<EncounterSide, 2> sides;
};

}  // namespace shoal

// What the collision regulations prefer, as a function of course and speed.
//
//   cpa, in extremis     the utility of the closest distance; in extremis 0 to port of the entry's
//                        course for a contact on the port side (17 c), and faster than at the
//                        entry where overtaken
//   head-on (14)         0 where it passes starboard to starboard or crosses ahead from the
//                        contact's port side; else that utility, and up to 100 more the faster the
//                        contact's bearing drifts to port: alter to starboard, and early
//   give-way, stern      0 where it crosses ahead, or turns to port without crossing astern
//   give-way, bow        0 where it turns to starboard without crossing ahead
//   overtaking (13)      0 where it passes on the side that was not chosen; utility from 15 up
//   stand-on, overtaken  holds the course and speed of the entry
//
// All are normalised to 0..100.
#pragma once

#include "lib/helm/colregs/colregs_state.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/colregs/passing.h"
#include "lib/helm/decision/cpa_function.h"
#include "lib/helm/decision/objective.h"
#include "lib/helm/decision/speed_along.h"

namespace shoal {

struct ColregsPreferences {
  double min_cpa_m = 10;
  double max_cpa_m = 75;
  double horizon_s = 120;
  bool port_turns_ok = true;  ///< False: giving way never turns to port, and always crosses astern.
  bool steady = true;         ///< False: in extremis all courses and speeds are allowed.
};

/// Returns the utility of closest distances: from 25 at min_cpa_m, or at half the distance where
/// that is not more, so that closer than min_cpa_m farther is still better.
[[nodiscard]] CpaUtility CpaUtilityAt(double range_m, double min_cpa_m, double max_cpa_m,
                                      double at_lo = 25);

/// Returns the utility of closest distances in danger: from 0 at a collision to 100 at twice
/// min_cpa_m, so that something is better than the rest wherever own ship cannot get clear.
[[nodiscard]] CpaUtility CpaUtilityInDanger(double min_cpa_m);

/// The value in a role that acts, before it is normalised.
class ColregsFunction final : public CourseSpeedFunction {
 public:
  /// `own` is own ship as it goes now. @pre not a role that stands on, in extremis aside
  ColregsFunction(const ColregsState& state, const VesselMotion& own, const VesselMotion& contact,
                  const ColregsPreferences& preferences, const Domain& domain);

  double At(int course, int speed) const override;
  /// Tight where a box lies on one side of every line at which the function jumps.
  Range Bound(const GridBox& box) const override;

 private:
  /// What is forbidden.
  enum class Rule {
    kNothing,
    kHeadOn,
    kGiveWayStern,
    kGiveWayBow,
    kPassStarboard,
    kPassPort,
    kNotToPort,
    kNotFaster
  };
  enum class Truth { kNever, kSometimes, kAlways };

  static Truth Not(Truth a);
  static Truth And(Truth a, Truth b);
  static Truth Or(Truth a, Truth b);
  static Truth Above(const Range& value, double threshold);
  static Truth AtLeast(const Range& value, double threshold);

  double SpeedAt(int speed) const { return first_mps_ + step_mps_ * speed; }
  bool IsForbidden(int course, int speed) const;
  Truth IsForbidden(const GridBox& box) const;
  Truth Turns(const GridBox& box, bool to_starboard) const;
  /// `drift_mps`: of the contact to the right, across the line of sight.
  double HeadOnBonus(double drift_mps) const;

  Rule rule_ = Rule::kNothing;
  CpaGrid cpa_;
  CpaUtility utility_;
  Aspect aspect_;
  SpeedAlong bow_;      ///< The contact's heading.
  SpeedAlong to_line_;  ///< From own ship square to the contact's bow-stern line.
  SpeedAlong right_;    ///< Square to the line of sight.
  double contact_mps_ = 0;
  double contact_drift_mps_ = 0;
  double head_on_drift_mps_ = 0;  ///< < 0: drift at which the bonus is full.
  double own_heading_deg_ = 0;
  double first_mps_ = 0;
  double step_mps_ = 0;
  double hold_deg_ = 0;  ///< In extremis, from the port side: no course to port of this.
  double hold_mps_ = 0;  ///< In extremis, overtaken: no speed above this.
  bool port_turns_ok_ = true;
};

/// Returns what the state prefers, normalised to 0..100.
/// @pre state.mode is not kNone
[[nodiscard]] Objective ColregsObjective(const ColregsState& state, const VesselMotion& own,
                                         const VesselMotion& contact,
                                         const ColregsPreferences& preferences,
                                         const Domain& domain);

}  // namespace shoal

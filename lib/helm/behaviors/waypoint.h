// Steers along a list of points.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/geometry/leg.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/track_line.h"
#include "lib/helm/modes/condition.h"
#include "lib/vehicle/guidance/route_rounds.h"
#include "lib/vehicle/guidance/waypoint_capture.h"

namespace shoal {

/// kind = "waypoint". Steers along a list of points.
struct WaypointOptions {
  static constexpr std::string_view kKind = "waypoint";

  std::vector<Eigen::Vector2d> points = {};  ///< x East, y North; at least one.
  double speed = 0;                          ///< m/s; limited by the domain.
  double speed_alt = -1;  ///< m/s, instead of speed where use_alt_speed; -1: none.
  bool use_alt_speed = false;
  double capture_radius = 3;       ///< m; a point is reached closer than this.
  double slip_radius = 15;         ///< m; reached where the distance grows again after it was less.
  bool capture_line = false;       ///< Also reached past the line square to the leg.
  bool capture_line_only = false;  ///< capture_line = "absolute" of others: the radii do not count.
  double lead = -1;  ///< m; steers for a point this far ahead on the leg; -1: for the point itself.
  double lead_damper = -1;     ///< m of cross-track distance within which lead grows; -1: off.
  double return_angle = 15;    ///< Degrees to the leg, at most, after it kept clear of a contact.
  bool lead_to_start = false;  ///< The first leg begins where the behavior began to run.
  std::string lead_condition = {};          ///< Leads only while this condition holds.
  std::string order = "normal";             ///< normal, reverse or toggle (by turns).
  int repeat = 0;                           ///< Further rounds; -1: for ever.
  bool greedy_tour = false;                 ///< Reorders the points: always the nearest next.
  int currix = 0;                           ///< Index of the first point.
  std::string ipf_type = "zaic";            ///< zaic, zaic_spd or roc.
  double patience = 50;                     ///< Per cent of course against speed, 1 to 99.
  std::vector<std::string> wptflag = {};    ///< At each point that is reached.
  std::vector<std::string> cycleflag = {};  ///< At the end of the list.
  bool wptflag_on_start = false;            ///< wptflag once at the beginning too.
  bool reset_on_idle = false;               ///< Begins with the first point after a pause.
  double end_speed = -1;                    ///< m/s at the last point; -1: off.
  double end_slow_dist = 0;                 ///< m; begins to slow down.
  double end_stop_dist = 0;                 ///< m; has end_speed.
  std::string post_suffix = {};             ///< Behind the names of these three.
  std::string index_var = "WPT_INDEX";      ///< Names of what it posts; empty: it does not.
  std::string cycle_var = "CYCLE_INDEX";
  std::string status_var = "WPT_STAT";
  std::string dist_to_next_var = {};  ///< Metres to its point; -1 while it does not run.
  std::string dist_to_prev_var = {};  ///< Metres to the point before; -1: there is none yet.

  bool operator==(const WaypointOptions&) const = default;
};

/// Posts WPT_INDEX, CYCLE_INDEX and WPT_STAT, each with post_suffix, and distances to its points.
///
///   new  --- first iteration --->  on the way  --- last point of the last round --->  done
///    ^                              |      ^                                           |
///    |                        idle  v      | the conditions hold again                 |
///    +------- reset_on_idle ------ paused --+                                          |
///    +---------------------------------- idle, other points ---------------------------+
class WaypointBehavior final : public BehaviorWith<WaypointOptions> {
 public:
  explicit WaypointBehavior(const WaypointOptions& options);
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  /// Other points, another order or another currix: starts again. Else it goes on.
  void Reconfigure(const WaypointOptions& options) override;

 private:
  enum class State { kNew, kOnTheWay, kPaused, kDone };

  void TakeOver(const WaypointOptions& options);
  void Begin(const BehaviorInputs& inputs, BehaviorAnswer& answer);
  void ArrangePoints(const Eigen::Vector2d& position_m);
  /// `from_m`: where the leg begins; absent: there is none to follow.
  void HeadForPoint(const std::optional<Eigen::Vector2d>& from_m,
                    const Eigen::Vector2d& position_m);
  void Advance(const Eigen::Vector2d& position_m, BehaviorAnswer& answer);
  bool IsLastPoint() const;
  double Speed(double distance_m) const;
  Eigen::Vector2d SteersFor(const BehaviorInputs& inputs) const;
  Objective Preference(const BehaviorInputs& inputs, double course_deg, double speed_mps) const;
  void Report(const BehaviorInputs& inputs, double distance_m, BehaviorAnswer& answer) const;

  std::optional<Condition> lead_condition_;
  State state_ = State::kNew;
  std::vector<Eigen::Vector2d> points_m_;  ///< In the order of this round.
  RouteRounds rounds_;
  Diversion diversion_;
  bool has_leg_ = false;                    ///< There is a line to follow.
  std::optional<WaypointCapture> capture_;  ///< Of the leg to the point; absent: not begun.
};

}  // namespace shoal

// Steers along a list of points.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

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
  double lead_damper = -1;          ///< m of cross-track distance within which lead grows; -1: off.
  bool lead_to_start = false;       ///< The first leg begins where the behavior began to run.
  std::string lead_condition = {};  ///< Leads only while this condition holds.
  std::string order = "normal";     ///< normal, reverse or toggle (by turns).
  int repeat = 0;                   ///< Further rounds; -1: for ever.
  bool greedy_tour = false;         ///< Reorders the points: always the nearest next.
  int currix = 0;                   ///< Index of the first point.
  std::string ipf_type = "zaic";    ///< zaic, zaic_spd or roc.
  double patience = 50;             ///< Per cent of course against speed, 1 to 99.
  std::vector<std::string> wptflag = {};    ///< At each point that is reached.
  std::vector<std::string> cycleflag = {};  ///< At the end of the list.
  bool wptflag_on_start = false;            ///< wptflag once at the beginning too.
  bool reset_on_idle = false;               ///< Begins with the first point after a pause.
  double end_speed = -1;                    ///< m/s at the last point; -1: off.
  double end_slow_dist = 0;                 ///< m; begins to slow down.
  double end_stop_dist = 0;                 ///< m; has end_speed.
  std::string post_suffix = {};             ///< Behind the names of what it posts.

  bool operator==(const WaypointOptions&) const = default;
};

}  // namespace shoal

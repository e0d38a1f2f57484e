// Paths of underwater vehicles: what is wrong with them as a whole, and what the vehicle, or the
// end of the mission, will not let it do.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/mission/file/validate.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {
namespace {

/// On a steeper path the autopilot of the default Remus 100 cannot correct depth any more: its
/// pitch is at most 20 degrees (lib/vehicle/control/auv_pilot.cc).
constexpr double kSteepest_deg = 18;
/// Its turning circle has a diameter of 45 m at 2 m/s.
constexpr double kTightestTurn_m = 22.5;
constexpr size_t kMaxJoinedPoints = 10'000;

std::string_view KeyOf(const PathFollowTask& task) {
  return task.parts.empty() ? "points" : "path";
}

void CheckExtent(const TablePlace& place, const PathFollowTask& task,
                 const std::vector<Eigen::Vector3d>& points_m) {
  if (points_m.size() > kMaxJoinedPoints && !task.parts.empty()) {
    place.Refuse("path", fmt::format("the parts join to {} points; allowed: at most {}",
                                     points_m.size(), kMaxJoinedPoints));
  }
  const bool leaves = std::any_of(
      points_m.begin(), points_m.end(),
      [](const Eigen::Vector3d& point_m) { return point_m.head<2>().cwiseAbs().maxCoeff() > 1e6; });
  if (leaves && !task.parts.empty()) {
    place.Refuse("path",
                 "the path leads more than 1000 km from the origin: shorten its legs, or "
                 "give it fewer points");
  }
}

void WarnOfTime(const TablePlace& place, const PathFollowTask& task, const WaypointPath& path,
                double duration_s) {
  if (task.end == PathTaskEnd::kReturnToFirst || task.propeller_rpm > 0) return;
  const double time_s = EstimateTime_s(path, task.speed_mps, 1);
  if (time_s <= duration_s) return;
  place.Warn("", fmt::format("the path is {:.0f} m long and takes {:.0f} s at {:g} m/s, but the "
                             "mission ends after {:g} s: raise duration_s or speed_mps",
                             TotalLength_m(path), time_s, task.speed_mps, duration_s));
}

void WarnOfSpeed(const TablePlace& place, const PathFollowTask& task,
                 const Remus100Params& params) {
  const double max_rpm = params.propeller.max_rpm;
  if (task.propeller_rpm > max_rpm) {
    place.Warn("propeller_rpm",
               fmt::format("propeller_rpm = {:g} is more than the propeller's {:g}",
                           task.propeller_rpm, max_rpm));
  }
  const double fastest_mps = SteadySpeed(BuildRemus100(params), max_rpm);
  if (task.propeller_rpm == 0 && task.speed_mps > fastest_mps) {
    place.Warn("speed_mps", fmt::format("speed_mps = {:g} is more than the {:.2f} m/s that the "
                                        "vehicle reaches at its {:g} rpm",
                                        task.speed_mps, fastest_mps, max_rpm));
  }
}

void WarnOfDepths(const TablePlace& place, const PathFollowTask& task, const WaypointPath& path,
                  const Remus100Options& options) {
  double deepest_m = 0;
  for (const Eigen::Vector3d& point_m : path.points_m) deepest_m = std::max(deepest_m, point_m.z());
  if (deepest_m > options.max_depth_m) {
    place.Warn(
        KeyOf(task),
        fmt::format("the path goes down to {:g} m, but the vehicle's max_depth_m is {:g}: it "
                    "stays above",
                    deepest_m, options.max_depth_m));
  }
  if (task.depth_rule != DepthRule::kSlope) return;
  double steepest_deg = 0;
  for (size_t i = 1; i < path.points_m.size(); ++i) {
    const Eigen::Vector3d way_m = path.points_m[i] - path.points_m[i - 1];
    steepest_deg =
        std::max(steepest_deg, RadToDeg(Atan2(std::abs(way_m.z()), way_m.head<2>().norm())));
  }
  if (steepest_deg <= kSteepest_deg) return;
  place.Warn(KeyOf(task), fmt::format("a leg is {:.0f} degrees steep; beyond {:g} the vehicle lags "
                                      "behind the slope: lengthen the leg, or write depth_rule = "
                                      "\"next\"",
                                      steepest_deg, kSteepest_deg));
}

void WarnOfTurns(const TablePlace& place, const PathFollowTask& task) {
  if (task.turn_radius_m == 0 || task.turn_radius_m >= kTightestTurn_m) return;
  place.Warn("turn_radius_m",
             fmt::format("turn_radius_m = {:g} is tighter than the {:g} m in which "
                         "a Remus 100 turns: it swings wide",
                         task.turn_radius_m, kTightestTurn_m));
}

}  // namespace

bool MustEnd(const Mission& mission, const Vehicle& vehicle, size_t task) {
  if (task + 1 < vehicle.tasks.size()) return true;
  return std::any_of(mission.expectations.begin(), mission.expectations.end(),
                     [&](const Expectation& expectation) {
                       const auto* laps = std::get_if<LapsExpectation>(&expectation.what);
                       return laps != nullptr && laps->task == vehicle.tasks[task].name &&
                              (laps->vehicle == vehicle.name || laps->vehicle == "all");
                     });
}

void ValidatePaths(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      const auto* task = std::get_if<PathFollowTask>(&vehicle.tasks[k].what);
      if (task == nullptr) continue;
      const TablePlace place = file.Below("vehicle", i).Below("task", k);
      if (!place.IsSound()) continue;
      const WaypointPath path = PathOf(*task).path;
      CheckExtent(place, *task, path.points_m);
      if (MustEnd(mission, vehicle, k)) WarnOfTime(place, *task, path, mission.duration_s);
      const auto* options = std::get_if<Remus100Options>(&vehicle.model);
      if (options == nullptr) continue;
      const auto params = Remus100ParamsByName(options->parameters);
      if (params) WarnOfSpeed(place, *task, *params);
      WarnOfDepths(place, *task, path, *options);
      WarnOfTurns(place, *task);
    }
  }
}

}  // namespace shoal

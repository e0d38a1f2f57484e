#include "apps/helm/helm_endings.h"

#include <cmath>
#include <optional>
#include <variant>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// A depth that was commanded counts as the vehicle's own within this.
constexpr double kSameDepth_m = 3;
/// Ahead of the vehicle, to give its course; past the point it goes straight on.
constexpr double kAhead_m = 1000;

/// True where the task leaves the vehicle at the surface.
bool ComesUp(const Task& task) {
  const auto* path = std::get_if<PathFollowTask>(&task.what);
  return std::holds_alternative<SurfaceTask>(task.what) ||
         (path != nullptr && path->end == PathTaskEnd::kSurface);
}

/// Returns the depth to keep: the commanded one where the vehicle has it, else its own.
double DepthOf(const Fix& fix, const Guidance& last) {
  const double commanded_m = last.z_m.value_or(fix.z_m);
  return std::abs(commanded_m - fix.z_m) <= kSameDepth_m ? commanded_m : fix.z_m;
}

double CourseOf(const Fix& fix) {
  constexpr double kStill_mps = 0.1;
  const double speed_mps = fix.velocity_mps.norm();
  return std::isfinite(speed_mps) && speed_mps > kStill_mps ? HeadingOf(fix.velocity_mps)
                                                            : fix.heading_rad;
}

std::optional<double> CruiseDepthOf(const AnyModel& model) {
  const auto* remus100 = std::get_if<Remus100Options>(&model);
  return remus100 == nullptr ? std::nullopt : std::optional(remus100->cruise_depth_m);
}

}  // namespace

HelmEndings::HelmEndings(const Vehicle& vehicle)
    : options_(vehicle.helm_options),
      is_underwater_(FactsOfModel(vehicle.model).is_underwater),
      cruise_depth_m_(CruiseDepthOf(vehicle.model)) {}

Ending HelmEndings::AfterList(const Task* last) const {
  if (options_.end_of_tasks && options_.end_of_tasks != Ending::kEndMission) {
    return *options_.end_of_tasks;
  }
  return last != nullptr && ComesUp(*last) ? Ending::kSurface : Ending::kHold;
}

TaskRunner::What HelmEndings::TaskFor(Ending ending, const Fix& fix, const Guidance& last) const {
  const std::optional<double> z_m =
      is_underwater_ ? std::optional(DepthOf(fix, last)) : std::nullopt;
  const double speed_mps = last.speed_mps > 0 ? last.speed_mps : LoiterTask().speed_mps;
  switch (ending) {
    case Ending::kSurface:
      return SurfaceTask{};
    case Ending::kGoOn: {
      const Eigen::Vector2d ahead_m = fix.position_m + kAhead_m * UnitVector(CourseOf(fix));
      const double depth_m = z_m.value_or(0);
      return PathFollowTask{.points_m = {{fix.position_m.x(), fix.position_m.y(), depth_m},
                                         {ahead_m.x(), ahead_m.y(), depth_m}},
                            .speed_mps = speed_mps,
                            .propeller_rpm = last.propeller_rpm.value_or(0),
                            .end = PathTaskEnd::kGoOn};
    }
    case Ending::kLoiter:
      return LoiterTask{.center_m = fix.position_m,
                        .radius_m = options_.loiter_radius_m,
                        .speed_mps = speed_mps,
                        .z_m = z_m};
    case Ending::kHold:
    case Ending::kEndMission:
      break;
  }
  if (is_underwater_) return HoldHere(options_.hold_radius_m, z_m);
  return HoldAt(fix.position_m, fix);
}

TaskRunner::What HelmEndings::AtItsDepth(TaskRunner::What what) const {
  if (auto* keep = std::get_if<StationKeepTask>(&what); keep && !keep->z_m) {
    keep->z_m = cruise_depth_m_;
  }
  if (auto* home = std::get_if<ReturnTask>(&what); home && !home->z_m) {
    home->z_m = cruise_depth_m_;
  }
  return what;
}

StationKeepTask HelmEndings::HoldAt(const Eigen::Vector2d& point_m, const Fix& fix) const {
  StationKeepTask keep;
  if (is_underwater_) {
    keep = HoldHere(options_.hold_radius_m, fix.z_m);
  } else if (options_.hold_radius_m != keep.outer_radius_m) {
    keep.inner_radius_m = 0.4 * options_.hold_radius_m;
    keep.outer_radius_m = options_.hold_radius_m;
  }
  keep.here = false;
  keep.point_m = point_m;
  return keep;
}

}  // namespace shoal

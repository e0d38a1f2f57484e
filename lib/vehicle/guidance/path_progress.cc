#include "lib/vehicle/guidance/path_progress.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

// Returns the psi of the leg that begins at waypoint `index`; where that has none, of the last one
// before that has one, or of the first one after.
double PsiOf(const WaypointPath& path, const PathProgress& progress, size_t index) {
  const auto& points_m = path.points_m;
  const size_t size = points_m.size();
  const auto begin_m = [&](size_t i) { return size == 1 ? progress.start_m : points_m[i]; };
  const auto way_m = [&](size_t i) -> Eigen::Vector3d {
    return Plausible(points_m[(i + 1) % size]) - Plausible(begin_m(i));
  };
  const auto has_way = [&](size_t i) { return way_m(i).x() != 0 || way_m(i).y() != 0; };
  const auto psi_rad = [&](size_t i) { return Atan2(way_m(i).y(), way_m(i).x()); };
  for (size_t i = index + 1; i-- > 0;) {
    if (has_way(i)) return psi_rad(i);
  }
  for (size_t i = index + 1; i + 1 < size; ++i) {
    if (has_way(i)) return psi_rad(i);
  }
  return 0;
}

PathLeg LegBetween(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, double psi_rad) {
  return {.from_m = from_m,
          .to_m = to_m,
          .psi_rad = psi_rad,
          .length_m = (to_m - from_m).head<2>().norm()};
}

}  // namespace

PathProgress BeginPath(const WaypointPath& path, const Eigen::Vector3d& position_m,
                       double acceptance_radius_m) {
  SHOAL_CHECK(!path.points_m.empty(), "a path has at least one waypoint");
  const Eigen::Vector3d start_m = Plausible(position_m);
  const double distance_m = (Plausible(path.points_m.front()) - start_m).head<2>().norm();
  return {.start_m = start_m,
          .approaches = path.points_m.size() > 1 && distance_m > acceptance_radius_m};
}

PathLeg CurrentLeg(const WaypointPath& path, PathEnd end, const PathProgress& progress,
                   const Eigen::Vector3d& position_m) {
  const size_t size = path.points_m.size();
  SHOAL_CHECK(size > 0, "a path has at least one waypoint");
  SHOAL_CHECK(progress.previous < size, "progress.previous is a waypoint of this path");
  const bool closes = end == PathEnd::kReturnToFirst && size > 1;
  if (progress.approaches) {
    const Eigen::Vector3d to_m = Plausible(path.points_m.front());
    const Eigen::Vector3d way_m = to_m - Plausible(progress.start_m);
    return LegBetween(Plausible(progress.start_m), to_m, Atan2(way_m.y(), way_m.x()));
  }
  if (!progress.ended) {
    SHOAL_CHECK(closes || size == 1 || progress.previous + 1 < size,
                "the current leg has a next waypoint");
    return LegBetween(Plausible(size == 1 ? progress.start_m : path.points_m[progress.previous]),
                      Plausible(path.points_m[(progress.previous + 1) % size]),
                      PsiOf(path, progress, progress.previous));
  }
  PathLeg leg{.from_m = Plausible(path.points_m.back()),
              .psi_rad = PsiOf(path, progress, size > 1 ? size - 2 : 0)};
  leg.length_m = std::max(ErrorsOn(leg, position_m).x_e_m, 0.0) + kOpenEnd_m;
  leg.to_m = leg.from_m + leg.length_m * Eigen::Vector3d(Cos(leg.psi_rad), Sin(leg.psi_rad), 0);
  return leg;
}

TrackErrors ErrorsOn(const PathLeg& leg, const Eigen::Vector3d& position_m) {
  const auto [sin_psi, cos_psi] = SinCos(leg.psi_rad);
  const Eigen::Vector3d offset_m = Plausible(position_m) - Plausible(leg.from_m);
  return {.x_e_m = offset_m.x() * cos_psi + offset_m.y() * sin_psi,
          .y_e_m = -offset_m.x() * sin_psi + offset_m.y() * cos_psi};
}

double DepthOn(const PathLeg& leg, const Eigen::Vector3d& position_m) {
  if (leg.length_m <= 0) return leg.to_m.z();
  const double part = std::clamp(ErrorsOn(leg, position_m).x_e_m / leg.length_m, 0.0, 1.0);
  return leg.from_m.z() + part * (leg.to_m.z() - leg.from_m.z());
}

double SlopeOf(const PathLeg& leg) {
  return leg.length_m > 0 ? (leg.to_m.z() - leg.from_m.z()) / leg.length_m : 0;
}

bool IsReached(const WaypointSwitch& rule, const PathLeg& leg, const Eigen::Vector3d& position_m) {
  const bool is_curve = rule.is_within_leg && leg.length_m > 0 && rule.rule != SwitchRule::kCircle;
  const double radius_m =
      is_curve ? std::min(rule.acceptance_radius_m, leg.length_m / 2) : rule.acceptance_radius_m;
  const TrackErrors errors = ErrorsOn(leg, position_m);
  const double left_m = leg.length_m - errors.x_e_m;
  const bool passed = left_m <= 0 && std::abs(errors.y_e_m) <= rule.passed_line_within_m;
  const double distance_m = (Plausible(leg.to_m) - Plausible(position_m)).head<2>().norm();
  switch (rule.rule) {
    case SwitchRule::kCircleOrPassedLine:
      return distance_m <= radius_m || passed;
    case SwitchRule::kCircle:
      return distance_m <= radius_m;
    case SwitchRule::kPassedLine:
      return passed;
    case SwitchRule::kAlongTrack:
      return left_m < radius_m;
  }
  SHOAL_CHECK(false, "every switch rule is handled");
}

PathProgress NextLeg(const WaypointPath& path, PathEnd end, PathProgress progress) {
  SHOAL_CHECK(!path.points_m.empty(), "a path has at least one waypoint");
  if (progress.ended) return progress;
  if (progress.approaches) {
    progress.approaches = false;
    return progress;
  }
  const size_t size = path.points_m.size();
  const bool closes = end == PathEnd::kReturnToFirst && size > 1;
  if (closes) {
    progress.previous = (progress.previous + 1) % size;
    if (progress.previous == 0) ++progress.laps_done;
  } else {
    progress.previous = std::min(progress.previous + 1, size - 1);
    progress.ended = progress.previous == size - 1;
  }
  return progress;
}

PathProgress Advance(const WaypointPath& path, const WaypointSwitch& rule, PathEnd end,
                     PathProgress progress, const Eigen::Vector3d& position_m) {
  if (progress.ended) return progress;
  if (!IsReached(rule, CurrentLeg(path, end, progress, position_m), position_m)) return progress;
  return NextLeg(path, end, progress);
}

}  // namespace shoal

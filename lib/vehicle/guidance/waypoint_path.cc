#include "lib/vehicle/guidance/waypoint_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

double Between(double low, double high, Stream& stream) {
  return low + (high - low) * stream.Uniform();
}

// Returns psi of the way between two points, none without a horizontal distance.
std::optional<double> PsiBetween(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
  const Eigen::Vector3d way_m = Plausible(to_m) - Plausible(from_m);
  if (way_m.x() == 0 && way_m.y() == 0) return std::nullopt;
  return WrapPi(Atan2(way_m.y(), way_m.x()));
}

}  // namespace

WaypointPath Insert(WaypointPath path, size_t index, const Eigen::Vector3d& point_m) {
  SHOAL_CHECK(index <= path.points_m.size(),
              "a waypoint is inserted within the path or at its end");
  path.points_m.insert(path.points_m.begin() + static_cast<std::ptrdiff_t>(index), point_m);
  return path;
}

std::vector<double> LegLengths_m(const WaypointPath& path) {
  std::vector<double> lengths_m;
  for (size_t i = 1; i < path.points_m.size(); ++i) {
    lengths_m.push_back((Plausible(path.points_m[i]) - Plausible(path.points_m[i - 1])).norm());
  }
  return lengths_m;
}

std::vector<double> LegPsis_rad(const WaypointPath& path) {
  std::vector<double> psis_rad;
  std::optional<double> last_rad;
  size_t num_unknown = 0;
  for (size_t i = 1; i < path.points_m.size(); ++i) {
    const auto psi_rad = PsiBetween(path.points_m[i - 1], path.points_m[i]);
    if (psi_rad && !last_rad) std::fill_n(psis_rad.begin(), num_unknown, *psi_rad);
    if (psi_rad) last_rad = psi_rad;
    if (!last_rad) ++num_unknown;
    psis_rad.push_back(last_rad.value_or(0));
  }
  return psis_rad;
}

double TotalLength_m(const WaypointPath& path) {
  const std::vector<double> lengths_m = LegLengths_m(path);
  return std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0);
}

double EstimateTime_s(const WaypointPath& path, double speed_mps, double margin) {
  SHOAL_CHECK(speed_mps > 0 && margin > 0, "speed and margin are positive");
  const double time_s = TotalLength_m(path) / speed_mps * margin;
  return std::min(time_s, std::numeric_limits<double>::max());
}

BoundingSquare EstimateArea(const WaypointPath& path, double padding_m) {
  if (path.points_m.empty()) return EstimateArea({{Eigen::Vector3d::Zero()}}, padding_m);
  Eigen::Vector3d low_m = Plausible(path.points_m.front());
  Eigen::Vector3d high_m = low_m;
  for (const Eigen::Vector3d& point_m : path.points_m) {
    low_m = low_m.cwiseMin(Plausible(point_m));
    high_m = high_m.cwiseMax(Plausible(point_m));
  }
  const double extent_m = (high_m - low_m).head<2>().maxCoeff();
  return {.side_m = std::ceil(extent_m + 2 * Plausible(padding_m)),
          .origin_m =
              Eigen::Vector2d(Plausible(padding_m) - low_m.x(), Plausible(padding_m) - low_m.y())};
}

WaypointPath RandomPath(const RandomPathParams& params, Stream& stream) {
  WaypointPath path{{params.start_m}};
  double psi_rad = params.start_psi_rad;
  for (int i = 0; i < params.num_waypoints; ++i) {
    psi_rad = WrapPi(psi_rad + Between(params.min_turn_rad, params.max_turn_rad, stream));
    const double length_m = Between(params.min_leg_m, params.max_leg_m, stream);
    const Eigen::Vector3d& last_m = path.points_m.back();
    path.points_m.emplace_back(last_m.x() + length_m * Cos(psi_rad),
                               last_m.y() + length_m * Sin(psi_rad),
                               Between(params.min_depth_m, params.max_depth_m, stream));
  }
  return path;
}

}  // namespace shoal

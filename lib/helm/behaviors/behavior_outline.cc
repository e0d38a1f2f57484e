#include "lib/helm/behaviors/behavior_outline.h"

#include <utility>

#include "lib/base/geometry/convex_polygon.h"

namespace shoal {

namespace {

using Points = std::vector<Eigen::Vector2d>;

std::vector<TaskOutline> Station(const std::optional<Eigen::Vector2d>& point_m, double radius_m) {
  if (!point_m) return {};
  return {{.points_m = {*point_m}, .radius_m = radius_m}};
}

void AddZone(const Points& given_m, const Points& core_m, double distance_m,
             std::vector<TaskOutline>* zones) {
  if (!given_m.empty()) {
    zones->push_back({.area_m = given_m});
  } else if (distance_m >= 0 && core_m.size() > 2) {
    zones->push_back({.area_m = Grown(core_m, distance_m)});
  }
}

struct Outliner {
  std::vector<TaskOutline> operator()(const WaypointOptions& options) const {
    Points points_m = options.points;
    if (options.order == "reverse") points_m = {points_m.rbegin(), points_m.rend()};
    return {{.points_m = std::move(points_m), .closed = options.repeat != 0}};
  }
  std::vector<TaskOutline> operator()(const LoiterOptions& options) const {
    if (options.center_activate) return {};
    return {{.points_m = options.polygon, .closed = true}};
  }
  std::vector<TaskOutline> operator()(const StationKeepOptions& options) const {
    if (options.center_activate) return {};
    return Station(options.station_pt, options.outer_radius);
  }
  std::vector<TaskOutline> operator()(const RubberBandOptions& options) const {
    return Station(options.point, options.outer_radius);
  }
  std::vector<TaskOutline> operator()(const LegRunOptions& options) const {
    if (!options.p1 || !options.p2) return {};
    return {{.points_m = {*options.p1, *options.p2}}};
  }
  std::vector<TaskOutline> operator()(const OpRegionOptions& options) const {
    std::vector<TaskOutline> zones;
    if (!options.core_poly.empty()) zones.push_back({.area_m = options.core_poly});
    AddZone(options.save_poly, options.core_poly, options.save_dist, &zones);
    AddZone(options.halt_poly, options.core_poly, options.halt_dist, &zones);
    return zones;
  }
  std::vector<TaskOutline> operator()(const AvoidObstacleOptions& options) const {
    if (options.polygon.empty()) return {};
    return {{.area_m = options.polygon}};
  }
  template <class Options>
  std::vector<TaskOutline> operator()(const Options& /*of no place*/) const {
    return {};
  }
};

}  // namespace

std::vector<TaskOutline> OutlinesOf(const AnyBehavior& what) {
  return std::visit(Outliner{}, what);
}

}  // namespace shoal

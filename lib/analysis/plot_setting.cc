#include "lib/analysis/plot_setting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/mission/ocean_of.h"

namespace shoal {

namespace {

CurvePoint PointOf(const Eigen::Vector2d& point_m) { return {point_m.x(), point_m.y()}; }

PlannedPath PathOf(const WaypointsTask& task) {
  PlannedPath path;
  for (const Eigen::Vector2d& point_m : task.points_m) path.legs.push_back(PointOf(point_m));
  if (task.laps != 1 && path.legs.size() > 2) path.legs.push_back(path.legs.front());
  return path;
}

PlannedPath PathOf(const LoiterTask& task) {
  constexpr int kPoints = 72;
  PlannedPath path{.has_points = false};
  for (int i = 0; i <= kPoints; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / kPoints;
    path.legs.push_back({task.center_m.x() + task.radius_m * std::cos(angle_rad),
                         task.center_m.y() + task.radius_m * std::sin(angle_rad)});
  }
  return path;
}

PlannedPath PathOf(const StationKeepTask& task) {
  if (task.here) return {};
  return {.legs = {PointOf(task.point_m)}};
}

PlannedPath PathOf(const ReturnTask& task) { return {.legs = {PointOf(task.point_m)}}; }

PlannedPath PathOf(const PathFollowTask& task) {
  PlannedPath path;
  for (const Eigen::Vector3d& point_m : task.points_m) {
    path.legs.push_back(PointOf(point_m.head<2>()));
  }
  return path;
}

/// A vehicle that follows another has no path of its own.
PlannedPath PathOf(const TargetTrackTask&) { return {}; }

void AddDistances(const VelocityLaw& law, std::vector<DistanceMark>* marks) {
  if (const auto* bearing = std::get_if<ConstantBearingLaw>(&law)) {
    marks->push_back({"r_safe", bearing->r_safe_m});
    return;
  }
  for (const VelocityLayer& layer : std::get<VelocityCascade>(law).layers) {
    const auto* formation = std::get_if<FormationLayer>(&layer);
    if (formation == nullptr) continue;
    marks->push_back({"r_safe", formation->r_safe_m});
    marks->push_back({"r_inner", formation->r_inner_m});
    marks->push_back({"r_outer", formation->r_outer_m()});
  }
}

}  // namespace

PlotSetting SettingOf(const Mission& mission) {
  PlotSetting setting{
      .title = mission.name, .seed = mission.seed, .start_utime = mission.start_utime};
  for (const Vehicle& vehicle : mission.vehicles) {
    PlannedVehicle planned{.name = vehicle.name, .color = vehicle.color};
    for (const Task& task : vehicle.tasks) {
      PlannedPath path = std::visit([](const auto& what) { return PathOf(what); }, task.what);
      if (!path.legs.empty()) planned.paths.push_back(std::move(path));
      if (const auto* tracking = std::get_if<TargetTrackTask>(&task.what)) {
        planned.target = tracking->target;
        AddDistances(tracking->track.law, &setting.distances);
      }
    }
    setting.vehicles.push_back(std::move(planned));
  }
  if (const Result<Ocean> ocean = OceanOf(mission); ocean.ok() && ocean->floor) {
    setting.floor_depth_m = [floor = *ocean->floor](double x_m, double y_m) {
      return floor.DepthAt({x_m, y_m});
    };
  }
  std::stable_sort(
      setting.distances.begin(), setting.distances.end(),
      [](const DistanceMark& a, const DistanceMark& b) { return a.distance_m < b.distance_m; });
  setting.distances.erase(std::unique(setting.distances.begin(), setting.distances.end()),
                          setting.distances.end());
  return setting;
}

}  // namespace shoal

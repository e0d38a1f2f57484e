#include "lib/tools/plot/plot_setting.h"

#include <algorithm>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/helm/behaviors/behavior_outline.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/model/coverage_area.h"

namespace shoal {

namespace {

CurvePoint PointOf(const Eigen::Vector2d& point_m) { return {point_m.x(), point_m.y()}; }

/// Returns the path of a task; empty where it has none of its own.
PlannedPath PathOf(const TaskOutline& outline) {
  if (outline.circle) {
    constexpr int kPoints = 72;
    PlannedPath circle{.has_points = false};
    for (int i = 0; i <= kPoints; ++i) {
      const double angle_rad = 2 * std::numbers::pi * i / kPoints;
      circle.legs.push_back(
          {outline.circle->center_m.x() + outline.circle->radius_m * Cos(angle_rad),
           outline.circle->center_m.y() + outline.circle->radius_m * Sin(angle_rad)});
    }
    return circle;
  }
  PlannedPath path{.has_points = outline.marks_points};
  for (const Eigen::Vector2d& point_m : outline.points_m) path.legs.push_back(PointOf(point_m));
  if (outline.closed && path.legs.size() > 2) path.legs.push_back(path.legs.front());
  return path;
}

void AddArea(const std::vector<Eigen::Vector2d>& polygon_m, std::vector<Stroke>* areas) {
  if (polygon_m.empty()) return;
  Stroke area;
  for (const Eigen::Vector2d& corner_m : polygon_m) area.push_back(PointOf(corner_m));
  area.push_back(area.front());
  const bool is_known = std::find(areas->begin(), areas->end(), area) != areas->end();
  if (!is_known) areas->push_back(std::move(area));
}

void AddCoverage(const Mission& mission, const CoverageExpectation& coverage,
                 PlotSetting* setting) {
  for (const auto& polygon_m : PolygonsOf(mission, coverage)) AddArea(polygon_m, &setting->areas);
  for (const size_t place : VehiclesOf(mission, coverage)) {
    setting->coverage.push_back({mission.vehicles[place].name, coverage.sensor_width_m});
  }
}

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
  for (const Obstacle& obstacle : mission.obstacles) {
    AddArea(obstacle.polygon_m, &setting.obstacles);
  }
  for (const Vehicle& vehicle : mission.vehicles) {
    PlannedVehicle planned{
        .name = vehicle.name, .color = vehicle.color, .length_m = vehicle.length_m};
    if (FactsOfModel(vehicle.model).passive.empty()) planned.draught_m = DraughtOf(vehicle);
    for (const Task& task : vehicle.tasks) {
      const TaskOutline outline = FactsOf(task).outline;
      AddArea(outline.area_m, &setting.areas);
      PlannedPath path = PathOf(outline);
      if (!path.legs.empty()) planned.paths.push_back(std::move(path));
      if (const auto* tracking = std::get_if<TargetTrackTask>(&task.what)) {
        planned.target = tracking->target;
        AddDistances(tracking->track.law, &setting.distances);
      }
    }
    for (const BehaviorOptions& behavior : vehicle.behaviors) {
      for (const TaskOutline& outline : OutlinesOf(behavior.what)) {
        AddArea(outline.area_m, &setting.areas);
        PlannedPath path = PathOf(outline);
        if (!path.legs.empty()) planned.paths.push_back(std::move(path));
      }
    }
    setting.vehicles.push_back(std::move(planned));
  }
  for (const Expectation& expectation : mission.expectations) {
    if (const auto* coverage = std::get_if<CoverageExpectation>(&expectation.what)) {
      AddCoverage(mission, *coverage, &setting);
    }
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

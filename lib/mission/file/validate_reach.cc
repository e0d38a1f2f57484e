// What vehicles cannot do that the mission asks of them: reach their points in time, go so fast,
// stem the current, send by a medium that they do not have.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/ocean_of.h"
#include "lib/mission/file/task_way.h"
#include "lib/mission/file/validate.h"
#include "lib/vehicle/vehicle/surface_craft.h"

namespace shoal {

namespace {

/// A current this close to a vehicle's speed leaves it hardly any way against it.
constexpr double kNearlyAsFast = 0.8;

/// Returns the speed that a task asks for; 0: it names none.
double SpeedOf_mps(const Task& task) {
  return std::visit(
      [](const auto& what) -> double {
        if constexpr (requires { what.speed_mps; }) return what.speed_mps;
        return 0;
      },
      task.what);
}

/// Where a task's way begins, as far as it is known: where the one before it ends, else the start.
Eigen::Vector3d BeginningOf_m(const Vehicle& vehicle, size_t task) {
  if (task > 0) {
    const std::optional<TaskWay> before = WayOf(vehicle.tasks[task - 1]);
    if (before && !before->points_m.empty()) return before->points_m.back();
  }
  return {vehicle.start.x_m, vehicle.start.y_m, vehicle.start.depth_m};
}

/// A way that takes longer than this number of missions is a mistake, even if nothing waits for its
/// end.
constexpr double kMistakenDuration = 1.5;

/// Paths of underwater vehicles have their own (validate_paths.cc). A survey may well go on until
/// the end of the mission.
void WarnOfTime(const Mission& mission, const TablePlace& table, const Vehicle& vehicle,
                size_t task) {
  const Task& each = vehicle.tasks[task];
  const bool must_end = MustEnd(mission, vehicle, task);
  if (std::holds_alternative<SurveyTask>(each.what) && !must_end) return;
  const bool is_forever = std::holds_alternative<WaypointsTask>(each.what) &&
                          std::get<WaypointsTask>(each.what).laps == 0;
  if (is_forever || std::holds_alternative<PathFollowTask>(each.what)) return;
  const std::optional<TaskWay> way = WayOf(each);
  if (!way || way->points_m.empty() || !(way->speed_mps > 0)) return;
  const double length_m = LengthFrom_m(BeginningOf_m(vehicle, task), *way);
  const double time_s = length_m / way->speed_mps;
  if (time_s <= (must_end ? 1 : kMistakenDuration) * mission.duration_s) return;
  table.Warn(way->key,
             fmt::format("the way to the last point is {:.0f} m long and takes {:.0f} s at {:g} "
                         "m/s, but the mission ends after {:g} s: raise duration_s or speed_mps",
                         length_m, time_s, way->speed_mps, mission.duration_s));
}

void WarnOfSpeed(const TablePlace& table, const Vehicle& vehicle, double speed_mps) {
  const auto* craft = std::get_if<SurfaceCraftParams>(&vehicle.model);
  if (craft == nullptr) return;
  const double fastest_mps = SteadySpeed(*craft, 100);
  if (speed_mps <= fastest_mps) return;
  table.Warn("speed_mps",
             fmt::format("speed_mps = {:g} is more than the {:.2f} m/s that {} reaches "
                         "at full thrust: see thrust_map in [vehicle.surface_craft]",
                         speed_mps, fastest_mps, vehicle.name));
}

void WarnOfCurrent(const TablePlace& table, const Vehicle& vehicle, double speed_mps,
                   double current_mps) {
  if (speed_mps <= 0 || current_mps < kNearlyAsFast * speed_mps) return;
  table.Warn("speed_mps",
             fmt::format("the current flows with {:.2f} m/s, and {} is to go {:g} m/s relative to "
                         "the water: it {} against it; raise speed_mps",
                         current_mps, vehicle.name, speed_mps,
                         current_mps < speed_mps ? "hardly makes way" : "makes no way"));
}

/// Warns of vehicles that have none of the media that their reports go over.
void WarnOfMedia(const Mission& mission, const TablePlace& file) {
  const MediaChoice& over = mission.comms.reports_over;
  if (!mission.HasMedia() || over.names.empty()) return;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    if (!mission.IsReported(vehicle) || vehicle.media.names.empty()) continue;
    const bool has_one = std::ranges::any_of(
        over.names, [&](const std::string& medium) { return vehicle.HasMedium(medium); });
    if (has_one) continue;
    file.Below("vehicle", i)
        .Warn("media",
              fmt::format("no report of {} can be sent: reports_over = {} in [comms], and "
                          "it has {}; add a medium to either",
                          vehicle.name, TextOf(over), fmt::join(vehicle.media.names, ", ")));
  }
}

}  // namespace

void WarnOfReach(const Mission& mission, const TablePlace& file) {
  if (!file.IsSound()) return;
  const Result<Ocean> ocean = OceanOf(mission);
  const bool is_same_everywhere = ocean.ok() && !ocean->current_grid;
  const double current_mps = is_same_everywhere ? ocean->current.VelocityAt(0).norm() : 0;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      const TablePlace table = file.Below("vehicle", i).Below("task", k);
      const double speed_mps = SpeedOf_mps(vehicle.tasks[k]);
      WarnOfTime(mission, table, vehicle, k);
      WarnOfSpeed(table, vehicle, speed_mps);
      WarnOfCurrent(table, vehicle, speed_mps, current_mps);
    }
  }
  WarnOfMedia(mission, file);
}

}  // namespace shoal

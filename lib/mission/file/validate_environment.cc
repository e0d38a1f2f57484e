// Whether the sea of [environment] can be made, and is there where the vehicles start.
#include <fmt/format.h>

#include <utility>

#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/file/validate_ground.h"

namespace shoal {

namespace {

/// The grids of a mission, for messages.
const std::string& GridText(const CurrentGridOptions& options) {
  return options.file.empty() ? options.east : options.file;
}

/// Refuses a start where the current is not known, and warns of one on land.
void ValidateStart(const Mission& mission, const CurrentGrid& grid, const GridNotes& notes,
                   const Vehicle& vehicle, const TablePlace& place) {
  const Eigen::Vector2d start_m(vehicle.start.x_m, vehicle.start.y_m);
  const std::string& name = GridText(mission.environment.current_grid);
  const char* const moved_by = notes.needs_origin ? "origin in [mission]" : "grid_origin";
  const std::string where =
      fmt::format("{} starts at ({:g}, {:g})", vehicle.name, start_m.x(), start_m.y());
  if (!grid.IsInside(start_m)) {
    place.Refuse("start", fmt::format("{}, outside of the current's grid {}: start it inside, move "
                                      "the grid ({}), or name a larger one",
                                      where, name, moved_by));
  } else if (grid.IsLand(start_m)) {
    place.Warn("start", fmt::format("{}, where the current's grid {} has no data at any time: the "
                                    "water stands still there",
                                    where, name));
  }
}

void ValidateCurrentGrid(const Mission& mission, const CurrentGrid& grid, const GridNotes& notes,
                         const TablePlace& file) {
  const TablePlace current = file.Below("environment").Below("current");
  if (!grid.is_steady() && (grid.first_s() > 0 || grid.last_s() < mission.duration_s)) {
    current.Warn("grid", fmt::format("the grid has the current from {:.10g} to {:.10g} s of the "
                                     "mission, which lasts {:g} s: earlier and later it is that of "
                                     "the nearest time; see grid_time",
                                     grid.first_s(), grid.last_s(), mission.duration_s));
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    // A recorded track needs no water.
    if (std::holds_alternative<TrackOptions>(mission.vehicles[i].model)) continue;
    ValidateStart(mission, grid, notes, mission.vehicles[i], file.Below("vehicle", i));
  }
}

void WarnOfFloorElsewhere(const Mission& mission, const SeaFloor& floor, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    if (floor.Covers({vehicle.start.x_m, vehicle.start.y_m})) continue;
    file.Below("vehicle", i)
        .Warn("start", fmt::format("{} starts off the map of the sea floor, {}: the depth there is "
                                   "taken to be that of the map's nearest edge",
                                   vehicle.name, mission.environment.floor.grid));
  }
}

/// Warns where grid_origin and the mission's origin are different places.
void WarnOfTwoOrigins(const Mission& mission, const GeoPoint& own, const char* key,
                      const TablePlace& environment) {
  constexpr double kSame_m = 100;
  const LocalFrame frame({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg});
  const auto place_m = frame.ToLocal(own);
  if (place_m && place_m->norm() <= kSame_m) return;
  environment.Warn(key, fmt::format("grid_origin places the mission's origin at latitude {:.6f}, "
                                    "longitude {:.6f} of the grid's map, and origin in [mission] "
                                    "elsewhere: remove grid_origin, and the map lies by origin",
                                    own.lat_deg, own.lon_deg));
}

}  // namespace

void ValidateEnvironment(const Mission& mission, const TablePlace& file) {
  const TablePlace environment = file.Below("environment");
  if (!file.Has("environment") || !environment.IsSound()) return;
  const CurrentGridOptions& current = mission.environment.current_grid;
  const Result<Ocean> ocean = OceanOf(mission);
  if (!ocean.ok()) {
    const bool is_current =
        current.exists() && !ReadCurrentGrid(current, PlacementOf(mission)).ok();
    return environment.Refuse(is_current ? "current" : "floor", ocean.error());
  }
  const bool has_origin = file.Below("mission").Has("origin");
  for (const auto& [key, notes] :
       {std::pair("current", &ocean->current_notes), std::pair("floor", &ocean->floor_notes)}) {
    if (notes->needs_origin && !has_origin) {
      return environment.Refuse(
          key,
          "its grid has latitudes and longitudes, and the mission does not "
          "state where it takes place: write in [mission] origin = {lat_deg = "
          "..., lon_deg = ...}");
    }
    for (const std::string& warning : notes->warnings) environment.Warn(key, warning);
    if (notes->own_origin && has_origin)
      WarnOfTwoOrigins(mission, *notes->own_origin, key, environment);
  }
  if (ocean->current_grid) {
    ValidateCurrentGrid(mission, *ocean->current_grid, ocean->current_notes, file);
  }
  if (!ocean->floor) return;
  WarnOfFloorElsewhere(mission, *ocean->floor, file);
  ValidateGround(mission, *ocean->floor, file);
}

}  // namespace shoal

// What a log does not contain and its mission does: names, colours, where the vehicles were sent,
// what the sea floor is like. Figures use what is there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/tools/plot/plot_curve.h"

namespace shoal {

/// Where a task sends its vehicle.
struct PlannedPath {
  Stroke legs = {};        ///< x East, y North; the line from point to point.
  bool has_points = true;  ///< The points are waypoints; false: they only shape a circle.
};

/// What the mission expects to be covered.
struct PlannedCoverage {
  std::string vehicle;
  double width_m = 0;  ///< Of its sensor.
};

struct PlannedVehicle {
  std::string name;
  std::string color;
  std::vector<PlannedPath> paths = {};
  std::string target = {};  ///< The vehicle that it tracks; empty: none.
  double length_m = 0;      ///< 0: it collides with nothing.
  /// 0: it dives. Absent: it cannot run aground.
  std::optional<double> draught_m = {};
};

/// A distance that a guidance law holds to.
struct DistanceMark {
  std::string name;  ///< "r_safe".
  double distance_m = 0;

  bool operator==(const DistanceMark&) const = default;
};

struct PlotSetting {
  std::string title;                        ///< The mission's name; without one, the log's.
  std::optional<uint64_t> seed = {};        ///< Absent: not known.
  std::optional<int64_t> start_utime = {};  ///< When the mission began; absent: not known.
  std::vector<PlannedVehicle> vehicles = {};
  std::vector<Stroke> obstacles = {};  ///< Closed lines.
  std::vector<Stroke> areas = {};      ///< Closed lines around what is surveyed, each once.
  std::vector<PlannedCoverage> coverage = {};
  std::vector<DistanceMark> distances = {};  ///< Without repetition, in order of distance.
  std::function<double(double x_m, double y_m)> floor_depth_m = {};  ///< May be empty.
};

/// Returns the setting of `mission`, without the sea floor.
[[nodiscard]] PlotSetting SettingOf(const Mission& mission);

}  // namespace shoal

// The sea of a mission and the network in it, as data: [environment] and [acoustics].
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "lib/sea/acoustics/acoustic_options.h"

namespace shoal {

/// `[environment.current]`: each a number, two numbers ("0.1..0.4") from which one is drawn, or the
/// name of a zone (lib/sea/ocean/current_zones.h).
struct CurrentWords {
  std::string speed_mps = "0";
  std::string direction_deg = "0";  ///< Toward which it flows, clockwise from North.
  std::string speed_deviation_mps = "0";
  std::string direction_deviation_deg = "0";
  std::string speed_half_period_s = "60";
  std::string direction_half_period_s = "60";

  bool operator==(const CurrentWords&) const = default;
};

/// `[environment.current]` with a grid: other water at another place, depth and time.
struct CurrentGridOptions {
  std::string file;   ///< grid: a NetCDF file with both components.
  std::string east;   ///< grid_east: an ESRI ASCII file, or a NetCDF file and its variable.
  std::string north;  ///< grid_north: likewise.
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< The mission's origin in the grid.
  std::string time = "first";  ///< The grid's time at the mission's start: first, absolute, a date.

  bool exists() const { return !file.empty() || !east.empty() || !north.empty(); }
  bool operator==(const CurrentGridOptions&) const = default;
};

/// `[environment.floor]`.
struct FloorOptions {
  std::string style = "none";  ///< none, flat, linear, sigmoid, shelf or grid.
  double depth_m = 125;        ///< The least.
  double range_m = 10;         ///< How much deeper it gets.
  double size_m = 1000;        ///< The map's side; its middle is the mission's origin.
  double scale_m = 300;        ///< From hill to hill, about.
  double slope_east = 0;       ///< Metres deeper per metre.
  double slope_north = 0;
  std::string grid;  ///< grid: the path of an ESRI ASCII file, or of NetCDF: "bay.nc:variable".
  /// Its numbers are depths, or elevations. Absent: as the file states, else elevations.
  std::optional<bool> grid_is_depth = {};
  Eigen::Vector2d grid_origin_m = Eigen::Vector2d::Zero();  ///< The mission's origin in the grid.
  double grid_gap_depth_m = -1;  ///< Of points without data; negative: there may be none.

  bool operator==(const FloorOptions&) const = default;
};

/// What two vehicles do that come nearer than the mean of their lengths.
enum class ContactRule {
  kIgnore,  ///< They pass through each other.
  kStop,    ///< Both stand still from then on.
};

/// `[environment.plume]`: pollution that leaks from a point.
struct PlumeOptions {
  bool exists = false;  ///< The file has the table.
  Eigen::Vector3d source_m = {0, 0, 30};
  double rate_gps = 1.59;
  double current_mps = 1.5;
  double direction_deg = 90;  ///< Toward which it drifts, clockwise from North.

  bool operator==(const PlumeOptions&) const = default;
};

/// `[environment]`.
struct Environment {
  CurrentWords current;
  CurrentGridOptions current_grid;  ///< Where it exists, `current` has no effect.
  FloorOptions floor;
  PlumeOptions plume;
  ContactRule contact = ContactRule::kIgnore;

  bool operator==(const Environment&) const = default;
};

/// `[acoustics]`: the acoustic network, which carries what `reports_over` and `messages_over`
/// select, and ACOUSTIC_TX always.
struct Acoustics {
  /// The mission uses it: it has the table, or traffic that goes over it. Only then must
  /// there be a channel for each vehicle.
  bool is_used = false;
  /// Which of the packets that wait is thrown away when one more comes than there is room for.
  enum class QueueDrop : uint8_t { kOldest, kNewest };

  bool crc = true;    ///< Four more bytes on the air; receivers drop packets that fail the check.
  bool queue = true;  ///< A vehicle sends one packet after another; false: at once, as muNet does.
  int64_t queue_length = 16;  ///< At most as many packets of one vehicle wait; > 0.
  QueueDrop queue_drop = QueueDrop::kOldest;
  AcousticOptions options;

  bool operator==(const Acoustics&) const = default;
};

}  // namespace shoal

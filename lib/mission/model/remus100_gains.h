// The autopilot of a Remus 100 in mission files: [vehicle.autopilot] with model = "remus100".
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// The gains of AuvPilot (lib/vehicle/control). None is negative: which way a fin turns the vehicle
/// is its model's.
struct Remus100Gains {
  std::string gains = "default";  ///< The set that the others are from: default, munet or fossen.
  double heading_kp = 0;          ///< Radian of rudder per radian of error.
  double heading_ki = 0;          ///< Per radian-second.
  double heading_kd = 0;          ///< Per radian per second.
  double heading_observer_hz = 0;
  double pitch_kp = 0;  ///< Radian of stern plane per radian of error.
  double pitch_ki = 0;
  double pitch_kd = 0;
  double heave_kd = 0;  ///< Radian of stern plane per m/s of sinking.
  double depth_kp = 0;  ///< Radian of pitch per metre of error.
  double depth_ki = 0;  ///< Per metre-second.
  double max_pitch_deg = 0;
  double max_fin_deg = 0;

  bool operator==(const Remus100Gains&) const = default;
};

/// Returns the set of that name. @pre "default", "munet" or "fossen"
[[nodiscard]] Remus100Gains Remus100GainsNamed(std::string_view name);

}  // namespace shoal

// What checks and pages must know of a vehicle model, whatever its parameters are.
#pragma once

#include <string_view>

namespace shoal {

struct ModelFacts {
  std::string_view name;          ///< model = "remus100" and [vehicle.remus100] in mission files.
  bool is_underwater = false;     ///< It dives: it can start at a depth and do underwater tasks.
  double longest_tick_s = 0;      ///< A longer tick_s cannot steer it; 0: any can.
  double turning_diameter_m = 0;  ///< Of its circle with full rudder; 0: the defaults suit it.
  /// What it is that has no actuators, and so neither helm nor tasks: "moored". Empty: it has some.
  std::string_view passive = "";
};

}  // namespace shoal

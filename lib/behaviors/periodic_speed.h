// Alternates between no preference and a speed.
#pragma once

#include <string_view>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "periodic_speed". Alternates between no preference and a speed.
struct PeriodicSpeedOptions {
  static constexpr std::string_view kKind = "periodic_speed";

  double period_lazy = 0;   ///< s without preference; > 0.
  double period_busy = 0;   ///< s with a preference; > 0.
  double period_speed = 0;  ///< m/s.
  double peakwidth = 0;     ///< m/s.
  double basewidth = 0;     ///< m/s.
  double summitdelta = 25;  ///< 0 to 100.
  bool initially_busy = false;
  bool reset_upon_running = true;  ///< Begins anew after a pause.

  bool operator==(const PeriodicSpeedOptions&) const = default;
};

}  // namespace shoal

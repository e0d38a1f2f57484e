// The figures of `shoal rays`: impulse response, ray fan, transmission loss.
#pragma once

#include <string>
#include <vector>

#include "lib/sea/rays/eigenrays.h"
#include "lib/tools/plot/plot_script.h"

namespace shoal {

/// What they show.
struct RayLink {
  std::string title;
  RayScene scene;
  double range_m = 0;
  double source_m = 0;
  double receiver_m = 0;
  double absorption_dbpkm = 0;
  RayLimits limits;
  std::vector<RayArrival> arrivals;  ///< In order of delay.
};

/// Returns the figures impulse, fan and loss.
[[nodiscard]] std::vector<Figure> DrawRays(const RayLink& link, bool png);

}  // namespace shoal

// What a vehicle knows of the sea floor on its way, by `floor_from`: its altimeter, which gives the
// slope from what has passed below; its sonar as well, which sees what is ahead; or the mission's
// own chart.
//
//   FloorView floor(vehicle, chart);
//   floor.OnSonar(ping);
//   DepthBound bound = floor.Look(nav, turn_rad, dt_s, climb_mps);
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/control/floor_ahead.h"
#include "shoal/nav_t.hpp"
#include "shoal/sonar_t.hpp"

namespace shoal {

class FloorView {
 public:
  /// `chart`: the floor of the mission; used, and needed, with floor_from = "chart".
  FloorView(const Remus100Options& options, const SonarOptions& sonar,
            std::optional<SeaFloor> chart);

  /// Takes note of what the sonar saw.
  void OnSonar(const sonar_t& ping);

  /// Returns how deep the vehicle may go, `dt_s` after the last call. It is about to turn by
  /// `turn_rad`, clockwise, and can climb at `climb_mps` > 0.
  [[nodiscard]] DepthBound Look(const nav_t& nav, double turn_rad, double dt_s, double climb_mps);

  /// Forgets what has passed below and ahead.
  void Forget();

 private:
  std::vector<FloorPoint> ChartAhead(const nav_t& nav, double course_rad, double turn_rad,
                                     double speed_mps) const;
  DepthBound SonarBound(const nav_t& nav, double course_rad, double dt_s,
                        const Clearance& clearance);
  /// Returns the echoes on the way, raised by `higher_m`.
  std::vector<FloorPoint> EchoesAhead(const sonar_t& ping, const nav_t& nav, double course_rad,
                                      double higher_m) const;

  enum class Source { kAltimeter, kSonar, kChart };

  Source source_;
  double clearance_m_;
  double sonar_step_m_;  ///< Its ranges are rounded up to such steps.
  std::optional<SeaFloor> chart_;
  sonar_t ping_{};           ///< Each beam raised to the next above it; without the highest.
  sonar_t highest_beams_{};  ///< Those of the ping that look highest.
  double held_m_ = std::numeric_limits<double>::infinity();  ///< By what the sonar saw.
  FloorLine line_;
};

}  // namespace shoal

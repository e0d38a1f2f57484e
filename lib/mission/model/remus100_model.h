// The underwater vehicle in mission files: model = "remus100" and its table [vehicle.remus100].
#pragma once

#include <optional>
#include <string>

#include "lib/mission/model/model_facts.h"
#include "lib/mission/model/remus100_gains.h"
#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

class Fields;

/// `[vehicle.remus100]`: the underwater vehicle and its autopilots.
struct Remus100Options {
  std::string parameters = "default";  ///< default, munet or fossen: docs/vehicles/vehicles.md.
  double model_step_s = 0.02;          ///< The longest step of integration within a tick.
  double cruise_depth_m = 0;           ///< Of tasks that name no depth.
  double max_depth_m = 100;
  double seabed_clearance_m = 5;
  double depth_filter_s = 20;           ///< Time constant of the commanded depth; 0: one step.
  double max_propeller_rate_rpmps = 0;  ///< 0: the propeller is commanded at once.
  /// When submerged; 1 is neutral, above 1 floats up. Absent: what suits `parameters`, BuoyancyOf.
  std::optional<double> buoyancy_by_weight = {};
  /// What it knows of the floor ahead: altimeter, sonar (and altimeter), or chart.
  std::string floor_from = "altimeter";
  std::optional<Remus100Gains> autopilot = {};  ///< Absent: the set that suits `parameters`.

  bool operator==(const Remus100Options&) const = default;
};

constexpr ModelFacts FactsOf(const Remus100Options& /*model*/) {
  return {
      .name = "remus100", .is_underwater = true, .longest_tick_s = 0.2, .turning_diameter_m = 45};
}

/// Returns buoyancy by weight: a default hull floats up as a real one is ballasted to, by 1.5 N of
/// 304 N; those of the published programs are neutral.
[[nodiscard]] double BuoyancyOf(const Remus100Options& options);
/// Returns what the vehicle is made of. @pre the name of the parameters is one of the three
[[nodiscard]] Remus100Params ParamsOf(const Remus100Options& model);
/// Returns the gains that steer it.
[[nodiscard]] Remus100Gains GainsOf(const Remus100Options& options);

/// [vehicle.remus100].
void Describe(Fields& fields, Remus100Options& options);

}  // namespace shoal

// The table [vehicle.remus100].
#include <array>
#include <optional>
#include <string_view>

#include "lib/base/check/check.h"
#include "lib/mission/file/describe.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

double BuoyancyOf(const Remus100Options& options) {
  constexpr double kFloats = 1.005;
  return options.buoyancy_by_weight.value_or(options.parameters == "default" ? kFloats : 1);
}

Remus100Params ParamsOf(const Remus100Options& model) {
  std::optional<Remus100Params> params = Remus100ParamsByName(model.parameters);
  SHOAL_CHECK(params.has_value(), "the mission file was checked");
  params->buoyancy_by_weight = BuoyancyOf(model);
  return *params;
}

void Describe(Fields& fields, Remus100Options& options) {
  constexpr double kDeepest_m = 20'000;
  constexpr std::array<std::string_view, 3> kParameters = {"default", "munet", "fossen"};
  constexpr std::array<std::string_view, 3> kFloorSources = {"altimeter", "sonar", "chart"};
  fields.Word("parameters", options.parameters, kParameters);
  fields.Number("model_step_s", options.model_step_s, Between(1e-4, kMaxRemus100Step_s));
  fields.Number("cruise_depth_m", options.cruise_depth_m, Between(0, kDeepest_m));
  fields.Number("max_depth_m", options.max_depth_m, Above(0, kDeepest_m));
  fields.Number("seabed_clearance_m", options.seabed_clearance_m, Between(0, 1000));
  fields.Number("depth_filter_s", options.depth_filter_s, Between(0, 1000));
  fields.Number("max_propeller_rate_rpmps", options.max_propeller_rate_rpmps, Between(0, 1e6));
  double buoyancy_by_weight = BuoyancyOf(options);
  fields.Number("buoyancy_by_weight", buoyancy_by_weight, Between(0.9, 1.1));
  if (buoyancy_by_weight != BuoyancyOf(options)) options.buoyancy_by_weight = buoyancy_by_weight;
  fields.Word("floor_from", options.floor_from, kFloorSources);
}

}  // namespace shoal

// What a [[vehicle]] navigates with, [vehicle.navigation], and the places that it may range to,
// [[beacon]].
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "lib/base/geometry/angles.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/model/navigation_options.h"

namespace shoal {
namespace {

constexpr NumberLimits kRate_hz = Above(0, 100);
constexpr NumberLimits kShare = Between(0, 1);

void Describe(Fields& fields, NavigationOptions::CompassKeys& compass) {
  fields.Number("bias_deg", compass.bias_deg, Between(-180, 180));
  fields.Number("bias_sigma_deg", compass.bias_sigma_deg, Between(0, 90));
  fields.Number("noise_deg", compass.noise_deg, Above(0, 90));
  if (fields.Has("deviation_deg", !compass.deviation_deg.empty())) {
    constexpr size_t kCoefficients = 5;
    std::vector<double>& deviation_deg = compass.deviation_deg;
    fields.Numbers("deviation_deg", deviation_deg, kCoefficients);
    if (deviation_deg.size() != kCoefficients) {
      fields.Refuse("deviation_deg",
                    "deviation_deg needs five coefficients, [A, B, C, D, E], like "
                    "[0, 2, -1, 0.5, 0]");
    } else if (!(std::abs(deviation_deg[0]) <= 180) ||
               !(std::abs(deviation_deg[1]) + std::abs(deviation_deg[2]) +
                     2 * std::abs(deviation_deg[3]) + 2 * std::abs(deviation_deg[4]) <=
                 RadToDeg(kMaxDeviation))) {
      fields.Refuse("deviation_deg",
                    fmt::format("|B| + |C| + 2 |D| + 2 |E| must be at most {:.1f} degrees, and "
                                "|A| at most 180: beyond that one heading has several readings",
                                RadToDeg(kMaxDeviation)));
    }
  }
  fields.Number("rate_hz", compass.rate_hz, kRate_hz);
}

void Describe(Fields& fields, NavigationOptions::GyroKeys& gyro) {
  fields.Number("bias_degph", gyro.bias_degph, Between(-36'000, 36'000));
  fields.Number("bias_sigma_degph", gyro.bias_sigma_degph, Between(0, 36'000));
  fields.Number("noise_deg_per_rth", gyro.noise_deg_per_rth, Between(0, 1000));
  fields.Number("bias_walk_degph_per_rth", gyro.bias_walk_degph_per_rth, Between(0, 36'000));
}

void Describe(Fields& fields, NavigationOptions::DvlKeys& dvl) {
  fields.Flag("fitted", dvl.fitted);
  fields.Number("min_altitude_m", dvl.min_altitude_m, Between(0, 20'000));
  fields.Number("max_altitude_m", dvl.max_altitude_m, Between(0, 20'000));
  if (dvl.max_altitude_m < dvl.min_altitude_m) {
    fields.Refuse("max_altitude_m", "max_altitude_m must not be less than min_altitude_m");
  }
  fields.Number("scale_error", dvl.scale_error, Between(-0.5, 0.5));
  fields.Number("scale_sigma", dvl.scale_sigma, Between(0, 0.5));
  fields.Number("noise_mps", dvl.noise_mps, Above(0, kFastest_mps));
  fields.Number("dropout", dvl.dropout, kShare);
  fields.Number("rate_hz", dvl.rate_hz, kRate_hz);
}

void Describe(Fields& fields, NavigationOptions::LogKeys& log) {
  fields.Flag("fitted", log.fitted);
  fields.Number("noise_mps", log.noise_mps, Above(0, kFastest_mps));
  fields.Number("rate_hz", log.rate_hz, kRate_hz);
}

void Describe(Fields& fields, NavigationOptions::DepthKeys& depth) {
  fields.Number("bias_m", depth.bias_m, Between(-1000, 1000));
  fields.Number("bias_sigma_m", depth.bias_sigma_m, Between(0, 1000));
  fields.Number("noise_m", depth.noise_m, Between(0, 1000));
}

void Describe(Fields& fields, NavigationOptions::GpsKeys& gps) {
  fields.Flag("fitted", gps.fitted);
  fields.Number("antenna_depth_m", gps.antenna_depth_m, Between(0, 100));
  fields.Number("cold_fix_s", gps.cold_fix_s, Between(0, kLongest_s));
  fields.Number("hot_fix_s", gps.hot_fix_s, Between(0, kLongest_s));
  fields.Number("hot_for_s", gps.hot_for_s, Between(0, kLongest_s));
  fields.Flag("starts_hot", gps.starts_hot);
  fields.Number("noise_m", gps.noise_m, Above(0, 10'000));
  fields.Number("rate_hz", gps.rate_hz, kRate_hz);
}

void Describe(Fields& fields, NavigationOptions::ClockKeys& clock) {
  fields.Number("phase_ms", clock.phase_ms, Between(-10'000, 10'000));
  fields.Number("phase_sigma_ms", clock.phase_sigma_ms, Between(0, 10'000));
  fields.Number("drift_ppm", clock.drift_ppm, Between(-1000, 1000));
  fields.Number("drift_sigma_ppm", clock.drift_sigma_ppm, Between(0, 1000));
}

void Describe(Fields& fields, NavigationOptions::RangingKeys& ranging) {
  fields.Flag("fitted", ranging.fitted);
  fields.Number("max_range_m", ranging.max_range_m, Above(0, 100'000));
  fields.Number("noise_m", ranging.noise_m, Above(0, 10'000));
  fields.Number("dropout", ranging.dropout, kShare);
  fields.Number("outlier_ratio", ranging.outlier_ratio, kShare);
  fields.Number("outlier_m", ranging.outlier_m, Between(0, 100'000));
  fields.Flag("usbl", ranging.usbl);
  fields.Number("bearing_noise_deg", ranging.bearing_noise_deg, Above(0, 180));
  fields.Number("depression_noise_deg", ranging.depression_noise_deg, Above(0, 90));
}

void Describe(Fields& fields, NavigationOptions& options) {
  constexpr std::array<std::pair<std::string_view, NavigationGrade>, 2> kGrades = {{
      {"survey", NavigationGrade::kSurvey},
      {"low_cost", NavigationGrade::kLowCost},
  }};
  fields.Choice("grade", options.grade, kGrades);
  if (fields.reading()) options = NavigationOfGrade(options.grade);
  options.is_fitted = true;
  fields.Number("start_sigma_m", options.start_sigma_m, Between(0, 10'000));
  fields.Number("start_heading_sigma_deg", options.start_heading_sigma_deg, Between(0, 90));
  fields.Number("current_sigma_mps", options.current_sigma_mps, Between(0, kFastest_mps));
  fields.Number("gate_probability", options.gate_probability, Between(0.5, 0.999999999));
  fields.Number("report_every_s", options.report_every_s, Above(0, 3600));
  fields.Below("compass", [&](Fields& table) { Describe(table, options.compass); });
  fields.Below("gyro", [&](Fields& table) { Describe(table, options.gyro); });
  fields.Below("dvl", [&](Fields& table) { Describe(table, options.dvl); });
  fields.Below("log", [&](Fields& table) { Describe(table, options.log); });
  fields.Below("depth", [&](Fields& table) { Describe(table, options.depth); });
  fields.Below("gps", [&](Fields& table) { Describe(table, options.gps); });
  fields.Below("clock", [&](Fields& table) { Describe(table, options.clock); });
  fields.Below("ranging", [&](Fields& table) { Describe(table, options.ranging); });
}

}  // namespace

void DescribeNavigation(Fields& fields, Vehicle& vehicle) {
  if (!fields.Has("navigation", vehicle.navigation.is_fitted)) return;
  fields.Below("navigation", [&](Fields& table) {
    Describe(table, vehicle.navigation);
    if (vehicle.sensors.is_fitted) {
      table.Refuse("",
                   "a vehicle with [vehicle.navigation] knows where it is by its filter: leave "
                   "[vehicle.sensors] out, or this table");
    }
  });
}

void Describe(Fields& fields, BeaconOptions& beacon) {
  constexpr std::array<std::string_view, 3> kKinds = {"two_way", "one_way", "packets"};
  fields.Require("name", "name = \"north\"");
  fields.Text("name", beacon.name, {.min_length = 1});
  fields.Require("point", "point = [100, 200]");
  fields.Pair("point", beacon.point_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("depth_m", beacon.depth_m, Between(0, 20'000));
  fields.Number("position_sigma_m", beacon.position_sigma_m, Between(0, 10'000));
  fields.Word("kind", beacon.kind, kKinds);
  if (beacon.kind == "packets") {
    fields.Require("sender", "sender = \"buoy\"");
    fields.Text("sender", beacon.sender, {.min_length = 1});
    for (const char* key : {"interval_s", "offset_s", "turnaround_s"}) {
      fields.NoKey(key, "the packets of its sender are the ranges");
    }
    return;
  }
  fields.Number("interval_s", beacon.interval_s, Between(0.1, 100'000));
  fields.Number("offset_s", beacon.offset_s, Between(0, kLongest_s));
  if (beacon.kind == "two_way") {
    fields.Number("turnaround_s", beacon.turnaround_s, Between(0, 60));
  }
}

}  // namespace shoal

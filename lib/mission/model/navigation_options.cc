#include "lib/mission/model/navigation_options.h"

#include "lib/base/geometry/angles.h"

namespace shoal {

NavigationOptions NavigationOfGrade(NavigationGrade grade) {
  NavigationOptions options;
  options.grade = grade;
  if (grade == NavigationGrade::kSurvey) return options;
  options.compass.bias_sigma_deg = 2;
  options.compass.noise_deg = 1;
  options.gyro = {.bias_degph = 0,
                  .bias_sigma_degph = 30,
                  .noise_deg_per_rth = 3,
                  .bias_walk_degph_per_rth = 10};
  options.dvl.fitted = false;
  options.log.noise_mps = 0.1;
  options.depth = {.bias_m = 0, .bias_sigma_m = 0.1, .noise_m = 0.05};
  options.gps.noise_m = 3;
  options.clock = {.phase_ms = 0, .phase_sigma_ms = 1, .drift_ppm = 0, .drift_sigma_ppm = 1};
  options.ranging.noise_m = 1.5;
  return options;
}

InstrumentOptions InstrumentsOf(const NavigationOptions& options, double sound_speed_mps) {
  InstrumentOptions instruments;
  instruments.compass = {.bias_rad = DegToRad(options.compass.bias_deg),
                         .bias_sigma_rad = DegToRad(options.compass.bias_sigma_deg),
                         .noise_rad = DegToRad(options.compass.noise_deg),
                         .deviation = {},
                         .rate_hz = options.compass.rate_hz};
  const std::vector<double>& deviation_deg = options.compass.deviation_deg;
  if (deviation_deg.size() == 5) {
    instruments.compass.deviation = {
        .a = DegToRad(deviation_deg[0]),
        .b = DegToRad(deviation_deg[1]),
        .c = DegToRad(deviation_deg[2]),
        .d = DegToRad(deviation_deg[3]),
        .e = DegToRad(deviation_deg[4]),
    };
  }
  constexpr double kHour_s = 3600;
  constexpr double kRootHour_rts = 60;
  instruments.gyro = {.bias_radps = DegToRad(options.gyro.bias_degph) / kHour_s,
                      .bias_sigma_radps = DegToRad(options.gyro.bias_sigma_degph) / kHour_s,
                      .noise_rad_per_rts = DegToRad(options.gyro.noise_deg_per_rth) / kRootHour_rts,
                      .bias_walk_radps_per_rts =
                          DegToRad(options.gyro.bias_walk_degph_per_rth) / kHour_s / kRootHour_rts};
  if (options.dvl.fitted) {
    instruments.dvl = Dvl{.min_altitude_m = options.dvl.min_altitude_m,
                          .max_altitude_m = options.dvl.max_altitude_m,
                          .scale_error = options.dvl.scale_error,
                          .scale_sigma = options.dvl.scale_sigma,
                          .noise_mps = options.dvl.noise_mps,
                          .dropout = options.dvl.dropout,
                          .rate_hz = options.dvl.rate_hz};
  }
  if (options.log.fitted) {
    instruments.log = SpeedLog{.noise_mps = options.log.noise_mps, .rate_hz = options.log.rate_hz};
  }
  instruments.depth = {.bias_m = options.depth.bias_m,
                       .bias_sigma_m = options.depth.bias_sigma_m,
                       .noise_m = options.depth.noise_m};
  if (options.gps.fitted) {
    instruments.gps = Gps{.antenna_depth_m = options.gps.antenna_depth_m,
                          .cold_fix_s = options.gps.cold_fix_s,
                          .hot_fix_s = options.gps.hot_fix_s,
                          .hot_for_s = options.gps.hot_for_s,
                          .starts_hot = options.gps.starts_hot,
                          .noise_m = options.gps.noise_m,
                          .rate_hz = options.gps.rate_hz};
  }
  instruments.clock = {.phase_s = options.clock.phase_ms / 1000,
                       .phase_sigma_s = options.clock.phase_sigma_ms / 1000,
                       .drift_ppm = options.clock.drift_ppm,
                       .drift_sigma_ppm = options.clock.drift_sigma_ppm};
  if (options.ranging.fitted) {
    AcousticRanging ranging = {.max_range_m = options.ranging.max_range_m,
                               .sound_speed_mps = sound_speed_mps,
                               .dropout = options.ranging.dropout,
                               .errors = {.noise_m = options.ranging.noise_m,
                                          .outlier_ratio = options.ranging.outlier_ratio,
                                          .outlier_m = options.ranging.outlier_m},
                               .usbl = {}};
    if (options.ranging.usbl) {
      ranging.usbl = UsblErrors{DegToRad(options.ranging.bearing_noise_deg),
                                DegToRad(options.ranging.depression_noise_deg)};
    }
    instruments.ranging = ranging;
  }
  return instruments;
}

StartKnowledge StartKnowledgeOf(const NavigationOptions& options) {
  return {.position_m = options.start_sigma_m,
          .heading_rad = DegToRad(options.start_heading_sigma_deg),
          .current_mps = options.current_sigma_mps};
}

}  // namespace shoal

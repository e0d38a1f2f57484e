// [vehicle.navigation] and [[beacon]] as data, in the units of mission files.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "lib/vehicle/navigation/beacons.h"
#include "lib/vehicle/navigation/navigator.h"

namespace shoal {

/// What the instruments are unless the file states something else.
enum class NavigationGrade {
  kSurvey,   ///< A fibre-optic gyro and a DVL.
  kLowCost,  ///< A micromechanical gyro, a magnetic compass, no DVL.
};

/// `[vehicle.navigation]`: instruments with errors, and a filter that reckons with them. The
/// defaults are those of kSurvey; `..._sigma_...` is the spread of what is drawn once per vehicle,
/// and what the filter assumes.
struct NavigationOptions {
  struct CompassKeys {
    double bias_deg = 0;
    double bias_sigma_deg = 0.3;
    double noise_deg = 0.2;
    std::vector<double> deviation_deg = {};  ///< A, B, C, D, E; empty: none.
    double rate_hz = 2;

    bool operator==(const CompassKeys&) const = default;
  };
  struct GyroKeys {
    double bias_degph = 0;
    double bias_sigma_degph = 1;
    double noise_deg_per_rth = 0.1;        ///< Angle random walk, degrees per root hour.
    double bias_walk_degph_per_rth = 0.1;  ///< Degrees per hour, per root hour.

    bool operator==(const GyroKeys&) const = default;
  };
  struct DvlKeys {
    bool fitted = true;
    double min_altitude_m = 0.5;
    double max_altitude_m = 80;
    double scale_error = 0;
    double scale_sigma = 0.003;
    double noise_mps = 0.01;
    double dropout = 0.02;
    double rate_hz = 2;

    bool operator==(const DvlKeys&) const = default;
  };
  struct LogKeys {
    bool fitted = true;
    double noise_mps = 0.05;
    double rate_hz = 1;

    bool operator==(const LogKeys&) const = default;
  };
  struct DepthKeys {
    double bias_m = 0;
    double bias_sigma_m = 0.05;
    double noise_m = 0.02;

    bool operator==(const DepthKeys&) const = default;
  };
  struct GpsKeys {
    bool fitted = true;
    double antenna_depth_m = 0.3;
    double cold_fix_s = 35;
    double hot_fix_s = 5;
    double hot_for_s = 7200;
    bool starts_hot = true;
    double noise_m = 2;
    double rate_hz = 1;

    bool operator==(const GpsKeys&) const = default;
  };
  struct ClockKeys {
    double phase_ms = 0;
    double phase_sigma_ms = 0.1;
    double drift_ppm = 0;
    double drift_sigma_ppm = 0.02;

    bool operator==(const ClockKeys&) const = default;
  };
  struct RangingKeys {
    bool fitted = true;
    double max_range_m = 2000;
    double noise_m = 0.5;
    double dropout = 0.1;
    double outlier_ratio = 0;
    double outlier_m = 50;
    bool usbl = false;
    double bearing_noise_deg = 1;
    double depression_noise_deg = 1;

    bool operator==(const RangingKeys&) const = default;
  };

  bool is_fitted = false;  ///< The file has the table: helm and reports go by ESTIMATED_NAV.
  NavigationGrade grade = NavigationGrade::kSurvey;
  double start_sigma_m = 2;  ///< Of the first position, x and y.
  double start_heading_sigma_deg = 2;
  double current_sigma_mps = 0.3;  ///< How strong a current may be; the filter begins at 0.
  double gate_probability = 0.999;
  double report_every_s = 1;  ///< NAVIGATION.
  CompassKeys compass;
  GyroKeys gyro;
  DvlKeys dvl;
  LogKeys log;
  DepthKeys depth;
  GpsKeys gps;
  ClockKeys clock;
  RangingKeys ranging;

  bool operator==(const NavigationOptions&) const = default;
};

/// Returns the defaults of a grade.
[[nodiscard]] NavigationOptions NavigationOfGrade(NavigationGrade grade);

/// Returns the same for lib/vehicle/navigation: radians, seconds, absent where not fitted. The
/// speed of sound is that of the mission's water.
[[nodiscard]] InstrumentOptions InstrumentsOf(const NavigationOptions& options,
                                              double sound_speed_mps);
[[nodiscard]] StartKnowledge StartKnowledgeOf(const NavigationOptions& options);

/// `[[beacon]]`: a transponder or pinger at a place that vehicles know.
struct BeaconOptions {
  std::string name = {};
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  double depth_m = 0;
  double position_sigma_m = 0;   ///< How far off vehicles believe x and y, drawn once.
  std::string kind = "two_way";  ///< "two_way", "one_way" or "packets".
  std::string sender = {};       ///< packets: the vehicle whose acoustic packets are ranges.
  double interval_s = 10;        ///< Not of packets.
  double offset_s = 0;
  double turnaround_s = 0.1;  ///< Of two_way.

  bool operator==(const BeaconOptions&) const = default;
};

}  // namespace shoal

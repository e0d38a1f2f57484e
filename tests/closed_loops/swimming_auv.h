// A Remus 100 as a mission runs it, pilot and model, over a floor of a test's own: with the delay
// of a step from NAV to ACTUATORS.
//
//   SwimmingAuv auv({.floor_from = "chart"}, FloorAlong([](double x_m) { return 60 - x_m / 8; }));
//   auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 40});
//   auv.Swim(ToDepth(40), 60);
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "apps/helm/underwater_pilot.h"
#include "apps/vehicle_sim/simulated_remus100.h"
#include "apps/vehicle_sim/sonar_unit.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

/// Returns a floor whose depth depends on x alone: from 0 to 900 m, a point each metre.
inline SeaFloor FloorAlong(const std::function<double(double)>& depth_at_m) {
  std::vector<float> depths_m;
  for (int x_m = 0; x_m <= 900; ++x_m) depths_m.push_back(static_cast<float>(depth_at_m(x_m)));
  return SeaFloor(std::make_shared<const DepthGrid>(
      GridFrame{.columns = 901, .rows = 1, .south_west_m = {0, 0}, .cell_m = {1, 1}}, depths_m));
}

inline Guidance EastAt(double speed_mps) {
  Guidance guidance;
  guidance.heading_rad = kPi / 2;
  guidance.speed_mps = speed_mps;
  return guidance;
}
inline Guidance ToDepth(double z_m, double speed_mps = 2) {
  Guidance guidance = EastAt(speed_mps);
  guidance.z_m = z_m;
  return guidance;
}
/// As target tracking asks for it.
inline Guidance WithPitch(double pitch_deg, double speed_mps = 2) {
  Guidance guidance = EastAt(speed_mps);
  guidance.pitch_rad = DegToRad(pitch_deg);
  return guidance;
}

/// The extremes of one swim.
struct Extremes {
  double least_altitude_m = 1e9;
  double greatest_altitude_m = -1e9;
  double least_z_m = 1e9;
  double greatest_z_m = -1e9;
  double stern_plane_deg = 0;  ///< The largest.
  double rudder_deg = 0;
};

class SwimmingAuv {
 public:
  static constexpr double kTick_s = 0.1;

  explicit SwimmingAuv(const Remus100Options& options, SeaFloor floor = {},
                       const SonarOptions& sonar = {})
      : floor_(std::move(floor)),
        pilot_(options, sonar, floor_),
        craft_(options),
        sonar_(sonar, 1, "alpha"),
        has_sonar_(sonar.is_fitted) {}

  void Start(const StartPose& pose) { craft_.Reset(pose, WaterHere()); }

  Extremes Swim(const Guidance& guidance, double duration_s) {
    Extremes seen;
    for (int i = 0; i < std::lround(duration_s / kTick_s); ++i) {
      Step(guidance);
      const double altitude_m = Altitude();
      seen.least_altitude_m = std::min(seen.least_altitude_m, altitude_m);
      seen.greatest_altitude_m = std::max(seen.greatest_altitude_m, altitude_m);
      seen.least_z_m = std::min(seen.least_z_m, z_m());
      seen.greatest_z_m = std::max(seen.greatest_z_m, z_m());
      seen.stern_plane_deg = std::max(seen.stern_plane_deg, std::abs(actuators_.stern_plane_deg));
      seen.rudder_deg = std::max(seen.rudder_deg, std::abs(actuators_.rudder_deg));
    }
    return seen;
  }

  double z_m() const { return craft_.position_m().z(); }
  double x_m() const { return craft_.position_m().x(); }
  double Altitude() const { return floor_.DepthAt(craft_.position_m().head<2>()) - z_m(); }
  const desired_t& desired() const { return desired_; }
  const actuators_t& actuators() const { return actuators_; }

 private:
  Water WaterHere() const {
    return {.velocity_mps = Eigen::Vector2d::Zero(),
            .floor_z_m = floor_.DepthAt(craft_.position_m().head<2>())};
  }

  void Step(const Guidance& guidance) {
    nav_t nav{};
    craft_.Show(WaterHere(), &nav);
    nav.utime = utime_;
    if (has_sonar_) {
      if (const auto ping = sonar_.Ping(nav, {.floor = floor_})) pilot_.OnSonar(*ping);
    }
    craft_.Execute(actuators_);
    pilot_.Steer(guidance, nav, utime_ == 0 ? 0 : kTick_s, &desired_, &actuators_);
    craft_.Step(WaterHere(), kTick_s);
    utime_ += std::lround(kTick_s * 1e6);
  }

  SeaFloor floor_;
  UnderwaterPilot pilot_;
  SimulatedRemus100 craft_;
  SonarUnit sonar_;
  bool has_sonar_;
  desired_t desired_{};
  actuators_t actuators_{};
  int64_t utime_ = 0;
};

}  // namespace shoal

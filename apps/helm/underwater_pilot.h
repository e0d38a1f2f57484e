// The autopilots of a Remus 100: heading, depth or pitch, and propeller. Turns the world's frame
// into the guidance frame and back (docs/start/glossary.md).
#pragma once

#include <optional>
#include <string>

#include "apps/helm/floor_view.h"
#include "apps/helm/pilot.h"
#include "apps/helm/remus100_ahead.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "lib/vehicle/vehicle/trim.h"

namespace shoal {

class UnderwaterPilot : public Pilot {
 public:
  /// `chart`: the sea floor that it knows with floor_from = "chart".
  explicit UnderwaterPilot(const Remus100Options& options, const SonarOptions& sonar = {},
                           std::optional<SeaFloor> chart = {});
  UnderwaterPilot(const UnderwaterPilot&) = delete;
  UnderwaterPilot& operator=(const UnderwaterPilot&) = delete;

  void Steer(const Guidance& guidance, const nav_t& nav, double dt_s, desired_t* desired,
             actuators_t* actuators) override;
  void OnSonar(const sonar_t& ping) override { floor_.OnSonar(ping); }
  void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) override;
  std::optional<double> desired_pitch_rad() const override { return pilot_.desired_theta_rad(); }
  std::string GainsText() const override;

 private:
  double RpmOf(const Guidance& guidance) const;
  /// Returns how fast it can climb at this speed through water, some fin kept for steering.
  double ClimbAt(double speed_mps) const;

  Remus100Options options_;
  Remus100 auv_;
  std::optional<Remus100Ahead> ahead_;  ///< With muNet's gains, which bear no delay.
  AuvPilot pilot_;
  FloorView floor_;
  double heave_share_ = 0;  ///< Radian per metre: see HeaveShareOf.
  LevelTrim level_trim_;
  double rpm_ = 0;
  bool rests_ = true;
};

}  // namespace shoal

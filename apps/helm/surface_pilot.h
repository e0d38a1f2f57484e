// The autopilots of a surface craft: heading to rudder, speed to thrust.
#pragma once

#include <string>

#include "apps/helm/pilot.h"
#include "lib/vehicle/control/heading_pid.h"
#include "lib/vehicle/control/speed_controller.h"

namespace shoal {

class SurfacePilot : public Pilot {
 public:
  SurfacePilot(const SurfaceCraftParams& craft, const AutopilotOptions& options);

  void Steer(const Guidance& guidance, const nav_t& nav, double dt_s, desired_t* desired,
             actuators_t* actuators) override;
  void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) override;
  std::string GainsText() const override;

 private:
  SurfaceCraftParams craft_;
  AutopilotOptions options_;
  HeadingPid heading_pid_;
  SpeedController speed_controller_;
};

}  // namespace shoal

// The pilot of what is moored: it has no actuators.
#pragma once

#include <string>

#include "apps/helm/pilot.h"

namespace shoal {

class MooredPilot : public Pilot {
 public:
  void Steer(const Guidance& /*guidance*/, const nav_t& nav, double /*dt_s*/, desired_t* desired,
             actuators_t* actuators) override {
    Rest(nav, desired, actuators);
  }
  void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) override {
    *desired = {};
    *actuators = {};
    desired->heading_deg = nav.heading_deg;
  }
  std::string GainsText() const override { return "moored: no actuators"; }
};

}  // namespace shoal

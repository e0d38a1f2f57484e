// The pilot of what has no actuators: it is moored, or replayed from a track.
#pragma once

#include <string>
#include <string_view>

#include "apps/helm/pilot.h"

namespace shoal {

class PassivePilot : public Pilot {
 public:
  /// `why`: what the vehicle is, for the status page.
  explicit PassivePilot(std::string_view why) : why_(why) {}

  void Steer(const Guidance& /*guidance*/, const nav_t& nav, double /*dt_s*/, desired_t* desired,
             actuators_t* actuators) override {
    Rest(nav, desired, actuators);
  }
  void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) override {
    *desired = {};
    *actuators = {};
    desired->heading_deg = nav.heading_deg;
  }
  std::string GainsText() const override { return why_ + ": no actuators"; }

 private:
  std::string why_;
};

}  // namespace shoal

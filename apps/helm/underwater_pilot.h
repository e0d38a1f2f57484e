// The autopilots of a Remus 100: heading, depth or pitch, and propeller. Turns the world's frame
// into the guidance frame and back (docs/glossary.md).
#pragma once

#include <optional>
#include <string>

#include "apps/helm/pilot.h"
#include "apps/helm/remus100_ahead.h"
#include "lib/control/auv_pilot.h"
#include "lib/vehicle/remus100.h"

namespace shoal {

class UnderwaterPilot : public Pilot {
 public:
  explicit UnderwaterPilot(const Remus100Options& options);
  UnderwaterPilot(const UnderwaterPilot&) = delete;
  UnderwaterPilot& operator=(const UnderwaterPilot&) = delete;

  void Steer(const Guidance& guidance, const nav_t& nav, double dt_s, desired_t* desired,
             actuators_t* actuators) override;
  void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) override;
  std::optional<double> desired_pitch_rad() const override { return pilot_.desired_theta_rad(); }
  std::string GainsText() const override;

 private:
  double RpmOf(const Guidance& guidance) const;

  Remus100Options options_;
  Remus100 auv_;
  std::optional<Remus100Ahead> ahead_;  ///< With muNet's gains, which bear no delay.
  AuvPilot pilot_;
  double heave_share_ = 0;  ///< Radian per metre: see HeaveShareOf.
  double rpm_ = 0;
  bool rests_ = true;
};

}  // namespace shoal

// lib/vehicle/vehicle/buoy as vehicle_sim runs it.
#pragma once

#include <string>

#include "apps/vehicle_sim/simulated_craft.h"
#include "lib/vehicle/vehicle/buoy.h"

namespace shoal {

class SimulatedBuoy : public SimulatedCraft {
 public:
  explicit SimulatedBuoy(const BuoyParams& params) : params_(params) {}

  /// Its anchor lies below the pose.
  void Reset(const StartPose& pose, const Water& water) override;
  bool Execute(const actuators_t& actuators) override;
  void Rest() override {}
  void Step(const Water& water, double dt_s) override;
  Eigen::Vector3d position_m() const override;
  void Show(const Water& water, nav_t* nav) const override;
  std::string ActuatorsText() const override;

 private:
  BuoyParams params_;
  BuoyState state_;
  double heading_deg_ = 0;
};

}  // namespace shoal

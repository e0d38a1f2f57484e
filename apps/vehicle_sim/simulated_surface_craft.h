// lib/vehicle/vehicle/surface_craft as vehicle_sim runs it.
#pragma once

#include <string>

#include "apps/vehicle_sim/simulated_craft.h"
#include "lib/vehicle/vehicle/surface_craft.h"

namespace shoal {

class SimulatedSurfaceCraft : public SimulatedCraft {
 public:
  explicit SimulatedSurfaceCraft(const SurfaceCraftParams& params) : params_(params) {}

  void Reset(const StartPose& pose, const Water& water) override;
  bool Execute(const actuators_t& actuators) override;
  void Rest() override { command_ = {}; }
  void Step(const Water& water, double dt_s) override;
  Eigen::Vector3d position_m() const override;
  void Show(const Water& water, nav_t* nav) const override;
  std::string ActuatorsText() const override;

 private:
  SurfaceCraftParams params_;
  SurfaceCraftState state_;
  SurfaceCraftCommand command_;
};

}  // namespace shoal

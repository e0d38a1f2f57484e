// lib/vehicle/vehicle/remus100 as vehicle_sim runs it: in steps of at most model_step_s, and
// mirrored from the guidance frame into that of the world (docs/start/glossary.md).
#pragma once

#include <string>

#include "apps/vehicle_sim/simulated_craft.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

class SimulatedRemus100 : public SimulatedCraft {
 public:
  explicit SimulatedRemus100(const Remus100Options& options);

  void Reset(const StartPose& pose, const Water& water) override;
  bool Execute(const actuators_t& actuators) override;
  void Rest() override { command_ = {}; }
  void Step(const Water& water, double dt_s) override;
  Eigen::Vector3d position_m() const override { return state_.eta.head<3>(); }
  void Show(const Water& water, nav_t* nav) const override;
  std::string ActuatorsText() const override;

 private:
  double model_step_s_;
  /// +1 where the model counts stern planes as the world does, bow up; else -1.
  double stern_plane_sign_;
  Remus100 auv_;
  Remus100State state_;
  Remus100Actuators command_;
};

}  // namespace shoal

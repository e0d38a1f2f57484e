// The work that the propeller shaft of a Remus 100 does, from what is commanded and how it moves.
//
//   ShaftWork work(ParamsOf(options));
//   work.Step(rpm, surge_mps, 0.1);   // once per step
//   work.work_j();
//
// Power is P = 2 pi n Q with the torque Q(n, u) of the propeller's model (ForceOf in
// lib/vehicle/vehicle/propulsion.h; Allen, Vorus and Prestero 2000), n the revolutions per second
// and u the speed of the water from ahead; integrated by explicit Euler, step by step. n follows
// the command, limited to what the propeller can do, with the model's first-order lag. Losses of
// motor and electronics, fins and the hotel load are not in it.
#pragma once

#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

class ShaftWork {
 public:
  explicit ShaftWork(const Remus100Params& params) : params_(params) {}

  /// Takes what holds from now on for `dt_s` seconds. A propeller that the water drives does no
  /// work and gives none back.
  /// @pre dt_s >= 0; numbers that are not finite count as 0
  void Step(double commanded_rpm, double surge_mps, double dt_s);

  double work_j() const { return work_j_; }
  double rpm() const { return rpm_; }

 private:
  Remus100Params params_;
  double rpm_ = 0;  ///< As the propeller turns.
  double work_j_ = 0;
};

}  // namespace shoal

// Where a Remus 100 will be when a command takes effect. Between processes that is one step after
// the NAV from which the command was decided: what is published in one step is received in the
// next.
//
//   Remus100Ahead ahead(auv, model_step_s);
//   const Remus100State then = ahead.Predict(nav, dt_s);
//   ahead.Command({rudder_rad, stern_plane_rad, rpm});   // from `then` on
//
// Laws with next to no margin of delay, as muNet's of heading, steer by it.
#pragma once

#include "lib/vehicle/vehicle/remus100.h"
#include "shoal/nav_t.hpp"

namespace shoal {

class Remus100Ahead {
 public:
  /// `model_step_s` is the longest step of integration, > 0.
  Remus100Ahead(const Remus100& auv, double model_step_s)
      : auv_(auv), model_step_s_(model_step_s) {}

  /// The actuators are at rest.
  void Start() { command_ = actuators_ = {}; }

  /// Returns the state `dt_s` after `nav`: one step of the vehicle's own model, in water at rest,
  /// with the last command. To be called once per step. @pre 0 < dt_s <= 1
  Remus100State Predict(const nav_t& nav, double dt_s);

  /// Takes the command that holds from there on.
  void Command(const Remus100Actuators& command) { command_ = command; }

 private:
  const Remus100& auv_;
  double model_step_s_;
  Remus100Actuators command_;    ///< Being carried out.
  Remus100Actuators actuators_;  ///< As they are at the time of NAV.
};

}  // namespace shoal

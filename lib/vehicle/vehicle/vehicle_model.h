// What makes a vehicle model: four plain structs and one function. docs/vehicles/vehicles.md shows
// how to add one.
//
//   static_assert(VehicleModel<SurfaceCraftParams, SurfaceCraftState, SurfaceCraftCommand,
//                              Eigen::Vector2d>);
#pragma once

#include <concepts>

namespace shoal {

/// Params: what it is, never changed. State: where it is, copied. Command: what it is ordered to
/// do. Environment: the sea around it. Step is a pure function of these: it reads no clock, draws
/// no random number, and gives a finite state for finite ones.
template <class Params, class State, class Command, class Environment>
concept VehicleModel = std::copyable<State> && std::default_initializable<State> &&
    std::default_initializable<Command> &&
    requires(const Params& params, const State& state, const Command& command,
             const Environment& environment, double dt_s) {
  { Step(params, state, command, environment, dt_s) } -> std::same_as<State>;
};

}  // namespace shoal

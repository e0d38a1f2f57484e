// Comes up from time to time.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "periodic_surface". Comes up from time to time.
struct PeriodicSurfaceOptions {
  static constexpr std::string_view kKind = "periodic_surface";

  double period = 300;  ///< s between ascents.
  std::string mark_variable =
      "GPS_UPDATE_RECEIVED";  ///< A new setting of it ends the time at the surface.
  double ascent_speed = -1;   ///< m/s; -1: as it is when the ascent begins.
  std::string ascent_grade =
      "linear";  ///< linear, quadratic, quasi or fullspeed: how the speed falls with the depth.
  double zero_speed_depth = 0;       ///< m; the speed is 0 from here up.
  double max_time_at_surface = 300;  ///< s.
  std::string pending_status_var = "PENDING_SURFACE";
  std::string atsurface_status_var = "TIME_AT_SURFACE";

  bool operator==(const PeriodicSurfaceOptions&) const = default;
};

/// States, posted as texts of the page:
///
///   waiting  --- period is over --->  ascending  --- at the surface --->  at_surface
///      ^                                                                     |
///      +------------- mark_variable is set, max_time_at_surface -------------+
///
/// A setting of mark_variable begins the wait again in every state.
class PeriodicSurfaceBehavior final : public BehaviorWith<PeriodicSurfaceOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// The wait goes on.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  enum class State { kWaiting, kAscending, kAtSurface };

  /// Above zero_speed_depth by less than this counts as at the surface: a hull floats half out.
  static constexpr double kSurface_m = 0.5;

  void Update(const BehaviorInputs& inputs);
  void Enter(State state, double time_s);
  double AscentSpeed(double depth_m) const;

  State state_ = State::kWaiting;
  std::optional<double> since_s_;  ///< Of the state; absent: before the first iteration.
  double start_depth_m_ = 0;       ///< Of the ascent.
  double start_speed_mps_ = 0;
};

}  // namespace shoal

// When steps are due: warp, pauses, and the commands that change them. Pure; wall time, in
// microseconds, comes in as an argument.
//
//   StepPace pace(1, tick_us, "");
//   pace.Begin(wall_us);
//   if (!pace.is_paused() && wall_us >= pace.DueTime()) pace.OnStep(step, wall_us);
#pragma once

#include <cstdint>
#include <string>

#include "shoal/clock_command_t.hpp"

namespace shoal {

class StepPace {
 public:
  /// `warp`: mission seconds per wall second; 0: as fast as possible. `fixed_pace`: why the pace
  /// must stay as it is; empty: it may change.
  StepPace(double warp, int64_t tick_us, std::string fixed_pace);

  /// Starts the pace: step 0 is due now.
  void Begin(int64_t wall_us);
  /// Step `step` begins.
  void OnStep(int64_t step, int64_t wall_us);

  /// Returns the wall time at which the step after the last is due. With warp 0 that is always.
  int64_t DueTime() const;
  /// Shifts the schedule after a stall, so that steps which are late do not follow in a burst.
  void ForgiveStall(int64_t wall_us);

  /// Executes pause, resume or warp. Returns why not, or an empty text.
  std::string Execute(const clock_command_t& command, int64_t wall_us);

  /// Measures factor() again where the last measurement is old enough.
  void MeasureFactor(int64_t wall_us);

  double warp() const { return warp_; }
  bool is_paused() const { return is_paused_; }
  /// Returns mission seconds per wall second, as measured last; 0: not yet, or paused.
  double factor() const { return is_paused_ ? 0 : factor_; }

 private:
  void Set(double warp, bool is_paused, int64_t wall_us);

  const int64_t tick_us_;
  const std::string fixed_pace_;
  double warp_;
  bool is_paused_ = false;
  int64_t step_ = -1;        ///< The last that began.
  int64_t began_us_ = 0;     ///< When it did.
  int64_t origin_us_ = 0;    ///< Wall time at which ...
  int64_t origin_step_ = 0;  ///< ... this step was, or would have been, due.
  int64_t since_us_ = 0;     ///< Where the present factor is measured from ...
  int64_t since_step_ = 0;
  double factor_ = 0;
};

}  // namespace shoal

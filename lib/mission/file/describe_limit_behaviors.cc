// [[vehicle.behavior]] of the kinds that hold one value, limit it, or count time.
#include <fmt/format.h>

#include "lib/mission/file/behavior_fields.h"

namespace shoal {
namespace {

void Peak(Fields& fields, double& width, double& base, double& delta, double max) {
  fields.Number("peakwidth", width, Between(0, max));
  fields.Number("basewidth", base, Between(0, max));
  fields.Number("summitdelta", delta, kPercentRange);
  fields.CalledElsewhere("summitdelta", "summit_delta");
}

}  // namespace

void DescribeKind(Fields& fields, ConstantDepthOptions& o, bool) {
  fields.Number("depth", o.depth, kDepthRange);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, 20'000);
  VariableName(fields, "depth_mismatch_var", o.depth_mismatch_var);
}

void DescribeKind(Fields& fields, ConstantSpeedOptions& o, bool) {
  fields.Number("speed", o.speed, kSpeedRange);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, kFastest_mps);
  VariableName(fields, "speed_mismatch_var", o.speed_mismatch_var);
  fields.CalledElsewhere("speed", "speed_mps");
}

void DescribeKind(Fields& fields, ConstantHeadingOptions& o, bool) {
  fields.Number("heading", o.heading, Between(-360, 360));
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, 180);
  OrOff(fields, "complete_thresh", o.complete_thresh, 180);
  VariableName(fields, "heading_mismatch_var", o.heading_mismatch_var);
  fields.CalledElsewhere("heading", "heading_deg");
}

void DescribeKind(Fields&, TimerOptions&, bool) {}

void DescribeKind(Fields& fields, PeriodicSurfaceOptions& o, bool) {
  fields.Number("period", o.period, kSecondsRange);
  VariableName(fields, "mark_variable", o.mark_variable);
  OrOff(fields, "ascent_speed", o.ascent_speed, kFastest_mps);
  OneWordOf(fields, "ascent_grade", o.ascent_grade, {"linear", "quadratic", "quasi", "fullspeed"});
  fields.Number("zero_speed_depth", o.zero_speed_depth, kDepthRange);
  fields.Number("max_time_at_surface", o.max_time_at_surface, kSecondsRange);
  VariableName(fields, "pending_status_var", o.pending_status_var);
  VariableName(fields, "atsurface_status_var", o.atsurface_status_var);
}

void DescribeKind(Fields& fields, MaxDepthOptions& o, bool) {
  fields.Require("max_depth", "max_depth = 30");
  fields.Number("max_depth", o.max_depth, kDepthRange);
  fields.Number("tolerance", o.tolerance, kDepthRange);
  VariableName(fields, "depth_slack_var", o.depth_slack_var);
  fields.CalledElsewhere("max_depth", "depth");
  fields.CalledElsewhere("tolerance", "basewidth");
}

void DescribeKind(Fields& fields, MaxSpeedOptions& o, bool) {
  fields.Require("max_speed", "max_speed = 1.5");
  fields.Number("max_speed", o.max_speed, kSpeedRange);
  fields.Number("tolerance", o.tolerance, kSpeedRange);
  VariableName(fields, "speed_slack_var", o.speed_slack_var);
  fields.CalledElsewhere("max_speed", "speed");
  fields.CalledElsewhere("tolerance", "basewidth");
}

void DescribeKind(Fields& fields, GoToDepthOptions& o, bool) {
  fields.Require("depths", "depths = [[10, 60], [20, 120]], depth in m and time at it in s");
  fields.Pairs("depths", o.depths, Between(0, kLongest_s), kMaxBehaviorPoints);
  for (const Eigen::Vector2d& level : o.depths) {
    if (level.x() > kDepthRange.max) {
      fields.Refuse("depths", fmt::format("a depth of {} m is out of range; allowed: 0 to {}",
                                          level.x(), kDepthRange.max));
    }
  }
  fields.SmallInteger("repeat", o.repeat, 0, 1'000'000);
  fields.Number("capture_delta", o.capture_delta, Above(0, 1000));
  FlagTexts(fields, "capture_flag", o.capture_flag);
  fields.CalledElsewhere("depths", "depth");
}

void DescribeKind(Fields& fields, OpRegionOptions& o, bool) {
  ConvexCorners(fields, "core_poly", o.core_poly, true);
  ConvexCorners(fields, "save_poly", o.save_poly, true);
  ConvexCorners(fields, "halt_poly", o.halt_poly, true);
  OrOff(fields, "save_dist", o.save_dist, kFarthest_m);
  OrOff(fields, "halt_dist", o.halt_dist, kFarthest_m);
  fields.Number("max_depth", o.max_depth, kDepthRange);
  fields.Number("min_altitude", o.min_altitude, kDepthRange);
  fields.Number("max_time", o.max_time, kSecondsRange);
  fields.Number("trigger_entry_time", o.trigger_entry_time, kSecondsRange);
  fields.Number("trigger_exit_time", o.trigger_exit_time, kSecondsRange);
  fields.Flag("trigger_on_poly_entry", o.trigger_on_poly_entry);
  fields.Flag("soft_poly_breach", o.soft_poly_breach);
  fields.Number("look_ahead", o.look_ahead, kSecondsRange);
  fields.Number("turn_rate", o.turn_rate, kDegreesRange);
  fields.Number("recover_spd", o.recover_spd, kSpeedRange);
  fields.Numbers("recover_patience", o.recover_patience, 100);
  for (const double share : o.recover_patience) {
    if (share < 1 || share > 99) {
      fields.Refuse("recover_patience", "each of recover_patience must be 1 to 99");
    }
  }
  fields.Flag("latch", o.latch);
  VariableName(fields, "reset_var", o.reset_var);
  FlagTexts(fields, "save_flag", o.save_flag);
  FlagTexts(fields, "savex_flag", o.savex_flag);
  FlagTexts(fields, "breached_poly_flag", o.breached_poly_flag);
  FlagTexts(fields, "breached_depth_flag", o.breached_depth_flag);
  FlagTexts(fields, "breached_altitude_flag", o.breached_altitude_flag);
  FlagTexts(fields, "breached_time_flag", o.breached_time_flag);
  fields.CalledElsewhere("core_poly", "polygon");
  fields.CalledElsewhere("recover_spd", "recover_speed");
  if (o.save_dist >= 0 && o.halt_dist >= 0 && o.halt_dist < o.save_dist) {
    fields.Refuse("halt_dist", "halt_dist must not be less than save_dist");
  }
  const bool has_region = !o.core_poly.empty() || !o.save_poly.empty() || !o.halt_poly.empty();
  if (!has_region && o.max_depth == 0 && o.min_altitude == 0 && o.max_time == 0) {
    fields.Refuse("core_poly",
                  "op_region needs a limit: core_poly = [[-50, -50], [50, -50], [50, 50], "
                  "[-50, 50]], max_depth, min_altitude or max_time");
  }
}

void DescribeKind(Fields& fields, MemoryTurnLimitOptions& o, bool) {
  fields.Require("memory_time", "memory_time = 60");
  fields.Require("turn_range", "turn_range = 45");
  fields.Number("memory_time", o.memory_time, Above(0, kLongest_s));
  fields.Number("turn_range", o.turn_range, Above(0, 180));
}

void DescribeKind(Fields& fields, PeriodicSpeedOptions& o, bool) {
  fields.Require("period_lazy", "period_lazy = 100");
  fields.Require("period_busy", "period_busy = 20");
  fields.Number("period_lazy", o.period_lazy, Above(0, kLongest_s));
  fields.Number("period_busy", o.period_busy, Above(0, kLongest_s));
  fields.Number("period_speed", o.period_speed, kSpeedRange);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, kFastest_mps);
  fields.Flag("initially_busy", o.initially_busy);
  fields.Flag("reset_upon_running", o.reset_upon_running);
}

void DescribeKind(Fields&, FullStopOptions&, bool) {}

void DescribeKind(Fields& fields, MaintainHeadingOptions& o, bool) {
  fields.Number("peakwidth", o.peakwidth, kDegreesRange);
  fields.Number("basewidth", o.basewidth, kDegreesRange);
  fields.Number("summitdelta", o.summitdelta, kPercentRange);
  fields.NoKey("heading", "it keeps the heading of its begin; constant_heading keeps a given one");
}

void DescribeKind(Fields& fields, HeadingBiasOptions& o, bool) {
  OneWordOf(fields, "bias", o.bias, {"right", "left"});
}

void DescribeKind(Fields& fields, HysteresisOptions& o, bool) {
  fields.Require("memory_time", "memory_time = 60");
  fields.Number("memory_time", o.memory_time, Above(0, kLongest_s));
  fields.Number("min_heading_window", o.min_heading_window, Between(0, 360));
  fields.Number("max_heading_window", o.max_heading_window, Between(0, 360));
  fields.Number("max_window_utility", o.max_window_utility, Above(0, 100));
  if (o.min_heading_window > o.max_heading_window) {
    fields.Refuse("min_heading_window",
                  "min_heading_window must not be greater than max_heading_window");
  }
}

void DescribeKind(Fields& fields, MinAltitudeOptions& o, bool) {
  fields.Require("min_altitude", "min_altitude = 10");
  fields.Number("min_altitude", o.min_altitude, kDepthRange);
  fields.Number("tolerance", o.tolerance, kDepthRange);
  fields.Flag("missing_altitude_critical", o.missing_altitude_critical);
  fields.CalledElsewhere("tolerance", "basewidth");
}

void DescribeKind(Fields& fields, RubberBandOptions& o, bool) {
  MayBePoint(fields, "point", o.point);
  fields.Number("inner_radius", o.inner_radius, Between(0, 10'000));
  fields.Number("outer_radius", o.outer_radius, Above(0, 10'000));
  fields.Number("outer_speed", o.outer_speed, kSpeedRange);
  fields.Number("extra_speed", o.extra_speed, kSpeedRange);
  fields.Number("stiffness", o.stiffness, Between(0, 1000));
  if (o.outer_radius <= o.inner_radius) {
    fields.Refuse("outer_radius", "outer_radius must be greater than inner_radius");
  }
}

void DescribeKind(Fields& fields, TestFailureOptions& o, bool) {
  OneWordOf(fields, "failure_type", o.failure_type, {"crash", "burn"});
  fields.Number("burn_time", o.burn_time, Between(0, 60));
}

}  // namespace shoal

// [[vehicle.behavior]] of the kinds that go somewhere: routes, stations and turns.
#include <fmt/format.h>

#include "lib/helm/modes/condition.h"
#include "lib/mission/file/behavior_fields.h"

namespace shoal {
namespace {

void Patience(Fields& fields, double& patience) {
  fields.Number("patience", patience, Between(1, 99));
  fields.CalledElsewhere("patience", "crs_spd_zaic_ratio");
}

void Capture(Fields& fields, std::string_view radius_key, double& radius, double& slip_radius) {
  fields.Number(radius_key, radius, Above(0, 10'000));
  fields.Number("slip_radius", slip_radius, Between(0, 10'000));
  fields.CalledElsewhere("slip_radius", "nm_radius");
  fields.CalledElsewhere("slip_radius", "nonmonotonic_radius");
  fields.CalledElsewhere(radius_key, "capture");
  if (radius_key == "radius") fields.CalledElsewhere(radius_key, "capture_radius");
  if (radius_key != "radius") fields.CalledElsewhere(radius_key, "radius");
}

void AltSpeed(Fields& fields, double& speed, double& speed_alt, bool& use_alt_speed) {
  fields.Number("speed", speed, kSpeedRange);
  OrOff(fields, "speed_alt", speed_alt, kFastest_mps);
  fields.Flag("use_alt_speed", use_alt_speed);
  fields.CalledElsewhere("speed", "speed_mps");
}

void Lead(Fields& fields, double& lead, double& lead_damper, double& return_angle) {
  fields.Number("return_angle", return_angle, Between(5, 90));
  OrOff(fields, "lead", lead, kFarthest_m);
  OrOff(fields, "lead_damper", lead_damper, kFarthest_m);
  fields.CalledElsewhere("lead", "lead_distance");
}

}  // namespace

// Where a behavior has `updates`, its points may come with the first of them.

void DescribeKind(Fields& fields, WaypointOptions& o, bool is_recipe) {
  const bool waits = fields.Has("updates", false);
  if (!is_recipe && !waits) fields.Require("points", "points = [[0, 0], [100, 0]]");
  PointList(fields, "points", o.points);
  AltSpeed(fields, o.speed, o.speed_alt, o.use_alt_speed);
  Capture(fields, "capture_radius", o.capture_radius, o.slip_radius);
  fields.Flag("capture_line", o.capture_line);
  fields.Flag("capture_line_only", o.capture_line_only);
  Lead(fields, o.lead, o.lead_damper, o.return_angle);
  fields.Flag("lead_to_start", o.lead_to_start);
  fields.Text("lead_condition", o.lead_condition, {.max_length = 1000});
  if (!o.lead_condition.empty()) {
    const auto condition = Condition::Parse(o.lead_condition);
    if (!condition.ok()) fields.Refuse("lead_condition", condition.error());
  }
  OneWordOf(fields, "order", o.order, {"normal", "reverse", "toggle"});
  fields.SmallInteger("repeat", o.repeat, -1, 1'000'000);
  fields.Flag("greedy_tour", o.greedy_tour);
  fields.SmallInteger("currix", o.currix, 0, static_cast<int>(kMaxBehaviorPoints));
  OneWordOf(fields, "ipf_type", o.ipf_type, {"zaic", "zaic_spd", "roc"});
  Patience(fields, o.patience);
  FlagTexts(fields, "wptflag", o.wptflag);
  FlagTexts(fields, "cycleflag", o.cycleflag);
  fields.Flag("wptflag_on_start", o.wptflag_on_start);
  fields.Flag("reset_on_idle", o.reset_on_idle);
  OrOff(fields, "end_speed", o.end_speed, kFastest_mps);
  fields.Number("end_slow_dist", o.end_slow_dist, kDistanceRange);
  fields.Number("end_stop_dist", o.end_stop_dist, kDistanceRange);
  fields.Text("post_suffix", o.post_suffix, {});
  VariableName(fields, "index_var", o.index_var);
  VariableName(fields, "cycle_var", o.cycle_var);
  VariableName(fields, "status_var", o.status_var);
  VariableName(fields, "dist_to_next_var", o.dist_to_next_var);
  VariableName(fields, "dist_to_prev_var", o.dist_to_prev_var);
  fields.CalledElsewhere("index_var", "wpt_index_var");
  fields.CalledElsewhere("cycle_var", "cycle_index_var");
  fields.CalledElsewhere("status_var", "wpt_status_var");
  fields.CalledElsewhere("dist_to_next_var", "wpt_dist_to_next");
  fields.CalledElsewhere("dist_to_prev_var", "wpt_dist_to_prev");
  fields.CalledElsewhere("points", "polygon");
  fields.CalledElsewhere("end_speed", "end_spd");
  fields.CalledElsewhere("cycleflag", "cycle_flag");
  if (o.currix > 0 && !o.points.empty() && static_cast<size_t>(o.currix) >= o.points.size()) {
    fields.Refuse("currix", fmt::format("currix = {} is not the index of a point; the last is {}",
                                        o.currix, o.points.size() - 1));
  }
}

void DescribeKind(Fields& fields, LoiterOptions& o, bool is_recipe) {
  const bool waits = fields.Has("updates", false);
  if (!is_recipe && !waits) {
    fields.Require("polygon", "polygon = \"radial:: x=0, y=0, radius=30, pts=8\"");
  }
  ConvexCorners(fields, "polygon", o.polygon, is_recipe || waits);
  AltSpeed(fields, o.speed, o.speed_alt, o.use_alt_speed);
  fields.Scalar("clockwise", o.clockwise);
  if (o.clockwise != "true" && o.clockwise != "false" && o.clockwise != "best") {
    fields.Refuse("clockwise", "clockwise must be true, false or \"best\"");
    o.clockwise = "true";
  }
  Capture(fields, "radius", o.radius, o.slip_radius);
  fields.Number("acquire_dist", o.acquire_dist, kDistanceRange);
  fields.Flag("center_activate", o.center_activate);
  fields.Number("spiral_factor", o.spiral_factor, Between(-1000, 1000));
  Patience(fields, o.patience);
  OrOff(fields, "slingshot", o.slingshot, 36'000);
  fields.Text("post_suffix", o.post_suffix, {});
  OneWordOf(fields, "ipf_type", o.ipf_type, {"zaic", "zaic_spd"});
}

void DescribeKind(Fields& fields, StationKeepOptions& o, bool is_recipe) {
  MayBePoint(fields, "station_pt", o.station_pt);
  fields.Flag("center_activate", o.center_activate);
  fields.Number("swing_time", o.swing_time, Between(0, 60));
  fields.Number("inner_radius", o.inner_radius, Between(0, 10'000));
  fields.Number("outer_radius", o.outer_radius, Above(0, 10'000));
  fields.Number("outer_speed", o.outer_speed, kSpeedRange);
  fields.Number("transit_speed", o.transit_speed, kSpeedRange);
  OrOff(fields, "hibernation_radius", o.hibernation_radius, 10'000);
  fields.CalledElsewhere("station_pt", "point");
  fields.CalledElsewhere("transit_speed", "extra_speed");
  if (o.outer_radius <= o.inner_radius) {
    fields.Refuse("outer_radius", "outer_radius must be greater than inner_radius");
  }
  if (!is_recipe && !o.station_pt && !o.center_activate && !fields.Has("updates", false)) {
    fields.Refuse("station_pt",
                  "station_keep needs station_pt = [0, 0], or center_activate = true to stay where "
                  "it begins");
  }
}

void DescribeKind(Fields& fields, LegRunOptions& o, bool is_recipe) {
  if (!is_recipe) {
    fields.Require("p1", "p1 = [0, 0]");
    fields.Require("p2", "p2 = [100, 0]");
  }
  MayBePoint(fields, "p1", o.p1);
  MayBePoint(fields, "p2", o.p2);
  fields.Number("speed", o.speed, kSpeedRange);
  fields.Numbers("leg_spds", o.leg_spds, 1000);
  for (const double speed : o.leg_spds) {
    if (speed < 0 || speed > kFastest_mps) {
      fields.Refuse("leg_spds", fmt::format("a speed of {} m/s is out of range; allowed: 0 to {}",
                                            speed, kFastest_mps));
    }
  }
  fields.Number("turn1_rad", o.turn1_rad, Above(0, kFarthest_m));
  fields.Number("turn2_rad", o.turn2_rad, Above(0, kFarthest_m));
  fields.Number("turn1_bias", o.turn1_bias, Between(-100, 100));
  fields.Number("turn2_bias", o.turn2_bias, Between(-100, 100));
  fields.Number("turn1_ext", o.turn1_ext, kDistanceRange);
  fields.Number("turn2_ext", o.turn2_ext, kDistanceRange);
  OneWordOf(fields, "turn1_dir", o.turn1_dir, {"auto", "port", "starboard"});
  OneWordOf(fields, "turn2_dir", o.turn2_dir, {"auto", "port", "starboard"});
  Capture(fields, "capture_radius", o.capture_radius, o.slip_radius);
  fields.Flag("capture_line", o.capture_line);
  fields.Flag("capture_line_only", o.capture_line_only);
  Lead(fields, o.lead, o.lead_damper, o.return_angle);
  Patience(fields, o.patience);
  fields.SmallInteger("repeat", o.repeat, -1, 1'000'000);
  FlagTexts(fields, "leg_end_flag", o.leg_end_flag);
  FlagTexts(fields, "start_leg_flag", o.start_leg_flag);
  FlagTexts(fields, "mid_flag", o.mid_flag);
  FlagTexts(fields, "start_turn_flag", o.start_turn_flag);
  FlagTexts(fields, "end_turn_flag", o.end_turn_flag);
  FlagTexts(fields, "mid_turn_flag", o.mid_turn_flag);
}

void DescribeKind(Fields& fields, FixedTurnOptions& o, bool) {
  fields.Require("fix_turn", "fix_turn = 180");
  fields.Number("fix_turn", o.fix_turn, Above(0, 36'000));
  fields.Number("mod_hdg", o.mod_hdg, Above(0, 180));
  OneWordOf(fields, "turn_dir", o.turn_dir, {"port", "starboard"});
  OrOff(fields, "speed", o.speed, kFastest_mps);
  OrOff(fields, "timeout", o.timeout, kLongest_s);
  OrOff(fields, "turn_delay", o.turn_delay, kLongest_s);
  VariableName(fields, "radius_rep_var", o.radius_rep_var);
}

void DescribeKind(Fields& fields, ZigzagOptions& o, bool) {
  fields.Number("stem_hdg", o.stem_hdg, Between(-360, 360));
  fields.Flag("stem_on_active", o.stem_on_active);
  fields.Number("speed", o.speed, kSpeedRange);
  fields.Flag("speed_on_active", o.speed_on_active);
  fields.Number("zig_angle", o.zig_angle, Between(1, 90));
  OneWordOf(fields, "zig_first", o.zig_first, {"port", "starboard"});
  fields.Number("hdg_thresh", o.hdg_thresh, kDegreesRange);
  fields.SmallInteger("max_zig_legs", o.max_zig_legs, 0, 1'000'000);
  OrOff(fields, "max_stem_odo", o.max_stem_odo, kFarthest_m);
  fields.Flag("fierce_zigging", o.fierce_zigging);
  FlagTexts(fields, "zigflag", o.zigflag);
  FlagTexts(fields, "zagflag", o.zagflag);
}

}  // namespace shoal

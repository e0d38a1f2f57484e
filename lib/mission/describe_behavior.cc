// The tables [[vehicle.behavior]], [[vehicle.mode]], [vehicle.variables], [vehicle.domain] and
// [[obstacle]]. The same descriptions read updates of a running helm (update_reader.h).
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/behaviors/behavior_runner.h"
#include "lib/geometry/convex_polygon.h"
#include "lib/mission/describe.h"
#include "lib/mission/polygon_text.h"
#include "lib/mission/suggest.h"
#include "lib/modes/value_text.h"

namespace shoal {
namespace {

constexpr size_t kMostBehaviorPoints = 10'000;
constexpr size_t kMostBehaviorCorners = 1000;
constexpr size_t kMostFlags = 100;
constexpr size_t kMostVariables = 1000;
constexpr int kMostDomainPoints = 10'001;
constexpr NumberLimits kBehaviorPlace = Between(-kFarthest_m, kFarthest_m);
constexpr NumberLimits kDistance = Between(0, kFarthest_m);
constexpr NumberLimits kSpeed = Between(0, kFastest_mps);
constexpr NumberLimits kSeconds = Between(0, kLongest_s);
constexpr NumberLimits kDepth = Between(0, 20'000);
constexpr NumberLimits kDegrees = Between(0, 180);
constexpr NumberLimits kPercent = Between(0, 100);

/// A number where -1, the default, means that it is off.
void OrOff(Fields& fields, std::string_view key, double& value, double max) {
  fields.Number(key, value, Between(-1, max));
  if (value < 0 && value != -1) {
    fields.Refuse(key, fmt::format("{} = {} is neither -1 (off) nor 0 to {}", key, value, max));
    value = -1;
  }
}

/// One text, or an array of them.
void TextsOrOne(Fields& fields, std::string_view key, std::vector<std::string>& texts,
                size_t max_count) {
  if (!fields.HoldsText(key)) return fields.Texts(key, texts, max_count);
  std::string text;
  fields.Text(key, text, {.min_length = 1, .max_length = 4096});
  texts = {text};
}

void Flags(Fields& fields, std::string_view key, std::vector<std::string>& flags) {
  TextsOrOne(fields, key, flags, kMostFlags);
  const auto parsed = ParseFlags(flags);
  if (!parsed.ok()) fields.Refuse(key, parsed.error());
}

void Conditions(Fields& fields, std::string_view key, std::vector<std::string>& conditions) {
  TextsOrOne(fields, key, conditions, kMostFlags);
  const auto parsed = ParseConditions(conditions);
  if (!parsed.ok()) fields.Refuse(key, parsed.error());
}

/// The name of a variable, or nothing.
void Variable(Fields& fields, std::string_view key, std::string& name) {
  fields.Text(key, name, {});
  const std::string problem = name.empty() ? "" : VariableNameProblem(name);
  if (!problem.empty()) fields.Refuse(key, problem);
}

void Words(Fields& fields, std::string_view key, std::string& word,
           std::initializer_list<std::string_view> words) {
  fields.Word(key, word, std::span(words.begin(), words.size()));
}

/// Corners as an array, or as a text of MOOS-IvP's: "radial:: x=0, y=0, radius=30, pts=8".
void Corners(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& corners,
             bool may_lack) {
  if (fields.HoldsText(key)) {
    std::string text;
    fields.Text(key, text, {.max_length = 4096});
    auto polygon = ParsePolygon(text);
    if (polygon.ok()) {
      corners = std::move(*polygon);
    } else {
      fields.Refuse(key, fmt::format("{}: {}", key, polygon.error()));
      return;
    }
  } else {
    fields.Pairs(key, corners, kBehaviorPlace, kMostBehaviorCorners);
  }
  if (corners.empty() && may_lack) return;
  if (corners.empty() && !fields.Has(key, true)) return;  // That was refused.
  if (!IsConvex(corners)) {
    fields.Refuse(key, fmt::format("{} is not convex: give at least three corners that all turn to "
                                   "the same side",
                                   key));
  }
}

void Points(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& points) {
  if (!fields.HoldsText(key)) return fields.Pairs(key, points, kBehaviorPlace, kMostBehaviorPoints);
  std::string text;
  fields.Text(key, text, {.max_length = 100'000});
  auto read = ParsePoints(text);
  if (read.ok()) {
    points = std::move(*read);
  } else {
    fields.Refuse(key, fmt::format("{}: {}", key, read.error()));
  }
}

/// A point that may be absent.
void MayBePoint(Fields& fields, std::string_view key, std::optional<Eigen::Vector2d>& point) {
  if (!fields.Has(key, point.has_value())) return;
  Eigen::Vector2d read = point.value_or(Eigen::Vector2d(0, 0));
  fields.Pair(key, read, kBehaviorPlace);
  point = read;
}

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
  fields.Number("speed", speed, kSpeed);
  OrOff(fields, "speed_alt", speed_alt, kFastest_mps);
  fields.Flag("use_alt_speed", use_alt_speed);
  fields.CalledElsewhere("speed", "speed_mps");
}

void Lead(Fields& fields, double& lead, double& lead_damper) {
  OrOff(fields, "lead", lead, kFarthest_m);
  OrOff(fields, "lead_damper", lead_damper, kFarthest_m);
  fields.CalledElsewhere("lead", "lead_distance");
}

void Peak(Fields& fields, double& width, double& base, double& delta, double max) {
  fields.Number("peakwidth", width, Between(0, max));
  fields.Number("basewidth", base, Between(0, max));
  fields.Number("summitdelta", delta, kPercent);
  fields.CalledElsewhere("summitdelta", "summit_delta");
}

void Describe(Fields& fields, ContactOptions& options, bool is_recipe) {
  if (!is_recipe) fields.Require("contact", "contact = \"henry\", the name of a vehicle");
  fields.Text("contact", options.contact, {});
  fields.Flag("on_no_contact_ok", options.on_no_contact_ok);
  const std::pair<std::string_view, std::vector<std::string>*> filters[] = {
      {"match_name", &options.match_name},   {"ignore_name", &options.ignore_name},
      {"match_group", &options.match_group}, {"ignore_group", &options.ignore_group},
      {"match_type", &options.match_type},   {"ignore_type", &options.ignore_type}};
  for (const auto& [key, names] : filters) TextsOrOne(fields, key, *names, kMostVariables);
  fields.Flag("exit_on_filter_group", options.exit_on_filter_group);
  fields.Flag("post_per_contact_info", options.post_per_contact_info);
  TextsOrOne(fields, "cnflag", options.cnflag, kMostFlags);
  const auto moments = ParseMomentFlags(options.cnflag);
  if (!moments.ok()) fields.Refuse("cnflag", moments.error());
  fields.NoKey("extrapolate", "a helm always extrapolates its contacts: docs/contacts.md");
  fields.NoKey("decay", "a helm always extrapolates its contacts: docs/contacts.md");
  fields.NoKey("use_refinery", "decisions are exact without it");
}

/// What avoid_collision and colregs share.
template <class Options>
void Avoidance(Fields& fields, Options& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistance);
  fields.Number("completed_dist", o.completed_dist, Above(0, kFarthest_m));
  fields.Number("min_util_cpa_dist", o.min_util_cpa_dist, kDistance);
  fields.Number("max_util_cpa_dist", o.max_util_cpa_dist, kDistance);
  Words(fields, "pwt_grade", o.pwt_grade, {"linear", "quasi", "quadratic"});
  fields.Number("time_on_leg", o.time_on_leg, Above(0, 36'000));
  fields.Number("widen_per_s", o.widen_per_s, Between(0, kFastest_mps));
  fields.CalledElsewhere("pwt_outer_dist", "active_outer_distance");
  fields.CalledElsewhere("pwt_inner_dist", "active_inner_distance");
  fields.CalledElsewhere("completed_dist", "completed_distance");
  fields.CalledElsewhere("min_util_cpa_dist", "collision_distance");
  fields.CalledElsewhere("max_util_cpa_dist", "all_clear_distance");
  if (o.pwt_inner_dist >= o.pwt_outer_dist) {
    fields.Refuse("pwt_inner_dist", "pwt_inner_dist must be less than pwt_outer_dist");
  }
  if (o.min_util_cpa_dist >= o.max_util_cpa_dist) {
    fields.Refuse("min_util_cpa_dist", "min_util_cpa_dist must be less than max_util_cpa_dist");
  }
  if (o.completed_dist < o.pwt_outer_dist) {
    fields.Refuse("completed_dist",
                  "completed_dist must not be less than pwt_outer_dist: the behavior would end "
                  "while its contact is in range");
  }
}

void DescribeKind(Fields& fields, WaypointOptions& o, bool is_recipe) {
  if (!is_recipe) fields.Require("points", "points = [[0, 0], [100, 0]]");
  Points(fields, "points", o.points);
  AltSpeed(fields, o.speed, o.speed_alt, o.use_alt_speed);
  Capture(fields, "capture_radius", o.capture_radius, o.slip_radius);
  fields.Flag("capture_line", o.capture_line);
  fields.Flag("capture_line_only", o.capture_line_only);
  Lead(fields, o.lead, o.lead_damper);
  fields.Flag("lead_to_start", o.lead_to_start);
  fields.Text("lead_condition", o.lead_condition, {.max_length = 1000});
  if (!o.lead_condition.empty()) {
    const auto condition = Condition::Parse(o.lead_condition);
    if (!condition.ok()) fields.Refuse("lead_condition", condition.error());
  }
  Words(fields, "order", o.order, {"normal", "reverse", "toggle"});
  fields.SmallInteger("repeat", o.repeat, -1, 1'000'000);
  fields.Flag("greedy_tour", o.greedy_tour);
  fields.SmallInteger("currix", o.currix, 0, static_cast<int>(kMostBehaviorPoints));
  Words(fields, "ipf_type", o.ipf_type, {"zaic", "zaic_spd", "roc"});
  Patience(fields, o.patience);
  Flags(fields, "wptflag", o.wptflag);
  Flags(fields, "cycleflag", o.cycleflag);
  fields.Flag("wptflag_on_start", o.wptflag_on_start);
  fields.Flag("reset_on_idle", o.reset_on_idle);
  OrOff(fields, "end_speed", o.end_speed, kFastest_mps);
  fields.Number("end_slow_dist", o.end_slow_dist, kDistance);
  fields.Number("end_stop_dist", o.end_stop_dist, kDistance);
  fields.Text("post_suffix", o.post_suffix, {});
  fields.CalledElsewhere("points", "polygon");
  fields.CalledElsewhere("end_speed", "end_spd");
  fields.CalledElsewhere("cycleflag", "cycle_flag");
  if (o.currix > 0 && !o.points.empty() && static_cast<size_t>(o.currix) >= o.points.size()) {
    fields.Refuse("currix", fmt::format("currix = {} is not the index of a point; the last is {}",
                                        o.currix, o.points.size() - 1));
  }
}

void DescribeKind(Fields& fields, LoiterOptions& o, bool is_recipe) {
  if (!is_recipe) {
    fields.Require("polygon", "polygon = \"radial:: x=0, y=0, radius=30, pts=8\"");
  }
  Corners(fields, "polygon", o.polygon, is_recipe);
  AltSpeed(fields, o.speed, o.speed_alt, o.use_alt_speed);
  fields.Scalar("clockwise", o.clockwise);
  if (o.clockwise != "true" && o.clockwise != "false" && o.clockwise != "best") {
    fields.Refuse("clockwise", "clockwise must be true, false or \"best\"");
    o.clockwise = "true";
  }
  Capture(fields, "radius", o.radius, o.slip_radius);
  fields.Number("acquire_dist", o.acquire_dist, kDistance);
  fields.Flag("center_activate", o.center_activate);
  fields.Number("spiral_factor", o.spiral_factor, Between(-1000, 1000));
  Patience(fields, o.patience);
  OrOff(fields, "slingshot", o.slingshot, 36'000);
  fields.Text("post_suffix", o.post_suffix, {});
  Words(fields, "ipf_type", o.ipf_type, {"zaic", "zaic_spd"});
}

void DescribeKind(Fields& fields, StationKeepOptions& o, bool is_recipe) {
  MayBePoint(fields, "station_pt", o.station_pt);
  fields.Flag("center_activate", o.center_activate);
  fields.Number("swing_time", o.swing_time, Between(0, 60));
  fields.Number("inner_radius", o.inner_radius, Between(0, 10'000));
  fields.Number("outer_radius", o.outer_radius, Above(0, 10'000));
  fields.Number("outer_speed", o.outer_speed, kSpeed);
  fields.Number("transit_speed", o.transit_speed, kSpeed);
  OrOff(fields, "hibernation_radius", o.hibernation_radius, 10'000);
  fields.CalledElsewhere("station_pt", "point");
  fields.CalledElsewhere("transit_speed", "extra_speed");
  if (o.outer_radius <= o.inner_radius) {
    fields.Refuse("outer_radius", "outer_radius must be greater than inner_radius");
  }
  if (!is_recipe && !o.station_pt && !o.center_activate) {
    fields.Refuse("station_pt",
                  "station_keep needs station_pt = [0, 0], or center_activate = true to stay where "
                  "it begins");
  }
}

void DescribeKind(Fields& fields, AvoidCollisionOptions& o, bool is_recipe) {
  Avoidance(fields, o, is_recipe);
  OrOff(fields, "collision_depth", o.collision_depth, 20'000);
}

void DescribeKind(Fields& fields, ColregsOptions& o, bool is_recipe) {
  Avoidance(fields, o, is_recipe);
  fields.Number("turn_radius", o.turn_radius, kDistance);
  OrOff(fields, "giveway_bow_dist", o.giveway_bow_dist, kFarthest_m);
  fields.Flag("headon_only", o.headon_only);
  fields.Flag("pts_port_turns_ok", o.pts_port_turns_ok);
  fields.Flag("can_disable", o.can_disable);
  fields.Number("min_dwell", o.min_dwell, Between(0, 3600));
}

void DescribeKind(Fields& fields, ConstantDepthOptions& o, bool) {
  fields.Number("depth", o.depth, kDepth);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, 20'000);
  Variable(fields, "depth_mismatch_var", o.depth_mismatch_var);
}

void DescribeKind(Fields& fields, ConstantSpeedOptions& o, bool) {
  fields.Number("speed", o.speed, kSpeed);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, kFastest_mps);
  Variable(fields, "speed_mismatch_var", o.speed_mismatch_var);
  fields.CalledElsewhere("speed", "speed_mps");
}

void DescribeKind(Fields& fields, ConstantHeadingOptions& o, bool) {
  fields.Number("heading", o.heading, Between(-360, 360));
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, 180);
  OrOff(fields, "complete_thresh", o.complete_thresh, 180);
  Variable(fields, "heading_mismatch_var", o.heading_mismatch_var);
  fields.CalledElsewhere("heading", "heading_deg");
}

void DescribeKind(Fields& fields, AvoidObstacleOptions& o, bool is_recipe) {
  fields.Text("id", o.id, {});
  Corners(fields, "polygon", o.polygon, true);
  fields.Number("allowable_ttc", o.allowable_ttc, Above(0, 36'000));
  fields.Number("min_util_cpa_dist", o.min_util_cpa_dist, kDistance);
  fields.Number("max_util_cpa_dist", o.max_util_cpa_dist, kDistance);
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistance);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("completed_dist", o.completed_dist, Above(0, kFarthest_m));
  fields.Number("turn_radius", o.turn_radius, kDistance);
  fields.Flag("holonomic_ok", o.holonomic_ok);
  fields.Flag("allstop_on_breach", o.allstop_on_breach);
  Flags(fields, "rng_flag", o.rng_flag);
  Flags(fields, "cpa_flag", o.cpa_flag);
  fields.NoKey("use_refinery", "decisions are exact without it");
  if (o.pwt_inner_dist >= o.pwt_outer_dist) {
    fields.Refuse("pwt_inner_dist", "pwt_inner_dist must be less than pwt_outer_dist");
  }
  if (o.min_util_cpa_dist >= o.max_util_cpa_dist) {
    fields.Refuse("min_util_cpa_dist", "min_util_cpa_dist must be less than max_util_cpa_dist");
  }
  if (o.completed_dist < o.pwt_outer_dist) {
    fields.Refuse("completed_dist", "completed_dist must not be less than pwt_outer_dist");
  }
  if (!is_recipe && o.id.empty() && o.polygon.empty()) {
    fields.Refuse("id",
                  "avoid_obstacle needs the id of an [[obstacle]], a polygon of its own, or "
                  "templating = \"spawn\" for all obstacles");
  }
}

void DescribeKind(Fields&, TimerOptions&, bool) {}

void DescribeKind(Fields& fields, PeriodicSurfaceOptions& o, bool) {
  fields.Number("period", o.period, kSeconds);
  Variable(fields, "mark_variable", o.mark_variable);
  OrOff(fields, "ascent_speed", o.ascent_speed, kFastest_mps);
  Words(fields, "ascent_grade", o.ascent_grade, {"linear", "quadratic", "quasi", "fullspeed"});
  fields.Number("zero_speed_depth", o.zero_speed_depth, kDepth);
  fields.Number("max_time_at_surface", o.max_time_at_surface, kSeconds);
  Variable(fields, "pending_status_var", o.pending_status_var);
  Variable(fields, "atsurface_status_var", o.atsurface_status_var);
}

void DescribeKind(Fields& fields, TrailOptions& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  fields.Number("trail_range", o.trail_range, kDistance);
  fields.Number("trail_angle", o.trail_angle, Between(-360, 360));
  Words(fields, "trail_angle_type", o.trail_angle_type, {"relative", "absolute"});
  fields.Number("radius", o.radius, kDistance);
  fields.Number("nm_radius", o.nm_radius, Above(0, kFarthest_m));
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, kDistance);
  if (o.nm_radius < o.radius) {
    fields.Refuse("nm_radius", "nm_radius must not be less than radius");
  }
}

void DescribeKind(Fields& fields, MaxDepthOptions& o, bool) {
  fields.Require("max_depth", "max_depth = 30");
  fields.Number("max_depth", o.max_depth, kDepth);
  fields.Number("tolerance", o.tolerance, kDepth);
  Variable(fields, "depth_slack_var", o.depth_slack_var);
  fields.CalledElsewhere("max_depth", "depth");
  fields.CalledElsewhere("tolerance", "basewidth");
}

void DescribeKind(Fields& fields, MaxSpeedOptions& o, bool) {
  fields.Require("max_speed", "max_speed = 1.5");
  fields.Number("max_speed", o.max_speed, kSpeed);
  fields.Number("tolerance", o.tolerance, kSpeed);
  Variable(fields, "speed_slack_var", o.speed_slack_var);
  fields.CalledElsewhere("max_speed", "speed");
  fields.CalledElsewhere("tolerance", "basewidth");
}

void DescribeKind(Fields& fields, CutRangeOptions& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistance);
  fields.Number("giveup_dist", o.giveup_dist, kDistance);
  fields.Number("patience", o.patience, Between(0, 85));
  fields.Number("time_on_leg", o.time_on_leg, Above(0, 36'000));
  Flags(fields, "pursueflag", o.pursueflag);
  Flags(fields, "giveupflag", o.giveupflag);
  fields.CalledElsewhere("giveup_dist", "giveup_range");
  if (o.pwt_inner_dist >= o.pwt_outer_dist) {
    fields.Refuse("pwt_inner_dist", "pwt_inner_dist must be less than pwt_outer_dist");
  }
}

void DescribeKind(Fields& fields, ConvoyOptions& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  fields.Number("range", o.range, Above(0, kFarthest_m));
  fields.Number("radius", o.radius, Above(0, 10'000));
  fields.Number("nm_radius", o.nm_radius, Above(0, 10'000));
  fields.Number("mark_spacing", o.mark_spacing, Above(0, 10'000));
  fields.Number("spd_gain", o.spd_gain, Between(0, 100));
  OrOff(fields, "spd_max", o.spd_max, kFastest_mps);
}

void DescribeKind(Fields& fields, GoToDepthOptions& o, bool) {
  fields.Require("depths", "depths = [[10, 60], [20, 120]], depth in m and time at it in s");
  fields.Pairs("depths", o.depths, Between(0, kLongest_s), kMostBehaviorPoints);
  for (const Eigen::Vector2d& level : o.depths) {
    if (level.x() > kDepth.max) {
      fields.Refuse("depths", fmt::format("a depth of {} m is out of range; allowed: 0 to {}",
                                          level.x(), kDepth.max));
    }
  }
  fields.SmallInteger("repeat", o.repeat, 0, 1'000'000);
  fields.Number("capture_delta", o.capture_delta, Above(0, 1000));
  Flags(fields, "capture_flag", o.capture_flag);
  fields.CalledElsewhere("depths", "depth");
}

void DescribeKind(Fields& fields, LegRunOptions& o, bool is_recipe) {
  if (!is_recipe) {
    fields.Require("p1", "p1 = [0, 0]");
    fields.Require("p2", "p2 = [100, 0]");
  }
  MayBePoint(fields, "p1", o.p1);
  MayBePoint(fields, "p2", o.p2);
  fields.Number("speed", o.speed, kSpeed);
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
  fields.Number("turn1_ext", o.turn1_ext, kDistance);
  fields.Number("turn2_ext", o.turn2_ext, kDistance);
  Words(fields, "turn1_dir", o.turn1_dir, {"auto", "port", "starboard"});
  Words(fields, "turn2_dir", o.turn2_dir, {"auto", "port", "starboard"});
  Capture(fields, "capture_radius", o.capture_radius, o.slip_radius);
  Lead(fields, o.lead, o.lead_damper);
  Patience(fields, o.patience);
  fields.SmallInteger("repeat", o.repeat, -1, 1'000'000);
  Flags(fields, "leg_end_flag", o.leg_end_flag);
  Flags(fields, "start_leg_flag", o.start_leg_flag);
  Flags(fields, "mid_flag", o.mid_flag);
  Flags(fields, "start_turn_flag", o.start_turn_flag);
  Flags(fields, "end_turn_flag", o.end_turn_flag);
  Flags(fields, "mid_turn_flag", o.mid_turn_flag);
}

void DescribeKind(Fields& fields, OpRegionOptions& o, bool) {
  Corners(fields, "core_poly", o.core_poly, true);
  Corners(fields, "save_poly", o.save_poly, true);
  Corners(fields, "halt_poly", o.halt_poly, true);
  OrOff(fields, "save_dist", o.save_dist, kFarthest_m);
  OrOff(fields, "halt_dist", o.halt_dist, kFarthest_m);
  fields.Number("max_depth", o.max_depth, kDepth);
  fields.Number("min_altitude", o.min_altitude, kDepth);
  fields.Number("max_time", o.max_time, kSeconds);
  fields.Number("trigger_entry_time", o.trigger_entry_time, kSeconds);
  fields.Number("trigger_exit_time", o.trigger_exit_time, kSeconds);
  fields.Flag("trigger_on_poly_entry", o.trigger_on_poly_entry);
  fields.Flag("soft_poly_breach", o.soft_poly_breach);
  fields.Number("look_ahead", o.look_ahead, kSeconds);
  fields.Number("recover_spd", o.recover_spd, kSpeed);
  fields.Numbers("recover_patience", o.recover_patience, 100);
  for (const double share : o.recover_patience) {
    if (share < 1 || share > 99) {
      fields.Refuse("recover_patience", "each of recover_patience must be 1 to 99");
    }
  }
  fields.Flag("latch", o.latch);
  Variable(fields, "reset_var", o.reset_var);
  Flags(fields, "save_flag", o.save_flag);
  Flags(fields, "savex_flag", o.savex_flag);
  Flags(fields, "breached_poly_flag", o.breached_poly_flag);
  Flags(fields, "breached_depth_flag", o.breached_depth_flag);
  Flags(fields, "breached_altitude_flag", o.breached_altitude_flag);
  Flags(fields, "breached_time_flag", o.breached_time_flag);
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
  fields.Number("period_speed", o.period_speed, kSpeed);
  Peak(fields, o.peakwidth, o.basewidth, o.summitdelta, kFastest_mps);
  fields.Flag("initially_busy", o.initially_busy);
  fields.Flag("reset_upon_running", o.reset_upon_running);
}

void DescribeKind(Fields& fields, ShadowOptions& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, kDistance);
  fields.Number("heading_peakwidth", o.heading_peakwidth, kDegrees);
  fields.Number("heading_basewidth", o.heading_basewidth, kDegrees);
  fields.Number("speed_peakwidth", o.speed_peakwidth, kSpeed);
  fields.Number("speed_basewidth", o.speed_basewidth, kSpeed);
  fields.CalledElsewhere("pwt_outer_dist", "max_range");
}

void DescribeKind(Fields& fields, FixedTurnOptions& o, bool) {
  fields.Require("fix_turn", "fix_turn = 180");
  fields.Number("fix_turn", o.fix_turn, Above(0, 36'000));
  fields.Number("mod_hdg", o.mod_hdg, Above(0, 180));
  Words(fields, "turn_dir", o.turn_dir, {"port", "starboard"});
  OrOff(fields, "speed", o.speed, kFastest_mps);
  OrOff(fields, "timeout", o.timeout, kLongest_s);
  OrOff(fields, "turn_delay", o.turn_delay, kLongest_s);
  Variable(fields, "radius_rep_var", o.radius_rep_var);
}

void DescribeKind(Fields& fields, ZigzagOptions& o, bool) {
  fields.Number("stem_hdg", o.stem_hdg, Between(-360, 360));
  fields.Flag("stem_on_active", o.stem_on_active);
  fields.Number("speed", o.speed, kSpeed);
  fields.Flag("speed_on_active", o.speed_on_active);
  fields.Number("zig_angle", o.zig_angle, Between(1, 90));
  Words(fields, "zig_first", o.zig_first, {"port", "starboard"});
  fields.Number("hdg_thresh", o.hdg_thresh, kDegrees);
  fields.SmallInteger("max_zig_legs", o.max_zig_legs, 0, 1'000'000);
  OrOff(fields, "max_stem_odo", o.max_stem_odo, kFarthest_m);
  fields.Flag("fierce_zigging", o.fierce_zigging);
  Flags(fields, "zigflag", o.zigflag);
  Flags(fields, "zagflag", o.zagflag);
}

void DescribeKind(Fields&, FullStopOptions&, bool) {}

void DescribeKind(Fields& fields, TestFailureOptions& o, bool) {
  Words(fields, "failure_type", o.failure_type, {"crash", "burn"});
  fields.Number("burn_time", o.burn_time, Between(0, 60));
}

void DescribeFlags(Fields& fields, BehaviorFlags& flags) {
  Flags(fields, "runflag", flags.runflag);
  Flags(fields, "runxflag", flags.runxflag);
  Flags(fields, "idleflag", flags.idleflag);
  Flags(fields, "activeflag", flags.activeflag);
  Flags(fields, "inactiveflag", flags.inactiveflag);
  Flags(fields, "endflag", flags.endflag);
  Flags(fields, "spawnflag", flags.spawnflag);
  Flags(fields, "spawnxflag", flags.spawnxflag);
  Flags(fields, "configflag", flags.configflag);
  fields.NoKey("startflag", "write the setting in [vehicle.variables]");
}

void DescribeDuration(Fields& fields, BehaviorOptions& options) {
  if (fields.Has("duration", options.duration.has_value())) {
    double duration_s = options.duration.value_or(0);
    fields.Number("duration", duration_s, kSeconds);
    options.duration = duration_s;
  }
  fields.Flag("duration_idle_decay", options.duration_idle_decay);
  fields.Text("duration_reset", options.duration_reset, {.max_length = 200});
  Variable(fields, "duration_status", options.duration_status);
  TextsOrOne(fields, "nostarve", options.nostarve, kMostFlags);
  fields.Number("nostarve_s", options.nostarve_s, kSeconds);
  if (!options.nostarve.empty() && options.nostarve_s <= 0) {
    fields.Refuse("nostarve", "nostarve needs nostarve_s = 10, the greatest age in seconds");
  }
}

/// An axis as [first, last, number of points].
void DescribeAxis(Fields& fields, std::string_view key, Axis& axis, double max) {
  if (!fields.Has(key, axis.count > 0)) return;
  Eigen::Vector3d triple(axis.first, axis.count > 0 ? axis.Last() : 0, axis.count);
  fields.Triple(key, triple, Between(0, std::max<double>(max, kMostDomainPoints)));
  const double count = triple.z();
  if (triple.x() >= triple.y() || triple.y() > max || count != std::floor(count) || count < 2 ||
      count > kMostDomainPoints) {
    fields.Refuse(key, fmt::format("{} must be [first, last, number of points]: first less than "
                                   "last, last at most {}, 2 to {} points",
                                   key, max, kMostDomainPoints));
    return;
  }
  axis = {.first = triple.x(),
          .step = (triple.y() - triple.x()) / (count - 1),
          .count = static_cast<int>(count)};
}

}  // namespace

void DescribeKindOf(Fields& fields, BehaviorOptions& options) {
  const bool is_recipe = options.templating == Templating::kSpawn || !fields.demands_keys();
  std::visit([&](auto& what) { DescribeKind(fields, what, is_recipe); }, options.what);
}

void DescribeCommon(Fields& fields, BehaviorOptions& options) {
  fields.Number("pwt", options.pwt, Between(0, 1e6));
  fields.CalledElsewhere("pwt", "priority");
  fields.CalledElsewhere("pwt", "weight");
  Conditions(fields, "condition", options.condition);
  DescribeFlags(fields, options.flags);
  DescribeDuration(fields, options);
  fields.Flag("perpetual", options.perpetual);
}

void Describe(Fields& fields, BehaviorOptions& options) {
  constexpr std::array<std::pair<std::string_view, Templating>, 3> kTemplating = {{
      {"none", Templating::kNone},
      {"spawn", Templating::kSpawn},
      {"clone", Templating::kClone},
  }};
  const std::vector<AnyBehavior> kinds = OneBehaviorOfEachKind();
  std::vector<std::string_view> words;
  words.reserve(kinds.size());
  for (const AnyBehavior& each : kinds) words.push_back(KindOf(each));
  std::string kind(fields.reading() ? "" : KindOf(options.what));
  fields.Require("kind", "kind = \"waypoint\"");
  fields.Word("kind", kind, words);
  if (fields.reading()) {
    for (const AnyBehavior& each : kinds) {
      if (kind == KindOf(each)) options.what = each;
    }
    options.name = kind;
  }
  fields.Text("name", options.name, {.min_length = 1});
  if (!options.name.empty() && !VariableNameProblem(options.name).empty()) {
    fields.Refuse(
        "name", Quoted(options.name) + " is no name of a behavior: letters, digits and _ . - are");
  }
  if (kind.empty()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return;
  }
  DescribeCommon(fields, options);
  Variable(fields, "updates", options.updates);
  fields.Choice("templating", options.templating, kTemplating);
  if (fields.reading() && options.templating == Templating::kSpawn && !fields.Has("name", true)) {
    options.name += '_';  // The names of what it makes begin with it.
  }
  fields.SmallInteger("max_spawnings", options.max_spawnings, 1, 1'000'000);
  DescribeKindOf(fields, options);
}

void Describe(Fields& fields, ModeOptions& mode) {
  fields.Require("set", "set = \"MODE = ACTIVE\"");
  fields.Text("set", mode.set, {.min_length = 1, .max_length = 200});
  Conditions(fields, "condition", mode.condition);
  fields.Text("else", mode.otherwise, {});
  fields.CalledElsewhere("else", "otherwise");
  if (!mode.set.empty() && ParseConditions(mode.condition).ok()) {
    const auto tree = ModeTree::Parse(std::span(&mode, 1));
    if (!tree.ok()) fields.Refuse("set", tree.error());
  }
}

void Describe(Fields& fields, Domain& domain) {
  DescribeAxis(fields, "speed", domain.speed_mps, kFastest_mps);
  DescribeAxis(fields, "depth", domain.depth_m, kDepth.max);
  fields.NoKey("course", "courses are always whole degrees");
  if (domain.speed_mps.first != 0) {
    fields.Refuse("speed", "the first speed must be 0, so that a vessel can stop");
    domain.speed_mps.first = 0;
  }
}

void Describe(Fields& fields, Obstacle& obstacle) {
  fields.Require("id", "id = \"rock\"");
  fields.Text("id", obstacle.id, {.min_length = 1});
  if (!obstacle.id.empty() && !VariableNameProblem(obstacle.id).empty()) {
    fields.Refuse("id", Quoted(obstacle.id) + " is no id: letters, digits and _ . - are");
  }
  fields.Require("polygon", "polygon = [[40, -10], [60, -10], [60, 10], [40, 10]]");
  Corners(fields, "polygon", obstacle.polygon_m, true);
  if (obstacle.polygon_m.empty() && fields.Has("polygon", true)) {
    fields.Refuse("polygon", "polygon needs at least three corners");
  }
}

void DescribeVariables(Fields& fields, std::map<std::string, VariableValue>& variables) {
  fields.Scalars("variables", variables, kMostVariables);
  for (const auto& [name, value] : variables) {
    const std::string problem = VariableNameProblem(name);
    if (!problem.empty()) fields.Refuse("variables", problem);
  }
}

}  // namespace shoal

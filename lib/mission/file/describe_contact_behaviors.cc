// [[vehicle.behavior]] of the kinds that are about others: contacts and obstacles.
#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "lib/helm/behaviors/contact_moments.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/behavior_fields.h"

namespace shoal {
namespace {

void Describe(Fields& fields, ContactOptions& options, bool is_recipe) {
  if (!is_recipe) fields.Require("contact", "contact = \"henry\", the name of a vehicle");
  fields.Text("contact", options.contact, {});
  fields.Flag("on_no_contact_ok", options.on_no_contact_ok);
  const std::pair<std::string_view, std::vector<std::string>*> filters[] = {
      {"match_name", &options.match_name},   {"ignore_name", &options.ignore_name},
      {"match_group", &options.match_group}, {"ignore_group", &options.ignore_group},
      {"match_type", &options.match_type},   {"ignore_type", &options.ignore_type}};
  for (const auto& [key, names] : filters) TextsOrOne(fields, key, *names, kMaxVariables);
  fields.Flag("exit_on_filter_group", options.exit_on_filter_group);
  fields.Flag("post_per_contact_info", options.post_per_contact_info);
  TextsOrOne(fields, "cnflag", options.cnflag, kMaxFlags);
  const auto moments = ParseMomentFlags(options.cnflag);
  if (!moments.ok()) fields.Refuse("cnflag", moments.error());
  fields.NoKey("extrapolate", "a helm always extrapolates its contacts: docs/vehicles/contacts.md");
  fields.NoKey("decay", "a helm always extrapolates its contacts: docs/vehicles/contacts.md");
  fields.NoKey("use_refinery", "decisions are exact without it");
}

/// Of the kinds that do not keep clear.
void DescribeWithAlerts(Fields& fields, ContactOptions& options, bool is_recipe) {
  Describe(fields, options, is_recipe);
  OrOff(fields, "alert_range", options.alert_range, kFarthest_m);
}

/// What avoid_collision and colregs share.
template <class Options>
void Avoidance(Fields& fields, Options& o, bool is_recipe) {
  Describe(fields, o.contact, is_recipe);
  OrOff(fields, "vertical_separation", o.contact.vertical_separation, 20'000);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistanceRange);
  fields.Number("completed_dist", o.completed_dist, Above(0, kFarthest_m));
  fields.Number("min_util_cpa_dist", o.min_util_cpa_dist, kDistanceRange);
  fields.Number("max_util_cpa_dist", o.max_util_cpa_dist, kDistanceRange);
  OneWordOf(fields, "pwt_grade", o.pwt_grade, {"linear", "quasi", "quadratic"});
  fields.Number("time_on_leg", o.time_on_leg, Above(0, 36'000));
  fields.Flag("steady", o.steady);
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

}  // namespace

void DescribeKind(Fields& fields, AvoidCollisionOptions& o, bool is_recipe) {
  Avoidance(fields, o, is_recipe);
  OrOff(fields, "collision_depth", o.collision_depth, 20'000);
}

void DescribeKind(Fields& fields, ColregsOptions& o, bool is_recipe) {
  Avoidance(fields, o, is_recipe);
  fields.Number("turn_radius", o.turn_radius, kDistanceRange);
  OrOff(fields, "giveway_bow_dist", o.giveway_bow_dist, kFarthest_m);
  fields.Flag("headon_only", o.headon_only);
  fields.Flag("pts_port_turns_ok", o.pts_port_turns_ok);
  fields.Flag("can_disable", o.can_disable);
  fields.Number("min_dwell", o.min_dwell, Between(0, 3600));
}

void DescribeKind(Fields& fields, AvoidObstacleOptions& o, bool is_recipe) {
  fields.Text("id", o.id, {});
  ConvexCorners(fields, "polygon", o.polygon, true);
  fields.Number("allowable_ttc", o.allowable_ttc, Above(0, 36'000));
  fields.Number("min_util_cpa_dist", o.min_util_cpa_dist, kDistanceRange);
  fields.Number("max_util_cpa_dist", o.max_util_cpa_dist, kDistanceRange);
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistanceRange);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("completed_dist", o.completed_dist, Above(0, kFarthest_m));
  fields.Number("turn_radius", o.turn_radius, kDistanceRange);
  fields.Flag("holonomic_ok", o.holonomic_ok);
  fields.Flag("allstop_on_breach", o.allstop_on_breach);
  FlagTexts(fields, "rng_flag", o.rng_flag);
  FlagTexts(fields, "cpa_flag", o.cpa_flag);
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

void DescribeKind(Fields& fields, TrailOptions& o, bool is_recipe) {
  DescribeWithAlerts(fields, o.contact, is_recipe);
  fields.Number("trail_range", o.trail_range, kDistanceRange);
  fields.Number("trail_angle", o.trail_angle, Between(-360, 360));
  OneWordOf(fields, "trail_angle_type", o.trail_angle_type, {"relative", "absolute"});
  fields.Number("radius", o.radius, kDistanceRange);
  fields.Number("nm_radius", o.nm_radius, Above(0, kFarthest_m));
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, kDistanceRange);
  if (o.nm_radius < o.radius) {
    fields.Refuse("nm_radius", "nm_radius must not be less than radius");
  }
}

void DescribeKind(Fields& fields, CutRangeOptions& o, bool is_recipe) {
  DescribeWithAlerts(fields, o.contact, is_recipe);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, Above(0, kFarthest_m));
  fields.Number("pwt_inner_dist", o.pwt_inner_dist, kDistanceRange);
  fields.Number("giveup_dist", o.giveup_dist, kDistanceRange);
  fields.Number("patience", o.patience, Between(0, 85));
  fields.Number("time_on_leg", o.time_on_leg, Above(0, 36'000));
  FlagTexts(fields, "pursueflag", o.pursueflag);
  FlagTexts(fields, "giveupflag", o.giveupflag);
  fields.CalledElsewhere("giveup_dist", "giveup_range");
  if (o.pwt_inner_dist >= o.pwt_outer_dist) {
    fields.Refuse("pwt_inner_dist", "pwt_inner_dist must be less than pwt_outer_dist");
  }
}

void DescribeKind(Fields& fields, ConvoyOptions& o, bool is_recipe) {
  DescribeWithAlerts(fields, o.contact, is_recipe);
  fields.Number("range", o.range, Above(0, kFarthest_m));
  fields.Number("radius", o.radius, Above(0, 10'000));
  fields.Number("nm_radius", o.nm_radius, Above(0, 10'000));
  fields.Number("mark_spacing", o.mark_spacing, Above(0, 10'000));
  fields.Number("spd_gain", o.spd_gain, Between(0, 100));
  OrOff(fields, "spd_max", o.spd_max, kFastest_mps);
}

void DescribeKind(Fields& fields, ShadowOptions& o, bool is_recipe) {
  DescribeWithAlerts(fields, o.contact, is_recipe);
  fields.Number("pwt_outer_dist", o.pwt_outer_dist, kDistanceRange);
  fields.Number("heading_peakwidth", o.heading_peakwidth, kDegreesRange);
  fields.Number("heading_basewidth", o.heading_basewidth, kDegreesRange);
  fields.Number("speed_peakwidth", o.speed_peakwidth, kSpeedRange);
  fields.Number("speed_basewidth", o.speed_basewidth, kSpeedRange);
  fields.CalledElsewhere("pwt_outer_dist", "max_range");
}

}  // namespace shoal

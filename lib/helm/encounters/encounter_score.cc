#include "lib/helm/encounters/encounter_score.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kApparent_deg = 30;
constexpr double kApparentShare = 0.5;
constexpr double kHeldFull_deg = 3;
constexpr double kHeldNothing_deg = 30;
constexpr double kHeldFullShare = 0.05;
constexpr double kHeldNothingShare = 0.5;
/// Shorter times to the closest approach than this leave no choice of when to act.
constexpr double kLeastTime_s = 1;

/// Returns 0 at `nothing`, 1 at `full` and beyond, linear between them.
double Share(double value, double nothing, double full) {
  if (nothing == full) return value >= full ? 1 : 0;
  return std::clamp((value - nothing) / (full - nothing), 0.0, 1.0);
}

double RangeShare(const Encounter& encounter, const EncounterOptions& options) {
  const double range_m = encounter.closest_m;
  if (encounter.has_touched || range_m <= encounter.touch_m) return 0;
  if (range_m < options.near_miss_m) {
    return 0.2 * Share(range_m, encounter.touch_m, options.near_miss_m);
  }
  if (range_m < options.acceptable_m) {
    return 0.2 + 0.4 * Share(range_m, options.near_miss_m, options.acceptable_m);
  }
  return 0.6 + 0.4 * Share(range_m, options.acceptable_m, options.preferred_m);
}

double EarlyShare(const Encounter& encounter, const EncounterSide& side) {
  if (!side.conduct.first_alteration_s) return 0;
  const double available_s = std::max(side.entry.time_to_cpa_s, kLeastTime_s);
  const double left_s = encounter.begin_s + available_s - *side.conduct.first_alteration_s;
  return Share(left_s / available_s, 0, 0.5);
}

double LastResort(const Encounter& encounter, const EncounterSide& side,
                  const EncounterOptions& options) {
  if (!side.conduct.in_extremis_s) return 1;
  if (!side.conduct.acted_in_extremis) {
    return encounter.closest_m < options.acceptable_m ? 0.5 : 1;
  }
  const bool is_on_port_side = Wrap180(side.entry.beta_deg) < 0;
  return side.role == EncounterRole::kStandOn && is_on_port_side &&
                 side.conduct.turned_to_port_in_extremis
             ? 0.5
             : 1;
}

ScoreParts PartsOf(const Encounter& encounter, const EncounterSide& side,
                   const EncounterOptions& options) {
  const Conduct& conduct = side.conduct;
  ScoreParts parts;
  parts.range = RangeShare(encounter, options);
  if (side.role != EncounterRole::kStandOn && side.role != EncounterRole::kOvertaken) {
    parts.pose = 1 - std::max(0.0, Cos(DegToRad(side.alpha_deg)));
  }
  parts.apparent = std::max(Share(std::abs(conduct.largest_course_change_deg), 0, kApparent_deg),
                            Share(std::abs(conduct.largest_speed_change_share), 0, kApparentShare));
  parts.early = EarlyShare(encounter, side);
  parts.starboard = conduct.altered_to > 0 ? 1 : 0;
  parts.port_to_port = Wrap180(side.beta_deg) < 0 ? 1 : 0;
  if (side.crossed_ahead_m) {
    parts.behind = Share(*side.crossed_ahead_m, options.preferred_m, 3 * options.preferred_m);
  }
  parts.held_course = Share(conduct.held_course_change_deg, kHeldNothing_deg, kHeldFull_deg);
  parts.held_speed = Share(conduct.held_speed_change_share, kHeldNothingShare, kHeldFullShare);
  parts.last_resort = LastResort(encounter, side, options);
  return parts;
}

}  // namespace

EncounterScore ScoreOf(const Encounter& encounter, size_t side_number,
                       const EncounterOptions& options) {
  const EncounterSide& side = encounter.sides[side_number];
  EncounterScore score;
  score.parts = PartsOf(encounter, side, options);
  const ScoreParts& parts = score.parts;
  score.safety = 100 * parts.range * (0.75 + 0.25 * parts.pose);
  const double rule_8 = 100 * (parts.apparent + parts.early) / 2;
  const double rule_16 = 100 * (parts.apparent + parts.early + parts.range) / 3;
  const double rule_17 = 100 * std::min(parts.held_course, parts.held_speed) * parts.last_resort;
  switch (side.role) {
    case EncounterRole::kNone:
      score.overall = score.safety;
      break;
    case EncounterRole::kOvertaking:
      score.rule_8 = rule_8;
      score.rule_13 = 100 * parts.range * parts.behind;
      score.rule_16 = rule_16;
      score.overall = 0.4 * score.safety + 0.2 * rule_8 + 0.2 * *score.rule_13 + 0.2 * rule_16;
      break;
    case EncounterRole::kHeadOn:
      score.rule_8 = rule_8;
      score.rule_14 = 100 * (parts.starboard + parts.port_to_port) / 2;
      score.overall = 0.4 * score.safety + 0.2 * rule_8 + 0.4 * *score.rule_14;
      break;
    case EncounterRole::kGiveWay:
      score.rule_8 = rule_8;
      score.rule_15 = 100 * parts.behind;
      score.rule_16 = rule_16;
      score.overall = 0.4 * score.safety + 0.2 * rule_8 + 0.2 * *score.rule_15 + 0.2 * rule_16;
      break;
    case EncounterRole::kOvertaken:
    case EncounterRole::kStandOn:
      score.rule_17 = rule_17;
      score.overall = 0.4 * score.safety + 0.6 * rule_17;
      break;
  }
  if (encounter.has_touched) score.overall = 0;
  return score;
}

std::string_view PassedHow(const Encounter& encounter, size_t side_number) {
  const EncounterSide& side = encounter.sides[side_number];
  if (!encounter.is_over && encounter.closest_s >= encounter.end_s) return "not yet";
  if (side.role == EncounterRole::kHeadOn) {
    return Wrap180(side.beta_deg) < 0 ? "port to port" : "starboard to starboard";
  }
  // An overtaken vessel leaves the other's course line by the other's turn, not by its own.
  const bool is_overtaken = side.role == EncounterRole::kOvertaken;
  if (side.crossed_ahead_m && !is_overtaken) return "ahead";
  if (side.crossed_astern && !is_overtaken && side.role != EncounterRole::kOvertaking) {
    return "astern";
  }
  return Wrap180(side.alpha_deg) < 0 ? "on its port side" : "on its starboard side";
}

}  // namespace shoal

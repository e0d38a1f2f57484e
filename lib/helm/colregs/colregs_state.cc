#include "lib/helm/colregs/colregs_state.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/colregs/passing.h"

namespace shoal {

namespace {

constexpr double kPastBow_deg = 22.5;         // Own ship this near the contact's bow: past (13 d).
constexpr double kToStarboard_deg = 5;        // One alone, beyond the sector of head-on.
constexpr double kBothToStarboard_deg = 7.5;  // Both together, beyond twice the sector.
constexpr double kSideSwitch_deg = 5;         // Overtaking: beyond the bow before the side changes.
constexpr double kClearAgain = 1.5;           // Times min_cpa: what ends in extremis.
constexpr double kHoldAtMost_deg = 20;        // Off own course: what a vessel that stands on holds.
constexpr double kNearlyAhead_deg = 315;      // Beta from here on: a contact that crosses shortly.

/// Everything that entries and ends ask about one moment.
struct Moment {
  const VesselMotion& own;
  const VesselMotion& contact;
  const ColregsLimits& limits;
  double time_s;
  RelativeGeometry geometry;
  Passing own_passing;
  Passing contact_passing;

  bool closing() const { return geometry.range_rate_mps < 0; }
  bool opens_clear() const { return !closing() && geometry.range_m > limits.min_cpa_m; }
  bool inside() const { return geometry.range_m < limits.outer_m; }
};

Moment MomentOf(const VesselMotion& own, const VesselMotion& contact, const ColregsLimits& limits,
                double time_s) {
  return {.own = own,
          .contact = contact,
          .limits = limits,
          .time_s = time_s,
          .geometry = GeometryOf(own, contact),
          .own_passing = PassingOf(own, contact),
          .contact_passing = PassingOf(contact, own)};
}

bool IsHolder(ColregsMode mode) {
  return mode == ColregsMode::kStandOn || mode == ColregsMode::kOvertaken;
}

bool IsAbaft(double relative_deg, const ClassifyOptions& sectors) {
  return std::abs(Wrap180(relative_deg)) >= sectors.sidelight_deg;
}

bool Enters(ColregsMode mode, const Moment& at) {
  const ClassifyOptions& sectors = at.limits.sectors;
  const double beta_deg = at.geometry.beta_deg;
  const double alpha_deg = at.geometry.alpha_deg;
  switch (mode) {
    case ColregsMode::kOvertaking:
      return at.inside() && at.closing() && IsAbaft(alpha_deg, sectors) && at.own_passing.passes;
    case ColregsMode::kHeadOn:
      return at.geometry.range_m < 2 * at.limits.outer_m &&
             std::abs(Wrap180(beta_deg)) <= sectors.head_on_deg &&
             std::abs(Wrap180(alpha_deg)) <= sectors.head_on_deg && !at.opens_clear();
    case ColregsMode::kOvertaken:
      return at.inside() && IsAbaft(beta_deg, sectors) && at.contact_passing.passes &&
             at.geometry.cpa_m <= at.limits.max_cpa_m;
    case ColregsMode::kGiveWay:
      return at.inside() && alpha_deg >= 360 - sectors.sidelight_deg &&
             beta_deg <= sectors.sidelight_deg && !at.opens_clear();
    case ColregsMode::kStandOn:
      return at.inside() && beta_deg >= 360 - sectors.sidelight_deg &&
             alpha_deg <= sectors.sidelight_deg && at.contact_passing.crosses && at.closing();
    case ColregsMode::kNone:
    case ColregsMode::kCpa:
      break;
  }
  return false;
}

bool HasOpenedFor(const ColregsState& state, double dwell_s, double time_s) {
  return state.opening_since_s && time_s - *state.opening_since_s >= dwell_s;
}

bool IsOutOfRange(const ColregsState& state, const Moment& at) {
  const double limit_m = at.limits.outer_m * (state.mode == ColregsMode::kHeadOn ? 2 : 1);
  return at.geometry.range_m >= limit_m;
}

bool Ends(const ColregsState& state, const Moment& at) {
  if (IsOutOfRange(state, at)) return true;
  if (at.time_s - state.entered_s < at.limits.min_dwell_s) return false;
  const double beta_deg = Wrap180(at.geometry.beta_deg);
  const double alpha_deg = Wrap180(at.geometry.alpha_deg);
  const bool opened = HasOpenedFor(state, at.limits.min_dwell_s, at.time_s);
  if (state.in_extremis()) return opened;
  switch (state.mode) {
    case ColregsMode::kOvertaking:
      return opened || std::abs(alpha_deg) <= kPastBow_deg;
    case ColregsMode::kOvertaken:
      return opened || std::abs(beta_deg) <= kPastBow_deg;
    case ColregsMode::kHeadOn: {
      const double sector_deg = at.limits.sectors.head_on_deg;
      const bool to_starboard = alpha_deg > 0 && beta_deg > 0;
      return at.opens_clear() || std::abs(alpha_deg) > 90 ||
             (to_starboard && (std::max(alpha_deg, beta_deg) > sector_deg + kToStarboard_deg ||
                               alpha_deg + beta_deg > 2 * sector_deg + kBothToStarboard_deg));
    }
    case ColregsMode::kGiveWay:
      return at.opens_clear() || alpha_deg > 0;
    case ColregsMode::kStandOn:
      return at.opens_clear();
    case ColregsMode::kNone:
    case ColregsMode::kCpa:
      break;
  }
  return false;
}

/// What the vessel that gives way will do: fixed at entry.
ColregsSubMode GiveWaySubMode(const Moment& at) {
  const ColregsLimits& limits = at.limits;
  const double least_m =
      limits.give_way_bow_m < 0
          ? (2 * limits.max_cpa_m + limits.min_cpa_m) / 3
          : std::clamp(limits.give_way_bow_m, limits.min_cpa_m, 2 * limits.max_cpa_m);
  const bool clear_ahead = CrossingDistance(at.own, at.contact) > least_m;
  // Own turning circle to starboard, up to the contact's bow-stern line.
  const Eigen::Vector2d port_of_contact = UnitVector(DegToRad(at.contact.heading_deg) - kPi / 2);
  const Eigen::Vector2d centre_m =
      at.own.position_m + limits.turn_radius_m * UnitVector(DegToRad(at.own.heading_deg) + kPi / 2);
  const double gap_m =
      (centre_m - at.contact.position_m).dot(port_of_contact) - limits.turn_radius_m;
  const bool no_room_astern = gap_m < least_m;
  const bool goes_along =
      !at.own_passing.crosses && Cos(DegToRad(at.own.heading_deg - at.contact.heading_deg)) > 0;
  const bool ahead = at.own_passing.crosses_bow && (clear_ahead || no_room_astern);
  return ahead || goes_along ? ColregsSubMode::kBow : ColregsSubMode::kStern;
}

ColregsSubMode OvertakingSubMode(ColregsSubMode before, double beta_deg, bool keeps_side) {
  if (keeps_side && before != ColregsSubMode::kNone) return before;
  switch (before) {
    case ColregsSubMode::kPort:
      return beta_deg > 180 && beta_deg < 360 - kSideSwitch_deg ? ColregsSubMode::kStarboard
                                                                : ColregsSubMode::kPort;
    case ColregsSubMode::kStarboard:
      return beta_deg > kSideSwitch_deg && beta_deg < 180 ? ColregsSubMode::kPort
                                                          : ColregsSubMode::kStarboard;
    default:
      return beta_deg > 180 ? ColregsSubMode::kStarboard : ColregsSubMode::kPort;
  }
}

/// What the contact, which has to give way, will do if it goes on as it does.
ColregsSubMode StandOnSubMode(const Moment& at) {
  if (!at.contact_passing.crosses) return ColregsSubMode::kNeither;
  const ColregsLimits& limits = at.limits;
  const double ahead_m = CrossingDistance(at.contact, at.own);
  const double unsure_m = at.geometry.beta_deg >= kNearlyAhead_deg
                              ? limits.min_cpa_m
                              : (limits.min_cpa_m + limits.max_cpa_m) / 2;
  if (ahead_m >= limits.max_cpa_m) return ColregsSubMode::kBow;
  if (ahead_m >= unsure_m) return ColregsSubMode::kUnsureBow;
  return ahead_m > 0 ? ColregsSubMode::kUnsure : ColregsSubMode::kStern;
}

/// Standing on again would keep the two clear.
bool MayHoldAgain(const ColregsState& state, const Moment& at) {
  VesselMotion held = at.own;
  held.heading_deg = state.entry_heading_deg;
  held.speed_mps = state.entry_speed_mps;
  return GeometryOf(held, at.contact).cpa_m > kClearAgain * at.limits.min_cpa_m;
}

bool IsInExtremis(const Moment& at) {
  return at.geometry.range_m <= at.limits.max_cpa_m && at.geometry.cpa_m <= at.limits.min_cpa_m;
}

ColregsSubMode SubModeOf(const ColregsState& state, bool is_new, const Moment& at) {
  switch (state.mode) {
    case ColregsMode::kOvertaking:
      return OvertakingSubMode(state.sub_mode, at.geometry.beta_deg, at.limits.steady);
    case ColregsMode::kGiveWay:
      return is_new ? GiveWaySubMode(at) : state.sub_mode;
    case ColregsMode::kOvertaken:
      if (at.limits.steady ? state.danger_s.has_value() : state.in_extremis() || IsInExtremis(at)) {
        return ColregsSubMode::kInExtremis;
      }
      return at.geometry.alpha_deg < 180 ? ColregsSubMode::kPort : ColregsSubMode::kStarboard;
    case ColregsMode::kStandOn:
      if (IsInExtremis(at) || state.danger_s) return ColregsSubMode::kInExtremis;
      if (state.in_extremis() && (!at.limits.steady || !MayHoldAgain(state, at))) {
        return ColregsSubMode::kInExtremis;
      }
      if (!is_new && at.time_s - state.sub_mode_since_s < at.limits.min_dwell_s) {
        return state.sub_mode;
      }
      return StandOnSubMode(at);
    case ColregsMode::kHeadOn:
    case ColregsMode::kNone:
    case ColregsMode::kCpa:
      break;
  }
  return ColregsSubMode::kNone;
}

/// When danger was seen last; nothing once it is over.
std::optional<double> DangerSince(const ColregsState& state, const Moment& at) {
  const ColregsLimits& limits = at.limits;
  if (!limits.steady || state.mode == ColregsMode::kNone) return std::nullopt;
  if (IsDanger(at.geometry, limits.min_cpa_m, limits.max_cpa_m)) return at.time_s;
  if (!state.danger_s || at.time_s - *state.danger_s < limits.min_dwell_s) return state.danger_s;
  const bool has_to_stay_clear = IsHolder(state.mode) && at.closing() && !MayHoldAgain(state, at);
  return has_to_stay_clear ? state.danger_s : std::nullopt;
}

bool IsRole(ColregsMode mode) { return mode != ColregsMode::kNone && mode != ColregsMode::kCpa; }

ColregsMode EntryAt(const ColregsState& state, const Moment& at) {
  const bool both_make_way = at.own.speed_mps >= kNoWay_mps && at.contact.speed_mps >= kNoWay_mps;
  for (const ColregsMode mode :
       {ColregsMode::kOvertaking, ColregsMode::kHeadOn, ColregsMode::kOvertaken,
        ColregsMode::kGiveWay, ColregsMode::kStandOn}) {
    if (!both_make_way || (at.limits.head_on_only && mode != ColregsMode::kHeadOn)) continue;
    if (mode == state.ended && at.time_s - state.ended_s < at.limits.min_dwell_s) continue;
    if (Enters(mode, at)) return mode;
  }
  return at.geometry.range_m <= at.limits.outer_m ? ColregsMode::kCpa : ColregsMode::kNone;
}

}  // namespace

ColregsState NextColregsState(const ColregsState& before, const VesselMotion& own,
                              const VesselMotion& contact, const ColregsLimits& limits,
                              double time_s) {
  const Moment at = MomentOf(own, contact, limits, time_s);
  ColregsState state = before;
  if (at.closing()) {
    state.opening_since_s.reset();
  } else if (!state.opening_since_s) {
    state.opening_since_s = time_s;
  }
  if (IsRole(state.mode) && Ends(state, at)) {
    state.ended = state.mode;
    state.ended_s = time_s;
    state.mode = ColregsMode::kNone;
  }
  if (!IsRole(state.mode)) state.mode = EntryAt(state, at);
  const bool is_new = state.mode != before.mode;
  if (is_new) {
    state.sub_mode = ColregsSubMode::kNone;
    state.entered_s = time_s;
    state.entry_heading_deg = own.heading_deg;
    state.entry_speed_mps = own.speed_mps;
  } else if (limits.steady && before.stands_on()) {
    const double off_deg = Wrap180(state.entry_heading_deg - own.heading_deg);
    if (std::abs(off_deg) > kHoldAtMost_deg) {
      state.entry_heading_deg = Wrap360(own.heading_deg + std::copysign(kHoldAtMost_deg, off_deg));
    }
  }
  state.danger_s = DangerSince(state, at);
  const ColregsSubMode sub_mode = SubModeOf(state, is_new, at);
  if (is_new || sub_mode != state.sub_mode) state.sub_mode_since_s = time_s;
  state.sub_mode = sub_mode;
  return state;
}

EncounterRole RoleOf(ColregsMode mode) {
  switch (mode) {
    case ColregsMode::kNone:
    case ColregsMode::kCpa:
      return EncounterRole::kNone;
    case ColregsMode::kOvertaking:
      return EncounterRole::kOvertaking;
    case ColregsMode::kHeadOn:
      return EncounterRole::kHeadOn;
    case ColregsMode::kOvertaken:
      return EncounterRole::kOvertaken;
    case ColregsMode::kGiveWay:
      return EncounterRole::kGiveWay;
    case ColregsMode::kStandOn:
      return EncounterRole::kStandOn;
  }
  return EncounterRole::kNone;
}

std::string_view Name(ColregsMode mode) {
  return mode == ColregsMode::kCpa ? "cpa" : Name(RoleOf(mode));
}

std::string_view Name(ColregsSubMode sub_mode) {
  switch (sub_mode) {
    case ColregsSubMode::kNone:
      return "";
    case ColregsSubMode::kPort:
      return "port";
    case ColregsSubMode::kStarboard:
      return "starboard";
    case ColregsSubMode::kStern:
      return "stern";
    case ColregsSubMode::kBow:
      return "bow";
    case ColregsSubMode::kUnsureBow:
      return "unsure_bow";
    case ColregsSubMode::kUnsure:
      return "unsure";
    case ColregsSubMode::kNeither:
      return "neither";
    case ColregsSubMode::kInExtremis:
      return "in_extremis";
  }
  return "";
}

std::string TextOf(const ColregsState& state) {
  std::string text(Name(state.mode));
  const std::string_view sub_mode = Name(state.sub_mode);
  if (!sub_mode.empty()) text.append(":").append(sub_mode);
  return text;
}

std::string_view RuleOf(const ColregsState& state) {
  if (state.in_extremis()) return "17(b)";
  return state.mode == ColregsMode::kCpa ? "8" : RuleOf(RoleOf(state.mode));
}

}  // namespace shoal

#include "lib/helm/colregs/preferences.h"

#include <algorithm>
#include <memory>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/decision/shapes.h"

namespace shoal {

namespace {

constexpr double kUtilityAtLeast = 25;
constexpr double kOvertakingUtilityAtLeast = 15;
constexpr double kLeastCpa_m = 1e-3;  // Vessels at one point.
constexpr double kFullBonus = 100;
constexpr double kHoldOn_deg = 5;  // As good as no turn.
constexpr double kNoTurn_deg = 1e-9;

// What holding course and speed means: 25 at 20 degrees off; 50 at 0.1 m/s, and 0.4 m/s too fast.
constexpr double kHoldWidth_deg = 20;
constexpr double kHoldCourseShoulder = 25;
constexpr double kHoldLow_mps = 0.1;
constexpr double kHoldFaster_mps = 0.4;
constexpr double kHoldSpeedShoulder = 50;

}  // namespace

CpaUtility CpaUtilityAt(double range_m, double min_cpa_m, double max_cpa_m, double at_lo) {
  const double lo_m = std::max(range_m <= min_cpa_m ? range_m / 2 : min_cpa_m, kLeastCpa_m);
  return {.lo_m = lo_m, .hi_m = std::max(max_cpa_m, lo_m), .at_lo = at_lo};
}

CpaUtility CpaUtilityInDanger(double min_cpa_m) {
  return {.lo_m = kLeastCpa_m, .hi_m = std::max(2 * min_cpa_m, kLeastCpa_m), .at_lo = 0};
}

ColregsFunction::ColregsFunction(const ColregsState& state, const VesselMotion& own,
                                 const VesselMotion& contact, const ColregsPreferences& preferences,
                                 const Domain& domain)
    : cpa_(contact.position_m - own.position_m, VelocityOf(contact), preferences.horizon_s, domain),
      contact_mps_(std::max(0.0, contact.speed_mps)),
      own_heading_deg_(own.heading_deg),
      port_turns_ok_(preferences.port_turns_ok) {
  SHOAL_CHECK(!state.stands_on(), "a vessel that stands on keeps course and speed");
  const RelativeGeometry geometry = GeometryOf(own, contact);
  double at_lo = kUtilityAtLeast;
  if (state.mode == ColregsMode::kHeadOn) {
    rule_ = Rule::kHeadOn;
  } else if (state.mode == ColregsMode::kGiveWay) {
    rule_ = state.sub_mode == ColregsSubMode::kBow ? Rule::kGiveWayBow : Rule::kGiveWayStern;
  } else if (state.mode == ColregsMode::kOvertaking) {
    rule_ = state.sub_mode == ColregsSubMode::kStarboard ? Rule::kPassStarboard : Rule::kPassPort;
    at_lo = kOvertakingUtilityAtLeast;
  }
  if (preferences.steady && state.mode == ColregsMode::kStandOn && geometry.beta_deg > 180) {
    rule_ = Rule::kNotToPort;
  } else if (preferences.steady && state.mode == ColregsMode::kOvertaken) {
    rule_ = Rule::kNotFaster;
  }
  first_mps_ = domain.speed_mps.first;
  step_mps_ = domain.speed_mps.step;
  hold_mps_ = state.entry_speed_mps + domain.speed_mps.step / 2;
  hold_deg_ = state.entry_heading_deg;
  utility_ = CpaUtilityAt(geometry.range_m, preferences.min_cpa_m, preferences.max_cpa_m, at_lo);
  if (preferences.steady && state.danger_s) {
    utility_ = CpaUtilityInDanger(preferences.min_cpa_m);
  }
  aspect_ = AspectOf(geometry.alpha_deg);
  bow_ = SpeedAlong(contact.heading_deg, domain);
  to_line_ = SpeedAlong(contact.heading_deg + (aspect_.port ? 90 : -90), domain);
  const double right_deg = own.heading_deg + geometry.beta_deg + 90;
  right_ = SpeedAlong(right_deg, domain);
  contact_drift_mps_ = contact_mps_ * Cos(DegToRad(contact.heading_deg - right_deg));
  head_on_drift_mps_ = -2 * contact_mps_;
}

ColregsFunction::Truth ColregsFunction::Not(Truth a) {
  return a == Truth::kSometimes ? a : a == Truth::kNever ? Truth::kAlways : Truth::kNever;
}

ColregsFunction::Truth ColregsFunction::And(Truth a, Truth b) { return std::min(a, b); }

ColregsFunction::Truth ColregsFunction::Or(Truth a, Truth b) { return std::max(a, b); }

ColregsFunction::Truth ColregsFunction::Above(const Range& value, double threshold) {
  if (value.min > threshold) return Truth::kAlways;
  return value.max > threshold ? Truth::kSometimes : Truth::kNever;
}

ColregsFunction::Truth ColregsFunction::AtLeast(const Range& value, double threshold) {
  if (value.min >= threshold) return Truth::kAlways;
  return value.max >= threshold ? Truth::kSometimes : Truth::kNever;
}

double ColregsFunction::HeadOnBonus(double drift_mps) const {
  if (drift_mps >= -kNoDrift) return 0;
  if (drift_mps <= head_on_drift_mps_) return kFullBonus;
  return kFullBonus * drift_mps / head_on_drift_mps_;
}

bool ColregsFunction::IsForbidden(int course, int speed) const {
  if (rule_ == Rule::kNothing) return false;
  const double drift_mps = contact_drift_mps_ - right_.At(course, speed);
  const double turn_deg = Wrap180(course - own_heading_deg_);
  const bool crosses = to_line_.At(course, speed) > kNoDrift;
  const auto passes = [&] {
    const double gain_mps = bow_.At(course, speed) - contact_mps_;
    return (aspect_.fore ? -gain_mps : gain_mps) > kNoDrift;
  };
  switch (rule_) {
    case Rule::kHeadOn:
      return (passes() && !PassesPort(aspect_, drift_mps)) ||
             (aspect_.port && crosses && IsBowSide(aspect_, drift_mps));
    case Rule::kGiveWayStern: {
      const bool astern = crosses && IsSternSide(aspect_, drift_mps);
      if (crosses && IsBowSide(aspect_, drift_mps)) return true;
      return port_turns_ok_ ? turn_deg < -kNoTurn_deg && !astern
                            : turn_deg < -kNoTurn_deg || !astern;
    }
    case Rule::kGiveWayBow:
      return turn_deg > kNoTurn_deg && !(crosses && IsBowSide(aspect_, drift_mps));
    case Rule::kPassStarboard:
      return passes() && PassesPort(aspect_, drift_mps);
    case Rule::kPassPort:
      return passes() && !PassesPort(aspect_, drift_mps);
    case Rule::kNotToPort:
      return Wrap180(course - hold_deg_) < -kHoldOn_deg;
    case Rule::kNotFaster:
      return SpeedAt(speed) > hold_mps_;
    case Rule::kNothing:
      break;
  }
  return false;
}

double ColregsFunction::At(int course, int speed) const {
  if (IsForbidden(course, speed)) return 0;
  const double utility = UtilityOfCpa(cpa_.At(course, speed), utility_);
  if (rule_ != Rule::kHeadOn) return utility;
  return utility + HeadOnBonus(contact_drift_mps_ - right_.At(course, speed));
}

ColregsFunction::Truth ColregsFunction::Turns(const GridBox& box, bool to_starboard) const {
  const double first_deg = Wrap360(box.first_course - own_heading_deg_);
  const double last_deg = first_deg + box.last_course - box.first_course;
  constexpr double kEdge_deg = 2 * kNoTurn_deg;
  const bool all_starboard = first_deg > kEdge_deg && last_deg < 180 - kEdge_deg;
  const bool all_port = first_deg > 180 + kEdge_deg && last_deg < 360 - kEdge_deg;
  if (to_starboard ? all_starboard : all_port) return Truth::kAlways;
  return (to_starboard ? all_port : all_starboard) ? Truth::kNever : Truth::kSometimes;
}

ColregsFunction::Truth ColregsFunction::IsForbidden(const GridBox& box) const {
  if (rule_ == Rule::kNothing) return Truth::kNever;
  const Range across = right_.Bound(box);
  const Range drift_mps = {.min = contact_drift_mps_ - across.max,
                           .max = contact_drift_mps_ - across.min};
  const auto passes = [&] {
    const Range along = bow_.Bound(box);
    return aspect_.fore
               ? Above({.min = contact_mps_ - along.max, .max = contact_mps_ - along.min}, kNoDrift)
               : Above(along, contact_mps_ + kNoDrift);
  };
  const auto passes_port = [&] {
    return aspect_.fore ? Not(AtLeast(drift_mps, -kNoDrift)) : Above(drift_mps, kNoDrift);
  };
  const auto crosses = [&] { return Above(to_line_.Bound(box), kNoDrift); };
  const auto bow_side = [&] {
    return aspect_.port ? AtLeast(drift_mps, -kNoDrift) : Not(Above(drift_mps, kNoDrift));
  };
  const auto stern_side = [&] {
    return aspect_.port ? Not(Above(drift_mps, kNoDrift)) : AtLeast(drift_mps, -kNoDrift);
  };
  switch (rule_) {
    case Rule::kHeadOn:
      return Or(And(passes(), Not(passes_port())),
                aspect_.port ? And(crosses(), bow_side()) : Truth::kNever);
    case Rule::kGiveWayStern: {
      const Truth crossing = crosses();
      const Truth astern = And(crossing, stern_side());
      const Truth to_port = Turns(box, false);
      return Or(And(crossing, bow_side()),
                port_turns_ok_ ? And(to_port, Not(astern)) : Or(to_port, Not(astern)));
    }
    case Rule::kGiveWayBow:
      return And(Turns(box, true), Not(And(crosses(), bow_side())));
    case Rule::kPassStarboard:
      return And(passes(), passes_port());
    case Rule::kPassPort:
      return And(passes(), Not(passes_port()));
    case Rule::kNotToPort:
      return Truth::kSometimes;
    case Rule::kNotFaster:
      if (SpeedAt(box.first_speed) > hold_mps_) return Truth::kAlways;
      return SpeedAt(box.last_speed) > hold_mps_ ? Truth::kSometimes : Truth::kNever;
    case Rule::kNothing:
      break;
  }
  return Truth::kNever;
}

CourseSpeedFunction::Range ColregsFunction::Bound(const GridBox& box) const {
  const Truth forbidden = IsForbidden(box);
  if (forbidden == Truth::kAlways) return {};
  Range range = UtilityOfCpa(cpa_.Bound(box), utility_);
  if (rule_ == Rule::kHeadOn) {
    const Range across = right_.Bound(box);
    range.min += HeadOnBonus(contact_drift_mps_ - across.min);
    range.max += HeadOnBonus(contact_drift_mps_ - across.max);
  }
  if (forbidden == Truth::kSometimes) range.min = 0;
  return range;
}

Objective ColregsObjective(const ColregsState& state, const VesselMotion& own,
                           const VesselMotion& contact, const ColregsPreferences& preferences,
                           const Domain& domain) {
  SHOAL_CHECK(state.mode != ColregsMode::kNone, "without an encounter there is no preference");
  if (state.stands_on()) {
    const double hold_mps =
        std::clamp(state.entry_speed_mps, domain.speed_mps.first, domain.speed_mps.Last());
    return Couple(HeadingPolyline(state.entry_heading_deg, kHoldWidth_deg, kHoldWidth_deg,
                                  kHoldCourseShoulder, kHoldCourseShoulder),
                  SpeedPolyline(domain.speed_mps, hold_mps, std::min(kHoldLow_mps, hold_mps),
                                hold_mps + kHoldFaster_mps, kHoldSpeedShoulder, kHoldSpeedShoulder),
                  50, 50);
  }
  return NormaliseTo100(
      {.coupled = std::make_shared<ColregsFunction>(state, own, contact, preferences, domain)},
      domain);
}

}  // namespace shoal

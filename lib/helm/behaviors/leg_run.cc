#include "lib/helm/behaviors/leg_run.h"

#include <array>
#include <cmath>

#include "lib/base/check/enum_table.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"
#include "lib/helm/behaviors/track_line.h"

namespace shoal {

std::string_view LegRunBehavior::Name() const {
  constexpr EnumTable<Part, std::string_view> kNames = {"init", "leg1",  "turn1",
                                                        "leg2", "turn2", "done"};
  return kNames[part_];
}

// The half of the circle beyond the end of the leg, a point every 30 degrees.
std::vector<Eigen::Vector2d> LegRunBehavior::TurnPoints(const Leg& leg, bool first) const {
  constexpr int kSteps = 6;
  const double radius_m = first ? options_.turn1_rad : options_.turn2_rad;
  const double bias = (first ? options_.turn1_bias : options_.turn2_bias) / 100;
  const double extension_m = first ? options_.turn1_ext : options_.turn2_ext;
  const std::string& direction = first ? options_.turn1_dir : options_.turn2_dir;
  const bool is_to_starboard = direction == "auto" ? bias >= 0 : direction == "starboard";
  const double side = is_to_starboard ? 1 : -1;
  const double course_rad = Course(leg);
  const Eigen::Vector2d centre_m = leg.to_m + extension_m * UnitVector(course_rad) +
                                   bias * radius_m * UnitVector(course_rad + kPi / 2);
  std::vector<Eigen::Vector2d> points_m;
  for (int step = 0; step <= kSteps; ++step) {
    const double angle_rad = side * (step * kPi / kSteps - kPi / 2);
    points_m.emplace_back(centre_m + radius_m * UnitVector(course_rad + angle_rad));
  }
  return points_m;
}

void LegRunBehavior::HeadFor(const Leg& leg, const Eigen::Vector2d& position_m) {
  leg_ = leg;
  const bool by_radius = !options_.capture_line_only;
  capture_.emplace(CaptureRule{.capture_radius_m = by_radius ? options_.capture_radius : 0,
                               .slip_radius_m = by_radius ? options_.slip_radius : 0,
                               .capture_line = options_.capture_line || !by_radius},
                   leg, position_m);
}

void LegRunBehavior::Enter(Part part, const Eigen::Vector2d& position_m, BehaviorAnswer& answer) {
  part_ = part;
  passed_middle_ = false;
  const Leg there = {.from_m = *options_.p1, .to_m = *options_.p2};
  const Leg back = {.from_m = *options_.p2, .to_m = *options_.p1};
  if (part == Part::kInit) {
    HeadFor({.from_m = position_m, .to_m = *options_.p1}, position_m);
  } else if (IsTurn()) {
    answer.flags.emplace_back("start_turn_flag");
    turn_m_ = TurnPoints(part == Part::kTurn1 ? there : back, part == Part::kTurn1);
    turn_index_ = 0;
    HeadFor({.from_m = leg_.to_m, .to_m = turn_m_.front()}, position_m);
  } else if (part != Part::kDone) {
    answer.flags.emplace_back("start_leg_flag");
    HeadFor(part == Part::kLeg1 ? there : back, position_m);
  }
}

void LegRunBehavior::Proceed(const Eigen::Vector2d& position_m, BehaviorAnswer& answer) {
  if (IsTurn()) {
    if (++turn_index_ < turn_m_.size()) {
      HeadFor({.from_m = leg_.to_m, .to_m = turn_m_[turn_index_]}, position_m);
      return;
    }
    answer.flags.emplace_back("end_turn_flag");
    Enter(part_ == Part::kTurn1 ? Part::kLeg2 : Part::kLeg1, position_m, answer);
    return;
  }
  if (part_ == Part::kInit) {
    Enter(Part::kLeg1, position_m, answer);
    return;
  }
  answer.flags.emplace_back("leg_end_flag");
  ++num_legs_;
  const bool ends = options_.repeat >= 0 && num_legs_ >= 2 * (options_.repeat + 1);
  Enter(ends                   ? Part::kDone
        : part_ == Part::kLeg1 ? Part::kTurn1
                               : Part::kTurn2,
        position_m, answer);
}

// A quarter of a leg, half of a turn.
void LegRunBehavior::PassMiddle(const Eigen::Vector2d& position_m, BehaviorAnswer& answer) {
  if (passed_middle_ || part_ == Part::kInit) return;
  passed_middle_ = IsTurn() ? turn_index_ > turn_m_.size() / 2
                            : Project(leg_, position_m).along_m >= 0.25 * Length(leg_);
  if (passed_middle_) answer.flags.emplace_back(IsTurn() ? "mid_turn_flag" : "mid_flag");
}

BehaviorAnswer LegRunBehavior::Idle(const BehaviorInputs&) {
  if (part_ == Part::kDone) *this = LegRunBehavior(options_);
  capture_.reset();
  diversion_.Forget();
  return {};
}

void LegRunBehavior::Reconfigure(const LegRunOptions& options) {
  const bool is_same_leg = options.p1 == options_.p1 && options.p2 == options_.p2;
  options_ = options;
  if (!is_same_leg) *this = LegRunBehavior(options);
}

BehaviorAnswer LegRunBehavior::Run(const BehaviorInputs& inputs) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  BehaviorAnswer answer;
  if (!options_.p1 || !options_.p2 || part_ == Part::kDone) return answer;
  if (!capture_ && part_ == Part::kInit) {
    Enter(Part::kInit, position_m, answer);
  } else if (!capture_) {
    HeadFor(leg_, position_m);
  }
  if (capture_->Reached(position_m)) Proceed(position_m, answer);
  if (part_ == Part::kDone) {
    answer.completes = true;
    return answer;
  }
  PassMiddle(position_m, answer);

  const std::vector<double>& speeds = options_.leg_spds;
  const double speed_mps =
      InDomain(inputs, speeds.empty() ? options_.speed
                                      : speeds[static_cast<size_t>(num_legs_) % speeds.size()]);
  const bool is_leg = part_ == Part::kLeg1 || part_ == Part::kLeg2;
  diversion_.Look(inputs.avoids, leg_, position_m, options_.lead, options_.return_angle);
  const TrackLead lead = {.lead_m = options_.lead,
                          .lead_damper_m = options_.lead_damper,
                          .return_deg = diversion_.is_on() ? options_.return_angle : 90};
  const Eigen::Vector2d steers_for_m = is_leg ? SteeringPoint(leg_, position_m, lead) : leg_.to_m;
  BehaviorAnswer preference =
      PreferBoth(inputs, PeakOverCourse(BearingDeg(position_m, steers_for_m), 0, 180),
                 TransitSpeed(inputs, speed_mps, 70), options_.patience);
  preference.flags = answer.flags;
  preference.state = Name();
  Post(preference, "LEGRUN_STATE", Name());
  Post(preference, "LEGRUN_LEGS", num_legs_);
  preference.view = {
      .points_m = {*options_.p1, *options_.p2}, .closed = false, .steers_for_m = steers_for_m};
  preference.view.points_m.insert(preference.view.points_m.end(), turn_m_.begin(), turn_m_.end());
  return preference;
}

}  // namespace shoal

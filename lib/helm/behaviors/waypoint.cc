#include "lib/helm/behaviors/waypoint.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/preference.h"
#include "lib/helm/behaviors/track_line.h"

namespace shoal {

namespace {

using Points = std::vector<Eigen::Vector2d>;

// Puts the point that is nearest to the one before at each place.
void SortAsGreedyTour(Points& points_m, Eigen::Vector2d from_m) {
  for (auto next = points_m.begin(); next != points_m.end(); ++next) {
    const auto nearest = std::min_element(next, points_m.end(), [&](const auto& a, const auto& b) {
      return (a - from_m).squaredNorm() < (b - from_m).squaredNorm();
    });
    std::rotate(next, nearest, std::next(nearest));
    from_m = *next;
  }
}

// ipf_type = "roc": how fast the vessel comes nearer on a course delta off the bearing at speed u,
// against the speed v that is asked for; 80 parts of that, 20 of |delta| u.
class TowardPointFunction final : public CourseSpeedFunction {
 public:
  TowardPointFunction(const Domain& domain, double bearing_deg, double speed_mps)
      : speeds_(domain.speed_mps), bearing_deg_(bearing_deg), speed_mps_(speed_mps) {}

  double At(int course, int speed) const override {
    const double delta_deg = Wrap180(course - bearing_deg_);
    return Value(Cos(DegToRad(delta_deg)), std::abs(delta_deg), speeds_.At(speed));
  }

  // Intervals of the angle, of the closing speed, and of |delta| u, each exact, put together: never
  // narrower than the values of the box.
  Range Bound(const GridBox& box) const override {
    double least_deg = 180;
    double most_deg = 0;
    for (const int course : {box.first_course, box.last_course}) {
      const double delta_deg = std::abs(Wrap180(course - bearing_deg_));
      least_deg = std::min(least_deg, delta_deg);
      most_deg = std::max(most_deg, delta_deg);
    }
    if (Holds(box, bearing_deg_)) least_deg = 0;
    if (Holds(box, bearing_deg_ + 180)) most_deg = 180;
    const double slow_mps = speeds_.At(box.first_speed);
    const double fast_mps = speeds_.At(box.last_speed);
    const double ahead = Cos(DegToRad(least_deg));
    const double astern = Cos(DegToRad(most_deg));
    const double most_closing_mps = std::max(ahead * fast_mps, ahead * slow_mps);
    const double least_closing_mps = std::min(astern * slow_mps, astern * fast_mps);
    const auto [best, worst] = LossRange(least_closing_mps, most_closing_mps);
    const double top_mps = speeds_.Last();
    return {
        .min = 80 * (1 - worst / (2 * top_mps)) + 20 * (1 - most_deg * fast_mps / (180 * top_mps)),
        .max = 80 * (1 - best / (2 * top_mps)) + 20 * (1 - least_deg * slow_mps / (180 * top_mps))};
  }

 private:
  static bool Holds(const GridBox& box, double course_deg) {
    const double wrapped_deg = Wrap360(course_deg);
    return wrapped_deg >= box.first_course && wrapped_deg <= box.last_course;
  }

  // What the closing speed is off, half as bad when it is too fast.
  double Loss(double closing_mps) const {
    return closing_mps <= speed_mps_ ? speed_mps_ - closing_mps : (closing_mps - speed_mps_) / 2;
  }

  std::pair<double, double> LossRange(double least_mps, double most_mps) const {
    const double a = Loss(least_mps);
    const double b = Loss(most_mps);
    const bool hits = least_mps <= speed_mps_ && most_mps >= speed_mps_;
    return {hits ? 0 : std::min(a, b), std::max(a, b)};
  }

  double Value(double cosine, double delta_deg, double u_mps) const {
    const double top_mps = speeds_.Last();
    return 80 * (1 - Loss(u_mps * cosine) / (2 * top_mps)) +
           20 * (1 - delta_deg * u_mps / (180 * top_mps));
  }

  Axis speeds_;
  double bearing_deg_;
  double speed_mps_;
};

}  // namespace

WaypointBehavior::WaypointBehavior(const WaypointOptions& options) : BehaviorWith(options) {
  TakeOver(options);
}

void WaypointBehavior::TakeOver(const WaypointOptions& options) {
  options_ = options;
  lead_condition_.reset();
  if (options.lead_condition.empty()) return;
  Result<Condition> condition = Condition::Parse(options.lead_condition);
  SHOAL_CHECK(condition.ok(), "lead_condition was parsed when the options were read");
  lead_condition_ = *condition;
}

void WaypointBehavior::Reconfigure(const WaypointOptions& options) {
  const bool is_same_list = options.points == options_.points && options.order == options_.order &&
                            options.greedy_tour == options_.greedy_tour &&
                            options.currix == options_.currix;
  TakeOver(options);
  if (!is_same_list) state_ = State::kNew;
}

BehaviorAnswer WaypointBehavior::Idle(const BehaviorInputs&) {
  BehaviorAnswer answer;
  if (state_ == State::kOnTheWay || state_ == State::kDone) {
    Post(answer, options_.dist_to_next_var, -1);
    Post(answer, options_.dist_to_prev_var, -1);
  }
  diversion_.Forget();
  if (state_ == State::kDone || options_.reset_on_idle) {
    state_ = State::kNew;
  } else if (state_ == State::kOnTheWay) {
    state_ = State::kPaused;
  }
  return answer;
}

void WaypointBehavior::ArrangePoints(const Eigen::Vector2d& position_m) {
  points_m_ = options_.points;
  if (options_.greedy_tour) SortAsGreedyTour(points_m_, position_m);
  const bool is_reverse =
      options_.order == "reverse" || (options_.order == "toggle" && rounds_.num_rounds() % 2 == 1);
  if (is_reverse) std::reverse(points_m_.begin(), points_m_.end());
}

void WaypointBehavior::HeadForPoint(const std::optional<Eigen::Vector2d>& from_m,
                                    const Eigen::Vector2d& position_m) {
  has_leg_ = from_m.has_value();
  const Leg leg = {.from_m = from_m.value_or(position_m), .to_m = points_m_[rounds_.index()]};
  const bool by_radius = !options_.capture_line_only;
  const CaptureRule rule = {.capture_radius_m = by_radius ? options_.capture_radius : 0,
                            .slip_radius_m = by_radius ? options_.slip_radius : 0,
                            .capture_line = options_.capture_line || !by_radius};
  capture_.emplace(rule, leg, position_m);
}

void WaypointBehavior::Begin(const BehaviorInputs& inputs, BehaviorAnswer& answer) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  const std::optional<Eigen::Vector2d> start_m =
      options_.lead_to_start ? std::optional(position_m) : std::nullopt;
  if (state_ == State::kNew) {
    const int last = static_cast<int>(options_.points.size()) - 1;
    rounds_ = RouteRounds(options_.points.size(),
                          static_cast<size_t>(std::clamp(options_.currix, 0, last)));
    ArrangePoints(position_m);
    HeadForPoint(start_m, position_m);
    if (options_.wptflag_on_start) answer.flags.emplace_back("wptflag");
  } else if (state_ == State::kPaused) {
    const bool is_between = has_leg_ && rounds_.num_reached() > 0;
    HeadForPoint(is_between ? capture_->leg().from_m : start_m, position_m);
  }
  state_ = State::kOnTheWay;
}

bool WaypointBehavior::IsLastPoint() const { return rounds_.IsEnd(options_.repeat + 1); }

void WaypointBehavior::Advance(const Eigen::Vector2d& position_m, BehaviorAnswer& answer) {
  answer.flags.emplace_back("wptflag");
  const Eigen::Vector2d reached_m = points_m_[rounds_.index()];
  const bool is_round = rounds_.IsLast();
  const bool goes_on = rounds_.Pass(options_.repeat + 1);
  if (is_round) {
    answer.flags.emplace_back("cycleflag");
    Post(answer, options_.cycle_var, rounds_.num_rounds(), options_.post_suffix);
    ArrangePoints(position_m);
  }
  if (goes_on) {
    HeadForPoint(reached_m, position_m);
  } else {
    state_ = State::kDone;
    answer.completes = true;
  }
}

double WaypointBehavior::Speed(double distance_m) const {
  const bool is_alternative = options_.use_alt_speed && options_.speed_alt >= 0;
  const double speed_mps = is_alternative ? options_.speed_alt : options_.speed;
  if (options_.end_speed < 0 || !IsLastPoint()) return speed_mps;
  const double slow_over_m = options_.end_slow_dist - options_.end_stop_dist;
  if (distance_m >= options_.end_slow_dist) return speed_mps;
  if (distance_m <= options_.end_stop_dist || slow_over_m <= 0) return options_.end_speed;
  return std::lerp(options_.end_speed, speed_mps,
                   (distance_m - options_.end_stop_dist) / slow_over_m);
}

Eigen::Vector2d WaypointBehavior::SteersFor(const BehaviorInputs& inputs) const {
  const bool leads = has_leg_ && (!lead_condition_ || (inputs.variables != nullptr &&
                                                       lead_condition_->Holds(*inputs.variables)));
  const Leg& leg = capture_->leg();
  if (!leads) return leg.to_m;
  return SteeringPoint(leg, inputs.own.motion.position_m,
                       {.lead_m = options_.lead,
                        .lead_damper_m = options_.lead_damper,
                        .return_deg = diversion_.is_on() ? options_.return_angle : 90});
}

Objective WaypointBehavior::Preference(const BehaviorInputs& inputs, double course_deg,
                                       double speed_mps) const {
  const Domain& domain = *inputs.domain;
  if (options_.ipf_type == "roc") {
    return {.coupled = std::make_shared<TowardPointFunction>(domain, course_deg, speed_mps)};
  }
  // A slight liking of the present heading: it moves the maximum by a degree at most.
  const std::vector<double> course =
      SumOf(PeakOverCourse(course_deg, 0, 180),
            PeakOverCourse(inputs.own.motion.heading_deg, 30, 180, 5, 0, 20));
  const std::vector<double> speed =
      options_.ipf_type == "zaic_spd"
          ? TransitSpeed(inputs, speed_mps, 70)
          : PeakOverAxis(domain.speed_mps, speed_mps, speed_mps / 2, 1.6, 20);
  return Couple(course, speed, options_.patience, 100 - options_.patience);
}

void WaypointBehavior::Report(const BehaviorInputs& inputs, double distance_m,
                              BehaviorAnswer& answer) const {
  const std::string index = std::to_string(rounds_.index());
  const double speed_mps = inputs.own.motion.speed_mps;
  const std::string eta = speed_mps > 0 ? Whole(distance_m / speed_mps) : "-1";
  Post(answer, options_.index_var, static_cast<double>(rounds_.index()), options_.post_suffix);
  Post(answer, options_.status_var,
       "index=" + index + ",hits=" + std::to_string(rounds_.num_reached()) + ",cycles=" +
           std::to_string(rounds_.num_rounds()) + ",dist=" + Whole(distance_m) + ",eta=" + eta,
       options_.post_suffix);
  const double from_prev_m = (inputs.own.motion.position_m - capture_->leg().from_m).norm();
  Post(answer, options_.dist_to_next_var, distance_m);
  Post(answer, options_.dist_to_prev_var, rounds_.num_reached() > 0 && has_leg_ ? from_prev_m : -1);
  answer.state = "point " + index + " of " + std::to_string(points_m_.size());
}

BehaviorAnswer WaypointBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  if (options_.points.empty() || state_ == State::kDone) {
    answer.state = options_.points.empty() ? "no points" : "done";
    return answer;
  }
  if (state_ != State::kOnTheWay) Begin(inputs, answer);
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  if (capture_->Reached(position_m)) Advance(position_m, answer);
  if (state_ == State::kDone) return answer;

  const double distance_m = (capture_->leg().to_m - position_m).norm();
  diversion_.Look(inputs.avoids, capture_->leg(), position_m, options_.lead, options_.return_angle);
  const Eigen::Vector2d steers_for_m = SteersFor(inputs);
  const double speed_mps = InDomain(inputs, Speed(distance_m));
  BehaviorAnswer preference =
      Prefer(inputs, Preference(inputs, BearingDeg(position_m, steers_for_m), speed_mps));
  answer.objective = std::move(preference.objective);
  answer.relevance = preference.relevance;
  answer.view = {.points_m = points_m_, .closed = false, .steers_for_m = steers_for_m};
  Report(inputs, distance_m, answer);
  return answer;
}

}  // namespace shoal

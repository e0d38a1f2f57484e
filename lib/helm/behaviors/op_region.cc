#include "lib/helm/behaviors/op_region.h"

#include <algorithm>
#include <cmath>

#include "lib/base/check/bounds.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/behaviors/preference.h"
#include "lib/helm/behaviors/stay_inside.h"

namespace shoal {

namespace {

Polygon Zone(const Polygon& given_m, const Polygon& core_m, double distance_m) {
  if (!given_m.empty()) return given_m;
  return distance_m < 0 || core_m.empty() ? Polygon() : Grown(core_m, distance_m);
}

}  // namespace

OpRegionBehavior::OpRegionBehavior(const OpRegionOptions& options) : BehaviorWith(options) {
  TakeOver(options);
}

void OpRegionBehavior::TakeOver(const OpRegionOptions& options) {
  options_ = options;
  save_m_ = Zone(options.save_poly, options.core_poly, options.save_dist);
  border_m_ = Zone(options.halt_poly, options.core_poly, options.halt_dist);
  if (border_m_.empty() && save_m_.empty()) border_m_ = options.core_poly;
}

void OpRegionBehavior::Reconfigure(const OpRegionOptions& options) {
  const Polygon save_m = save_m_;
  const Polygon border_m = border_m_;
  TakeOver(options);
  if (save_m_ == save_m && border_m_ == border_m) return;
  Clear();
  inside_since_s_.reset();
  outside_since_s_.reset();
  has_entered_ = false;
  was_in_save_ = false;
}

BehaviorAnswer OpRegionBehavior::Idle(const BehaviorInputs&) {
  const std::string latched = latched_;
  *this = OpRegionBehavior(options_);
  latched_ = latched;
  return {};
}

void OpRegionBehavior::Clear() {
  latched_.clear();
  last_text_.clear();
  outside_since_s_.reset();
  begun_s_.reset();
}

std::optional<OpRegionBehavior::Breach> OpRegionBehavior::PolygonBreach(
    const BehaviorInputs& inputs) {
  if (border_m_.empty()) return std::nullopt;
  if (SignedDistance(border_m_, inputs.own.motion.position_m) <= 0) {
    outside_since_s_.reset();
    if (!inside_since_s_) inside_since_s_ = inputs.time_s;
    has_entered_ = has_entered_ || inputs.time_s - *inside_since_s_ >= options_.trigger_entry_time;
    return std::nullopt;
  }
  inside_since_s_.reset();
  if (!has_entered_ && options_.trigger_on_poly_entry) return std::nullopt;
  if (!outside_since_s_) outside_since_s_ = inputs.time_s;
  if (inputs.time_s - *outside_since_s_ < options_.trigger_exit_time) return std::nullopt;
  return Breach{.text = "outside the op region", .flag = "breached_poly_flag"};
}

std::optional<OpRegionBehavior::Breach> OpRegionBehavior::LimitBreach(
    const BehaviorInputs& inputs) const {
  const OwnMotion& own = inputs.own;
  if (options_.max_depth > 0 && own.depth_m > options_.max_depth) {
    return Breach{.text = "deeper than max_depth", .flag = "breached_depth_flag"};
  }
  if (options_.min_altitude > 0 && own.altitude_m >= 0 && own.altitude_m < options_.min_altitude) {
    return Breach{.text = "lower than min_altitude", .flag = "breached_altitude_flag"};
  }
  if (options_.max_time > 0 && inputs.time_s - *begun_s_ > options_.max_time) {
    return Breach{.text = "longer than max_time", .flag = "breached_time_flag"};
  }
  return std::nullopt;
}

// Flags at the beginning of each breach; the error lasts as long as the breach, or is latched.
void OpRegionBehavior::AnswerBreach(const std::optional<Breach>& breach, BehaviorAnswer& answer) {
  const std::string text = breach ? breach->text : "";
  const bool begins = breach.has_value() && text != last_text_;
  last_text_ = text;
  if (begins) answer.flags.push_back(breach->flag);
  const bool is_soft = options_.soft_poly_breach && breach && breach->flag == "breached_poly_flag";
  if (is_soft) {
    answer.parks = begins;
    answer.warning = text;
    return;
  }
  if (breach && options_.latch && latched_.empty()) latched_ = text;
  answer.error = latched_.empty() ? text : latched_;
}

// 100 for the shortest way to the save zone, 0 for the longest and for courses that miss it. With
// the bow off the zone the vessel turns to one side, the one that was nearer at first, until the
// bow meets it: else it would change sides with each small change of its heading.
std::vector<double> OpRegionBehavior::CoursesBack(const BehaviorInputs& inputs) {
  const VesselMotion& own = inputs.own.motion;
  std::vector<std::optional<double>> ways_m(Domain::kNumCourses);
  double near_m = kInfinity;
  double far_m = 0;
  double nearest_turn_deg = kInfinity;
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    const std::optional<double> way_m = RayDistance(save_m_, own.position_m, DegToRad(course));
    ways_m[static_cast<size_t>(course)] = way_m;
    if (!way_m) continue;
    near_m = std::min(near_m, *way_m);
    far_m = std::max(far_m, *way_m);
    const double turn_deg = Wrap180(course - own.heading_deg);
    if (std::abs(turn_deg) < std::abs(nearest_turn_deg)) nearest_turn_deg = turn_deg;
  }
  if (RayDistance(save_m_, own.position_m, DegToRad(own.heading_deg))) {
    side_ = 0;
  } else if (side_ == 0) {
    side_ = nearest_turn_deg < 0 ? -1 : 1;
  }
  std::vector<double> values(Domain::kNumCourses, 0);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    const auto index = static_cast<size_t>(course);
    const double turn_deg = Wrap180(course - own.heading_deg);
    if (!ways_m[index] || turn_deg * side_ < 0) continue;
    values[index] = far_m > near_m ? 100 * (far_m - *ways_m[index]) / (far_m - near_m) : 100;
  }
  return values;
}

void OpRegionBehavior::TurnBack(const BehaviorInputs& inputs, BehaviorAnswer& answer) {
  if (save_m_.empty()) return;
  const bool is_in_save = SignedDistance(save_m_, inputs.own.motion.position_m) <= 0;
  if (is_in_save || (!was_in_save_ && options_.trigger_on_poly_entry)) {
    was_in_save_ = was_in_save_ || is_in_save;
    is_saving_ = false;
    side_ = 0;
    answer.state = is_in_save ? "inside" : "not entered";
    return;
  }
  if (!is_saving_) answer.flags.emplace_back("save_flag");
  is_saving_ = true;
  answer.flags.emplace_back("savex_flag");
  answer.state = "turns back";
  constexpr double kPatience = 95;
  const std::vector<double>& patience = options_.recover_patience;
  const BehaviorAnswer back =
      PreferBoth(inputs, CoursesBack(inputs),
                 PeakOverAxis(inputs.domain->speed_mps, InDomain(inputs, options_.recover_spd),
                              options_.recover_spd / 2, 0.2, 20),
                 patience.empty() ? kPatience : patience[num_iterations_ % patience.size()]);
  answer.objective = back.objective;
  answer.relevance = back.relevance;
}

AllowedPart OpRegionBehavior::AllowedNow(const BehaviorInputs& inputs) const {
  if (options_.look_ahead <= 0) return {};
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  AllowedPart allowed;
  // A start outside is the vessel's own business until it has come in.
  const bool has_been_inside = has_entered_ || was_in_save_ || !options_.trigger_on_poly_entry;
  if (!Limit().empty() && (has_been_inside || SignedDistance(Limit(), position_m) <= 0)) {
    allowed = StayInside(Limit(), inputs.own.motion,
                         {.horizon_s = options_.look_ahead, .turn_degps = options_.turn_rate},
                         *inputs.domain);
  }
  const Axis& depth_m = inputs.domain->depth_m;
  if (options_.max_depth > 0 && depth_m.count > 0) {
    const double last = std::floor((options_.max_depth - depth_m.first) / depth_m.step + 1e-9);
    allowed.depths =
        IndexRange{.first = 0, .last = static_cast<int>(std::min(last, depth_m.count - 1.0))};
  }
  return allowed;
}

void OpRegionBehavior::Report(const BehaviorInputs& inputs, BehaviorAnswer& answer) const {
  const VesselMotion& own = inputs.own.motion;
  const auto seconds = [&](double distance_m) {
    return distance_m < 0 || own.speed_mps <= 0 ? -1 : std::round(distance_m / own.speed_mps);
  };
  const Polygon& limit_m = Limit();
  if (!limit_m.empty()) {
    const double nearest_m = -SignedDistance(limit_m, own.position_m);
    const double ahead_m =
        nearest_m < 0
            ? -1
            : RayDistance(limit_m, own.position_m, DegToRad(own.heading_deg)).value_or(-1);
    Post(answer, "OPREG_ABSOLUTE_PERIM_DIST", std::round(nearest_m));
    Post(answer, "OPREG_ABSOLUTE_PERIM_ETA", seconds(nearest_m));
    Post(answer, "OPREG_TRAJECTORY_PERIM_DIST", std::round(ahead_m));
    Post(answer, "OPREG_TRAJECTORY_PERIM_ETA", seconds(ahead_m));
  }
  if (options_.max_time > 0) {
    const double left_s = options_.max_time - (inputs.time_s - *begun_s_);
    Post(answer, "OPREG_TIME_REMAINING", std::round(std::max(0.0, left_s)));
  }
  answer.view = {.points_m = limit_m, .closed = true};
}

BehaviorAnswer OpRegionBehavior::Run(const BehaviorInputs& inputs) {
  if (IsFresh(inputs, options_.reset_var)) Clear();
  if (!begun_s_) begun_s_ = inputs.time_s;
  ++num_iterations_;
  BehaviorAnswer answer;
  const std::optional<Breach> outside = PolygonBreach(inputs);
  const std::optional<Breach> beyond = LimitBreach(inputs);
  AnswerBreach(outside ? outside : beyond, answer);
  if (answer.error.empty() && !outside) TurnBack(inputs, answer);
  answer.allowed = AllowedNow(inputs);
  if (!answer.error.empty()) answer.state = "breached: " + answer.error;
  Report(inputs, answer);
  return answer;
}

}  // namespace shoal

#include "lib/helm/behaviors/preference.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

std::string Suffixed(std::string_view variable, std::string_view suffix) {
  std::string name(variable);
  if (!suffix.empty()) name.append("_").append(suffix);
  return name;
}

std::vector<double> Over(const Axis& axis, const Peak& peak) {
  return PeakOverAxis(axis, peak.summit, peak.width, peak.base, peak.delta);
}

}  // namespace

BehaviorAnswer Prefer(const BehaviorInputs& inputs, Objective objective) {
  BehaviorAnswer answer;
  answer.objective = NormaliseTo100(std::move(objective), *inputs.domain);
  answer.relevance = 1;
  return answer;
}

BehaviorAnswer PreferCourse(const Peak& peak, const BehaviorInputs& inputs) {
  return Prefer(inputs, {.course = PeakOverCourse(peak.summit, peak.width, peak.base, peak.delta)});
}

BehaviorAnswer PreferSpeed(const Peak& peak, const BehaviorInputs& inputs) {
  if (inputs.domain->speed_mps.count == 0) return {};
  return Prefer(inputs, {.speed = Over(inputs.domain->speed_mps, peak)});
}

BehaviorAnswer PreferDepth(const Peak& peak, const BehaviorInputs& inputs) {
  if (inputs.domain->depth_m.count == 0) return WarnOfNoDepth();
  return Prefer(inputs, {.depth = Over(inputs.domain->depth_m, peak)});
}

BehaviorAnswer WarnOfNoDepth() {
  BehaviorAnswer answer;
  answer.warning = "the helm does not decide about depth: [vehicle.domain] has none";
  return answer;
}

BehaviorAnswer PreferBoth(const BehaviorInputs& inputs, const std::vector<double>& course,
                          const std::vector<double>& speed, double patience) {
  return Prefer(inputs, Couple(course, speed, patience, 100 - patience));
}

double InDomain(const BehaviorInputs& inputs, double speed_mps) {
  const Axis& axis = inputs.domain->speed_mps;
  return std::clamp(speed_mps, axis.first, std::max(axis.first, axis.Last()));
}

std::vector<double> TransitSpeed(const BehaviorInputs& inputs, double speed_mps,
                                 double slow_value) {
  constexpr double kSlow_mps = 0.1;
  constexpr double kTooFast_mps = 0.4;
  return SpeedPolyline(inputs.domain->speed_mps, speed_mps, std::min(kSlow_mps, speed_mps),
                       speed_mps + kTooFast_mps, slow_value, 20);
}

void Post(BehaviorAnswer& answer, std::string_view variable, double value,
          std::string_view suffix) {
  if (variable.empty()) return;
  answer.posts.push_back({.variable = Suffixed(variable, suffix), .value = value});
}

void Post(BehaviorAnswer& answer, std::string_view variable, std::string_view value,
          std::string_view suffix) {
  if (variable.empty()) return;
  answer.posts.push_back({.variable = Suffixed(variable, suffix), .value = std::string(value)});
}

std::string Whole(double number) { return std::to_string(std::lround(number)); }

bool IsFresh(const BehaviorInputs& inputs, std::string_view variable) {
  if (variable.empty() || inputs.variables == nullptr) return false;
  const Variables::Entry* entry = inputs.variables->Find(variable);
  return entry != nullptr && !entry->fresh.empty();
}

double BearingDeg(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  return Wrap360(RadToDeg(HeadingOf(to_m - from_m)));
}

}  // namespace shoal

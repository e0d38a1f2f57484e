// What the judge makes of all that it saw: a verdict for each expectation.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/encounters/encounter_score.h"
#include "lib/routing/vehicle_name.h"
#include "lib/verdict/expectation_text.h"
#include "lib/verdict/judge.h"

namespace shoal {

namespace {

constexpr size_t kMaxFailuresShown = 5;

/// Judges by the share (at_least_pct, at_most_pct) that `count` has in all that was offered.
void JudgeShare(const auto& limits, int64_t count, int64_t offered, Outcome* outcome) {
  if (offered == 0) {
    outcome->passed = !limits.at_least_pct;
    outcome->numbers = "nothing was offered on these links";
    return;
  }
  // A share that is exactly the limit is within it, whatever binary fractions make of the limit.
  constexpr double kRounding_pct = 1e-9;
  const double share_pct = 100 * static_cast<double>(count) / static_cast<double>(offered);
  outcome->numbers = fmt::format("{} of {} ({:.4g} %)", count, offered, share_pct);
  const double missing_pct = limits.at_least_pct.value_or(0) - share_pct;
  const double excess_pct = share_pct - limits.at_most_pct.value_or(100);
  if (missing_pct > kRounding_pct) {
    outcome->passed = false;
    outcome->numbers += fmt::format(", {} % too low", FormatExcess(missing_pct));
  }
  if (excess_pct > kRounding_pct) {
    outcome->passed = false;
    outcome->numbers += fmt::format(", {} % too high", FormatExcess(excess_pct));
  }
}

Outcome JudgeCoverage(const CoverageWatch& watch, double at_least_pct) {
  const double missing_pct = at_least_pct - watch.covered_pct();
  Outcome outcome = {.passed = missing_pct <= 0,
                     .strain = missing_pct,
                     .numbers = fmt::format("{:.2f} % of {:.0f} m2, in cells of {:.2g} m",
                                            watch.covered_pct(), watch.area_m2(), watch.cell_m())};
  if (missing_pct > 0) outcome.numbers += fmt::format(", {} % too low", FormatExcess(missing_pct));
  return outcome;
}

/// Judges the smallest and the largest that a quantity in metres was. Absent limits do not count.
Outcome JudgeExtremes(const ExtremeWatch& watch, std::optional<double> min_m,
                      std::optional<double> max_m, std::string_view quantity) {
  if (!watch.has_seen()) {
    return {.passed = false, .strain = 0, .numbers = fmt::format("no {} was seen", quantity)};
  }
  Outcome outcome = {
      .passed = true, .strain = -std::numeric_limits<double>::infinity(), .numbers = {}};
  const auto add = [&](std::string_view what, const Extreme& extreme, double excess_m) {
    if (!outcome.numbers.empty()) outcome.numbers += ", ";
    outcome.numbers += fmt::format("{} {:.2f} m at {:.1f} s", what, extreme.value, extreme.time_s);
    if (excess_m > 0) outcome.numbers += fmt::format(", {} m beyond", FormatExcess(excess_m));
    outcome.passed = outcome.passed && excess_m <= 0;
    outcome.strain = std::max(outcome.strain, excess_m);
  };
  if (min_m) add("least", watch.smallest(), *min_m - watch.smallest().value);
  if (max_m) add("most", watch.largest(), watch.largest().value - *max_m);
  return outcome;
}

}  // namespace

std::vector<ExpectationVerdict> Judge::Verdicts() const {
  std::vector<ExpectationVerdict> verdicts;
  for (const Case& each : cases_) {
    Outcome outcome;
    if (const auto* what = std::get_if<SeparationExpectation>(&each.expectation->what)) {
      outcome = FindSeparation(*what);
    } else if (const auto* approach =
                   std::get_if<ClosestApproachExpectation>(&each.expectation->what)) {
      outcome = FindClosestApproach(*approach, encounters_[each.encounters]);
    } else if (const auto* score =
                   std::get_if<EncounterScoreExpectation>(&each.expectation->what)) {
      outcome = FindEncounterScore(*score, encounters_[each.encounters]);
    } else if (const auto* comms = std::get_if<CommsExpectation>(&each.expectation->what)) {
      outcome = FindComms(*comms);
    } else if (const auto* swarm = std::get_if<SwarmExpectation>(&each.expectation->what)) {
      const int from = PlaceInCounts(swarm->from);
      const int to = PlaceInCounts(swarm->to);
      outcome = {.passed = true, .strain = 0, .numbers = {}};
      JudgeShare(*swarm, swarm_counts_.Count(from, to, swarm->outcome),
                 swarm_counts_.CountOffered(from, to), &outcome);
    } else if (const auto* coverage = std::get_if<CoverageExpectation>(&each.expectation->what)) {
      outcome = JudgeCoverage(*each.coverage, coverage->at_least_pct);
    } else {
      outcome = Combine(each, FindForVehicles(each));
    }
    verdicts.push_back({.where = each.expectation->where,
                        .text = Describe(mission_, *each.expectation),
                        .passed = outcome.passed,
                        .numbers = outcome.numbers});
  }
  return verdicts;
}

bool Judge::Passed() const {
  if (num_collisions_ > 0 && mission_.collisions == CollisionVerdict::kFail) return false;
  const std::vector<ExpectationVerdict> verdicts = Verdicts();
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const ExpectationVerdict& verdict) { return verdict.passed; });
}

Outcome Judge::FindSeparation(const SeparationExpectation& separation) const {
  const Approach& closest = separation_.closest();
  if (closest.first < 0) return {.passed = false, .numbers = "no two vehicles were seen"};
  const double missing_m = separation.min_m - closest.range_m;
  std::string numbers = fmt::format("closest: {}-{} {:.1f} m at {:.1f} s",
                                    mission_.vehicles[static_cast<size_t>(closest.first)].name,
                                    mission_.vehicles[static_cast<size_t>(closest.second)].name,
                                    closest.range_m, SecondsSinceStart(closest.utime));
  if (missing_m > 0) numbers += fmt::format(", {} m too close", FormatExcess(missing_m));
  return {.passed = missing_m <= 0, .strain = missing_m, .numbers = numbers};
}

bool Judge::IsNamed(std::string_view name, size_t vehicle) const {
  const std::string key = VehicleKey(name);
  return key == "all" || key == VehicleKey(mission_.vehicles[vehicle].name);
}

Outcome Judge::FindClosestApproach(const ClosestApproachExpectation& approach,
                                   const EncounterWatch& watch) const {
  const std::vector<Encounter> encounters = watch.Encounters();
  const Encounter* closest = nullptr;
  int64_t count = 0;
  for (const Encounter& each : encounters) {
    const size_t first = each.sides[0].vessel;
    const size_t second = each.sides[1].vessel;
    if (!(IsNamed(approach.vehicle, first) && IsNamed(approach.to, second)) &&
        !(IsNamed(approach.vehicle, second) && IsNamed(approach.to, first))) {
      continue;
    }
    ++count;
    if (closest == nullptr || each.closest_m < closest->closest_m) closest = &each;
  }
  if (closest == nullptr) return {.passed = false, .numbers = "no encounter was seen"};
  const double missing_m = approach.at_least_m - closest->closest_m;
  std::string numbers = fmt::format(
      "closest of {} encounter{}: {}-{} {:.1f} m at {:.1f} s", count, count == 1 ? "" : "s",
      mission_.vehicles[closest->sides[0].vessel].name,
      mission_.vehicles[closest->sides[1].vessel].name, closest->closest_m, closest->closest_s);
  if (missing_m > 0) numbers += fmt::format(", {} m too close", FormatExcess(missing_m));
  return {.passed = missing_m <= 0, .strain = missing_m, .numbers = numbers};
}

Outcome Judge::FindEncounterScore(const EncounterScoreExpectation& expected,
                                  const EncounterWatch& watch) const {
  const std::vector<Encounter> encounters = watch.Encounters();
  const Encounter* lowest = nullptr;
  size_t lowest_side = 0;
  double lowest_score = 0;
  int64_t count = 0;
  std::string other_role;
  for (const Encounter& each : encounters) {
    for (size_t i = 0; i < 2; ++i) {
      const EncounterSide& side = each.sides[i];
      const size_t other = each.sides[1 - i].vessel;
      if (!IsNamed(expected.vehicle, side.vessel) || !IsNamed(expected.to, other)) continue;
      ++count;
      if (!expected.role.empty() && Name(side.role) != expected.role && other_role.empty()) {
        other_role = fmt::format("{} was {} toward {} at {:.1f} s, not {}",
                                 mission_.vehicles[side.vessel].name, Name(side.role),
                                 mission_.vehicles[other].name, each.begin_s, expected.role);
      }
      const double score = ScoreOf(each, i, watch.options()).overall;
      if (lowest != nullptr && score >= lowest_score) continue;
      lowest = &each;
      lowest_side = i;
      lowest_score = score;
    }
  }
  if (lowest == nullptr) return {.passed = false, .numbers = "no encounter was seen"};
  if (!other_role.empty()) return {.passed = false, .numbers = other_role};
  const EncounterSide& side = lowest->sides[lowest_side];
  const double missing = expected.at_least - lowest_score;
  std::string numbers =
      fmt::format("lowest of {}: {} as {} toward {} {:.1f}, closest {:.1f} m at {:.1f} s", count,
                  mission_.vehicles[side.vessel].name, Name(side.role),
                  mission_.vehicles[lowest->sides[1 - lowest_side].vessel].name, lowest_score,
                  lowest->closest_m, lowest->closest_s);
  if (missing > 0) numbers += fmt::format(", {} too low", FormatExcess(missing));
  return {.passed = missing <= 0, .strain = missing, .numbers = numbers};
}

Outcome Judge::FindComms(const CommsExpectation& comms) const {
  const int from = PlaceInCounts(comms.from);
  const int to = PlaceInCounts(comms.to);
  const int64_t count = fates(comms.kind).Count(from, to, comms.cause);
  Outcome outcome = {.passed = true, .strain = 0, .numbers = std::to_string(count)};
  if (comms.at_least_pct || comms.at_most_pct) {
    JudgeShare(comms, count, fates(comms.kind).CountOffered(from, to), &outcome);
  }
  if (comms.at_least && count < *comms.at_least) {
    outcome.passed = false;
    outcome.numbers += fmt::format(", {} too few", *comms.at_least - count);
  }
  if (comms.at_most && count > *comms.at_most) {
    outcome.passed = false;
    outcome.numbers += fmt::format(", {} too many", count - *comms.at_most);
  }
  return outcome;
}

Outcome Judge::FindHelm(const HelmExpectation& helm, size_t vehicle) const {
  const std::optional<HelmFacts>& facts = helms_[vehicle];
  if (!facts) return {.passed = false, .strain = 0, .numbers = "no helm state was received"};
  const bool state_fits = helm.state.empty() || VehicleKey(helm.state) == VehicleKey(facts->state);
  const bool task_fits = helm.task.empty() || helm.task == facts->task;
  return {.passed = state_fits && task_fits,
          .strain = 0,
          .numbers = fmt::format("{} with {}", facts->state,
                                 facts->task.empty() ? "no task" : "task " + facts->task)};
}

Outcome Judge::FindLaps(const LapsExpectation& expected, const LapsWatch& watch) const {
  if (!watch.reached_s) {
    return {.passed = false,
            .strain = static_cast<double>(expected.at_least - watch.most),
            .numbers = fmt::format("{}, {} too few", watch.most, expected.at_least - watch.most)};
  }
  const double late_s = *watch.reached_s - LimitSeconds(mission_, expected.by_s);
  std::string numbers = fmt::format("{}, enough at {:.1f} s", watch.most, *watch.reached_s);
  if (late_s > 0) numbers += fmt::format(", {} s late", FormatExcess(late_s));
  return {.passed = late_s <= 0, .strain = *watch.reached_s, .numbers = numbers};
}

std::vector<Outcome> Judge::FindForVehicles(const Case& each) const {
  std::vector<Outcome> outcomes;
  for (size_t i = 0; i < each.vehicles.size(); ++i) {
    if (const auto* helm = std::get_if<HelmExpectation>(&each.expectation->what)) {
      outcomes.push_back(FindHelm(*helm, each.vehicles[i]));
    } else if (const auto* laps = std::get_if<LapsExpectation>(&each.expectation->what)) {
      outcomes.push_back(FindLaps(*laps, each.laps[i]));
    } else if (const auto* track = std::get_if<TrackExpectation>(&each.expectation->what)) {
      outcomes.push_back(JudgeExtremes(each.extremes[i], {}, track->max_m, "track"));
    } else if (const auto* distance = std::get_if<DistanceExpectation>(&each.expectation->what)) {
      outcomes.push_back(
          JudgeExtremes(each.extremes[i], distance->min_m, distance->max_m, "distance"));
    } else if (const auto* altitude = std::get_if<AltitudeExpectation>(&each.expectation->what)) {
      outcomes.push_back(JudgeExtremes(each.extremes[i], altitude->min_m, {}, "altitude"));
    } else {
      outcomes.push_back(each.arrivals[i].Find());
    }
  }
  return outcomes;
}

/// Makes one outcome of many: the failures, or where there are none the narrowest success.
Outcome Judge::Combine(const Case& each, const std::vector<Outcome>& outcomes) const {
  if (outcomes.empty()) return {.passed = false, .strain = 0, .numbers = "no such vehicle"};
  if (outcomes.size() == 1) return outcomes.front();
  const auto with_name = [&](size_t i) {
    return mission_.vehicles[each.vehicles[i]].name + ": " + outcomes[i].numbers;
  };
  size_t num_failed = 0;
  size_t narrowest = 0;
  std::string failures;
  for (size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].strain > outcomes[narrowest].strain) narrowest = i;
    if (outcomes[i].passed || ++num_failed > kMaxFailuresShown) continue;
    failures += (failures.empty() ? "" : "; ") + with_name(i);
  }
  if (num_failed == 0) {
    return {.passed = true,
            .strain = 0,
            .numbers = fmt::format("all {}; narrowest {}", outcomes.size(), with_name(narrowest))};
  }
  if (num_failed > kMaxFailuresShown) {
    failures += fmt::format("; and {} more", num_failed - kMaxFailuresShown);
  }
  return {.passed = false,
          .strain = 0,
          .numbers = fmt::format("{} of {} failed: {}", num_failed, outcomes.size(), failures)};
}

}  // namespace shoal

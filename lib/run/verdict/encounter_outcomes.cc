#include "lib/run/verdict/encounter_outcomes.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/vehicle_name.h"
#include "lib/helm/encounters/encounter_score.h"

namespace shoal {

namespace {

bool IsNamed(const Mission& mission, std::string_view name, size_t vehicle) {
  const std::string key = VehicleKey(name);
  return key == "all" || key == VehicleKey(mission.vehicles[vehicle].name);
}

}  // namespace

Outcome JudgeClosestApproach(const Mission& mission, const ClosestApproachExpectation& approach,
                             const EncounterWatch& watch) {
  const std::vector<Encounter> encounters = watch.Encounters();
  const Encounter* closest = nullptr;
  int64_t count = 0;
  for (const Encounter& each : encounters) {
    const size_t first = each.sides[0].vessel;
    const size_t second = each.sides[1].vessel;
    if (!(IsNamed(mission, approach.vehicle, first) && IsNamed(mission, approach.to, second)) &&
        !(IsNamed(mission, approach.vehicle, second) && IsNamed(mission, approach.to, first))) {
      continue;
    }
    ++count;
    if (closest == nullptr || each.closest_m < closest->closest_m) closest = &each;
  }
  if (closest == nullptr) return {.passed = false, .numbers = "no encounter was seen"};
  const double missing_m = approach.at_least_m - closest->closest_m;
  std::string numbers = fmt::format(
      "closest of {} encounter{}: {}-{} {:.1f} m at {:.1f} s", count, count == 1 ? "" : "s",
      mission.vehicles[closest->sides[0].vessel].name,
      mission.vehicles[closest->sides[1].vessel].name, closest->closest_m, closest->closest_s);
  if (missing_m > 0) numbers += fmt::format(", {} m too close", FormatExcess(missing_m));
  return {.passed = missing_m <= 0,
          .strain = missing_m,
          .numbers = numbers,
          .value = closest->closest_m};
}

Outcome JudgeEncounterScore(const Mission& mission, const EncounterScoreExpectation& expected,
                            const EncounterWatch& watch) {
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
      if (!IsNamed(mission, expected.vehicle, side.vessel) || !IsNamed(mission, expected.to, other))
        continue;
      ++count;
      if (!expected.role.empty() && Name(side.role) != expected.role && other_role.empty()) {
        other_role = fmt::format("{} was {} toward {} at {:.1f} s, not {}",
                                 mission.vehicles[side.vessel].name, Name(side.role),
                                 mission.vehicles[other].name, each.begin_s, expected.role);
      }
      const double score = ScoreOf(each, i, watch.options()).overall;
      if (lowest != nullptr && score >= lowest_score) continue;
      lowest = &each;
      lowest_side = i;
      lowest_score = score;
    }
  }
  if (lowest == nullptr) return {.passed = false, .numbers = "no encounter was seen"};
  if (!other_role.empty()) return {.passed = false, .numbers = other_role, .value = lowest_score};
  const EncounterSide& side = lowest->sides[lowest_side];
  const double missing = expected.at_least - lowest_score;
  std::string numbers =
      fmt::format("lowest of {}: {} as {} toward {} {:.1f}, closest {:.1f} m at {:.1f} s", count,
                  mission.vehicles[side.vessel].name, Name(side.role),
                  mission.vehicles[lowest->sides[1 - lowest_side].vessel].name, lowest_score,
                  lowest->closest_m, lowest->closest_s);
  if (missing > 0) numbers += fmt::format(", {} too low", FormatExcess(missing));
  return {.passed = missing <= 0, .strain = missing, .numbers = numbers, .value = lowest_score};
}

}  // namespace shoal

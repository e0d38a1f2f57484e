#include "lib/tools/metrics/trial_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lib/run/verdict/summary.h"

namespace shoal {

namespace {

constexpr size_t kMaxReasons = 20;

/// Returns "alpha and bravo collide at 30.0 s".
std::string CollisionText(const Mission& mission, const CollisionFact& fact) {
  const size_t second = fact.collision.second;
  return fmt::format(
      "{} and {} collide at {:.1f} s", mission.vehicles[fact.collision.first].name,
      fact.is_obstacle ? "obstacle " + mission.obstacles[second].id : mission.vehicles[second].name,
      fact.time_s);
}

/// Returns where an expectation stands without the folder of its file: results of a campaign do not
/// depend on where it lies.
std::string_view WithoutFolder(std::string_view where) {
  return where.starts_with("--") ? where : where.substr(where.rfind('/') + 1);
}

}  // namespace

TrialResult ResultOf(const Mission& mission, const Judge& judge, const TrialWatch& watch) {
  std::vector<std::string> reasons;
  for (const ExpectationVerdict& verdict : judge.Verdicts()) {
    if (verdict.passed) continue;
    reasons.push_back(
        fmt::format("{}: {} [{}]", verdict.text, verdict.numbers, WithoutFolder(verdict.where)));
  }
  if (mission.collisions == CollisionVerdict::kFail) {
    for (const CollisionFact& fact : judge.collisions()) {
      reasons.push_back(CollisionText(mission, fact));
    }
  }
  if (mission.grounding == GroundingVerdict::kFail) {
    for (const GroundingFact& fact : judge.groundings()) {
      reasons.push_back(GroundingText(mission, fact));
    }
  }
  if (reasons.size() > kMaxReasons) {
    const size_t num_more = reasons.size() - kMaxReasons;
    reasons.resize(kMaxReasons);
    reasons.push_back(fmt::format("and {} more", num_more));
  }
  return {.outcome = judge.Passed() ? TrialOutcome::kPass : TrialOutcome::kFail,
          .why = fmt::format("{}", fmt::join(reasons, "; ")),
          .metrics = watch.Values(judge)};
}

}  // namespace shoal

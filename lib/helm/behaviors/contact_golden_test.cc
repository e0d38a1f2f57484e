// Objective functions of contact behaviors, held against those of MOOS-IvP's helm
// (tests/golden/README.md, helm/).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lib/helm/behaviors/avoid_collision.h"
#include "lib/helm/behaviors/colregs.h"
#include "lib/helm/behaviors/contact_testing.h"
#include "lib/helm/behaviors/cut_range.h"
#include "lib/helm/behaviors/shadow.h"
#include "lib/helm/behaviors/trail.h"
#include "tests/golden/helm_functions.h"

namespace shoal::contact_golden_test {

constexpr double kTolerance = 0.02;
const ContactOptions kBravo = {.contact = "bravo"};

struct Compared {
  double difference = 0;
  double weight = 0;  ///< Greatest relative difference.
  int num_functions = 0;
};

/// Runs a fresh behavior in each state. `most_weight`: a greater golden weight counts as this one.
template <class Kind, class Options>
Compared Compare(const std::string& title, const Options& options, double pwt,
                 double most_weight = 1e9) {
  const auto encounters = ReadEncounters();
  Compared compared;
  for (const GoldenRow& row : ReadFunctions(title)) {
    const GoldenEncounter& at = encounters.at(row.at("state"));
    const TestMeeting meeting(at.own, at.contact);
    Kind behavior(options);
    const BehaviorAnswer answer = meeting.Run(behavior);
    const bool has_function = row.contains("values") && !row.at("values").empty();
    EXPECT_EQ(answer.objective.has_value(), has_function) << title << " " << row.at("state");
    if (!answer.objective || !has_function) continue;
    const double difference = GreatestDifference(*answer.objective, row);
    EXPECT_LE(difference, kTolerance) << title << " " << row.at("state");
    const double weight = std::min(Number(row, "weight"), most_weight);
    const double off = std::abs(pwt * answer.relevance / weight - 1);
    EXPECT_LE(off, 1e-4) << title << " " << row.at("state");
    compared.difference = std::max(compared.difference, difference);
    compared.weight = std::max(compared.weight, off);
    ++compared.num_functions;
  }
  return compared;
}

TEST(Golden, AvoidCollisionIsTheSameButForTheWeightInsideTheInnerDistance) {
  // There the original exceeds the priority weight: its relevance is not limited to 1.
  const AvoidCollisionOptions options = {.contact = kBravo,
                                         .pwt_outer_dist = 80,
                                         .pwt_inner_dist = 20,
                                         .completed_dist = 100,
                                         .min_util_cpa_dist = 8,
                                         .max_util_cpa_dist = 25,
                                         .pwt_grade = "linear",
                                         .steady = false};
  EXPECT_EQ(Compare<AvoidCollisionBehavior>("avoid_exact", options, 200, 200).num_functions, 48);
}

TEST(Golden, ColregsIsTheSameInTheFirstIteration) {
  const ColregsOptions options = {.contact = kBravo,
                                  .pwt_outer_dist = 80,
                                  .pwt_inner_dist = 20,
                                  .completed_dist = 100,
                                  .min_util_cpa_dist = 8,
                                  .max_util_cpa_dist = 25,
                                  .steady = false};
  EXPECT_EQ(Compare<ColregsBehavior>("colregs_exact", options, 200).num_functions, 48);
}

TEST(Golden, TrailIsTheSame) {
  const TrailOptions options = {.contact = kBravo, .trail_range = 20, .radius = 5, .nm_radius = 15};
  EXPECT_EQ(Compare<TrailBehavior>("trail_exact", options, 100).num_functions, 48);
}

TEST(Golden, CutRangeIsTheSame) {
  const CutRangeOptions options = {.contact = kBravo,
                                   .pwt_outer_dist = 60,
                                   .pwt_inner_dist = 10,
                                   .giveup_dist = 500,
                                   .patience = 45};
  EXPECT_EQ(Compare<CutRangeBehavior>("cutrange_exact", options, 100).num_functions, 48);
}

TEST(Golden, ShadowIsTheSame) {
  const ShadowOptions options = {.contact = kBravo};
  EXPECT_EQ(Compare<ShadowBehavior>("shadow", options, 100).num_functions, 48);
}

}  // namespace shoal::contact_golden_test

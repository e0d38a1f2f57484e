// Contact functions and decisions against those of another helm (tests/golden/helm).
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lib/base/geometry/angles.h"
#include "lib/helm/colregs/preferences.h"
#include "lib/helm/decision/cpa_function.h"
#include "lib/helm/decision/decide.h"
#include "lib/helm/decision/shapes.h"
#include "tests/golden/helm_functions.h"

namespace shoal::decision_golden_test {

constexpr double kTolerance = 0.02;  // Of 100; two decimals are printed.

const Domain kDomain;

/// The contact parameters of the golden data: 8 m, 25 m, 120 s.
Objective Avoid(const GoldenEncounter& at) {
  const Eigen::Vector2d velocity_mps =
      at.contact.speed_mps * UnitVector(DegToRad(at.contact.heading_deg));
  const CpaGrid cpa(at.contact.position_m - at.own.position_m, velocity_mps, 120, kDomain);
  const double lo_m = cpa.range_m() <= 8 ? cpa.range_m() / 2 : 8;
  const CpaUtility utility = {.lo_m = lo_m, .hi_m = 25};
  return NormaliseTo100({.coupled = std::make_shared<CpaFunction>(cpa, utility)}, kDomain);
}

Objective Colregs(const GoldenEncounter& at) {
  const ColregsState state = NextColregsState(
      {}, at.own, at.contact, {.outer_m = 80, .min_cpa_m = 8, .max_cpa_m = 25, .steady = false}, 0);
  return ColregsObjective(state, at.own, at.contact,
                          {.min_cpa_m = 8, .max_cpa_m = 25, .steady = false}, kDomain);
}

/// Toward (100, 0) at 2 m/s.
Objective Waypoint(const GoldenEncounter& at) {
  const Eigen::Vector2d way_m = Eigen::Vector2d(100, 0) - at.own.position_m;
  return Couple(SumOf(PeakOverCourse(RadToDeg(HeadingOf(way_m)), 0, 180),
                      PeakOverCourse(at.own.heading_deg, 30, 180, 5, 0, 20)),
                PeakOverAxis(kDomain.speed_mps, 2, 1, 1.6, 20), 50, 50);
}

TEST(DecisionGolden, ContactFunctionsAreTheSame) {
  const auto encounters = ReadEncounters();
  const auto rows = ReadFunctions("avoid_exact");
  EXPECT_EQ(rows.size(), 48U);
  for (const GoldenRow& row : rows) {
    EXPECT_LT(GreatestDifference(Avoid(encounters.at(row.at("state"))), row), kTolerance)
        << row.at("state");
  }
}

TEST(DecisionGolden, WaypointFunctionsAreTheSame) {
  const auto encounters = ReadEncounters();
  const auto rows = ReadFunctions("waypoint_zaic");
  EXPECT_EQ(rows.size(), 48U);
  for (const GoldenRow& row : rows) {
    EXPECT_LT(GreatestDifference(Waypoint(encounters.at(row.at("state"))), row), kTolerance)
        << row.at("state");
  }
}

/// Decides with a waypoint of weight 100 and one contact's function at the weight of the golden
/// data, in the states of both sets: the other helm's decisions on exact functions, and on pieces
/// of them.
void CompareDecisions(const std::string& behavior, Objective (*contact)(const GoldenEncounter&)) {
  const auto encounters = ReadEncounters();
  std::map<std::string, double> weights;
  for (const GoldenRow& row : ReadFunctions(behavior + "_exact")) {
    weights[row.at("state")] = Number(row, "weight");
  }
  int num_exact = 0;
  int num_pieces = 0;
  for (const GoldenRow& row : ReadGoldenCsv("helm/decisions.csv")) {
    const bool exact = row.at("set") == "wpt+" + behavior + "_exact";
    if (!exact && row.at("set") != "wpt+" + behavior + "_pieces") continue;
    const GoldenEncounter& at = encounters.at(row.at("state"));
    const std::vector<WeightedObjective> aims = {
        {.weight = 100, .objective = Waypoint(at)},
        {.weight = weights.at(row.at("state")), .objective = contact(at)}};
    const GridDecision decision = Decide(kDomain, aims);
    const DomainPoint theirs = {.course = static_cast<int>(Number(row, "course")),
                                .speed = static_cast<int>(std::lround(10 * Number(row, "speed")))};
    double utility_of_theirs = 0;
    for (const auto& [weight, objective] : aims) {
      utility_of_theirs += weight * ValueOf(objective, theirs);
    }
    EXPECT_GE(decision.utility, utility_of_theirs - 1e-9) << row.at("set") << row.at("state");
    if (!exact) {
      ++num_pieces;
      continue;
    }
    ++num_exact;
    const double best = Number(row, "best_weighted_sum");
    EXPECT_NEAR(decision.utility, best, 1e-4 * best) << row.at("state");
    EXPECT_EQ(decision.point, theirs) << row.at("state");
  }
  EXPECT_EQ(num_exact, 48);
  EXPECT_EQ(num_pieces, 48);
}

TEST(DecisionGolden, DecisionsToAvoidAreTheSameOnExactFunctionsAndBetterOnPieces) {
  CompareDecisions("avoid", Avoid);
}

TEST(DecisionGolden, DecisionsByTheRulesAreTheSameOnExactFunctionsAndBetterOnPieces) {
  CompareDecisions("colregs", Colregs);
}

}  // namespace shoal::decision_golden_test

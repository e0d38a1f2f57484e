// Contact functions and decisions against those of another helm (tests/golden/helm).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "lib/decision/cpa_function.h"
#include "lib/decision/decide.h"
#include "lib/decision/shapes.h"
#include "lib/geometry/angles.h"
#include "tests/golden/read_golden.h"

namespace shoal::decision_golden_test {

constexpr double kTolerance = 0.02;  // Of 100; two decimals are printed.

struct State {
  Eigen::Vector2d own_m = Eigen::Vector2d::Zero();
  double own_heading_deg = 0;
  Eigen::Vector2d contact_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d contact_mps = Eigen::Vector2d::Zero();
};

std::map<int, State> ReadStates() {
  std::map<int, State> states;
  for (const GoldenRow& row : ReadGoldenCsv("helm/states.csv")) {
    states[static_cast<int>(Number(row, "state"))] = {
        .own_m = {Number(row, "osx"), Number(row, "osy")},
        .own_heading_deg = Number(row, "osh"),
        .contact_m = {Number(row, "cnx"), Number(row, "cny")},
        .contact_mps = Number(row, "cnv") * UnitVector(DegToRad(Number(row, "cnh")))};
  }
  return states;
}

struct GoldenFunction {
  double weight = 0;
  std::vector<double> values = {};  ///< Courses 0, 10, ...; for each the speeds 0, 0.5, ... 4.
};

/// Those of one behavior, by state; states without a function are left out.
std::map<int, GoldenFunction> ReadFunctions(const std::string& behavior) {
  std::map<int, GoldenFunction> functions;
  for (const GoldenRow& row : ReadGoldenCsv("helm/functions.csv")) {
    if (row.at("behavior") != behavior || !row.contains("values")) continue;
    GoldenFunction function{.weight = Number(row, "weight")};
    std::istringstream values(row.at("values"));
    for (double value = 0; values >> value;) function.values.push_back(value);
    if (function.values.size() == 324) functions[static_cast<int>(Number(row, "state"))] = function;
  }
  return functions;
}

/// The contact parameters of the golden data: 8 m, 25 m, 120 s.
Objective Avoid(const State& state, const Domain& domain) {
  const CpaGrid cpa(state.contact_m - state.own_m, state.contact_mps, 120, domain);
  const double lo_m = cpa.range_m() <= 8 ? cpa.range_m() / 2 : 8;
  return NormaliseTo100(
      {.coupled = std::make_shared<CpaFunction>(cpa, CpaUtility{.lo_m = lo_m, .hi_m = 25})},
      domain);
}

/// Toward (100, 0) at 2 m/s.
Objective Waypoint(const State& state, const Domain& domain) {
  const double bearing_deg = RadToDeg(HeadingOf(Eigen::Vector2d(100, 0) - state.own_m));
  return Couple(SumOf(PeakOverCourse(bearing_deg, 0, 180),
                      PeakOverCourse(state.own_heading_deg, 30, 180, 5, 0, 20)),
                PeakOverAxis(domain.speed_mps, 2, 1, 1.6, 20), 50, 50);
}

double GreatestDifference(const Objective& ours, const GoldenFunction& golden) {
  double greatest = 0;
  for (size_t i = 0; i < golden.values.size(); ++i) {
    const int course = 10 * static_cast<int>(i / 9);
    const int speed = 5 * static_cast<int>(i % 9);
    greatest = std::max(greatest, std::abs(Value(ours, course, speed, 0) - golden.values[i]));
  }
  return greatest;
}

TEST(DecisionGolden, ContactFunctionsAreTheSame) {
  const auto functions = ReadFunctions("avoid_exact");
  const auto states = ReadStates();
  EXPECT_EQ(functions.size(), 48U);
  for (const auto& [state, golden] : functions) {
    EXPECT_LT(GreatestDifference(Avoid(states.at(state), {}), golden), kTolerance) << state;
  }
}

TEST(DecisionGolden, WaypointFunctionsAreTheSame) {
  const auto functions = ReadFunctions("waypoint_zaic");
  const auto states = ReadStates();
  EXPECT_EQ(functions.size(), 48U);
  for (const auto& [state, golden] : functions) {
    EXPECT_LT(GreatestDifference(Waypoint(states.at(state), {}), golden), kTolerance) << state;
  }
}

TEST(DecisionGolden, DecisionsAreAsGoodOrBetter) {
  const auto avoid = ReadFunctions("avoid_exact");
  const auto states = ReadStates();
  int num_exact = 0;
  int num_same_point = 0;
  for (const GoldenRow& row : ReadGoldenCsv("helm/decisions.csv")) {
    const bool exact = row.at("set") == "wpt+avoid_exact";
    if (!exact && row.at("set") != "wpt+avoid_pieces") continue;
    const int number = static_cast<int>(Number(row, "state"));
    const State& state = states.at(number);
    const Domain domain;
    std::vector<WeightedObjective> aims = {{.weight = 100, .objective = Waypoint(state, domain)}};
    if (avoid.contains(number)) {
      aims.push_back({.weight = avoid.at(number).weight, .objective = Avoid(state, domain)});
    }
    const Decision decision = Decide(domain, aims);
    const int course = static_cast<int>(Number(row, "course"));
    const int speed = static_cast<int>(std::lround(10 * Number(row, "speed")));
    double at_theirs = 0;
    for (const auto& [weight, objective] : aims) {
      at_theirs += weight * Value(objective, course, speed, 0);
    }
    EXPECT_GE(decision.utility, at_theirs - 1e-9) << row.at("set") << " " << number;
    if (!exact) continue;
    ++num_exact;
    const double best = Number(row, "best_weighted_sum");
    EXPECT_NEAR(decision.utility, best, 1e-4 * best) << number;
    num_same_point += decision.point == DomainPoint{.course = course, .speed = speed} ? 1 : 0;
  }
  EXPECT_EQ(num_exact, 48);
  EXPECT_EQ(num_same_point, 48);
}

}  // namespace shoal::decision_golden_test

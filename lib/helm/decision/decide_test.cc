#include "lib/helm/decision/decide.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "lib/helm/decision/decision_testing.h"

namespace shoal::decide_test {

using Aims = std::vector<WeightedObjective>;

double SumAt(const Aims& aims, int course, int speed) {
  double sum = 0;
  for (const auto& [weight, objective] : aims) {
    sum += weight * ValueOf(objective, course, speed, 0);
  }
  return sum;
}

struct Found {
  int course = 0;
  int speed = 0;
  double sum = 0;
};

/// Every point; the first of equal ones stays.
Found BruteForce(const Domain& domain, const Aims& aims) {
  Found best{.sum = SumAt(aims, 0, 0)};
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
      const double sum = SumAt(aims, course, speed);
      if (sum > best.sum) best = {.course = course, .speed = speed, .sum = sum};
    }
  }
  return best;
}

/// Every point that is allowed; the first of equal ones stays. Nothing: none is.
std::optional<Found> BruteForce(const Domain& domain, const Aims& aims,
                                const AllowedPart& allowed) {
  std::optional<Found> best;
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
      if (!allowed.speeds[static_cast<size_t>(course)].Has(speed)) continue;
      const double sum = SumAt(aims, course, speed);
      if (!best || sum > best->sum) best = {.course = course, .speed = speed, .sum = sum};
    }
  }
  return best;
}

/// Sectors with a range of speeds each; some with none.
AllowedPart DrawAllowed(Stream& stream, const Domain& domain) {
  AllowedPart allowed;
  IndexRange range;
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    if (course == 0 || stream.Uniform() < 0.05) {
      const int last_speed = domain.speed_mps.count - 1;
      range = {.first = IntBetween(stream, 0, last_speed),
               .last = IntBetween(stream, -1, last_speed)};
    }
    allowed.speeds.push_back(range);
  }
  return allowed;
}

/// One that goes somewhere, and 0 to 4 contacts to keep clear of.
Aims DrawAims(Stream& stream, const Domain& domain) {
  Aims aims;
  const double bearing_deg = Between(stream, 0, 360);
  aims.push_back({.weight = 100, .objective = GoToward(bearing_deg, 2, domain)});
  for (int i = IntBetween(stream, 0, 4); i > 0; --i) {
    aims.push_back({.weight = Between(stream, 0, 300),
                    .objective = KeepClear(DrawContact(stream), DrawUtility(stream), domain)});
  }
  return aims;
}

RC_GTEST_PROP(Decide, FindsTheBestPointOfBruteForce, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const Aims aims = DrawAims(stream, domain);
  const GridDecision decision = Decide(domain, aims);
  const Found best = BruteForce(domain, aims);
  RC_ASSERT(decision.point == (DomainPoint{.course = best.course, .speed = best.speed}));
  RC_ASSERT(std::abs(decision.utility - best.sum) < 1e-9);
}

RC_GTEST_PROP(Decide, FindsTheBestPointOfThoseThatAreAllowed, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const Aims aims = DrawAims(stream, domain);
  const AllowedPart allowed = DrawAllowed(stream, domain);
  const GridDecision decision = Decide(domain, aims, allowed);
  const Found whole = BruteForce(domain, aims);
  const std::optional<Found> best = BruteForce(domain, aims, allowed);
  const Found expected = best.value_or(whole);
  RC_ASSERT(decision.point == (DomainPoint{.course = expected.course, .speed = expected.speed}));
  RC_ASSERT(std::abs(decision.utility - expected.sum) < 1e-9);
  const bool is_held = expected.course != whole.course || expected.speed != whole.speed;
  RC_ASSERT(decision.wanted.has_value() == is_held);
  RC_CLASSIFY(is_held);
}

TEST(Decide, TakesWhatIsAllowedHoweverGreatAWeightIs) {
  const Domain domain = {.depth_m = {.first = 0, .step = 1, .count = 51}};
  Objective deep;
  for (int i = 0; i < 51; ++i) deep.depth.push_back(2 * i);
  const Aims aims = {{.weight = 1e6, .objective = GoToward(90, 2, domain)},
                     {.weight = 1e6, .objective = deep}};
  AllowedPart allowed = {.speeds = std::vector<IndexRange>(360, {.first = 0, .last = 40}),
                         .depths = IndexRange{.first = 3, .last = 30}};
  for (size_t course = 80; course <= 95; ++course) allowed.speeds[course] = {};
  const GridDecision decision = Decide(domain, aims, allowed);
  EXPECT_EQ(decision.point, (DomainPoint{.course = 96, .speed = 20, .depth = 30}));
  EXPECT_EQ(decision.wanted, (DomainPoint{.course = 90, .speed = 20, .depth = 50}));
  allowed.speeds.assign(360, {});  // None: then all.
  allowed.depths = IndexRange();
  EXPECT_EQ(Decide(domain, aims, allowed).point, *decision.wanted);
}

TEST(Restrict, KeepsWhatBothAllowUnlessNothingIsLeft) {
  AllowedPart allowed = {.depths = IndexRange{.first = 0, .last = 5}};
  const AllowedPart slow = {.speeds = std::vector<IndexRange>(360, {.first = 0, .last = 10})};
  Restrict(&allowed, slow);
  EXPECT_EQ(allowed.speeds, slow.speeds);
  Restrict(&allowed, {.speeds = std::vector<IndexRange>(360, {.first = 11, .last = 12}),
                      .depths = IndexRange{.first = 4, .last = 9}});
  EXPECT_EQ(allowed.speeds, slow.speeds);
  EXPECT_EQ(allowed.depths, (IndexRange{.first = 4, .last = 5}));
  Restrict(&allowed, {.speeds = std::vector<IndexRange>(360, {.first = 8, .last = 12})});
  EXPECT_EQ(allowed.speeds[7], (IndexRange{.first = 8, .last = 10}));
}

/// Small integers, so that sums are exact and ties are many.
Objective DrawSteps(Stream& stream, const Domain& domain) {
  const int steps = IntBetween(stream, 1, 4);
  Objective objective{.offset = 5.0 * IntBetween(stream, -1, 1), .scale = 1};
  if (stream.Uniform() < 0.5) {
    for (int i = 0; i < 360; ++i) objective.course.push_back(IntBetween(stream, -1, 1));
  }
  if (stream.Uniform() < 0.5) {
    for (int i = 0; i < domain.speed_mps.count; ++i) {
      objective.speed.push_back(IntBetween(stream, 0, 1));
    }
  }
  std::vector<double> values;
  for (int i = 0; i < 360 * domain.speed_mps.count; ++i) {
    values.push_back(IntBetween(stream, 0, steps));
  }
  objective.coupled =
      std::make_shared<TableFunction>(values, domain.speed_mps.count, IntBetween(stream, 0, 1));
  if (stream.Uniform() < 0.3) objective.scale = -1;
  return objective;
}

RC_GTEST_PROP(Decide, TakesTheLowestCourseThenTheLowestSpeedOfEquals, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  Aims aims;
  for (int i = IntBetween(stream, 1, 3); i > 0; --i) {
    aims.push_back({.weight = 1, .objective = DrawSteps(stream, domain)});
  }
  const Found best = BruteForce(domain, aims);
  const GridDecision decision = Decide(domain, aims);
  RC_ASSERT(decision.point == (DomainPoint{.course = best.course, .speed = best.speed}));
  RC_ASSERT(decision.utility == best.sum);
}

TEST(Decide, TakesTheLowerOfTwoMirroredCourses) {
  // Exactly head-on: port is as good as starboard.
  const Domain domain;
  const Objective clear =
      KeepClear({.offset_m = {0, 60}, .velocity_mps = {0, -1.5}}, {.lo_m = 8, .hi_m = 25}, domain);
  const Aims aims = {{.weight = 100, .objective = GoToward(0, 2, domain)},
                     {.weight = 200, .objective = clear}};
  const DomainPoint point = Decide(domain, aims).point;
  EXPECT_GT(*point.course, 0);
  EXPECT_LT(*point.course, 180);
  EXPECT_NEAR(SumAt(aims, *point.course, *point.speed),
              SumAt(aims, 360 - *point.course, *point.speed), 1e-9);
}

TEST(Decide, SettlesAPlateauOfEquals) {
  const Domain domain;
  const Aims aims = {{.weight = 200,
                      .objective = KeepClear({.offset_m = {0, 15}, .velocity_mps = {0, -1}},
                                             {.lo_m = 8, .hi_m = 25}, domain)}};
  const Found best = BruteForce(domain, aims);
  EXPECT_EQ(Decide(domain, aims).point, (DomainPoint{.course = best.course, .speed = best.speed}));
}

RC_GTEST_PROP(Decide, DoesNotDependOnTheOrderOfItsObjectives, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  Aims aims = DrawAims(stream, domain);
  const GridDecision decision = Decide(domain, aims);
  std::reverse(aims.begin(), aims.end());
  const GridDecision reversed = Decide(domain, aims);
  RC_ASSERT(reversed.point == decision.point);
  RC_ASSERT(reversed.utility == decision.utility);
  std::rotate(aims.begin(), aims.begin() + static_cast<ptrdiff_t>(aims.size() / 2), aims.end());
  RC_ASSERT(Decide(domain, aims).utility == decision.utility);
}

RC_GTEST_PROP(Decide, DoesNotDependOnACommonFactorOfTheWeights, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  Aims aims = DrawAims(stream, domain);
  const DomainPoint point = Decide(domain, aims).point;
  const double factor = Between(stream, 0.01, 50);
  for (WeightedObjective& aim : aims) aim.weight *= factor;
  RC_ASSERT(Decide(domain, aims).point == point);
}

RC_GTEST_PROP(Decide, IgnoresConstantsAndFlatObjectives, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  Aims aims = DrawAims(stream, domain);
  const GridDecision decision = Decide(domain, aims);
  for (WeightedObjective& aim : aims) aim.objective.offset += Between(stream, -1000, 1000);
  RC_ASSERT(Decide(domain, aims).point == decision.point);
  const size_t count = aims.size();
  aims.push_back({.weight = 150, .objective = {.course = std::vector<double>(360, 100)}});
  aims.push_back({.weight = 50, .objective = KeepClear({.offset_m = {900, 900}}, {}, domain)});
  RC_ASSERT(Decide(domain, aims).point == decision.point);
  aims.resize(count);
  aims.push_back({.weight = 0, .objective = GoToward(77, 1, domain)});
  aims.push_back({.weight = -5, .objective = GoToward(99, 1, domain)});
  RC_ASSERT(Decide(domain, aims).point == decision.point);
}

RC_GTEST_PROP(Decide, TurnsWithTheWorld, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const int turn_deg = IntBetween(stream, 0, 359);
  const double bearing_deg = Between(stream, 0, 360);
  Aims aims = {{.weight = 100, .objective = GoToward(bearing_deg, 2, domain)}};
  Aims turned = {{.weight = 100, .objective = GoToward(bearing_deg + turn_deg, 2, domain)}};
  const Eigen::Rotation2D<double> turn(
      DegToRad(static_cast<double>(-turn_deg)));  // Compass to maths.
  for (int i = IntBetween(stream, 1, 3); i > 0; --i) {
    const TestContact contact = DrawContact(stream);
    TestContact contact_turned = contact;
    contact_turned.offset_m = turn * contact.offset_m;
    contact_turned.velocity_mps = turn * contact.velocity_mps;
    const CpaUtility utility = DrawUtility(stream);
    aims.push_back({.weight = 200, .objective = KeepClear(contact, utility, domain)});
    turned.push_back({.weight = 200, .objective = KeepClear(contact_turned, utility, domain)});
  }
  const GridDecision decision = Decide(domain, aims);
  const GridDecision decision_turned = Decide(domain, turned);
  RC_ASSERT(std::abs(decision.utility - decision_turned.utility) < 1e-6);
  // Ties aside: where the course is another one, it must be as good.
  const int turned_back = (*decision_turned.point.course - turn_deg + 360) % 360;
  RC_ASSERT(std::abs(SumAt(aims, turned_back, *decision_turned.point.speed) - decision.utility) <
            1e-6);
}

RC_GTEST_PROP(Decide, FindsTheDepthOnItsOwn, ()) {
  Stream stream = AnyStream();
  Domain domain = SmallDomain(stream);
  domain.depth_m = {.first = 0, .step = 2, .count = 31};
  Aims aims = DrawAims(stream, domain);
  const GridDecision level = Decide(domain, aims);
  RC_ASSERT(!level.point.depth);
  aims[0].objective.depth = PeakOverAxis(domain.depth_m, Between(stream, 0, 60), 3, 30, 10);
  aims.push_back({.weight = Between(stream, 1, 200),
                  .objective = {.depth = AtMost(domain.depth_m, Between(stream, 0, 60), 20)}});
  int best = 0;
  const auto value_of_depth = [&](int depth) {
    return aims.front().weight * ValueOf(aims.front().objective, {.depth = depth}) +
           aims.back().weight * ValueOf(aims.back().objective, {.depth = depth});
  };
  for (int depth = 1; depth < 31; ++depth) {
    if (value_of_depth(depth) > value_of_depth(best)) best = depth;
  }
  const GridDecision decision = Decide(domain, aims);
  RC_ASSERT(decision.point.depth == best);
  RC_ASSERT(decision.point.course == level.point.course);
  RC_ASSERT(decision.point.speed == level.point.speed);
}

TEST(Decide, LeavesOutVariablesThatNoObjectiveMentions) {
  const Domain domain;
  EXPECT_EQ(Decide(domain, {}).point, DomainPoint());
  const Aims course = {{.weight = 1, .objective = {.course = PeakOverCourse(45, 10, 170, 25)}}};
  EXPECT_EQ(Decide(domain, course).point, (DomainPoint{.course = 45}));
  EXPECT_EQ(Decide(domain, course).utility, 100);
  const Aims speed = {
      {.weight = 1, .objective = {.speed = PeakOverAxis(domain.speed_mps, 1.3, 0, .2)}},
      {.weight = 0, .objective = {.course = PeakOverCourse(45, 10, 170, 25)}}};
  EXPECT_EQ(Decide(domain, speed).point, (DomainPoint{.speed = 13}));
}

TEST(Explain, NamesValueBestPointAndLossOfEachObjective) {
  const Domain domain{.depth_m = {.first = 0, .step = 1, .count = 11}};
  const Aims aims = {
      {.weight = 100, .objective = GoToward(90, 2, domain)},
      {.weight = 300, .objective = {.course = PeakOverCourse(200, 10, 100)}},
      {.weight = 50, .objective = {.depth = PeakOverAxis(domain.depth_m, 4, 0, 10)}},
  };
  const GridDecision decision = Decide(domain, aims);
  EXPECT_EQ(decision.point, (DomainPoint{.course = 190, .speed = 20, .depth = 4}));
  const auto explained = Explain(domain, aims, decision);
  ASSERT_EQ(explained.size(), 3U);
  EXPECT_EQ(explained[0].best_point, (DomainPoint{.course = 90, .speed = 20}));
  EXPECT_NEAR(explained[0].best_value, 100, 1e-9);
  EXPECT_NEAR(explained[0].value, 50 + 50 * 80.0 / 180, 1e-9);
  EXPECT_NEAR(explained[0].loss, 100 * 50 * 100.0 / 180, 1e-6);
  EXPECT_EQ(explained[1].best_point, (DomainPoint{.course = 190}));
  EXPECT_EQ(explained[1].loss, 0);
  EXPECT_EQ(explained[2].best_point, (DomainPoint{.depth = 4}));
}

RC_GTEST_PROP(Explain, FindsTheBestPointOfACoupledObjective, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const Aims aims = DrawAims(stream, domain);
  const GridDecision decision = Decide(domain, aims);
  const auto explained = Explain(domain, aims, decision);
  double sum = 0;
  for (size_t i = 0; i < aims.size(); ++i) {
    const Found best = BruteForce(domain, {{.weight = 1, .objective = aims[i].objective}});
    RC_ASSERT(std::abs(explained[i].best_value - best.sum) < 1e-9);
    RC_ASSERT(explained[i].best_point == (DomainPoint{.course = best.course, .speed = best.speed}));
    RC_ASSERT(explained[i].loss >= -1e-6);
    sum += aims[i].weight * explained[i].best_value - explained[i].loss;
  }
  RC_ASSERT(std::abs(sum - decision.utility) < 1e-6);
}

RC_GTEST_PROP(NormaliseTo100, SpansContactFunctionsExactly, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const Objective objective = KeepClear(DrawContact(stream), DrawUtility(stream), domain);
  double least = 1e9;
  double greatest = -1e9;
  for (int course = 0; course < 360; ++course) {
    for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
      least = std::min(least, ValueOf(objective, course, speed, 0));
      greatest = std::max(greatest, ValueOf(objective, course, speed, 0));
    }
  }
  if (objective.scale == 0) {
    RC_ASSERT(least == greatest);
  } else {
    RC_ASSERT(std::abs(least) < 1e-9);
    RC_ASSERT(std::abs(greatest - 100) < 1e-9);
  }
}

}  // namespace shoal::decide_test

#include "lib/helm/behaviors/leg_run.h"

#include <gtest/gtest.h>

#include <map>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::leg_run_test {

using Points = std::vector<Eigen::Vector2d>;

LegRunOptions North() {
  return {.p1 = Eigen::Vector2d(0, 0),
          .p2 = Eigen::Vector2d(0, 200),
          .speed = 2,
          .turn1_ext = 30,
          .turn2_ext = 30,
          .lead = 10,
          .repeat = 0};
}

/// Lets the vessel go where the behavior steers, 1 m a call, until it completes.
struct Voyage {
  explicit Voyage(const LegRunOptions& options) : leg_run(options) {
    vessel.own.motion.position_m = {0, -50};
  }

  bool Sail(int metres) {
    for (int i = 0; i < metres; ++i) {
      const BehaviorAnswer answer = vessel.Run(leg_run);
      for (const std::string& flag : answer.flags) ++flags[flag];
      if (states.empty() || states.back() != answer.state) states.push_back(answer.state);
      if (answer.completes) return true;
      const Eigen::Vector2d way_m = *answer.view.steers_for_m - vessel.own.motion.position_m;
      vessel.own.motion.position_m += way_m.normalized();
    }
    return false;
  }

  TestVessel vessel = {};
  LegRunBehavior leg_run;
  std::map<std::string, int> flags = {};
  std::vector<std::string> states = {};
};

TEST(LegRun, RunsThereTurnsAndComesBack) {
  Voyage run(North());
  EXPECT_TRUE(run.Sail(2000));
  EXPECT_EQ(run.states, std::vector<std::string>({"init", "leg1", "turn1", "leg2", ""}));
  EXPECT_LT((run.vessel.own.motion.position_m - Eigen::Vector2d(0, 0)).norm(), 4);
}

TEST(LegRun, SetsOffFlagsOncePerLegAndTurn) {
  Voyage run(North());
  ASSERT_TRUE(run.Sail(2000));
  EXPECT_EQ(run.flags, (std::map<std::string, int>({{"start_leg_flag", 2},
                                                    {"mid_flag", 2},
                                                    {"leg_end_flag", 2},
                                                    {"start_turn_flag", 1},
                                                    {"mid_turn_flag", 1},
                                                    {"end_turn_flag", 1}})));
}

TEST(LegRun, RunsFurtherRoundsAndForEver) {
  LegRunOptions options = North();
  options.repeat = 1;
  Voyage twice(options);
  EXPECT_TRUE(twice.Sail(4000));
  EXPECT_EQ(twice.flags["leg_end_flag"], 4);
  EXPECT_EQ(twice.flags["start_turn_flag"], 3);
  options.repeat = -1;
  Voyage for_ever(options);
  EXPECT_FALSE(for_ever.Sail(4000));
  EXPECT_GT(for_ever.flags["leg_end_flag"], 4);
}

TEST(LegRun, LaysItsTurnToTheSideOfItsBias) {
  LegRunOptions options = North();
  options.turn1_ext = 0;
  options.turn1_rad = 20;
  for (const double bias : {-100.0, 100.0}) {
    options.turn1_bias = bias;
    TestVessel vessel;
    LegRunBehavior leg_run(options);
    (void)vessel.RunAt(leg_run, {0, 0});
    const BehaviorAnswer answer = vessel.RunAt(leg_run, {0, 200});
    ASSERT_EQ(answer.state, "turn1");
    // p1, p2, then half a circle from p2 to 40 m beside it.
    const Points& points_m = answer.view.points_m;
    ASSERT_EQ(points_m.size(), 9U);
    EXPECT_TRUE(points_m[2].isApprox(Eigen::Vector2d(0, 200), 1e-9)) << points_m[2];
    const double side = bias > 0 ? 1 : -1;
    EXPECT_TRUE(points_m[5].isApprox(Eigen::Vector2d(20 * side, 220)));
    EXPECT_TRUE(points_m[8].isApprox(Eigen::Vector2d(40 * side, 200)));
  }
}

TEST(LegRun, HasASpeedOfItsOwnForEachLegByTurns) {
  LegRunOptions options = North();
  options.leg_spds = {1, 3};
  Voyage run(options);
  run.Sail(60);
  EXPECT_DOUBLE_EQ(run.vessel.Best(run.vessel.Run(run.leg_run)).speed_mps, 1);
  while (run.states.back() != "leg2") run.Sail(1);
  EXPECT_DOUBLE_EQ(run.vessel.Best(run.vessel.Run(run.leg_run)).speed_mps, 3);
}

TEST(LegRun, LeadsAlongItsLegs) {
  Voyage run(North());
  run.Sail(60);
  EXPECT_TRUE(
      run.vessel.RunAt(run.leg_run, {4, 100}).view.steers_for_m->isApprox(Eigen::Vector2d(0, 110)));
}

TEST(LegRun, GoesOnAfterAPauseAndBeginsAnewWithOtherEnds) {
  Voyage run(North());
  run.Sail(150);
  ASSERT_EQ(run.states.back(), "leg1");
  (void)run.leg_run.Idle(run.vessel.Inputs());
  EXPECT_EQ(run.vessel.Run(run.leg_run).state, "leg1");
  LegRunOptions other = North();
  other.p1 = Eigen::Vector2d(500, 0);
  run.leg_run.Reconfigure(other);
  EXPECT_EQ(run.vessel.Run(run.leg_run).state, "init");
}

TEST(LegRun, EndsALegPastTheLineThroughItsEndHoweverFarFromIt) {
  for (const bool has_line : {false, true}) {
    LegRunOptions options = North();
    options.capture_line = has_line;
    TestVessel vessel;
    LegRunBehavior leg_run(options);
    (void)vessel.RunAt(leg_run, {0, 0});
    (void)vessel.RunAt(leg_run, {50, 199});
    EXPECT_EQ(vessel.Run(leg_run).state, "leg1");
    EXPECT_EQ(vessel.RunAt(leg_run, {50, 201}).state, has_line ? "turn1" : "leg1");
  }
}

TEST(LegRun, CountsNoRadiusWhereTheLineAloneCounts) {
  LegRunOptions options = North();
  options.capture_line_only = true;
  TestVessel vessel;
  LegRunBehavior leg_run(options);
  (void)vessel.RunAt(leg_run, {0, -1});
  (void)vessel.RunAt(leg_run, {0, 1});
  EXPECT_EQ(vessel.RunAt(leg_run, {0, 199.9}).state, "leg1");
  EXPECT_EQ(vessel.RunAt(leg_run, {0, 200.1}).state, "turn1");
}

}  // namespace shoal::leg_run_test

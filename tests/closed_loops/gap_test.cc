// Followers between two walls, with a current along the walls: none touches, whatever the gap and
// the current; those that do not get through wait before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "tests/closed_loops/careful_auv.h"

namespace shoal::gap_test {

using Eigen::Vector3d;

constexpr double kWall_m = 400;    ///< x of the walls' near side, ...
constexpr double kBehind_m = 420;  ///< ... and of their far side.

struct Outcome {
  double nearest_m = 1e9;  ///< Of any follower's centre to a wall.
  int num_through = 0;
};

TargetTrackTask Follow(bool speed_along_bow) {
  TargetTrackTask task;
  task.speed_along_bow = speed_along_bow;
  task.track.law = VelocityCascade{
      {SurvivalLayer{.group = {.r_safe_m = 8, .r_avoid_m = 25, .r_pass_m = 10},
                     .sonar = {.r_avoid_m = 40, .r_pass_m = 10, .memory_s = 20}},
       FormationLayer{.r_safe_m = 8, .r_inner_m = 40, .r_follow_m = 60}, FeedForwardLayer{}}};
  return task;
}

/// Their leader goes through the middle of the gap at 1.5 m/s over ground.
Outcome PassGap(double gap_m, double current_mps, bool speed_along_bow = true) {
  SeaAround sea = {.current_mps = {0, current_mps, 0}};
  const double half_m = gap_m / 2;
  sea.walls_m = {{{kWall_m, half_m}, {kBehind_m, half_m}, {kBehind_m, 300}, {kWall_m, 300}},
                 {{kWall_m, -300}, {kBehind_m, -300}, {kBehind_m, -half_m}, {kWall_m, -half_m}}};
  const std::vector<Vector3d> starts_m = {{140, 30, 15}, {140, -30, 17}, {110, 60, 19}};
  std::vector<CarefulAuv> auvs;
  for (const Vector3d& start_m : starts_m) {
    const int id = static_cast<int>(auvs.size()) + 1;
    auvs.emplace_back(id, Follow(speed_along_bow), start_m, kPi / 2, 1.5, sea);
  }
  Outcome outcome;
  for (int step = 0; step < 8000 && outcome.num_through < std::ssize(auvs); ++step) {
    const double lead_m = 200 + 1.5 * step * CarefulAuv::kStep_s;
    std::vector<Neighbour> around = {
        {.id = 0, .position_m = {lead_m, 0, 20}, .velocity_mps = {1.5, 0, 0}}};
    for (const CarefulAuv& auv : auvs) around.push_back(auv.neighbour());
    outcome.num_through = 0;
    for (size_t i = 0; i < auvs.size(); ++i) {
      std::vector<Neighbour> others = around;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      auvs[i].Step(others, true);
      const Vector3d at_m = auvs[i].neighbour().position_m;
      if (at_m.x() > kBehind_m + 5) ++outcome.num_through;
      for (const Polygon& wall_m : sea.walls_m) {
        outcome.nearest_m = std::min(outcome.nearest_m, SignedDistance(wall_m, at_m.head<2>()));
      }
    }
  }
  return outcome;
}

// docs/vehicles/guidance.md has the table.
TEST(AGap, IsPassedWithoutContactOrWaitedBefore) {
  for (const double gap_m : {30.0, 60.0, 100.0}) {
    for (const double current_mps : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      const Outcome outcome = PassGap(gap_m, current_mps);
      EXPECT_GT(outcome.nearest_m, 3) << gap_m << " m, " << current_mps << " m/s";
      const bool is_easy = gap_m > 60 || (gap_m == 60 && current_mps < 0.5);
      EXPECT_GE(outcome.num_through, is_easy ? 3 : 0) << gap_m << " m, " << current_mps << " m/s";
      const std::string name =
          "gap_" + std::to_string(std::lround(gap_m)) + "_m_" + std::to_string(current_mps);
      RecordProperty(name, std::to_string(outcome.nearest_m) + " m, " +
                               std::to_string(outcome.num_through) + " through");
    }
  }
}

TEST(AGap, IsTooNarrowForAllOfTheSpeedWhereverTheBowPoints) {
  EXPECT_LT(PassGap(60, 0.6, /*speed_along_bow=*/false).nearest_m, 0) << "through the wall";
}

}  // namespace shoal::gap_test

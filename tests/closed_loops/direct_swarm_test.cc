// muNet's whole simulations without a network (tests/golden/munet/sim_direct_*), by shoal's model,
// autopilots and laws in the order of muNet's loop: each vehicle decides and moves in turn, and
// sees those before it where they have just arrived.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/vehicle/vehicle/contact.h"
#include "tests/closed_loops/golden_track.h"
#include "tests/closed_loops/munet_auv.h"

namespace shoal::direct_swarm_test {

constexpr double kLength_m = 1.6;

/// A leader on a path and its followers, by ids from 1 on.
class DirectSwarm {
 public:
  DirectSwarm(const std::vector<GoldenRow>& start, const std::vector<Eigen::Vector3d>& waypoints_m,
              const VelocityLaw& law) {
    for (const GoldenRow& row : start) {
      auvs.emplace_back(StateIn(row), Number(row, "psi"), Number(row, "z"));
      if (auvs.size() > 1) auvs.back().TakeTarget(law);
    }
    auvs.front().TakePath(waypoints_m, 1200);
  }

  /// `decide(auv, surroundings)` stands for a follower's guidance.
  template <class Decide>
  void Step(const Decide& decide) {
    auvs.front().DecideOnPath();
    auvs.front().Step(kSea);
    for (size_t i = 1; i < auvs.size(); ++i) {
      std::vector<Neighbour> group;
      for (size_t j = 1; j < auvs.size(); ++j) {
        if (j != i) group.push_back(auvs[j].AsNeighbour(static_cast<int>(j) + 1));
      }
      decide(auvs[i], Surroundings{.own = auvs[i].AsNeighbour(static_cast<int>(i) + 1),
                                   .target = auvs.front().AsNeighbour(1),
                                   .group = group,
                                   .seabed_z_m = kMunetSeabed_m});
      auvs[i].Step(kSea);
    }
    StopThoseInContact();
  }
  void Step() {
    Step([](MunetAuv& auv, const Surroundings& around) { auv.DecideOnTarget(around); });
  }

  std::vector<MunetAuv> auvs;

 private:
  static constexpr double kFloor_m = 200;
  const Remus100Environment kSea = {.floor_z_m = kFloor_m};

  void StopThoseInContact() {
    for (MunetAuv& a : auvs) {
      for (MunetAuv& b : auvs) {
        if (&a == &b) continue;
        if (InContact(a.position_m(), kLength_m, b.position_m(), kLength_m)) {
          a.state.immobilized = b.state.immobilized = true;
        }
      }
    }
  }
};

const std::vector<Eigen::Vector3d> kPath_m = {
    {0, 0, 20}, {200, 0, 25}, {300, 150, 30}, {300, 400, 20}};
const VelocityCascade kCascade{{SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}};
const ConstantBearingLaw kConstantBearing{.lookahead_m = 10, .r_safe_m = 10};

/// Where muNet's vehicles were, and how far from there shoal's are.
class Comparison {
 public:
  explicit Comparison(const std::string& name)
      : name_(name), golden_(ReadTracks("munet/sim_direct_" + name + ".csv")) {}

  const std::vector<GoldenRow>& start() const { return golden_.begin()->second; }

  /// Calls `look(step, rows)` at each step that has golden rows, and `swarm.Step()` in between.
  template <class Look, class... Decide>
  void Run(DirectSwarm* swarm, const Look& look, const Decide&... decide) const {
    for (int64_t step = 0; step <= golden_.rbegin()->first; ++step) {
      if (const auto found = golden_.find(step); found != golden_.end()) look(step, found->second);
      swarm->Step(decide...);
    }
  }

  template <class... Decide>
  void ExpectSameRun(DirectSwarm* swarm, const Decide&... decide) const {
    const auto look = [&](int64_t step, const std::vector<GoldenRow>& rows) {
      if (testing::Test::HasFailure()) return;
      for (size_t i = 0; i < rows.size(); ++i) {
        const std::string where =
            name_ + " step " + std::to_string(step) + " vehicle " + std::to_string(i + 1);
        ExpectState(swarm->auvs[i].state, rows[i], kSame, where);
      }
    };
    Run(swarm, look, decide...);
  }

 private:
  static constexpr double kSame = 1e-8;

  std::string name_;
  GoldenTracks golden_;
};

double FarthestApart(const DirectSwarm& swarm, const std::vector<GoldenRow>& rows) {
  double most_m = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    most_m = std::max(most_m, (swarm.auvs[i].position_m() - PositionIn(rows[i])).norm());
  }
  return most_m;
}

TEST(DirectSwarmAsMunet, ThreeFollowersKeepFormationOnTheSameTracks) {
  const Comparison munet("apf");
  DirectSwarm swarm(munet.start(), kPath_m, kCascade);
  munet.ExpectSameRun(&swarm);
}

// What is left of the distance: muNet's followers stand still, and forget their course, until their
// target first moves (DecideWithItsFaults). Shoal's set out at once.
TEST(DirectSwarmAsMunet, TwoFollowersByConstantBearingStayWithinAMetreOfItsTracks) {
  const Comparison munet("cb");
  DirectSwarm swarm(munet.start(), kPath_m, kConstantBearing);
  double most_m = 0;
  munet.Run(&swarm, [&](int64_t, const std::vector<GoldenRow>& rows) {
    most_m = std::max(most_m, FarthestApart(swarm, rows));
  });
  EXPECT_LT(most_m, 0.1);
  EXPECT_GT(most_m, 0.01) << "then they no longer set out before muNet's";
}

const std::vector<Eigen::Vector3d> kTowardEachOther_m = {{0, 0, 20}, {400, 0, 20}};

double Gap(const std::vector<GoldenRow>& rows) {
  return (PositionIn(rows[0]) - PositionIn(rows[1])).norm();
}

// Head on from 25 m, which no vehicle of this rudder can dodge. Inside r_safe shoal's turns away
// and muNet's comes closer.
TEST(DirectSwarmAsMunet, AHeadOnMeetingStaysWithinAMetreOfItsTracksUntilInsideTheSafeDistance) {
  const Comparison munet("contact");
  DirectSwarm swarm(munet.start(), kTowardEachOther_m, kConstantBearing);
  double most_m = 0;
  size_t num_compared = 0;
  munet.Run(&swarm, [&](int64_t, const std::vector<GoldenRow>& rows) {
    if (Gap(rows) < kConstantBearing.r_safe_m) return;
    most_m = std::max(most_m, FarthestApart(swarm, rows));
    ++num_compared;
  });
  EXPECT_GT(num_compared, 10U);
  EXPECT_LT(most_m, 0.5);
}

/// muNet's constant bearing with its faults, to show that they are all that is left: inside
/// r_safe, too, it closes in; for a target at rest it wants no velocity, which is the course East
/// whatever that was before; from a course West it turns there to port, -pi being where half a turn
/// is wrapped to.
void DecideWithItsFaults(MunetAuv& auv, const Surroundings& around) {
  constexpr double kMax_mps = 2.5;
  const Eigen::Vector3d v_t_mps = around.target->velocity_mps;
  if (v_t_mps.norm() == 0) {
    auv.DecideOnVelocity(Eigen::Vector3d::Zero(), -1e-15);
    return;
  }
  const Eigen::Vector3d offset_m = around.own.position_m - around.target->position_m;
  const Eigen::Vector3d los = offset_m.normalized();
  const double gap_m = std::abs(offset_m.norm() - kConstantBearing.r_safe_m);
  const double along_mps = v_t_mps.dot(los);
  const double u_a_mps =
      along_mps + std::sqrt(along_mps * along_mps + kMax_mps * kMax_mps - v_t_mps.squaredNorm());
  const double kappa_mps = u_a_mps * gap_m / std::hypot(kConstantBearing.lookahead_m, gap_m);
  auv.DecideOnVelocity(v_t_mps - kappa_mps * los, 0);
}

TEST(DirectSwarmAsMunet, WithItsFaultsOfConstantBearingTwoFollowersTakeTheSameTracks) {
  const Comparison munet("cb");
  DirectSwarm swarm(munet.start(), kPath_m, kConstantBearing);
  munet.ExpectSameRun(&swarm, DecideWithItsFaults);
}

TEST(DirectSwarmAsMunet, WithItsFaultsOfConstantBearingTwoVehiclesMeetAndStayWhereTheyTouched) {
  const Comparison munet("contact");
  DirectSwarm swarm(munet.start(), kTowardEachOther_m, kConstantBearing);
  munet.ExpectSameRun(&swarm, DecideWithItsFaults);
  EXPECT_TRUE(swarm.auvs[0].state.immobilized);
  EXPECT_TRUE(swarm.auvs[1].state.immobilized);
}

}  // namespace shoal::direct_swarm_test

// muNet's whole simulations by the processes of a mission: mission file, NAV and ACTUATORS over a
// bus. What is received in a step was published in the step before, so that every command takes
// effect one step of 0.02 s later than in muNet's loop (direct_swarm_test.cc has its order, and its
// numbers).
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/mission/file/load.h"
#include "tests/closed_loops/golden_track.h"
#include "tests/closed_loops/munet_auv.h"

namespace shoal::whole_swarm_test {

/// The options that make shoal behave as muNet.
constexpr char kAsMunet[] = R"(
[mission]
tick_s = 0.02
duration_s = 240

[environment]
floor = {style = "flat", depth_m = 200}

[template.auv]
type = "auv"
model = "remus100"
length_m = 1.6
remus100 = {parameters = "munet", depth_filter_s = 0}
helm_options = {deploy_at_start = true}

[[vehicle]]
name = "v1"
template = "auv"
start = {heading_deg = 90, depth_m = 20}

[[vehicle.task]]
kind = "path_follow"
points = [[0, 0, 20], [200, 0, 25], [300, 150, 30], [300, 400, 20]]
propeller_rpm = 1200
waypoint_switch = "along_track"
end = "go_on"
guard_crab = false
turn_crab = false
)";
const std::vector<Eigen::Vector3d> kPath_m = {
    {0, 0, 20}, {200, 0, 25}, {300, 150, 30}, {300, 400, 20}};

constexpr char kTrack[] = R"(
[[vehicle.task]]
kind = "target_track"
target = "v1"
compensate_current = false
speed_along_bow = false
climb_mps = 0
max_pitch_deg = 90
)";
constexpr char kByConstantBearing[] = R"(law = "constant_bearing"
lookahead_m = 10
)";

std::string Follower(const std::string& name, double x_m, double y_m, const std::string& law) {
  return "[[vehicle]]\nname = \"" + name +
         "\"\ntemplate = \"auv\"\nstart = {x_m = " + std::to_string(x_m) +
         ", y_m = " + std::to_string(y_m) + ", heading_deg = 90, depth_m = 20}\n" + kTrack + law;
}

const std::string kInFormation = kAsMunet + Follower("v2", -120, 0, "") +
                                 Follower("v3", -120, -48, "") + Follower("v4", -120, 48, "");
const std::string kOnTheBearing = kAsMunet + Follower("v2", -120, 0, kByConstantBearing) +
                                  Follower("v3", -120, -48, kByConstantBearing);

using Positions = std::vector<Eigen::Vector3d>;

/// Runs helms and simulators of a mission; `look(step, positions)` sees each step.
template <class Look>
void RunMission(const std::string& text, int64_t last_step, const Look& look) {
  const LoadedMission loaded = LoadMissionText(text, "as_munet.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  if (!loaded.errors.empty()) return;
  const Mission& mission = loaded.mission;
  MemoryBus hub;
  Bus& test_bus = hub.Join("test");
  std::vector<std::unique_ptr<App>> apps;
  Positions positions_m(mission.vehicles.size());
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    apps.push_back(std::make_unique<HelmApp>(mission, vehicle, hub.Join("helm_" + vehicle.name)));
    apps.push_back(
        std::make_unique<VehicleSimApp>(mission, vehicle, hub.Join("sim_" + vehicle.name)));
    Subscribe(test_bus, channels::Nav(vehicle.name), [&positions_m, i](const nav_t& nav) {
      positions_m[i] = {nav.x_m, nav.y_m, nav.z_m};
    });
  }
  // NAV of a step is here in the next.
  for (int64_t step = 0; step <= last_step + 1; ++step) {
    hub.NextStep();
    hub.HandleAll();
    if (step > 0) look(step - 1, positions_m);
    for (const auto& app : apps) app->Tick(step * mission.tick_us);
  }
}

/// Returns how far vehicles of a mission come from where muNet's are, at most.
double FarthestFromMunet(const std::string& file, const std::string& text) {
  const GoldenTracks golden = ReadTracks(file);
  double most_m = 0;
  RunMission(text, golden.rbegin()->first, [&](int64_t step, const Positions& positions_m) {
    const auto found = golden.find(step);
    if (found == golden.end()) return;
    ASSERT_EQ(found->second.size(), positions_m.size());
    for (size_t i = 0; i < positions_m.size(); ++i) {
      most_m = std::max(most_m, (positions_m[i] - PositionIn(found->second[i])).norm());
    }
  });
  return most_m;
}

// The autopilots look ahead to the step in which their commands take effect; guidance goes by where
// the vehicles were a step before. The next tests show that this is all.
TEST(WholeSwarmAsMunet, ThreeFollowersKeepFormationWithinAQuarterOfAMetreOfItsTracks) {
  EXPECT_LT(FarthestFromMunet("munet/sim_direct_apf.csv", kInFormation), 0.25);
}

TEST(WholeSwarmAsMunet, TwoFollowersByConstantBearingStayWithinAQuarterOfAMetreOfItsTracks) {
  EXPECT_LT(FarthestFromMunet("munet/sim_direct_cb.csv", kOnTheBearing), 0.25);
}

/// The laws by themselves, each decision put off by a step as between processes; the autopilots
/// look that step ahead (remus100_ahead.h).
class LateSwarm {
 public:
  LateSwarm(const Positions& start_m, const VelocityLaw& law) {
    for (const Eigen::Vector3d& each_m : start_m) {
      Remus100State state;
      state.eta.head<3>() = each_m;
      auvs_.emplace_back(state, 0, each_m.z());
      if (auvs_.size() > 1) auvs_.back().TakeTarget(law);
    }
    auvs_.front().TakePath(kPath_m, 1200);
  }

  void Step() {
    std::vector<Neighbour> seen;
    std::vector<MunetAuv> next = auvs_;  // By the commands of the step before.
    for (size_t i = 0; i < auvs_.size(); ++i) {
      seen.push_back(auvs_[i].AsNeighbour(static_cast<int>(i)));
      next[i].Step({});
      auvs_[i].seen_by_pilot = next[i].state;
    }
    for (size_t i = 0; i < auvs_.size(); ++i) {
      Decide(i, seen);
      auvs_[i].state = next[i].state;
    }
  }

  const MunetAuv& auv(size_t i) const { return auvs_.at(i); }

 private:
  void Decide(size_t i, const std::vector<Neighbour>& seen) {
    if (i == 0) {
      auvs_[i].DecideOnPath();
      return;
    }
    std::vector<Neighbour> group;
    for (size_t j = 1; j < seen.size(); ++j) {
      if (j != i) group.push_back(seen[j]);
    }
    auvs_[i].DecideOnTarget(
        {.own = seen[i], .target = seen[0], .group = group, .seabed_z_m = kMunetSeabed_m});
  }

  std::vector<MunetAuv> auvs_;
};

void ExpectLateLaws(const std::string& text, const Positions& start_m, const VelocityLaw& law) {
  constexpr int64_t kSteps = 3000;
  constexpr double kSame_m = 1e-6;
  LateSwarm swarm(start_m, law);
  RunMission(text, kSteps, [&](int64_t step, const Positions& positions_m) {
    if (testing::Test::HasFatalFailure()) return;
    for (size_t i = 0; i < positions_m.size(); ++i) {
      const double away_m = (positions_m[i] - swarm.auv(i).position_m()).norm();
      ASSERT_LT(away_m, kSame_m) << "step " << step << " vehicle " << i + 1;
    }
    swarm.Step();
  });
}

TEST(WholeSwarm, MovesInFormationAsItsLawsDoAStepLate) {
  ExpectLateLaws(kInFormation, {{0, 0, 20}, {-120, 0, 20}, {-120, -48, 20}, {-120, 48, 20}},
                 VelocityCascade{{SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}});
}

TEST(WholeSwarm, MovesByConstantBearingAsItsLawDoesAStepLate) {
  ExpectLateLaws(kOnTheBearing, {{0, 0, 20}, {-120, 0, 20}, {-120, -48, 20}},
                 ConstantBearingLaw{.lookahead_m = 10, .r_safe_m = 10});
}

}  // namespace shoal::whole_swarm_test

// Helm, simulator and navigation together: what becomes of an AUV that does not know where it is.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::navigation_loop_test {

/// What was seen at the end of a run, and on the way.
struct Seen {
  nav_t nav{};
  nav_t estimate{};
  navigation_t navigation{};
  std::string task;
  double highest_m = 1000;  ///< Least depth.

  double error_m() const { return std::hypot(nav.x_m - estimate.x_m, nav.y_m - estimate.y_m); }
};

/// Runs an AUV that starts 10 m down, out of reach of the floor, in an unknown current of 0.4 m/s.
Seen SeenAfter(const std::vector<Task>& tasks, double duration_s) {
  Mission mission;
  mission.seed = 4;
  mission.environment.current.speed_mps = "0.4";
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = Remus100Options{};
  vehicle.start = {.heading_deg = 90, .depth_m = 10};
  vehicle.helm_options.deploy_at_start = true;
  vehicle.tasks = tasks;
  vehicle.navigation.is_fitted = true;
  mission.vehicles = {vehicle};
  MemoryBus hub;
  HelmApp helm(mission, vehicle, hub.Join("helm_alpha"));
  VehicleSimApp sim(mission, vehicle, hub.Join("vehicle_sim_alpha"));
  Bus& test = hub.Join("test");
  Seen seen;
  Subscribe(test, channels::Nav("alpha"), [&](const nav_t& nav) {
    seen.nav = nav;
    seen.highest_m = std::min(seen.highest_m, nav.z_m);
  });
  Subscribe(test, channels::EstimatedNav("alpha"), [&](const nav_t& nav) { seen.estimate = nav; });
  Subscribe(test, channels::Navigation("alpha"),
            [&](const navigation_t& navigation) { seen.navigation = navigation; });
  Subscribe(test, channels::HelmState("alpha"),
            [&](const helm_state_t& state) { seen.task = state.task; });
  for (int64_t utime = 0; utime <= static_cast<int64_t>(duration_s * 1e6);
       utime += mission.tick_us) {
    hub.NextStep();
    hub.HandleAll();
    helm.Tick(utime);
    sim.Tick(utime);
  }
  hub.NextStep();
  hub.HandleAll();
  return seen;
}

const Task kLeg = {.name = "leg",
                   .what = PathFollowTask{.points_m = {{0, 0, 10}, {2000, 0, 10}}, .speed_mps = 2}};

TEST(NavigationLoop, IsCarriedOffByACurrentThatItDoesNotKnow) {
  const Seen seen = SeenAfter({kLeg}, 200);
  // 0.4 m/s for 200 s, less what the filter allows for; the bound shows that it does not know.
  EXPECT_GT(seen.error_m(), 40);
  EXPECT_GT(seen.navigation.ellipse_major_m, 40);
  EXPECT_EQ(seen.navigation.num_gps, 0);
}

TEST(NavigationLoop, ComesUpForFixesAndGoesOn) {
  const Seen seen = SeenAfter({{.name = "fix", .what = SurfaceForFixTask{.fixes = 40}}, kLeg}, 200);
  EXPECT_LT(seen.highest_m, 0.3);
  EXPECT_GE(seen.navigation.num_gps, 40);
  EXPECT_EQ(seen.task, "leg");
  EXPECT_GT(seen.nav.z_m, 5) << "it has gone down again";
  // The fixes show the current, too.
  EXPECT_LT(seen.error_m(), 20);
}

}  // namespace shoal::navigation_loop_test

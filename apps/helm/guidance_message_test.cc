// GUIDANCE of an underwater vehicle, and the events of its waypoints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::guidance_message_test {

/// An AUV that goes East at 2 m/s and 20 m of depth, whatever its helm wants, 5 m North of its
/// path.
class HelmOfAuv {
 public:
  explicit HelmOfAuv(const Vehicle& vehicle)
      : helm_bus_(hub_.Join("helm")), test_bus_(hub_.Join("test")), helm_({}, vehicle, helm_bus_) {
    Subscribe(test_bus_, channels::Guidance("alpha"),
              [this](const guidance_t& message) { messages.push_back(message); });
    Subscribe(test_bus_, channels::Desired("alpha"),
              [this](const desired_t& message) { desired = message; });
  }

  void Run(double duration_s) {
    for (int i = 0; i < std::lround(duration_s * 10); ++i) {
      hub_.NextStep();
      hub_.HandleAll();
      helm_.Tick(utime);
      nav_t nav{};
      nav.utime = utime;
      nav.x_m = 2 * static_cast<double>(utime) / 1e6;
      nav.y_m = 5;
      nav.z_m = 20;
      nav.heading_deg = 90;
      nav.course_over_ground_deg = 90;
      nav.speed_mps = nav.speed_over_ground_mps = nav.surge_mps = 2;
      nav.altitude_m = -1;
      Publish(test_bus_, channels::Nav("alpha"), nav);
      if (has_echo) {
        sonar_t ping{};
        ping.utime = utime;
        ping.max_range_m = 100;
        ping.beams = {{.azimuth_deg = 0, .elevation_deg = 0, .range_m = 20}};
        ping.num_beams = 1;
        Publish(test_bus_, channels::Sonar("alpha"), ping);
      }
      utime += 100'000;
    }
  }
  StatusPage Page() const { return helm_.Status(); }

  int64_t utime = 0;
  bool has_echo = false;
  std::vector<guidance_t> messages;
  desired_t desired{};

 private:
  MemoryBus hub_;
  Bus& helm_bus_;
  Bus& test_bus_;
  HelmApp helm_;
};

Vehicle Auv(const std::vector<VelocityLayer>& layers) {
  PathFollowTask path;
  path.points_m = {{0, 0, 20}, {40, 0, 20}, {1000, 0, 20}};
  path.cascade.layers = layers;
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = Remus100Options{};
  vehicle.sonar.is_fitted = true;
  vehicle.helm_options.deploy_at_start = true;
  vehicle.tasks = {{.name = "path", .what = path}};
  return vehicle;
}

TEST(GuidanceMessage, ComesOncePerSecondAndWhereTheWaypointChanges) {
  HelmOfAuv loop(Auv({}));
  loop.Run(5.05);
  const size_t before = loop.messages.size();
  EXPECT_GE(before, 5u);
  EXPECT_LE(before, 7u);
  EXPECT_EQ(loop.messages.back().task, "path");
  EXPECT_EQ(loop.messages.back().task_kind, "path_follow");
  EXPECT_EQ(loop.messages.back().waypoint_index, 1);
  loop.Run(15);
  const auto changed =
      std::find_if(loop.messages.begin(), loop.messages.end(),
                   [](const guidance_t& message) { return message.waypoint_index == 2; });
  ASSERT_NE(changed, loop.messages.end());
  EXPECT_LT(changed->utime - (changed - 1)->utime, 1'000'000) << "it does not wait for the second";
}

TEST(GuidanceMessage, HasWhatTheAutopilotsAreAskedFor) {
  HelmOfAuv loop(Auv({}));
  loop.Run(10.1);
  const guidance_t& last = loop.messages.back();
  EXPECT_NEAR(last.heading_deg, loop.desired.heading_deg, 0.2) << "DESIRED comes more often";
  EXPECT_EQ(last.depth_m, loop.desired.depth_m);
  EXPECT_EQ(last.speed_mps, 2);
  EXPECT_NEAR(last.cross_track_error_m, -5, 1e-9) << "to port of the leg";
  // The vehicle lies to port for 10 s: a current is taken to set to port, by about
  // gamma Delta y_e / sqrt(Delta^2 + y_e^2) = 0.0027 rad/s.
  EXPECT_NEAR(last.crab_deg, -10 * 0.154, 0.2);
  EXPECT_EQ(last.num_layers, 0);
}

TEST(GuidanceMessage, HasEachLayerWithItsWeight) {
  HelmOfAuv loop(Auv({SurvivalSonarLayer{.r_avoid_m = 40}}));
  loop.Run(3);
  ASSERT_EQ(loop.messages.back().num_layers, 2);
  EXPECT_EQ(loop.messages.back().layers[0].speed_mps, 0);
  EXPECT_EQ(loop.messages.back().layers[1].weight, 1);
  loop.has_echo = true;
  loop.Run(3);
  const guidance_t& last = loop.messages.back();
  ASSERT_EQ(last.num_layers, 2);
  EXPECT_EQ(last.u_max_mps, 2.5);
  EXPECT_EQ(last.layers[0].name, "sonar");
  EXPECT_NEAR(last.layers[0].speed_mps, 2.5 / 8, 1e-9);
  EXPECT_NEAR(last.layers[0].east_mps, -2.5 / 8, 1e-9);
  EXPECT_EQ(last.layers[0].weight, 1);
  EXPECT_EQ(last.layers[1].name, "waypoint");
  EXPECT_NEAR(last.layers[1].weight, 1 - 1.0 / 8, 1e-9);
  EXPECT_NE(loop.Page().text.find("sonar              asks for 0.31 m/s, weight 1.000"),
            std::string::npos)
      << loop.Page().text;
}

TEST(GuidanceMessage, IsNotPublishedBySurfaceCraft) {
  Vehicle vehicle = Auv({});
  vehicle.model = SurfaceCraftParams{};
  vehicle.tasks = {{.name = "way", .what = WaypointsTask{.points_m = {{100, 0}}}}};
  HelmOfAuv loop(vehicle);
  loop.Run(3);
  EXPECT_TRUE(loop.messages.empty());
}

TEST(Arrival, AtAWaypointIsAnEventOfTheHelm) {
  HelmOfAuv loop(Auv({}));
  loop.Run(20);
  EXPECT_NE(loop.Page().text.find("waypoint 2 of path reached, "), std::string::npos)
      << loop.Page().text;
}

}  // namespace shoal::guidance_message_test

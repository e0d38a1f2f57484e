// What underwater vehicles do when their tasks are done: whole missions with the model of a Remus
// 100, looked at from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/mission/model/mission.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "sim/simulation.h"

namespace shoal::endings_test {

/// A vehicle as it published itself last.
struct Seen {
  nav_t nav{};
  actuators_t actuators{};
  desired_t desired{};
  helm_state_t helm{};
};

/// Runs a mission; `look(time_s, seen)` sees each step. Returns how long it lasted.
double FlyMission(const std::string& text,
                  const std::function<void(double, const std::vector<Seen>&)>& look) {
  const LoadedMission loaded = LoadMissionText(text, "endings.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  if (!loaded.errors.empty()) return 0;
  const Mission& mission = loaded.mission;
  Simulation simulation(mission, "");
  std::vector<Seen> seen(mission.vehicles.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    const std::string& name = mission.vehicles[i].name;
    Subscribe(simulation.bus(), channels::Nav(name),
              [&seen, i](const nav_t& nav) { seen[i].nav = nav; });
    Subscribe(simulation.bus(), channels::Actuators(name),
              [&seen, i](const actuators_t& actuators) { seen[i].actuators = actuators; });
    Subscribe(simulation.bus(), channels::Desired(name),
              [&seen, i](const desired_t& desired) { seen[i].desired = desired; });
    Subscribe(simulation.bus(), channels::HelmState(name),
              [&seen, i](const helm_state_t& helm) { seen[i].helm = helm; });
  }
  double time_s = 0;
  while (simulation.Step()) {
    time_s = static_cast<double>(simulation.utime() - mission.start_utime) / 1e6;
    look(time_s, seen);
  }
  return time_s;
}

/// One AUV on a short path 20 m down.
std::string OneAuv(const std::string& options, const std::string& end, double duration_s,
                   const std::string& environment = "") {
  return "[mission]\nduration_s = " + std::to_string(duration_s) + "\n[environment]\n" +
         environment +
         "\n[[vehicle]]\nname = \"alpha\"\nmodel = \"remus100\"\n"
         "remus100 = {buoyancy_by_weight = 1.0}\n"
         "start = {heading_deg = 90, depth_m = 20, speed_mps = 1.5}\n"
         "helm_options = {deploy_at_start = true" +
         options +
         "}\n[[vehicle.task]]\nkind = \"path_follow\"\nspeed_mps = 2\n"
         "points = [[0, 0, 20], [150, 0, 20]]\nend = \"" +
         end + "\"\n";
}

constexpr char kCurrent[] = "current = {speed_mps = 0.4, direction_deg = 45}\n";

/// Returns the diameter of the circle of a vehicle with full rudder.
double TurningDiameter_m(const std::string& parameters, double rpm) {
  const Remus100 auv = BuildRemus100(*Remus100ParamsByName(parameters));
  Remus100State state;
  state.eta[2] = 20;
  for (int i = 0; i < 15'000; ++i) {
    state = Step(auv, state, {.rudder_rad = 1, .propeller_rpm = rpm}, {}, 0.02);
  }
  return 2 * state.velocity_mps.norm() / std::abs(state.nu[5]);
}

TEST(TurningCircle, IsNoWiderThanTheModelsFactsHaveIt) {
  const double most_m = FactsOf(Remus100Options()).turning_diameter_m;
  EXPECT_NEAR(TurningDiameter_m("default", 700), 42.5, 0.5);
  EXPECT_NEAR(TurningDiameter_m("default", 1500), 34.4, 0.5);
  EXPECT_NEAR(TurningDiameter_m("munet", 1000), 23.5, 0.5);
  EXPECT_NEAR(TurningDiameter_m("fossen", 700), most_m, 0.5);
}

Eigen::Vector2d PlaceOf(const nav_t& nav) { return {nav.x_m, nav.y_m}; }

/// What is asked of a vehicle at rest, from some time on.
struct Rest {
  double deepest_m = -1e9;
  double least_m = 1e9;
  double most_rpm = 0;
  double most_fin_deg = 0;  ///< Rudder or stern plane.

  void Look(const Seen& seen) {
    deepest_m = std::max(deepest_m, seen.nav.z_m);
    least_m = std::min(least_m, seen.nav.z_m);
    most_rpm = std::max(most_rpm, std::abs(seen.actuators.propeller_rpm));
    most_fin_deg = std::max({most_fin_deg, std::abs(seen.actuators.rudder_deg),
                             std::abs(seen.actuators.stern_plane_deg)});
  }
};

void ExpectRestAtTheSurface(const std::string& text) {
  double up_at_s = -1;
  Rest rest;
  const double end_s = FlyMission(text, [&](double time_s, const std::vector<Seen>& seen) {
    if (up_at_s < 0 && time_s > 60 && seen[0].nav.z_m < 0.5) up_at_s = time_s;
    if (up_at_s > 0 && time_s > up_at_s + 60) rest.Look(seen[0]);
  });
  ASSERT_GT(up_at_s, 0);
  ASSERT_GT(end_s, up_at_s + 360);
  EXPECT_EQ(rest.most_rpm, 0);
  EXPECT_LT(rest.most_fin_deg, 1);
  EXPECT_LT(rest.deepest_m, 0.5);
  EXPECT_LT(rest.deepest_m - rest.least_m, 0.05);
  testing::Test::RecordProperty("z_m", std::to_string(rest.least_m));
}

TEST(EndAtTheSurface, DriftsWithItsPropellerOffAfterAPathThatEndsThere) {
  ExpectRestAtTheSurface(OneAuv("", "surface", 560));
}

TEST(EndAtTheSurface, ComesUpWhereTheEndOfTasksIsTheSurface) {
  ExpectRestAtTheSurface(OneAuv(", end_of_tasks = \"surface\"", "done", 560, kCurrent));
}

/// How a vehicle kept its station from the end of its tasks on.
struct Station {
  double farthest_m = 0;
  double off_depth_m = 0;
  double turned_deg = 0;  ///< Full circles count 360 each.
  double way_s = 0;       ///< With the propeller on.
};

Station KeepStation(const std::string& text) {
  Station station;
  double since_s = -1;
  double last_heading_deg = 0;
  double turn_deg = 0;
  Eigen::Vector2d last_m(0, 0);
  double last_s = 0;
  const double end_s = FlyMission(text, [&](double time_s, const std::vector<Seen>& seen) {
    const nav_t& nav = seen[0].nav;
    if (seen[0].helm.task != "end_of_tasks") return;
    if (since_s < 0) {
      since_s = time_s;
      last_heading_deg = nav.heading_deg;
    }
    turn_deg += std::remainder(nav.heading_deg - last_heading_deg, 360);
    last_heading_deg = nav.heading_deg;
    station.turned_deg = std::max(station.turned_deg, std::abs(turn_deg));
    const Eigen::Vector2d point_m(seen[0].helm.waypoint_x_m, seen[0].helm.waypoint_y_m);
    station.farthest_m = std::max(station.farthest_m, (PlaceOf(nav) - point_m).norm());
    station.off_depth_m = std::max(station.off_depth_m, std::abs(nav.z_m - 20));
    if (seen[0].actuators.propeller_rpm > 0) station.way_s += time_s - last_s;
    last_s = time_s;
  });
  EXPECT_GT(since_s, 0);
  EXPECT_GT(end_s, since_s + 600);
  return station;
}

TEST(EndOfTasks, StaysWhereItCameToRestInStillWater) {
  const Station station = KeepStation(OneAuv("", "done", 700));
  EXPECT_LT(station.farthest_m, 8);
  EXPECT_LT(station.off_depth_m, 1);
  EXPECT_LT(station.turned_deg, 30);
  RecordProperty("farthest_m", std::to_string(station.farthest_m));
  RecordProperty("off_depth_m", std::to_string(station.off_depth_m));
  RecordProperty("turned_deg", std::to_string(station.turned_deg));
  RecordProperty("way_s", std::to_string(station.way_s));
}

/// Returns the greatest distance from 20 m of depth of each vehicle, from `from_s` on.
std::vector<double> OffDepth(const std::string& text, double from_s) {
  std::vector<double> off_m;
  FlyMission(text, [&](double time_s, const std::vector<Seen>& seen) {
    off_m.resize(seen.size());
    for (size_t i = 0; i < seen.size() && time_s > from_s; ++i) {
      off_m[i] = std::max(off_m[i], std::abs(seen[i].nav.z_m - 20));
    }
  });
  return off_m;
}

/// AUVs that keep a place by a task, an order, a return and the end of a path.
std::string FourWaysToStay(const std::string& environment, double buoyancy_by_weight) {
  std::string text =
      "[mission]\nduration_s = 500\n[environment]\n" + environment +
      "[template.auv]\nmodel = \"remus100\"\nhelm_options = {deploy_at_start = true}\n"
      "remus100 = {cruise_depth_m = 20, buoyancy_by_weight = " +
      std::to_string(buoyancy_by_weight) + "}\n";
  const auto add = [&](const std::string& name, const std::string& task) {
    text += "[[vehicle]]\nname = \"" + name +
            "\"\ntemplate = \"auv\"\nstart = {heading_deg = 90, depth_m = 20}\n"
            "[[vehicle.task]]\n" +
            task + "\n";
  };
  add("task", "kind = \"station_keep\"");
  add("order", "kind = \"path_follow\"\npoints = [[0, 0, 20], [900, 0, 20]]");
  add("home", "kind = \"return\"");
  add("path", "kind = \"path_follow\"\npoints = [[0, 0, 20], [90, 0, 20]]\nend = \"hold\"");
  return text + "[[event]]\nat_s = 60\nvehicle = \"order\"\ncommand = \"station_keep\"\n";
}

TEST(AVehicleThatStays, KeepsItsDepthWithinAMetreByTaskOrderReturnAndPath) {
  for (const std::string environment : {"", kCurrent}) {
    for (const double buoyancy_by_weight : {1.0, 1.005, 1.01}) {
      const std::vector<double> off_m =
          OffDepth(FourWaysToStay(environment, buoyancy_by_weight), 0);
      for (size_t i = 0; i < off_m.size(); ++i) {
        EXPECT_LT(off_m[i], 1) << "vehicle " << i << ", buoyancy " << buoyancy_by_weight
                               << (environment.empty() ? "" : ", in a current");
      }
    }
  }
}

TEST(AVehicleThatStays, GoesToTheDepthOfItsTasksFirst) {
  const std::string text =
      "[mission]\nduration_s = 500\n[[vehicle]]\nname = \"alpha\"\nmodel = \"remus100\"\n"
      "helm_options = {deploy_at_start = true}\nremus100 = {cruise_depth_m = 20}\n"
      "[[vehicle.task]]\nkind = \"station_keep\"\n";
  EXPECT_LT(OffDepth(text, 200).at(0), 1);
}

TEST(AtTheSurface, AParkedVehicleAndOneThatKeepsItsPlaceHaveTheirAntennasOut) {
  const auto expect_up = [](const std::string& text) {
    double deepest_m = 0;
    FlyMission(text, [&](double, const std::vector<Seen>& seen) {
      deepest_m = std::max(deepest_m, seen[0].nav.z_m);
    });
    EXPECT_LT(deepest_m, 0.2);
  };
  for (const std::string buoyancy : {"1.0", "1.005"}) {
    for (const std::string deploy : {"true", "false"}) {
      expect_up(
          "[mission]\nduration_s = 300\n[[vehicle]]\nname = \"alpha\"\n"
          "model = \"remus100\"\nremus100 = {buoyancy_by_weight = " +
          buoyancy + "}\nhelm_options = {deploy_at_start = " + deploy +
          "}\n[[vehicle.task]]\nkind = \"station_keep\"\n");
    }
  }
}

TEST(EndOfTasks, KeepsItsStationInACurrentWithoutCircling) {
  const Station station = KeepStation(OneAuv("", "done", 700, kCurrent));
  EXPECT_LT(station.farthest_m, 90);
  EXPECT_LT(station.off_depth_m, 2);
  EXPECT_LT(station.turned_deg, 300);
  EXPECT_GT(station.way_s, 10);
  EXPECT_LT(station.way_s, 300);
  RecordProperty("farthest_m", std::to_string(station.farthest_m));
  RecordProperty("off_depth_m", std::to_string(station.off_depth_m));
  RecordProperty("turned_deg", std::to_string(station.turned_deg));
  RecordProperty("way_s", std::to_string(station.way_s));
}

TEST(EndOfTasks, GoesOnOnItsCourseAtItsDepth) {
  Eigen::Vector2d from_m(0, 0);
  Seen last;
  double since_s = -1;
  FlyMission(OneAuv(", end_of_tasks = \"go_on\"", "done", 400, kCurrent),
             [&](double time_s, const std::vector<Seen>& seen) {
               last = seen[0];
               if (since_s >= 0 || last.helm.task != "end_of_tasks") return;
               since_s = time_s;
               from_m = PlaceOf(last.nav);
             });
  EXPECT_GT(last.nav.x_m, from_m.x() + 400);
  EXPECT_NEAR(last.nav.y_m, from_m.y(), 20);
  EXPECT_NEAR(last.nav.z_m, 20, 0.5);
  EXPECT_NEAR(last.nav.speed_mps, 2, 0.1);
}

TEST(EndOfTasks, LoitersAboutItsLastPlaceAtItsDepth) {
  std::vector<double> distances_m;
  double off_depth_m = 0;
  double since_s = -1;
  Eigen::Vector2d center_m(0, 0);
  FlyMission(OneAuv(", end_of_tasks = \"loiter\"", "done", 700),
             [&](double time_s, const std::vector<Seen>& seen) {
               if (seen[0].helm.task != "end_of_tasks") return;
               if (since_s < 0) {
                 since_s = time_s;
                 center_m = PlaceOf(seen[0].nav);
               }
               off_depth_m = std::max(off_depth_m, std::abs(seen[0].nav.z_m - 20));
               if (time_s > since_s + 120)
                 distances_m.push_back((PlaceOf(seen[0].nav) - center_m).norm());
             });
  ASSERT_GT(distances_m.size(), 1000U);
  const auto [least_m, most_m] = std::minmax_element(distances_m.begin(), distances_m.end());
  EXPECT_GT(*least_m, 35);
  EXPECT_LT(*most_m, 60);
  EXPECT_LT(off_depth_m, 0.5);
}

TEST(EndOfTasks, EndsTheMissionWhenItsVehiclesAreDone) {
  const std::string second =
      "[[vehicle]]\nname = \"bravo\"\nmodel = \"remus100\"\n"
      "start = {x_m = 0, y_m = 200, heading_deg = 90, depth_m = 20}\n"
      "helm_options = {deploy_at_start = true, end_of_tasks = \"end_mission\"}\n"
      "[[vehicle.task]]\nkind = \"path_follow\"\nspeed_mps = 2\n"
      "points = [[0, 200, 20], [300, 200, 20]]\n";
  const std::string option = ", end_of_tasks = \"end_mission\"";
  const double alone_s = FlyMission(OneAuv(option, "done", 700), [](double, const auto&) {});
  const double both_s =
      FlyMission(OneAuv(option, "done", 700) + second, [](double, const auto&) {});
  EXPECT_NEAR(alone_s, 75, 10);
  EXPECT_NEAR(both_s, 150, 15);
}

TEST(TasksAtDepth, BeginAndEndWithoutAJumpOfTheDesiredDepth) {
  const std::string orders =
      "[[event]]\nat_s = 40\nvehicle = \"alpha\"\ncommand = \"station_keep\"\n"
      "[[event]]\nat_s = 120\nvehicle = \"alpha\"\ncommand = \"deploy\"\n"
      "[[event]]\nat_s = 300\nvehicle = \"alpha\"\ncommand = \"deploy\"\n";
  std::string task;
  int num_tasks = 0;
  double before_m = 20;
  double largest_jump_m = 0;
  double off_depth_m = 0;
  FlyMission(OneAuv("", "done", 500, kCurrent) + orders,
             [&](double time_s, const std::vector<Seen>& seen) {
               if (time_s < 1) return;  // DESIRED begins with the second NAV.
               if (seen[0].helm.task != task) ++num_tasks;
               task = seen[0].helm.task;
               const double now_m = seen[0].desired.depth_m;
               largest_jump_m = std::max(largest_jump_m, std::abs(now_m - before_m));
               before_m = now_m;
               off_depth_m = std::max(off_depth_m, std::abs(seen[0].nav.z_m - 20));
             });
  EXPECT_GE(num_tasks, 6) << "path, station, path, end, path, end";
  EXPECT_LT(largest_jump_m, 0.3);
  EXPECT_LT(off_depth_m, 0.3);
  RecordProperty("largest_jump_m", std::to_string(largest_jump_m));
  RecordProperty("off_depth_m", std::to_string(off_depth_m));
}

/// A leader that comes up, and followers.
std::string SwarmThatComesUp(const std::string& knowledge) {
  std::string text =
      "[mission]\nduration_s = 700\n[environment]\n"
      "current = {speed_mps = 0.3, direction_deg = 30}\n"
      "floor = {style = \"flat\", depth_m = 80}\n";
  if (knowledge == "acoustic") {
    text +=
        "[acoustics]\naccess_mode = \"fdma\"\n[swarm]\nleader = \"alpha\"\n"
        "scheduler = \"fdma_lf\"\nepisode_s = 5\n";
  }
  text +=
      "[template.auv]\nmodel = \"remus100\"\nhelm_options = {deploy_at_start = true}\n"
      "[[vehicle]]\nname = \"alpha\"\ntemplate = \"auv\"\n"
      "start = {x_m = 0, y_m = 0, heading_deg = 90, depth_m = 20, speed_mps = 1.5}\n"
      "[[vehicle.task]]\nkind = \"path_follow\"\nspeed_mps = 1.5\nend = \"surface\"\n"
      "points = [[0, 0, 20], [300, 0, 25]]\n";
  const std::vector<Eigen::Vector2d> places_m = {{-85, -42}, {-85, 42}, {-110, 0}};
  for (size_t i = 0; i < places_m.size(); ++i) {
    text += "[[vehicle]]\nname = \"follower" + std::to_string(i) +
            "\"\ntemplate = \"auv\"\nstart = {x_m = " + std::to_string(places_m[i].x()) +
            ", y_m = " + std::to_string(places_m[i].y()) +
            ", heading_deg = 90, depth_m = 20, speed_mps = 1.5}\n"
            "[[vehicle.task]]\nkind = \"target_track\"\ntarget = \"alpha\"\nswarm = \"" +
            knowledge + "\"\n";
  }
  return text;
}

class EndOfTheLeader : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Swarm, EndOfTheLeader, testing::Values("direct", "acoustic"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(EndOfTheLeader, BringsItsFollowersToTheSurfaceWhereTheyDriftApartFromEachOther) {
  std::vector<Rest> rests(4);
  double closest_m = 1e9;
  FlyMission(SwarmThatComesUp(GetParam()), [&](double time_s, const std::vector<Seen>& seen) {
    for (size_t i = 0; i < seen.size() && time_s > 1; ++i) {
      for (size_t k = 0; k < i; ++k) {
        closest_m = std::min(closest_m, (PlaceOf(seen[i].nav) - PlaceOf(seen[k].nav)).norm());
      }
    }
    for (size_t i = 0; i < seen.size() && time_s > 500; ++i) rests[i].Look(seen[i]);
  });
  for (const Rest& rest : rests) {
    EXPECT_LT(rest.deepest_m, 0.5);
    EXPECT_EQ(rest.most_rpm, 0);
    EXPECT_LT(rest.most_fin_deg, 1);
  }
  EXPECT_GT(closest_m, 15);
  RecordProperty("closest_m", std::to_string(closest_m));
}

/// An AUV that nothing has deployed, and a mast that it reports to by radio.
constexpr char kParked[] = R"(
[mission]
duration_s = 120
seed = 5

[comms]
comms_range = "nolimit"
reports_over = "vhf"

[[medium]]
name = "vhf"
kind = "radio"
range_m = 2000

[[vehicle]]
name = "alpha"
model = "remus100"
length_m = 1.6
start = {x_m = 50, y_m = 0, heading_deg = 90}
navigation = {grade = "survey"}

[[vehicle.task]]
kind = "station_keep"

[[vehicle]]
name = "shore"
model = "buoy"
type = "shore"
start = {x_m = 0, y_m = 0}
antenna_height_m = 10
)";

TEST(AParkedAuv, FloatsWithItsAntennasOutSoThatReportsAndFixesCome) {
  const LoadedMission loaded = LoadMissionText(kParked, "parked.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  ASSERT_TRUE(loaded.errors.empty());
  Simulation simulation(loaded.mission, "");
  int num_reports = 0;
  int num_delivered = 0;
  Subscribe(simulation.bus(), channels::CommsFates(), [&](const comms_fates_t& fates) {
    for (const fate_t& fate : fates.fates) {
      if (fate.kind != "report") continue;
      ++num_reports;
      if (fate.cause == "delivered") ++num_delivered;
    }
  });
  navigation_t navigation{};
  Subscribe(simulation.bus(), channels::Navigation("alpha"),
            [&](const navigation_t& each) { navigation = each; });
  double deepest_m = 0;
  Subscribe(simulation.bus(), channels::Nav("alpha"),
            [&](const nav_t& nav) { deepest_m = std::max(deepest_m, nav.z_m); });
  while (simulation.Step()) {
  }
  EXPECT_LT(deepest_m, 0.3);
  EXPECT_GT(num_reports, 400);  // Both report twice a second.
  EXPECT_EQ(num_delivered, num_reports);
  EXPECT_GT(navigation.num_gps, 100);
}

}  // namespace shoal::endings_test

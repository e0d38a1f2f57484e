#include "sim/simulation.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/mission/load.h"

namespace shoal {
namespace {

Mission Load(const std::string& text) {
  LoadedMission loaded = LoadMissionText(text, "test.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

constexpr char kTwoVessels[] = R"(
[mission]
duration_s = 30
[comms]
comms_range = 80
[[vehicle]]
name = "alpha"
start = { x_m = 0, y_m = 0, heading_deg = 90 }
helm_options = { deploy_at_start = true }
[[vehicle.task]]
name = "go"
kind = "waypoints"
points = [[40, 0]]
speed_mps = 2
[[vehicle]]
name = "bravo"
start = { x_m = 100, y_m = 0, heading_deg = 0 }
[[expect]]
kind = "reports"
from = "alpha"
to = "bravo"
at_least = 1
)";

TEST(Simulation, TakesEveryStepFromTheFirstToTheLast) {
  const Mission mission = Load(kTwoVessels);
  Simulation simulation(mission, "");
  int64_t steps = 0;
  while (simulation.Step()) ++steps;
  EXPECT_EQ(steps, 301);
  EXPECT_FALSE(simulation.Step());
}

TEST(Simulation, LetsVesselsReceiveEachOtherOnlyWithinRange) {
  const Mission mission = Load(kTwoVessels);
  Simulation simulation(mission, "");
  while (simulation.Step()) {
  }
  EXPECT_TRUE(simulation.Passed()) << simulation.Summary();
  EXPECT_GT(simulation.num_blocked(), 0) << "at first they are 100 m apart, with a range of 80 m";
}

TEST(Simulation, CountsAFatePerReportAndDestination) {
  const Mission mission = Load(kTwoVessels);
  Simulation simulation(mission, "");
  while (simulation.Step()) {
  }
  // Two vessels, 2 reports per second: each is offered to the other once both are known.
  const int64_t offered = simulation.num_delivered() + simulation.num_blocked();
  EXPECT_NEAR(static_cast<double>(offered), 2 * 2 * 30, 4);
}

TEST(EveryMission, OfShoalsOwnPasses) {
  int num_missions = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHOAL_SOURCE_DIR) + "/missions")) {
    const LoadedMission loaded = LoadMission(entry.path().string());
    ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
    if (!CanRunInOneProcess(loaded.mission).ok()) continue;
    Simulation simulation(loaded.mission, "");
    while (simulation.Step()) {
    }
    EXPECT_TRUE(simulation.Passed()) << entry.path() << "\n" << simulation.Summary();
    ++num_missions;
  }
  EXPECT_GE(num_missions, 3);
}

TEST(CanRunInOneProcess, RefusesAUsersOwnParticipants) {
  const Mission mission =
      Load(std::string(kTwoVessels) + "[[participant]]\nname = \"mine\"\ncommand = [\"./mine\"]\n");
  const Result<bool> can = CanRunInOneProcess(mission);
  ASSERT_FALSE(can.ok());
  EXPECT_NE(can.error().find("mine is not one of shoal's own"), std::string::npos);
}

}  // namespace
}  // namespace shoal

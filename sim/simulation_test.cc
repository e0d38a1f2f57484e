#include "sim/simulation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/run/run/log_plan.h"

namespace shoal::simulation_test {

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

TEST(Simulation, WritesALogOfAboutTheSizeThatIsExpected) {
  const Mission mission = Load(kTwoVessels);
  const std::string path = ::testing::TempDir() + "simulation_test_size.lcm";
  for (const ChannelChoice& choice :
       {ChannelChoice{}, ChannelChoice{.only = {"NAV_*"}}, ChannelChoice{.without = {"NAV_*"}}}) {
    Simulation simulation(mission, path, choice);
    while (simulation.Step()) {
    }
    simulation.End();
    const auto size = static_cast<double>(std::filesystem::file_size(path));
    const double expected = EstimateLog_bytes(mission, choice);
    EXPECT_LT(expected, 1.5 * size);
    EXPECT_GT(expected, size / 1.5);
  }
  std::filesystem::remove(path);
}

TEST(Simulation, LetsVesselsReceiveReportsOnlyWithinRange) {
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

std::string FileOf(const std::string& text, const std::string& name) {
  const std::string path = testing::TempDir() + "/simulation_test_" + name;
  std::ofstream(path) << text;
  return path;
}

std::string ContentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(Simulation, NamesEveryErrorOfAMissionFile) {
  const auto opened = Simulation::Open(
      {.mission_file = FileOf("[mission]\nduration_s = -1\n[comms]\nrange = 3\n", "bad.toml")});
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().find("bad.toml:2:"), std::string::npos) << opened.error();
  EXPECT_NE(opened.error().find("bad.toml:4:"), std::string::npos) << opened.error();
  EXPECT_NE(Simulation::Open({.mission_file = "/nowhere.toml"}).error().find("/nowhere.toml"),
            std::string::npos);
}

TEST(Simulation, NamesALogThatCannotBeWritten) {
  const auto opened = Simulation::Open(
      {.mission_file = FileOf(kTwoVessels, "good.toml"), .log_path = "/nowhere/at/all.lcm"});
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().find("/nowhere/at/all.lcm"), std::string::npos) << opened.error();
}

TEST(Simulation, TakesItsSeedAndOverrides) {
  const auto opened = Simulation::Open({.mission_file = FileOf(kTwoVessels, "seed.toml"),
                                        .overrides = {"comms.comms_range=50"},
                                        .seed = 77});
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->mission().seed, 77U);
  EXPECT_EQ(opened->mission().comms.comms_range_m, 50);
}

TEST(Simulation, HandsTheEmbedderWhatWasPublishedInTheStepBefore) {
  Simulation simulation(Load(kTwoVessels), "");
  std::vector<int64_t> utimes;
  Subscribe(simulation.bus(), channels::Nav("alpha"),
            [&](const nav_t& nav) { utimes.push_back(nav.utime); });
  ASSERT_TRUE(simulation.Step());
  EXPECT_TRUE(utimes.empty());
  ASSERT_TRUE(simulation.Step());
  EXPECT_EQ(utimes, (std::vector<int64_t>{simulation.utime() - 100'000}));
}

TEST(Simulation, CarriesOutCommandsOfTheEmbedder) {
  Simulation simulation(Load(kTwoVessels), "");
  std::string state;
  Subscribe(simulation.bus(), channels::HelmState("bravo"),
            [&](const helm_state_t& helm) { state = helm.state; });
  for (int i = 0; i < 20; ++i) simulation.Step();
  EXPECT_EQ(state, "PARK");
  helm_command_t command{};
  command.utime = simulation.utime();
  command.command = "deploy";
  Publish(simulation.bus(), channels::HelmCommand("bravo"), command);
  for (int i = 0; i < 20; ++i) simulation.Step();
  EXPECT_EQ(state, "DRIVE");
}

TEST(Simulation, WritesTheSameLogWhereTheEmbedderOnlySubscribes) {
  const std::string alone = testing::TempDir() + "/simulation_test_alone.lcm";
  const std::string watched = testing::TempDir() + "/simulation_test_watched.lcm";
  {
    Simulation simulation(Load(kTwoVessels), alone);
    while (simulation.Step()) {
    }
  }
  int64_t num_received = 0;
  {
    Simulation simulation(Load(kTwoVessels), watched);
    Subscribe(simulation.bus(), channels::CommsFates(),
              [&](const comms_fates_t&) { ++num_received; });
    while (simulation.Step()) {
    }
  }
  EXPECT_GT(num_received, 0);
  EXPECT_FALSE(ContentOf(alone).empty());
  EXPECT_TRUE(ContentOf(alone) == ContentOf(watched));
}

/// alpha's helm crashes after 5 s; bravo sails on.
Mission WithACrash(const std::string& on_loss, int duration_s = 30) {
  std::string text = kTwoVessels;
  text.replace(text.find("duration_s = 30"), 15,
               fmt::format("duration_s = {}\non_loss = \"{}\"", duration_s, on_loss));
  text.replace(text.find("[[vehicle]]\nname = \"bravo\""), 11,
               "[[vehicle.behavior]]\nname = \"fault\"\nkind = \"test_failure\"\nduration = 5\n"
               "[[vehicle]]");
  return Load(text);
}

/// Counts the helm's messages by the whole second.
std::map<int64_t, int> ActuatorsOfAlpha(Simulation* simulation) {
  std::map<int64_t, int> counts;
  Subscribe(simulation->bus(), channels::Actuators("alpha"),
            [&](const actuators_t& actuators) { ++counts[actuators.utime / 1'000'000]; });
  while (simulation->Step()) {
  }
  return counts;
}

TEST(Simulation, EndsWhereAHelmCrashesAsItDoesWithAProcessThatDies) {
  Simulation simulation(WithACrash("end"), "");
  const std::map<int64_t, int> counts = ActuatorsOfAlpha(&simulation);
  EXPECT_EQ(simulation.Fault(),
            "LOST: helm_alpha: the behavior fault crashes the helm; the mission ends without it");
  EXPECT_EQ(simulation.utime() / 1'000'000, 5);
  EXPECT_FALSE(counts.contains(6));
}

TEST(Simulation, GoesOnWithoutAHelmThatCrashed) {
  Simulation simulation(WithACrash("continue"), "");
  const std::map<int64_t, int> counts = ActuatorsOfAlpha(&simulation);
  EXPECT_EQ(simulation.Fault(), "");
  EXPECT_EQ(simulation.utime(), 30'000'000);
  EXPECT_EQ(simulation.losses().size(), 1u);
  EXPECT_TRUE(counts.contains(4));
  EXPECT_FALSE(counts.contains(6));
}

TEST(Simulation, StartsAHelmThatCrashedAgainWithNothingOfWhatItDid) {
  Simulation simulation(WithACrash("restart", 40), "");
  const std::map<int64_t, int> counts = ActuatorsOfAlpha(&simulation);
  // With deploy_at_start it goes through its list, and so the five seconds, again.
  EXPECT_EQ(simulation.losses().size(), 5u);
  EXPECT_EQ(simulation.Fault(),
            "helm_alpha: the behavior fault crashes the helm; it was restarted 5 times already");
  for (int64_t second = 0; second < 25; ++second) EXPECT_GE(counts.at(second), 9) << second;
}

TEST(Simulation, FailsByACollisionAndItsHelmsStateIt) {
  std::string text = "[environment]\ncontact = \"stop\"\n" + std::string(kTwoVessels);
  text.resize(text.find("[[expect]]"));
  text.replace(text.find("= 30"), 4, "= 90");
  text += R"(helm_options = { deploy_at_start = true }
[[vehicle.task]]
name = "come"
kind = "waypoints"
points = [[0, 0]]
speed_mps = 2
)";
  Simulation simulation(Load(text), "");
  std::map<std::string, std::string> helms;
  for (const char* name : {"alpha", "bravo"}) {
    Subscribe(simulation.bus(), channels::HelmState(name), [&](const helm_state_t& helm) {
      helms[helm.vehicle] = helm.state + ": " + helm.all_stop;
    });
  }
  while (simulation.Step()) {
  }
  EXPECT_EQ(helms["alpha"], "ALL-STOP: collision with bravo");
  EXPECT_EQ(helms["bravo"], "ALL-STOP: collision with alpha");
  EXPECT_FALSE(simulation.Passed());
  EXPECT_TRUE(simulation.Summary().ends_with("\nFAIL: 1 collision\n")) << simulation.Summary();
}

TEST(Simulation, StopsASurfaceCraftThatRunsAground) {
  std::string text =
      "[environment]\nfloor = {style = \"flat\", depth_m = 0, range_m = 0, size_m = "
      "200, slope_east = -0.1}\n" +
      std::string(kTwoVessels);
  text.resize(text.find("[[vehicle]]"));
  text += R"([[vehicle]]
name = "ship"
start = {x_m = -30}
helm_options = {deploy_at_start = true}
[[vehicle.task]]
kind = "waypoints"
points = [[50, 0]]
speed_mps = 2
)";
  Simulation simulation(Load(text), "");
  nav_t last{};
  Subscribe(simulation.bus(), channels::Nav("ship"), [&](const nav_t& nav) { last = nav; });
  while (simulation.Step()) {
  }
  EXPECT_NEAR(last.x_m, -3, 0.5) << "where the water is as deep as its draught";
  EXPECT_EQ(last.speed_mps, 0);
  EXPECT_TRUE(simulation.Summary().ends_with("\nFAIL: 1 grounding\n")) << simulation.Summary();
}

TEST(EveryMission, OfShoalsOwnPasses) {
  int num_missions = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHOAL_SOURCE_DIR) + "/missions")) {
    if (!entry.is_regular_file()) continue;
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

}  // namespace shoal::simulation_test

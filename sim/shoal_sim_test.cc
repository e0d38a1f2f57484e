#include "sim/shoal_sim.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "sim/simulation.h"

namespace shoal::shoal_sim_test {

namespace fs = std::filesystem;

const std::string kAlpha = SHOAL_SOURCE_DIR "/missions/alpha.toml";

/// A mission by the C interface, freed at the end.
struct Held {
  explicit Held(const std::string& file) : sim(shoal_sim_new(file.c_str())) {}
  ~Held() { shoal_sim_free(sim); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  std::string Error() const { return shoal_sim_error(sim); }
  std::string Summary() const { return shoal_sim_summary(sim); }
  shoal_sim* sim;
};

std::string BytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ShoalSim, WritesTheSameLogAndSummaryAsASimulation) {
  const fs::path folder = fs::temp_directory_path();
  const std::string c_log = folder / "shoal_sim_test_c.lcm";
  const std::string log = folder / "shoal_sim_test.lcm";
  std::string c_summary;
  {
    Held held(SHOAL_SOURCE_DIR "/missions/berta.toml");
    ASSERT_EQ(shoal_sim_set(held.sim, "comms.comms_range=180"), SHOAL_SIM_OK);
    ASSERT_EQ(shoal_sim_set_seed(held.sim, 7), SHOAL_SIM_OK);
    ASSERT_EQ(shoal_sim_set_log(held.sim, c_log.c_str()), SHOAL_SIM_OK);
    ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
    while (shoal_sim_step(held.sim, 97) == 97) {
    }
    EXPECT_EQ(shoal_sim_has_ended(held.sim), 1);
    c_summary = held.Summary();
  }
  auto opened = Simulation::Open({.mission_file = SHOAL_SOURCE_DIR "/missions/berta.toml",
                                  .overrides = {"comms.comms_range=180"},
                                  .seed = 7,
                                  .log_path = log});
  ASSERT_TRUE(opened.ok());
  while (opened->Step()) {
  }
  EXPECT_EQ(c_summary, opened->Summary());
  EXPECT_GT(fs::file_size(log), 1'000'000U);
  EXPECT_TRUE(BytesOf(c_log) == BytesOf(log));
  fs::remove(c_log);
  fs::remove(log);
}

TEST(ShoalSim, ReadsTheLastMessageOfAWatchedChannel) {
  Held held(kAlpha);
  ASSERT_EQ(shoal_sim_watch(held.sim, "NAV_ALPHA"), SHOAL_SIM_OK);
  ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
  const void* data = &held;
  size_t size = 1;
  int64_t count = -1;
  ASSERT_EQ(shoal_sim_read(held.sim, "NAV_ALPHA", &data, &size, &count), SHOAL_SIM_OK);
  EXPECT_EQ(data, nullptr);
  EXPECT_EQ(count, 0);
  ASSERT_EQ(shoal_sim_step(held.sim, 5), 5);
  ASSERT_EQ(shoal_sim_read(held.sim, "NAV_ALPHA", &data, &size, &count), SHOAL_SIM_OK);
  nav_t nav{};
  ASSERT_TRUE(Decode({static_cast<const uint8_t*>(data), size}, &nav));
  EXPECT_EQ(count, 4) << "what is published in a step is read in the next";
  EXPECT_EQ(nav.utime + shoal_sim_tick_us(held.sim), shoal_sim_utime(held.sim));
  EXPECT_EQ(shoal_sim_step_number(held.sim), 4);
}

TEST(ShoalSim, TakesEveryMessageOfACollectedChannelInOrder) {
  Held held(SHOAL_SOURCE_DIR "/missions/berta.toml");
  ASSERT_EQ(shoal_sim_watch(held.sim, "NODE_REPORT_LOCAL"), SHOAL_SIM_OK);
  ASSERT_EQ(shoal_sim_collect(held.sim, "NODE_REPORT_LOCAL"), SHOAL_SIM_OK);
  ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
  auto opened = Simulation::Open({.mission_file = SHOAL_SOURCE_DIR "/missions/berta.toml"});
  ASSERT_TRUE(opened.ok()) << opened.error();
  std::vector<Bytes> expected;
  opened->bus().SubscribeBytes("NODE_REPORT_LOCAL", [&](const Message& message) {
    expected.emplace_back(message.data.begin(), message.data.end());
  });
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(opened->Step());
  const void* data = nullptr;
  size_t size = 0;
  EXPECT_EQ(shoal_sim_take(held.sim, "NODE_REPORT_LOCAL", &data, &size), 0);
  std::vector<Bytes> taken;
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(shoal_sim_step(held.sim, 100), 100);
    while (shoal_sim_take(held.sim, "NODE_REPORT_LOCAL", &data, &size) == 1) {
      const auto* bytes = static_cast<const uint8_t*>(data);
      taken.emplace_back(bytes, bytes + size);
    }
  }
  EXPECT_GT(taken.size(), 40U) << "two vessels report, twice a second or so";
  EXPECT_EQ(taken, expected);
  EXPECT_EQ(shoal_sim_take(held.sim, "NAV_ALPHA", &data, &size), SHOAL_SIM_MISUSE);
  EXPECT_EQ(held.Error(),
            "NAV_ALPHA is not collected: call shoal_sim_collect() before the first step");
  EXPECT_EQ(shoal_sim_collect(held.sim, "NAV_ALPHA"), SHOAL_SIM_MISUSE);
  EXPECT_EQ(held.Error(), "NAV_ALPHA: collect a channel before the first step");
}

TEST(ShoalSim, StopsWhereMoreWaitsThanItKeepsAndGoesOnWhenItIsTaken) {
  Held held(kAlpha);
  ASSERT_EQ(shoal_sim_collect(held.sim, "EXTRA"), SHOAL_SIM_OK);
  ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
  const Bytes large(size_t{1} << 24, 7);
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(shoal_sim_write(held.sim, "EXTRA", large.data(), large.size()), SHOAL_SIM_OK);
  }
  EXPECT_EQ(shoal_sim_step(held.sim, 10), SHOAL_SIM_MISUSE);
  EXPECT_EQ(held.Error(), "EXTRA: more than 64 MiB wait after step 0: call shoal_sim_take()");
  const void* data = nullptr;
  size_t size = 0;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(shoal_sim_take(held.sim, "EXTRA", &data, &size), 1);
  EXPECT_EQ(size, large.size());
  EXPECT_EQ(shoal_sim_step(held.sim, 10), 10);
}

TEST(ShoalSim, PublishesToTheMissionsParticipants) {
  double y_m[2] = {};
  for (const bool writes : {false, true}) {
    Held held(kAlpha);
    shoal_sim_watch(held.sim, "NAV_ALPHA");
    ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
    ASSERT_EQ(shoal_sim_step(held.sim, 100), 100);
    helm_command_t order{};
    order.command = "goto";
    order.values = {500, 500};
    order.num_values = 2;
    Bytes bytes;
    EncodeInto(order, &bytes);
    if (writes) {
      ASSERT_EQ(shoal_sim_write(held.sim, "HELM_COMMAND_ALPHA", bytes.data(), bytes.size()), 0);
    }
    shoal_sim_step(held.sim, 600);
    const void* data = nullptr;
    size_t size = 0;
    shoal_sim_read(held.sim, "NAV_ALPHA", &data, &size, nullptr);
    nav_t nav{};
    ASSERT_TRUE(Decode({static_cast<const uint8_t*>(data), size}, &nav));
    y_m[writes ? 1 : 0] = nav.y_m;
  }
  EXPECT_GT(y_m[1], y_m[0] + 50);
}

TEST(ShoalSim, StatesWhatIsWrongAndGoesOn) {
  EXPECT_EQ(shoal_sim_open(nullptr), SHOAL_SIM_MISUSE);
  EXPECT_NE(std::string(shoal_sim_error(nullptr)), "");
  EXPECT_EQ(shoal_sim_step(nullptr, 1), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_vehicle(nullptr, 0), nullptr);
  EXPECT_STREQ(shoal_sim_summary(nullptr), "");
  shoal_sim_free(nullptr);

  Held nowhere("/nowhere.toml");
  EXPECT_EQ(shoal_sim_step(nowhere.sim, 1), SHOAL_SIM_MISUSE);
  EXPECT_NE(nowhere.Error().find("shoal_sim_open()"), std::string::npos);
  EXPECT_EQ(shoal_sim_open(nowhere.sim), SHOAL_SIM_MISSION);
  EXPECT_NE(nowhere.Error().find("/nowhere.toml"), std::string::npos) << nowhere.Error();
  Held null_file("");
  EXPECT_EQ(shoal_sim_open(null_file.sim), SHOAL_SIM_MISSION);

  Held held(kAlpha);
  EXPECT_EQ(shoal_sim_set(held.sim, nullptr), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_watch(held.sim, "NAV ALPHA"), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_watch(held.sim, std::string(64, 'A').c_str()), SHOAL_SIM_MISUSE);
  ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
  EXPECT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_set(held.sim, "mission.seed=2"), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_step(held.sim, -1), SHOAL_SIM_MISUSE);
  ASSERT_EQ(shoal_sim_step(held.sim, 3), 3);
  EXPECT_EQ(shoal_sim_watch(held.sim, "NAV_ALPHA"), SHOAL_SIM_MISUSE);
  EXPECT_NE(held.Error().find("NAV_ALPHA: watch a channel before the first step"),
            std::string::npos);
  const void* data = nullptr;
  EXPECT_EQ(shoal_sim_read(held.sim, "NAV_ALPHA", &data, nullptr, nullptr), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_write(held.sim, "", "x", 1), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_write(held.sim, "NAV_ALPHA", nullptr, 1), SHOAL_SIM_MISUSE);
  EXPECT_EQ(shoal_sim_write(held.sim, "ACTUATORS_ALPHA", "no message", 10), SHOAL_SIM_OK);
  EXPECT_EQ(shoal_sim_step(held.sim, 3), 3) << "a message that does not decode is dropped";

  EXPECT_EQ(shoal_sim_end(held.sim), SHOAL_SIM_OK);
  EXPECT_EQ(shoal_sim_step(held.sim, 1), 0);
  EXPECT_EQ(shoal_sim_write(held.sim, "ACTUATORS_ALPHA", "no message", 10), SHOAL_SIM_OK);
}

TEST(ShoalSim, ReportsALogThatCannotBeWritten) {
  Held held(kAlpha);
  shoal_sim_set_log(held.sim, "/nowhere/log.lcm");
  EXPECT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_MISSION);
  EXPECT_NE(held.Error().find("/nowhere/log.lcm"), std::string::npos) << held.Error();
}

TEST(ShoalSim, StopsWhereTheDiskIsFull) {
  Held held(kAlpha);
  shoal_sim_set_log(held.sim, "/dev/full");
  int64_t taken = shoal_sim_open(held.sim) == SHOAL_SIM_OK ? 1 : SHOAL_SIM_FAULT;
  while (taken > 0) taken = shoal_sim_step(held.sim, 1000);
  EXPECT_EQ(taken, SHOAL_SIM_FAULT);
  EXPECT_NE(held.Error(), "");
}

TEST(ShoalSim, NamesItsVehiclesAndVersion) {
  Held held(SHOAL_SOURCE_DIR "/missions/berta.toml");
  EXPECT_EQ(shoal_sim_num_vehicles(held.sim), 0);
  ASSERT_EQ(shoal_sim_open(held.sim), SHOAL_SIM_OK) << held.Error();
  ASSERT_EQ(shoal_sim_num_vehicles(held.sim), 2);
  EXPECT_STREQ(shoal_sim_vehicle(held.sim, 0), "alpha");
  EXPECT_STREQ(shoal_sim_vehicle(held.sim, 1), "bravo");
  EXPECT_EQ(shoal_sim_vehicle(held.sim, 2), nullptr);
  EXPECT_EQ(shoal_sim_vehicle(held.sim, -1), nullptr);
  EXPECT_EQ(shoal_sim_abi_version(), SHOAL_SIM_ABI_VERSION);
  EXPECT_NE(std::strstr(shoal_sim_version(), " (build "), nullptr);
}

}  // namespace shoal::shoal_sim_test

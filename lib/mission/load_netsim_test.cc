// [netsim]: what a file makes of it, and every error with its exact text.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/load_testing.h"

namespace shoal::load_netsim_test {

/// A vehicle from outside and one of shoal's; what a test appends begins in line 12.
constexpr std::string_view kTwo = R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
[[vehicle]]
name = "outsider"
outside = true
[acoustics]
access_mode = "shared"
[netsim]
port = 62500
)";
constexpr std::string_view kBay = R"([[netsim.environment]]
name = "bay"
lat_min_deg = 43
lat_max_deg = 44
lon_min_deg = -71
lon_max_deg = -70
depth_max_m = 100
)";
constexpr std::string_view kOutsider = R"([[netsim.vehicle]]
name = "Outsider"
modem_tcp_port = 62000
environment = "bay"
modem = "micromodem"
)";

std::string ErrorsWith(std::string_view more, const std::vector<std::string>& overrides = {}) {
  return ErrorsOf(std::string(kTwo) + std::string(more), overrides);
}

TEST(LoadNetsim, TakesTheValuesOfTheFile) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kTwo) + std::string(kBay) + std::string(kOutsider) +
                          "gps = {tcp_port = 62100, path = \"/tmp/gps\"}\n",
                      "m.toml");
  ASSERT_EQ(loaded.errors, std::vector<std::string>());
  ASSERT_TRUE(loaded.mission.netsim.has_value());
  const NetsimOptions& netsim = *loaded.mission.netsim;
  EXPECT_EQ(netsim.port, 62500);
  EXPECT_EQ(netsim.address, "127.0.0.1");
  EXPECT_FALSE(netsim.allow_warp);
  ASSERT_EQ(netsim.environments.size(), 1U);
  EXPECT_EQ(netsim.environments[0].lon_max_deg, -70);
  EXPECT_EQ(netsim.environments[0].depth_min_m, 0);
  ASSERT_EQ(netsim.vehicles.size(), 1U);
  EXPECT_EQ(netsim.vehicles[0].name, "outsider") << "as its [[vehicle]] writes it";
  EXPECT_EQ(netsim.vehicles[0].modem, NetsimModem::kMicromodem);
  EXPECT_EQ(netsim.vehicles[0].address, "any");
  EXPECT_EQ(netsim.vehicles[0].gps.tcp_port, 62100);
}

TEST(LoadNetsim, IsNothingWithoutTheTable) {
  EXPECT_FALSE(LoadMissionText(kShortest, "m.toml").mission.netsim.has_value());
}

TEST(LoadNetsim, ReportsVehiclesThatShoalSimulatesItself) {
  EXPECT_EQ(ErrorsWith(std::string(kBay) + std::string(kOutsider), {"netsim.vehicle.1.name=alpha"}),
            "--set netsim.vehicle.1.name=alpha: shoal simulates alpha itself: write outside = true "
            "in its [[vehicle]]\n");
}

TEST(LoadNetsim, ReportsEnvironmentsAndPortsThatDoNotFit) {
  EXPECT_EQ(ErrorsWith(kOutsider),
            "15:15: environment no [[netsim.environment]] has the name 'bay'\n");
  const std::string taken =
      ErrorsWith(std::string(kBay) + std::string(kOutsider), {"netsim.port=62000"});
  EXPECT_NE(taken.find("modem_tcp_port 62000 is taken by port of netsim: each port has one use"),
            std::string::npos)
      << taken;
}

TEST(LoadNetsim, ReportsInvalidBounds) {
  EXPECT_EQ(ErrorsWith(std::string(kBay) + std::string(kOutsider),
                       {"netsim.environment.bay.lat_max_deg=42"}),
            "--set netsim.environment.bay.lat_max_deg=42: lat_max_deg must not be less than "
            "lat_min_deg, 43\n");
  EXPECT_EQ(ErrorsWith("[[netsim.environment]]\nname = \"bay\"\n"),
            "12:1: environment lacks 'depth_max_m'; for example: depth_max_m = 43.8\n"
            "12:1: environment lacks 'lat_max_deg'; for example: lat_max_deg = 43.8\n"
            "12:1: environment lacks 'lat_min_deg'; for example: lat_min_deg = 43.8\n"
            "12:1: environment lacks 'lon_max_deg'; for example: lon_max_deg = 43.8\n"
            "12:1: environment lacks 'lon_min_deg'; for example: lon_min_deg = 43.8\n");
}

TEST(LoadNetsim, ReportsAModemWithoutWater) {
  std::string text = std::string(kTwo) + std::string(kBay) + std::string(kOutsider);
  text.erase(text.find("[acoustics]"),
             std::string_view("[acoustics]\naccess_mode = \"shared\"\n").size());
  EXPECT_EQ(ErrorsOf(text),
            "23:9: a modem sends over the acoustic network: write [acoustics] as well\n");
}

}  // namespace shoal::load_netsim_test

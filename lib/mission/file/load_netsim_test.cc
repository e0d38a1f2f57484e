// [netsim]: what a file makes of it, and every error with its exact text.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/file/load_testing.h"

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
            "21:9: a modem sends over an acoustic network: write [acoustics] as well, or name a "
            "[[medium]] of kind = \"acoustic\" in [swarm] over\n");
}

TEST(LoadNetsim, RefusesAnAddressThatNoMicroModemHas) {
  std::string text = std::string(kTwo) + std::string(kBay) + std::string(kOutsider);
  text.replace(text.find("outside = true\n"), 15, "outside = true\nacoustic_address = 128\n");
  const std::string error =
      "8:20: acoustic_address = 128 of outsider: a Micro-Modem's address is 1 to 127; choose one "
      "of these (the default is the vehicle's place in the mission)\n";
  EXPECT_EQ(ErrorsOf(text), error);
  EXPECT_EQ(ErrorsOf(text, {"netsim.vehicle.outsider.modem=micromodem2"}), error);
  EXPECT_EQ(ErrorsOf(text, {"netsim.vehicle.outsider.modem=raw"}), "");
  EXPECT_EQ(ErrorsOf(text, {"vehicle.outsider.acoustic_address=127"}), "");
}

LoadedMission LoadWith(std::string_view acoustics, std::string_view modem = "micromodem") {
  std::string text = std::string(kTwo) + std::string(kBay) + std::string(kOutsider);
  const std::string_view shared = "access_mode = \"shared\"\n";
  text.replace(text.find(shared), shared.size(), acoustics);
  text.replace(text.find("\"micromodem\""), 12, "\"" + std::string(modem) + "\"");
  return LoadMissionText(text + "[comms]\ncomms_range = 500\n", "m.toml");
}

TEST(LoadNetsim, GivesModemsANetworkThatCarriesTheirPackets) {
  for (const char* modem : {"raw", "micromodem", "micromodem2"}) {
    const LoadedMission loaded = LoadWith("jitter = \"off\"\n", modem);
    ASSERT_EQ(loaded.errors, std::vector<std::string>());
    EXPECT_EQ(loaded.warnings, std::vector<std::string>());
    const AcousticOptions& options = loaded.mission.acoustics.options;
    ASSERT_TRUE(options.modem.has_value());
    EXPECT_EQ(options.modem->name, "WHOI Micro-Modem, 25 kHz");
    EXPECT_EQ(options.packet_loss_model, PacketLossModel::kModem);
    EXPECT_EQ(options.bit_error_model, BitErrorModel::kOff);
    EXPECT_TRUE(options.half_duplex);
    EXPECT_EQ(options.jitter, JitterModel::kOff) << "the file's own";
    const LoadedMission again = LoadMissionText(Explain(loaded.mission), "again.toml");
    EXPECT_EQ(again.errors, std::vector<std::string>());
    EXPECT_EQ(again.mission.acoustics, loaded.mission.acoustics);
  }
  EXPECT_FALSE(LoadWith("jitter = \"off\"\n", "none").mission.acoustics.options.modem);
}

TEST(LoadNetsim, WarnsOfModelsThatDamageNearlyEveryPacketOfAModem) {
  const LoadedMission loaded = LoadWith("bit_error_model = \"poisson\"\n");
  ASSERT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_FALSE(loaded.mission.acoustics.options.modem) << "the file has models of its own";
  EXPECT_EQ(
      loaded.warnings,
      std::vector<std::string>{
          "m.toml:9:19: warning: of a modem's packets of 47 bytes 66 % arrive whole at 1000 m, of "
          "those of 2105 bytes 0 %: poisson flips one bit of 1000, and crc = true throws "
          "damaged packets away. Leave the models out, for those of a modem "
          "(docs/communication/acoustic_network.md)"});
  EXPECT_EQ(LoadWith("bit_error_model = \"poisson\"\ncrc = false\n").warnings,
            std::vector<std::string>());
  EXPECT_EQ(LoadWith("bit_error_model = \"off\"\n").warnings, std::vector<std::string>());
}

TEST(LoadNetsim, WarnsOfTheDefaultRangeWhereOthersAnswerAModem) {
  const std::string text = std::string(kTwo) + std::string(kBay) + std::string(kOutsider);
  EXPECT_EQ(
      LoadMissionText(text, "m.toml").warnings,
      std::vector<std::string>{
          "m.toml:10:1: warning: comms_range is the default, 100 m: reports, and packets that "
          "programs of the mission send on ACOUSTIC_TX, are received nearer than that only, "
          "while what a modem sends has no range rule; write comms_range in [comms]"});
  std::string alone = text;
  alone.replace(alone.find("name = \"alpha\"\n"), 15, "name = \"alpha\"\noutside = true\n");
  EXPECT_EQ(LoadMissionText(alone, "m.toml").warnings,
            std::vector<std::string>{"m.toml:6:1: warning: outsider will receive no report: no "
                                     "other vehicle has a node_reporter"});
}

TEST(LoadNetsim, RefusesAnEnvironmentFartherFromTheOriginThanPositionsCanBe) {
  EXPECT_EQ(ErrorsWith(std::string(kBay) + std::string(kOutsider),
                       {"netsim.environment.bay.lon_min_deg=-100"}),
            "13:8: environment 'bay' lies in part more than 1500 km from the mission's origin "
            "(43.8253, -70.3304), where positions cannot be used: move origin in [mission], or the "
            "bounds\n");
  // Corners near the origin, and all longitudes between them: beyond the pole of the other side.
  EXPECT_NE(ErrorsWith(std::string(kBay) + std::string(kOutsider),
                       {"netsim.environment.bay.lon_min_deg=-72",
                        "netsim.environment.bay.lon_max_deg=289"}),
            "");
}

TEST(LoadVehicles, HaveOneKeyForWhatIsSimulatedElsewhere) {
  const Vehicle vehicle = LoadWith("jitter = \"off\"\n").mission.vehicles.at(1);
  for (const Provider provider : {vehicle.sim, vehicle.helm, vehicle.reporter, vehicle.acomms}) {
    EXPECT_EQ(provider, Provider::kNone);
  }
  EXPECT_EQ(ErrorsAfter("outside = true\nhelm = \"hand\"\n"),
            "6:8: outside = true means that shoal provides no part of this vehicle: leave helm "
            "out\n");
}

}  // namespace shoal::load_netsim_test

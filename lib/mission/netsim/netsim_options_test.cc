#include "lib/mission/netsim/netsim_options.h"

#include <gtest/gtest.h>

#include <limits>

#include "lib/mission/netsim/netsim_testing.h"

namespace shoal::netsim_options_test {

/// "where.key" of each problem.
std::vector<std::string> Problems(const NetsimOptions& options) {
  std::vector<std::string> places;
  for (const NetsimProblem& problem : FindNetsimProblems(options)) {
    EXPECT_FALSE(problem.message.empty());
    places.push_back(problem.where + "." + problem.key);
  }
  return places;
}

using Places = std::vector<std::string>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(NetsimOptions, AreRightByDefault) { EXPECT_EQ(Problems({}), Places{}); }

TEST(NetsimOptions, OfTheTestsAreRight) { EXPECT_EQ(Problems(TwoNetsimVehicles()), Places{}); }

TEST(NetsimOptions, WantEachPortOnce) {
  NetsimOptions options = TwoNetsimVehicles();
  options.vehicles[1].modem_tcp_port = 62000;
  EXPECT_EQ(Problems(options), Places{"netsim.vehicle 'bruce'.modem_tcp_port"});
  options.vehicles[1].modem_tcp_port = 61999;
  EXPECT_EQ(Problems(options), Places{"netsim.vehicle 'bruce'.modem_tcp_port"});
  options.vehicles[1].modem_tcp_port = 62001;
  options.vehicles[0].gps.tcp_port = 62001;
  EXPECT_EQ(Problems(options), Places{"netsim.vehicle 'bruce'.modem_tcp_port"});
  EXPECT_EQ(FindNetsimProblems(options)[0].message,
            "62001 is taken by gps_tcp_port of netsim.vehicle 'alice': each port has one use");
}

TEST(NetsimOptions, WantPortsThatThereAre) {
  NetsimOptions options = TwoNetsimVehicles();
  options.port = 65536;
  options.vehicles[0].modem_tcp_port = 0;
  options.vehicles[1].gps.tcp_port = -1;
  EXPECT_EQ(Problems(options), (Places{"netsim.port", "netsim.vehicle 'alice'.modem_tcp_port",
                                       "netsim.vehicle 'bruce'.gps_tcp_port"}));
}

TEST(NetsimOptions, WantAddressesThatClientsCanHave) {
  for (const char* address : {"localhost", "", "127.0.0", "127.0.0.01", "::1", "127.0.0.1 "}) {
    NetsimOptions options = TwoNetsimVehicles();
    options.address = address;
    options.vehicles[1].address = address;
    EXPECT_EQ(Problems(options), (Places{"netsim.address", "netsim.vehicle 'bruce'.address"}))
        << address;
  }
  EXPECT_FALSE(IsIpv4Address(std::string("127.0.0.1\0", 10)));
  EXPECT_TRUE(IsIpv4Address("0.0.0.0"));
}

TEST(NetsimOptions, WantAnEnvironmentForEachVehicle) {
  NetsimOptions options = TwoNetsimVehicles();
  options.vehicles[1].environment = "sea";
  EXPECT_EQ(Problems(options), Places{"netsim.vehicle 'bruce'.environment"});
}

TEST(NetsimOptions, WantNamesOnce) {
  NetsimOptions options = TwoNetsimVehicles();
  options.vehicles[1].name = "alice";
  options.environments[1].name = "";
  EXPECT_EQ(Problems(options), (Places{"netsim.environment ''.name", "netsim.vehicle 'alice'.name",
                                       "netsim.vehicle 'alice'.environment"}));
}

TEST(NetsimOptions, WantBoundsThatLeaveRoom) {
  NetsimOptions options = TwoNetsimVehicles();
  NetsimEnvironment& bay = options.environments[0];
  bay.lat_max_deg = bay.lat_min_deg;
  EXPECT_EQ(Problems(options), Places{});
  bay.lat_max_deg = bay.lat_min_deg - 1;
  bay.lon_min_deg = kNan;
  bay.depth_max_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Problems(options),
            (Places{"netsim.environment 'bay'.lat_max_deg", "netsim.environment 'bay'.lon_min_deg",
                    "netsim.environment 'bay'.depth_max_m"}));
}

TEST(NetsimOptions, WantLimitsThatLetSomeoneIn) {
  NetsimOptions options;
  options.max_connections = 0;
  options.max_line_bytes = 10;
  options.idle_timeout_s = kNan;
  EXPECT_EQ(Problems(options),
            (Places{"netsim.max_connections", "netsim.max_line_bytes", "netsim.idle_timeout_s"}));
}

}  // namespace shoal::netsim_options_test

#include <gtest/gtest.h>

#include "lib/bus/os/read_file.h"
#include "lib/mission/file/load_testing.h"

namespace shoal::load_hosts_test {

constexpr char kHost[] = R"([[host]]
name = "lab2"
address = "tcp://10.0.0.2:7700"
vehicles = ["Alpha"]
)";

TEST(LoadHosts, HaveDefaults) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest) + kHost, "m.toml");
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  ASSERT_EQ(loaded.mission.hosts.size(), 1U);
  const HostOptions& host = loaded.mission.hosts[0];
  EXPECT_EQ(host.name, "lab2");
  EXPECT_EQ(host.vehicles, std::vector<std::string>{"Alpha"});
  EXPECT_EQ(host.on_loss, OnLoss::kEnd);
  EXPECT_EQ(host.timeout_s, 0.9);
}

TEST(LoadHosts, TakeTheirVehiclesFromAnOverride) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kShortest) + kHost, "m.toml", {"host.lab2.vehicles=[]"});
  ASSERT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_TRUE(loaded.mission.hosts[0].vehicles.empty());
}

TEST(LoadHosts, RefuseVehiclesThatTheMissionHasNot) {
  EXPECT_EQ(ErrorsAfter("[[host]]\nname = \"lab2\"\nvehicles = [\"alphaa\"]\n"),
            "7:12: the mission has no vehicle 'alphaa' (did you mean 'alpha'?)\n");
  EXPECT_EQ(ErrorsAfter("[[host]]\nname = \"lab2\"\nparticipants = [\"referee\"]\n"),
            "7:16: the mission has no participant 'referee'\n");
}

TEST(LoadHosts, RefuseAVehicleOnTwoComputers) {
  EXPECT_EQ(ErrorsAfter(std::string(kHost) + "[[host]]\nname = \"lab3\"\nvehicles = [\"alpha\"]\n"),
            "11:12: vehicle 'alpha' is on host 'lab2' already: it runs on one computer\n");
}

TEST(LoadHosts, RefuseTwoHostsOfOneNameAndAddressesOfOtherForms) {
  EXPECT_EQ(ErrorsAfter(std::string(kHost) + "[[host]]\nname = \"LAB2\"\n"),
            "10:8: a host 'LAB2' exists already; names must differ in more than case\n");
  EXPECT_EQ(ErrorsAfter("[[host]]\nname = \"lab2\"\naddress = \"10.0.0.2\"\n"),
            "7:11: an address has the form tcp://10.0.0.2:7700\n");
}

TEST(FilesRead, ListsWhatAMissionConsistsOf) {
  const FilesRead files;
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) + "[acoustics]\nmodem = \"data/modems/nanomodem_v3\"\n",
      std::string(SHOAL_SOURCE_DIR) + "/m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  const std::string modem = std::string(SHOAL_SOURCE_DIR) + "/data/modems/nanomodem_v3.toml";
  EXPECT_EQ(files.paths(), std::set<std::string>{modem});
}

}  // namespace shoal::load_hosts_test

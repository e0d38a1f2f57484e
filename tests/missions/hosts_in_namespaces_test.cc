// Three hosts in network namespaces, joined to home by cables of their own: the same log as `shoal
// sim`, and one TCP port on the wire.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "tests/missions/host_farm.h"

namespace shoal::hosts_in_namespaces_test {

struct Placement {
  std::string mission;
  std::vector<std::string> vehicles;  ///< Of each host.
  bool has_programs = false;          ///< `shoal sim` runs none: then `shoal run` here is compared.
  std::vector<std::string> overrides = {};
};

void PrintTo(const Placement& placement, std::ostream* out) { *out << placement.mission; }

/// Why no namespaces can be made here, or empty.
std::string WhyNoNamespaces() {
  if (std::system("command -v ip python3 nsenter >/dev/null 2>&1") != 0) {
    return "ip, nsenter or python3 is missing: scripts/setup --with-tests installs them";
  }
  const char* command =
      "unshare -rn sh -c 'ip link add name here type veth peer name there && unshare -n true' "
      ">/dev/null 2>&1";
  return std::system(command) == 0
             ? ""
             : "this machine cannot give this user network namespaces (unshare -rn)";
}

class ThreeHosts : public testing::TestWithParam<Placement> {
 protected:
  void SetUp() override {
    if (const std::string why = WhyNoNamespaces(); !why.empty()) GTEST_SKIP() << why;
    for (const std::string name : {"home", "host1", "host2", "host3"}) {
      const Finished made =
          RunShoal(folder_, {"host", "keygen", "--out", (folder_ / name).string()});
      ASSERT_EQ(made.exit_code, 0) << made.output;
    }
  }

  std::string Place(const Placement& placement) {
    std::string text = ReadFile(MissionFile(placement.mission));
    for (size_t i = 0; i < placement.vehicles.size(); ++i) {
      const std::string number = std::to_string(i + 1);
      text += "\n[[host]]\nname = \"host" + number + "\"\naddress = \"tcp://10.99." + number +
              ".2:7700\"\nkey = \"host" + number + ".pub\"\ntimeout_s = 60\nvehicles = [" +
              placement.vehicles[i] + "]\n";
    }
    const std::string path = (folder_ / placement.mission).string();
    WriteFile(path, text);
    CopyMissionData(folder_.path());
    return path;
  }

  Finished Run(const std::vector<std::string>& arguments) {
    std::vector<std::string> argv = {"/usr/bin/unshare", "-rn",
                                     std::string(SHOAL_SOURCE_DIR) + "/tests/missions/three_hosts",
                                     Program("shoal"), folder_.path().string()};
    argv.insert(argv.end(), arguments.begin(), arguments.end());
    return RunningProcess(folder_, argv).Wait(4 * kPatience_s);
  }

  std::string HostOutput() const {
    std::string text;
    for (const std::string number : {"1", "2", "3"}) {
      text += ReadFile(folder_ / ("host" + number + ".txt"));
    }
    return text;
  }

  TestFolder folder_;
};

TEST_P(ThreeHosts, GiveTheLogOfOneComputerOverOnePort) {
  const std::string mission = Place(GetParam());
  const std::string here_log = (folder_ / "here/mission.lcm").string();
  std::filesystem::create_directories(folder_ / "here");
  std::vector<std::string> here_command = {"sim", mission, "--log", here_log, "--quiet"};
  if (GetParam().has_programs) {
    here_command = {"run",  mission,  "--warp", "max",    "--record", folder_ / "here", "--quiet",
                    "--on", "host1=", "--on",   "host2=", "--on",     "host3="};
  }
  std::vector<std::string> overrides;
  for (const std::string& each : GetParam().overrides) {
    overrides.insert(overrides.end(), {"--set", each});
  }
  here_command.insert(here_command.end(), overrides.begin(), overrides.end());
  const Finished here = RunShoal(folder_, here_command);
  const std::string dir = (folder_ / "rec").string();
  std::vector<std::string> command = {mission, "--warp", "max", "--record", dir, "--quiet"};
  command.insert(command.end(), overrides.begin(), overrides.end());
  const Finished run = Run(command);
  EXPECT_EQ(run.exit_code, here.exit_code) << run.output << HostOutput();
  EXPECT_NE(run.output.find("Reproducible: yes"), std::string::npos) << run.output;
  EXPECT_TRUE(ReadFile(dir + "/mission.lcm") == ReadFile(here_log)) << run.output;
  for (size_t i = 0; i < GetParam().vehicles.size(); ++i) {
    const std::string name = "wire" + std::to_string(i + 1) + ".txt";
    std::istringstream wire(ReadFile(folder_ / name));
    int64_t on_port = 0;
    std::string kind;
    for (int64_t count = 0; wire >> kind >> count;) {
      if (kind == "tcp-7700") on_port = count;
      EXPECT_TRUE(kind == "tcp-7700" || kind == "arp" || kind == "ipv6-icmp") << kind;
    }
    EXPECT_GT(on_port, 1000) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Missions, ThreeHosts,
    testing::Values(
        Placement{"alpha.toml", {"\"alpha\""}}, Placement{"berta.toml", {"\"alpha\"", "\"bravo\""}},
        Placement{
            "fleet.toml",
            {"\"scout_01\", \"scout_02\", \"scout_03\"", "\"scout_04\", \"scout_05\", \"scout_06\"",
             "\"scout_07\", \"scout_08\", \"scout_09\", \"scout_10\""}},
        Placement{"hide_and_seek.toml",
                  {"\"hider_1\", \"seeker_2\"", "\"hider_2\", \"hider_3\"", "\"seeker_3\""},
                  true},
        Placement{"swarm_fdma.toml", {"\"alpha\"", "\"bravo\", \"charlie\"", "\"delta\""}},
        Placement{"swarm20.toml",
                  {"\"alpha\", \"f01\", \"f02\", \"f03\", \"f04\", \"f05\"",
                   "\"f06\", \"f07\", \"f08\", \"f09\", \"f10\"",
                   "\"f11\", \"f12\", \"f13\", \"f14\", \"f15\""},
                  false,
                  {"mission.duration_s=30", "expect.2.from_s=0"}},
        Placement{"track_replay.toml", {"\"alpha\"", "\"ferry\"", "\"launch\""}},
        Placement{"acoustic_shared.toml", {"\"alpha\", \"echo\"", "\"bravo\"", "\"charlie\""}}),
    [](const auto& each) { return each.param.mission.substr(0, each.param.mission.find('.')); });

#ifdef SHOAL_HAS_NETCDF
INSTANTIATE_TEST_SUITE_P(
    MissionsWithNetcdf, ThreeHosts,
    testing::Values(Placement{"tidal_channel.toml", {"\"alpha\"", "\"bravo\""}}),
    [](const auto& each) { return each.param.mission.substr(0, each.param.mission.find('.')); });
#endif

}  // namespace shoal::hosts_in_namespaces_test

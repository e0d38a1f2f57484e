#include "tests/missions/host_farm.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "lib/bus/record/log_reader.h"

namespace shoal {

namespace {

std::string MakeKey(const TestFolder& folder, const std::string& name) {
  const std::string prefix = (folder / name).string();
  const Finished made = RunShoal(folder, {"host", "keygen", "--out", prefix});
  EXPECT_EQ(made.exit_code, 0) << made.output;
  return prefix;
}

}  // namespace

std::string LogOfSim(const TestFolder& folder, const std::string& mission) {
  const std::string log = (folder / "sim.lcm").string();
  const Finished finished = RunShoal(folder, {"sim", mission, "--log", log});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  return ReadFile(log);
}

void TakeOutWhatComesLater(const std::string& mission) {
  std::istringstream lines(ReadFile(mission));
  std::string kept;
  bool is_later = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) {
      is_later = line.starts_with("[[event]]") || line.starts_with("[[expect]]");
    }
    if (!is_later) kept += line + "\n";
  }
  WriteFile(mission, kept);
}

void Shorten(const std::string& mission, int duration_s) {
  TakeOutWhatComesLater(mission);
  const std::string text = ReadFile(mission);
  const std::regex duration("\nduration_s = [0-9]+");
  EXPECT_TRUE(std::regex_search(text, duration)) << mission;
  WriteFile(mission,
            std::regex_replace(text, duration, "\nduration_s = " + std::to_string(duration_s)));
}

HostFarm::HostFarm(size_t count, std::vector<std::string> options) {
  home_key = MakeKey(folder, "home");
  const int port = FreeTcpPorts(static_cast<int>(count));
  for (size_t i = 0; i < count; ++i) {
    const std::string name = "host" + std::to_string(i + 1);
    hosts.push_back({.name = name,
                     .address = "tcp://127.0.0.1:" + std::to_string(port + static_cast<int>(i)),
                     .public_key_file = MakeKey(folder, name) + ".pub",
                     .process = nullptr});
    Start(i, options);
  }
}

void HostFarm::Start(size_t host, const std::vector<std::string>& options) {
  TestHost& each = hosts[host];
  std::vector<std::string> argv = {Program("shoal"), "host",
                                   "--listen",       each.address,
                                   "--key",          (folder / (each.name + ".key")).string(),
                                   "--allow",        home_key + ".pub"};
  argv.insert(argv.end(), options.begin(), options.end());
  each.process.reset();
  each.process = std::make_unique<RunningProcess>(folder, argv);
  ASSERT_TRUE(each.process->WaitFor("shoal host listens")) << each.process->Output();
}

std::string HostFarm::Placed(const std::string& mission, const std::vector<std::string>& vehicles,
                             const std::string& more, std::vector<std::string> addresses) {
  std::string text = ReadFile(MissionFile(mission));
  for (size_t i = 0; i < vehicles.size(); ++i) {
    const bool is_given = i < addresses.size() && !addresses[i].empty();
    text += "\n[[host]]\nname = \"" + hosts[i].name + "\"\naddress = \"" +
            (is_given ? addresses[i] : hosts[i].address) + "\"\nkey = \"" + hosts[i].name +
            ".pub\"\nvehicles = [" + vehicles[i] + "]\n" + more;
  }
  const std::string path = (folder / mission).string();
  WriteFile(path, text);
  CopyMissionData(folder.path());
  return path;
}

std::vector<std::string> HostFarm::RunCommand(const std::string& mission_file,
                                              const std::vector<std::string>& more) const {
  std::vector<std::string> argv = {Program("shoal"), "run", mission_file, "--warp", "max", "--key",
                                   home_key + ".key"};
  argv.insert(argv.end(), more.begin(), more.end());
  return argv;
}

Finished HostFarm::Run(const std::string& mission_file,
                       const std::vector<std::string>& more) const {
  RunningProcess process(folder, RunCommand(mission_file, more));
  return process.Wait();
}

int HostFarm::PortOf(size_t host) const {
  const std::string& address = hosts[host].address;
  return std::atoi(address.c_str() + address.rfind(':') + 1);
}

MissionUnderWay::MissionUnderWay(const std::string& more,
                                 const std::function<std::string(const HostFarm&)>& way,
                                 const std::vector<std::string>& options)
    : farm(1) {
  mission = farm.Placed("berta.toml", {"\"bravo\""}, more, {way ? way(farm) : std::string()});
  std::vector<std::string> arguments = {"--warp", "20",    "--record",
                                        dir,      "--set", "mission.participant_timeout_s=60"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  process = std::make_unique<RunningProcess>(farm.folder, farm.RunCommand(mission, arguments));
  EXPECT_TRUE(AwaitThat([&] { return NumEvents() >= 200; }))
      << process->Output() << farm.hosts[0].process->Output();
}

int64_t MissionUnderWay::NumEvents() const {
  Result<LogReader> reader = LogReader::Open(dir + "/mission.lcm");
  if (!reader.ok()) return 0;
  int64_t events = 0;
  while (reader->Next()) ++events;
  return reader->error().empty() ? events : -1;
}

}  // namespace shoal

#include "lib/run/run/run_registry.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/run/run/run_folder.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr int kBlockDistance = 140;  ///< Between default blocks: room for the largest one.
constexpr int kLastBase = 30000;     ///< Beyond lie the ports that the kernel hands out itself.

/// True where no socket at all is bound to the UDP port, not even one that would share it.
bool IsFree(int port) {
  const int fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  const bool free = bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  close(fd);
  return free;
}

/// Binds a name that only one process of the machine can hold and that goes with it, however it
/// ends. The descriptor stays open on purpose.
bool Lock(int port) {
  const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = fmt::format("shoal-port-{}", port);
  std::memcpy(address.sun_path + 1, name.data(), name.size());
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(fd, reinterpret_cast<sockaddr*>(&address), size) == 0) return true;
  close(fd);
  return false;
}

bool BlockIsFree(int base, int num_ports) {
  for (int port = base; port < base + num_ports; ++port) {
    if (!IsFree(port)) return false;
  }
  return true;
}

/// Locks every port of the block; locks of a block that was claimed in part stay with this process,
/// which harms no other process.
bool LockBlock(int base, int num_ports) {
  for (int port = base; port < base + num_ports; ++port) {
    if (!Lock(port)) return false;
  }
  return true;
}

std::string EntryName(int port_base) { return fmt::format("{}.run", port_base); }
std::string SecretName(int port_base) { return fmt::format("{}.secret", port_base); }
std::string EndedName(int port_base) { return fmt::format("{}.ended", port_base); }

std::optional<RunningMission> ReadEntry(const std::string& name) {
  const Result<std::string> text = ReadRunFile(name);
  if (!text.ok()) return std::nullopt;
  std::istringstream in(*text);
  RunningMission mission;
  for (std::string line; std::getline(in, line);) {
    const size_t blank = std::min(line.find(' '), line.size());
    const std::string key = line.substr(0, blank);
    const std::string value = line.substr(std::min(blank + 1, line.size()));
    if (key == "name") mission.name = value;
    if (key == "file") mission.file = value;
    if (key == "folder") mission.folder = value;
    if (key == "mission_id") mission.mission_id = ReadNumber<int64_t>(value).value_or(0);
    if (key == "port_base") mission.port_base = ReadNumber<int>(value).value_or(0);
    if (key == "layout") {
      mission.layout = value == "communities" ? Layout::kCommunities : Layout::kShared;
    }
    if (key == "grouping") mission.grouping = value;
    if (key == "playback_of") mission.playback_of = value;
    if (key == "pid") mission.pid = ReadNumber<int>(value).value_or(0);
    if (key == "vehicle") mission.vehicles.push_back(value);
    if (key == "without_helm") mission.without_helm.push_back(value);
    if (key == "member") {
      const size_t end =
          std::min(value.find(' '), value.size());  // A group's name may hold blanks.
      mission.groups[value.substr(std::min(end + 1, value.size()))].push_back(value.substr(0, end));
    }
    if (key == "order") {
      const std::vector<std::string_view> parts = TrimmedParts(value, '\t');
      if (parts.size() < 3) continue;
      mission.orders.push_back({.name = std::string(parts[0]),
                                .target = std::string(parts[1]),
                                .words = {parts.begin() + 2, parts.end()}});
    }
    if (key == "set") mission.overrides.push_back(value);
  }
  const int num_ports =
      PortPlan::NumPorts(mission.layout, static_cast<int>(mission.vehicles.size()));
  if (mission.pid <= 0 || mission.port_base < 1024 || mission.port_base + num_ports > 65536) {
    return std::nullopt;
  }
  return mission;
}

}  // namespace

Result<bool> KeepEnded(int port_base, const EndedMission& ended) {
  const Result<std::string> path = WriteRunFile(
      EndedName(port_base), fmt::format("{}\n{}\n{}", ended.mission_id, ended.log, ended.verdict));
  if (!path.ok()) return Error{path.error()};
  return true;
}

std::optional<EndedMission> FindEnded(int port_base, int64_t mission_id) {
  const Result<std::string> text = ReadRunFile(EndedName(port_base));
  if (!text.ok()) return std::nullopt;
  const size_t first = text->find('\n');
  const size_t second = first == std::string::npos ? first : text->find('\n', first + 1);
  if (second == std::string::npos) return std::nullopt;
  if (text->substr(0, first) != std::to_string(mission_id)) return std::nullopt;
  return EndedMission{.mission_id = mission_id,
                      .log = text->substr(first + 1, second - first - 1),
                      .verdict = text->substr(second + 1)};
}

std::string EntryPath(int port_base) {
  return fmt::format("{}/{}", RunFolder(), EntryName(port_base));
}

std::string SecretPath(int port_base) {
  return fmt::format("{}/{}", RunFolder(), SecretName(port_base));
}

Result<bool> KeepSecret(int port_base, const MissionSecret& secret) {
  const Result<std::string> written = WriteRunFile(SecretName(port_base), SecretText(secret));
  if (!written.ok()) return Error{written.error()};
  return true;
}

Result<int> SecretInMemory(const MissionSecret& secret) {
  const std::string text = SecretText(secret);
  const int opened = memfd_create("shoal-secret", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (opened < 0 || !WriteAll(opened, text) ||
      fcntl(opened, F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
    return Error{
        fmt::format("cannot keep the mission's secret in memory: {}", std::strerror(errno))};
  }
  return opened;
}

Result<MissionSecret> FindSecret(int port_base) {
  const char* descriptor = std::getenv(kSecretFdVariable);
  const char* file = std::getenv(kSecretFileVariable);
  std::string why;
  if (descriptor != nullptr) {
    Result<MissionSecret> secret = ReadSecret(std::atoi(descriptor));
    if (secret.ok()) return secret;
    why = secret.error() + "; ";  // A program between may have closed it: the file is there too.
  }
  Result<MissionSecret> secret = ReadSecretFile(file == nullptr ? SecretPath(port_base) : file);
  if (secret.ok()) return secret;
  return Error{
      fmt::format("no secret of the mission at port {}, without which it accepts no participant: "
                  "{}{}. `shoal run` of the same user keeps it there",
                  port_base, why, secret.error())};
}

Result<int> ClaimPorts(int wanted_base, int num_ports) {
  // Else each port would seem to be taken.
  if (const FileDescriptor any(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)); !any.is_open()) {
    return Error{fmt::format("cannot look for free UDP ports: {}", ErrnoText(errno))};
  }
  if (wanted_base != 0) {
    if (wanted_base < 1024 || wanted_base + num_ports > 65536) {
      return Error{fmt::format("--port {}: the block of {} ports must lie within 1024 to 65535",
                               wanted_base, num_ports)};
    }
    const bool is_free = BlockIsFree(wanted_base, num_ports);
    if (is_free && LockBlock(wanted_base, num_ports)) return wanted_base;
    if (is_free) {
      return Error{fmt::format(
          "another process has claimed some of the UDP ports {} to {} (`ss -xa | grep shoal-port` "
          "shows them); choose others with --port, or leave it out",
          wanted_base, wanted_base + num_ports - 1)};
    }
    return Error{fmt::format(
        "UDP ports {} to {} are not all free (`ss -ulnp` shows which programs have "
        "them, `shoal status` which missions run); choose others with --port, or leave it out",
        wanted_base, wanted_base + num_ports - 1)};
  }
  for (int base = PortPlan::kDefaultBase; base + num_ports < kLastBase; base += kBlockDistance) {
    if (BlockIsFree(base, num_ports) && LockBlock(base, num_ports)) return base;
  }
  return Error{fmt::format("no free block of {} UDP ports between {} and {}", num_ports,
                           PortPlan::kDefaultBase, kLastBase)};
}

Result<bool> Register(const RunningMission& mission) {
  std::string text;
  const auto add = [&](std::string_view key, std::string value) {
    // A line break would begin another key; between TOML's values, a blank is as good.
    std::replace(value.begin(), value.end(), '\n', ' ');
    text += fmt::format("{} {}\n", key, value);
  };
  add("name", mission.name);
  add("file", mission.file);
  add("folder", mission.folder);
  add("mission_id", std::to_string(mission.mission_id));
  add("port_base", std::to_string(mission.port_base));
  add("layout", std::string(Name(mission.layout)));
  add("grouping", mission.grouping);
  if (!mission.playback_of.empty()) add("playback_of", mission.playback_of);
  add("pid", std::to_string(mission.pid));
  for (const std::string& vehicle : mission.vehicles) add("vehicle", vehicle);
  for (const std::string& vehicle : mission.without_helm) add("without_helm", vehicle);
  for (const auto& [group, members] : mission.groups) {
    for (const std::string& member : members) add("member", fmt::format("{} {}", member, group));
  }
  for (const OrderWords& order : mission.orders) {
    add("order", fmt::format("{}\t{}\t{}", order.name, order.target, fmt::join(order.words, "\t")));
  }
  for (const std::string& each : mission.overrides) add("set", each);
  RemoveRunFile(EndedName(mission.port_base));
  const Result<std::string> written = WriteRunFile(EntryName(mission.port_base), text);
  if (!written.ok()) return Error{written.error()};
  return true;
}

void Unregister(int port_base) {
  RemoveRunFile(EntryName(port_base));
  RemoveRunFile(SecretName(port_base));
}

Result<std::vector<RunningMission>> RunningMissions() {
  const Result<std::string> folder = OpenRunFolder();
  if (!folder.ok()) return Error{folder.error()};
  std::vector<RunningMission> missions;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(*folder, error)) {
    if (entry.path().extension() != ".run") continue;
    const std::string name = entry.path().filename().string();
    const std::optional<RunningMission> mission = ReadEntry(name);
    // Its launcher is this user's; EPERM means that another user's process has its number now.
    if (mission && kill(mission->pid, 0) == 0) {
      missions.push_back(*mission);
    } else {
      RemoveRunFile(name);
      RemoveRunFile(entry.path().stem().string() + ".secret");
    }
  }
  std::sort(missions.begin(), missions.end(),
            [](const auto& a, const auto& b) { return a.port_base < b.port_base; });
  return missions;
}

Result<RunningMission> ChooseMission(const std::vector<RunningMission>& missions, int port_base,
                                     const std::string& folder, Purpose purpose) {
  if (missions.empty()) {
    return Error{"no mission is running on this machine; start one with `shoal run FILE`"};
  }
  const auto is_wanted = [&](const RunningMission& mission) {
    if (port_base != 0) return mission.port_base == port_base;
    return !folder.empty() && mission.folder == folder;  // Empty: it has been removed.
  };
  const auto count = std::count_if(missions.begin(), missions.end(), is_wanted);
  if (count == 1) return *std::find_if(missions.begin(), missions.end(), is_wanted);
  if (port_base == 0 && missions.size() == 1 && purpose == Purpose::kLook) return missions.front();
  std::string message;
  if (port_base != 0) {
    message = fmt::format("no mission runs at port {}; running:", port_base);
  } else if (count > 1) {
    message =
        "several missions that were started in this folder are running; choose one with "
        "--port:";
  } else if (missions.size() > 1) {
    message = fmt::format(
        "several missions are running, and none was started in this folder ({}); choose one with "
        "--port:",
        folder);
  } else {
    message = fmt::format(
        "the mission that is running was not started in this folder ({}); to command it "
        "nevertheless, name its port:",
        folder);
  }
  for (const RunningMission& mission : missions) {
    message += fmt::format("\n  --port {}  {} ({}), started in {}", mission.port_base, mission.name,
                           mission.file, mission.folder);
  }
  return Error{message};
}

Result<RunningMission> FindRunningMission(int port_base, Purpose purpose) {
  const Result<std::vector<RunningMission>> missions = RunningMissions();
  if (!missions.ok()) return Error{missions.error()};
  return ChooseMission(*missions, port_base, WorkingFolder(), purpose);
}

std::string Describe(const RunningMission& mission) {
  return fmt::format(
      "{} ({}), ports from {}", mission.name,
      mission.playback_of.empty() ? mission.file : "PLAYBACK of " + mission.playback_of,
      mission.port_base);
}

std::string WorkingFolder() {
  std::error_code error;
  return fs::current_path(error).string();
}

}  // namespace shoal

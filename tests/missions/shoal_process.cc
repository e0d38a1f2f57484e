#include "tests/missions/shoal_process.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "lib/bus/bus/layout.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> ReadArguments(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/cmdline");
  std::vector<std::string> arguments;
  for (std::string each; std::getline(in, each, '\0');) arguments.push_back(each);
  return arguments;
}

std::string ParticipantOf(pid_t pid) {
  const std::vector<std::string> arguments = ReadArguments(pid);
  if (arguments.empty()) return {};
  std::string name = fs::path(arguments[0]).filename().string();
  for (size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == "--vehicle") name += "_" + arguments[i + 1];
    if (arguments[1] == "group" && arguments[i] == "--name") name = arguments[i + 1];
  }
  return name;
}

/// Returns the state of a process: 'R' running, 'Z' a zombie, 'T' stopped ...; 0: there is none.
char StateOf(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string stat;
  if (!std::getline(in, stat)) return 0;
  const size_t close = stat.rfind(')');
  return close != std::string::npos && stat.size() > close + 2 ? stat[close + 2] : '\0';
}

}  // namespace

TestFolder::TestFolder() {
  static std::atomic<int> counter = 0;
  path_ = fs::temp_directory_path() /
          ("shoal-test-" + std::to_string(getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(path_);
}

TestFolder::~TestFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

RunningProcess::RunningProcess(const TestFolder& folder, std::vector<std::string> argv) {
  static std::atomic<int> counter = 0;
  output_path_ = folder / ("output-" + std::to_string(counter++) + ".txt");
  const std::string run_dir = (folder / "run").string();
  std::vector<char*> pointers;
  for (std::string& each : argv) pointers.push_back(each.data());
  pointers.push_back(nullptr);
  started_s_ = WallSeconds();
  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setenv("SHOAL_RUN_DIR", run_dir.c_str(), 1);
    const int out = open(output_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
}

RunningProcess::~RunningProcess() {
  if (!HasEnded()) {
    Signal(SIGKILL);
    waitpid(pid_, &status_, 0);
  }
}

void RunningProcess::Signal(int signal) const { kill(pid_, signal); }

std::string RunningProcess::Output() const { return ReadFile(output_path_); }

bool RunningProcess::HasEnded() const {
  if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return ended_;
}

bool RunningProcess::WaitFor(const std::string& text, double patience_s) const {
  const double begin = WallSeconds();
  while (true) {
    const bool ended = HasEnded();
    if (Output().find(text) != std::string::npos) return true;
    if (ended || WallSeconds() - begin > patience_s) return false;
    SleepSeconds(0.01);
  }
}

Finished RunningProcess::Wait(double patience_s) {
  const double begin = WallSeconds();
  while (!HasEnded() && WallSeconds() - begin < patience_s) SleepSeconds(0.005);
  if (!ended_) {
    Signal(SIGKILL);
    waitpid(pid_, &status_, 0);
    ended_ = true;
  }
  return {.exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : -1,
          .output = Output(),
          .wall_s = WallSeconds() - started_s_};
}

std::map<std::string, pid_t> RunningProcess::Participants() const {
  const std::string pid = std::to_string(pid_);
  std::ifstream in("/proc/" + pid + "/task/" + pid + "/children");
  std::map<std::string, pid_t> participants;
  for (pid_t child = 0; in >> child;) participants[ParticipantOf(child)] = child;
  return participants;
}

Finished RunShoal(const TestFolder& folder, std::vector<std::string> arguments, double patience_s) {
  arguments.insert(arguments.begin(), Program("shoal"));
  return RunningProcess(folder, std::move(arguments)).Wait(patience_s);
}

bool AwaitThat(const std::function<bool()>& holds) {
  for (const double begin = WallSeconds(); !holds();) {
    if (WallSeconds() - begin > kPatience_s) return false;
    SleepSeconds(0.01);
  }
  return true;
}

std::string AwaitPage(const TestFolder& folder, const std::string& app,
                      const std::function<bool(const std::string& page)>& holds) {
  std::string page;
  AwaitThat([&] {
    page = RunShoal(folder, {"status", app}).output;
    return holds(page);
  });
  return page;
}

std::string AwaitStatus(const TestFolder& folder, const std::string& app,
                        const std::vector<std::string>& texts) {
  return AwaitPage(folder, app, [&](const std::string& page) {
    return std::all_of(texts.begin(), texts.end(), [&](const std::string& text) {
      return page.find(text) != std::string::npos;
    });
  });
}

std::string Program(const std::string& name) {
  return std::string(SHOAL_BINARY_DIR) + "/bin/" + name;
}

int FreeTcpPorts(int count) {
  // Each process has a block of ports of its own, which its number picks, so that tests side by
  // side do not meet: a port is free until a program listens there. Its next blocks lie far from
  // those of its neighbours.
  constexpr int kBlocks = 1500;
  constexpr int kBlock = 8;
  constexpr int kToNextBlock = 751;
  static int num_given = 0;
  for (int tries = 0; tries < kBlocks && count <= kBlock; ++tries) {
    if (num_given % kBlock + count > kBlock) num_given = (num_given / kBlock + 1) * kBlock;
    const int block = (getpid() + num_given / kBlock * kToNextBlock) % kBlocks;
    const int first = 20'000 + block * kBlock + num_given % kBlock;
    num_given += count;
    bool are_free = true;
    for (int i = 0; i < count && are_free; ++i) {
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_port = htons(static_cast<uint16_t>(first + i));
      address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      const FileDescriptor probe(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
      are_free =
          bind(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    if (are_free) return first;
  }
  ADD_FAILURE() << "no " << count << " TCP ports in a row are free from 20000 to 32000";
  return 0;
}

std::string MissionFile(const std::string& name) {
  return std::string(SHOAL_SOURCE_DIR) + "/missions/" + name;
}

void CopyMissionData(const std::filesystem::path& folder) {
  for (const char* name : {"data", "tracks"}) {
    std::filesystem::copy(MissionFile(name), folder / name,
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
  }
}

std::string ReadFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void WriteFile(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool IsAlive(pid_t pid) {
  const char state = StateOf(pid);
  return state != 0 && state != 'Z';
}

bool AllGone(const std::map<std::string, pid_t>& processes) {
  return AwaitThat([&] {
    return std::none_of(processes.begin(), processes.end(),
                        [](const auto& each) { return IsAlive(each.second); });
  });
}

bool IsStopped(pid_t pid) {
  return AwaitThat([&] { return StateOf(pid) == 'T'; });
}

double WallSeconds() { return static_cast<double>(MonotonicMicroseconds()) / 1e6; }

void SleepSeconds(double seconds) { usleep(static_cast<useconds_t>(seconds * 1e6)); }

void SendDatagram(int port, std::string_view datagram) {
  const int sender = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int ttl = 0;
  setsockopt(sender, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = inet_addr(kLcmGroup);
  EXPECT_EQ(sendto(sender, datagram.data(), datagram.size(), 0,
                   reinterpret_cast<const sockaddr*>(&address), sizeof address),
            static_cast<ssize_t>(datagram.size()));
  close(sender);
}

}  // namespace shoal

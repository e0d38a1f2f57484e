#include "apps/shoal/doctor_facts.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lib/bus/bus/lcm_transport.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_folder.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr int kTrialMessages = 100;
constexpr int64_t kTrialPatience_us = 2'000'000;
/// A mission of two vehicles in the shared layout has this many ports.
constexpr int kPortsOfASmallMission = 3;

/// Returns a UDP port that is free, or 0.
int FreeUdpPort() {
  const int fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return 0;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  socklen_t size = sizeof address;
  const bool bound = bind(fd, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(fd);
  return bound ? ntohs(address.sin_port) : 0;
}

void WriteTrial(int fd, const MulticastTrial& trial) {
  [[maybe_unused]] const ssize_t written = write(fd, &trial, sizeof trial);
}

/// Sends messages to itself; writes its progress to `fd`: opened, and at the end how many came.
void TryMulticastHere(int fd) {
  LcmTransport transport;
  MulticastTrial trial{.sent = kTrialMessages, .opened = false, .received = 0};
  transport.set_receiver(
      [&](int, std::string_view, std::span<const uint8_t>) { ++trial.received; });
  const int port = FreeUdpPort();
  const uint8_t text[] = "shoal doctor";
  transport.Listen(port, "SHOAL_DOCTOR");
  trial.opened = transport.error().empty();
  WriteTrial(fd, trial);
  if (!trial.opened) return;
  for (int i = 0; i < kTrialMessages; ++i) transport.Send(port, "SHOAL_DOCTOR", text);
  while (trial.received < kTrialMessages) {
    transport.Poll(100'000);
    WriteTrial(fd, trial);
  }
}

/// Tries in a child process: liblcm may print, or wait.
MulticastTrial TryMulticast() {
  MulticastTrial trial{.sent = kTrialMessages, .opened = false, .received = 0};
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return trial;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(null, STDERR_FILENO);
    TryMulticastHere(ends[1]);
    _exit(0);
  }
  close(ends[1]);
  const int64_t deadline = MonotonicMicroseconds() + kTrialPatience_us;
  while (child > 0) {
    const int64_t left_us = deadline - MonotonicMicroseconds();
    pollfd waiting{.fd = ends[0], .events = POLLIN, .revents = 0};
    if (left_us <= 0 || poll(&waiting, 1, static_cast<int>(left_us / 1000) + 1) <= 0) break;
    MulticastTrial news;
    if (read(ends[0], &news, sizeof news) != sizeof news) break;
    trial = news;
  }
  close(ends[0]);
  if (child > 0) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  return trial;
}

bool Exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

void LookAtJava(DoctorFacts* facts) {
  std::error_code error;
  // Relative to build/bin/shoal; both exist where it was built.
  const fs::path build = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  facts->source_dir = build.parent_path().string();
  const fs::path types = build / "shoal_types.jar";
  if (Exists(types)) facts->types_jar = types.string();

  const char* display = std::getenv("DISPLAY");
  facts->has_display = display != nullptr && *display != '\0';
  facts->has_lcm_jar = Exists("/usr/share/java/lcm.jar");
  facts->has_chart_jar = Exists("/usr/share/java/jchart2d.jar");
  const char* path = std::getenv("PATH");
  facts->java = FindExecutable("java", path == nullptr ? "" : path);
  if (facts->java.empty()) return;
  const fs::path home = fs::canonical(facts->java, error).parent_path().parent_path();
  facts->java_has_windows = Exists(home / "lib/libawt_xawt.so");
}

std::optional<int64_t> Limit(__rlimit_resource resource) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  return static_cast<int64_t>(limit.rlim_cur);
}

/// Returns the smaller of the user's limit and the container's.
std::optional<int64_t> ThreadLimit() {
  std::optional<int64_t> limit = Limit(RLIMIT_NPROC);
  int64_t of_container = 0;
  if (std::ifstream("/sys/fs/cgroup/pids.max") >> of_container) {
    limit = std::min(limit.value_or(of_container), of_container);
  }
  return limit;
}

}  // namespace

DoctorFacts CollectDoctorFacts() {
  DoctorFacts facts;
  // First, while this process has only one thread: it forks.
  facts.multicast = TryMulticast();
  facts.in_container = Exists("/.dockerenv") || Exists("/run/.containerenv");
  facts.receive_buffer_limit_bytes = ReceiveBufferLimit();
  if (const Result<int> base = ClaimPorts(0, kPortsOfASmallMission); base.ok()) {
    facts.port_base = *base;
  }
  if (Result<std::vector<RunningMission>> running = RunningMissions(); running.ok()) {
    facts.running = std::move(*running);
    // What a mission does first; a full disk shows here too.
    const Result<std::string> written = WriteRunFile("doctor", "");
    if (!written.ok()) facts.run_folder_error = written.error();
    RemoveRunFile("doctor");
  } else {
    facts.run_folder_error = running.error();
  }
  std::error_code error;
  facts.folder = fs::current_path(error).string();
  struct statvfs disk {};
  if (statvfs(".", &disk) == 0) {
    facts.folder_free_bytes =
        static_cast<int64_t>(disk.f_bavail) * static_cast<int64_t>(disk.f_frsize);
  }
  facts.max_open_files = Limit(RLIMIT_NOFILE);
  facts.max_threads = ThreadLimit();
  LookAtJava(&facts);
  return facts;
}

}  // namespace shoal

#include "apps/viewer/plan_runs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "lib/run/run/run_app.h"
#include "lib/run/run/run_folder.h"

namespace shoal {

namespace {

constexpr std::chrono::milliseconds kLook(50);
constexpr int64_t kPatience_us = 40'000'000;
constexpr int64_t kEndPatience_us = 5'000'000;
constexpr std::string_view kAddress = "viewer: http";

/// Returns the address that the viewer of a mission has printed; empty: not yet.
std::string AddressIn(const std::string& log_path) {
  std::ifstream in(log_path);
  for (std::string line; std::getline(in, line);) {
    const size_t at = line.find(kAddress);
    if (at == line.npos || in.eof()) continue;  // The last line may be cut.
    const size_t begin = at + kAddress.size() - 4;
    return line.substr(begin, line.find_first_of(" \t", begin) - begin);
  }
  return "";
}

/// Returns the program `shoal`, which lies beside this one.
std::string ShoalBesideThis() {
  std::error_code error;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "shoal" : (own.parent_path() / "shoal").string();
}

}  // namespace

PlanRuns::PlanRuns() : thread_([this] { Work(); }) {}

PlanRuns::~PlanRuns() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void PlanRuns::Work() {
  std::unique_lock lock(mutex_);
  while (!is_stopping_) {
    for (Order* order : orders_) {
      if (const Result<pid_t> started = children_.Start(order->command); !started.ok()) {
        order->error = started.error();
      }
      order->is_done = true;
    }
    orders_.clear();
    for (ChildExit& exit : children_.Reap()) exits_.push_back(std::move(exit));
    news_.notify_all();
    // The end of a child is found by looking: its signal belongs to the whole process.
    news_.wait_for(lock, kLook, [&] { return is_stopping_ || !orders_.empty(); });
  }
  children_.SignalAll(SIGINT);
  const int64_t deadline_us = MonotonicMicroseconds() + kEndPatience_us;
  while (children_.num_running() > 0 && MonotonicMicroseconds() < deadline_us) {
    children_.Reap();
    news_.wait_for(lock, kLook);
  }
}

Result<std::string> PlanRuns::Start(const std::string& file,
                                    const std::vector<std::string>& overrides) {
  const Result<std::string> folder = OpenRunFolder();
  if (!folder.ok()) return folder;
  std::unique_lock lock(mutex_);
  if (children_.num_running() + orders_.size() >= kMaxRuns) {
    return Error{
        fmt::format("{} missions run that this viewer has started: end one first", kMaxRuns)};
  }
  const std::string name = fmt::format("plan-{}-{}", getpid(), ++num_started_);
  Order order;
  order.command = {.name = name,
                   .argv = {ShoalBesideThis(), "run", file, "--view", "--allow-commands"},
                   .environment = {},
                   .log_path = *folder + "/" + name + ".txt",
                   .is_log_private = true};
  for (const std::string& each : overrides) {
    order.command.argv.insert(order.command.argv.end(), {"--set", each});
  }
  orders_.push_back(&order);
  news_.notify_all();
  news_.wait(lock, [&] { return order.is_done; });
  if (!order.error.empty()) return Error{order.error};
  const std::string log_path = order.command.log_path;
  const int64_t deadline_us = MonotonicMicroseconds() + kPatience_us;
  while (!is_stopping_ && MonotonicMicroseconds() < deadline_us) {
    if (std::string address = AddressIn(log_path); !address.empty()) return address;
    const auto ended = std::find_if(exits_.begin(), exits_.end(),
                                    [&](const ChildExit& each) { return each.name == name; });
    if (ended != exits_.end()) {
      return Error{fmt::format("shoal run {}: {}\n{}", ended->how, file,
                               fmt::join(ended->last_lines, "\n"))};
    }
    news_.wait_for(lock, kLook);
  }
  return Error{fmt::format("the mission has not begun within {} s; {} has what it printed",
                           kPatience_us / 1'000'000, log_path)};
}

}  // namespace shoal

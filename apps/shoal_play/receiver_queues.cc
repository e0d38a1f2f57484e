#include "apps/shoal_play/receiver_queues.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <system_error>

namespace shoal {

namespace {

constexpr int64_t kPause_us = 200;

}  // namespace

std::vector<ReceiverQueue> ParseQueues(std::istream& table, const std::set<int>& ports,
                                       const std::set<std::string, std::less<>>& own) {
  // sl local_address rem_address st tx:rx tr:when retrnsmt uid timeout inode ref pointer drops
  constexpr size_t kLocalAddress = 1;
  constexpr size_t kQueues = 4;
  constexpr size_t kInode = 9;
  constexpr int kHexadecimal = 16;
  std::vector<ReceiverQueue> queues;
  for (std::string line; std::getline(table, line);) {
    std::istringstream in(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
    if (words.size() <= kInode) continue;
    const std::string& address = words[kLocalAddress];
    const std::string& waiting = words[kQueues];
    const size_t port_at = address.find(':') + 1;
    const size_t receive_at = waiting.find(':') + 1;
    const auto port =
        static_cast<int>(std::strtol(address.c_str() + port_at, nullptr, kHexadecimal));
    if (!ports.contains(port) || own.contains(words[kInode])) continue;
    queues.push_back(
        {.inode = words[kInode],
         .waiting_bytes = std::strtoll(waiting.c_str() + receive_at, nullptr, kHexadecimal)});
  }
  return queues;
}

std::set<std::string, std::less<>> OwnSocketInodes() {
  std::set<std::string, std::less<>> inodes;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string target = std::filesystem::read_symlink(entry.path(), error).string();
    constexpr std::string_view kPrefix = "socket:[";
    if (!target.starts_with(kPrefix)) continue;
    inodes.insert(target.substr(kPrefix.size(), target.size() - kPrefix.size() - 1));
  }
  return inodes;
}

PacedTransport::PacedTransport(Transport* inner, Look look, Pause pause)
    : inner_(*inner), look_(std::move(look)), pause_(std::move(pause)) {}

void PacedTransport::Send(int port, std::string_view channel, std::span<const uint8_t> datagram) {
  ++num_sent_;
  num_bytes_ += static_cast<int64_t>(datagram.size());
  if (num_sent_ >= kDatagramsBetweenLooks || num_bytes_ >= kBytesBetweenLooks) WaitForReceivers();
  inner_.Send(port, channel, datagram);
}

void PacedTransport::WaitForReceivers() {
  num_sent_ = 0;
  num_bytes_ = 0;
  std::map<std::string, int64_t, std::less<>> least;
  for (int64_t waited_us = 0;; waited_us += kPause_us) {
    bool is_behind = false;
    for (const ReceiverQueue& queue : look_()) {
      const auto given_up = given_up_.find(queue.inode);
      if (given_up != given_up_.end()) {
        if (queue.waiting_bytes >= given_up->second) continue;
        given_up_.erase(given_up);  // It reads again.
      }
      if (queue.waiting_bytes <= kMaxWaiting_bytes) continue;
      const auto [it, is_new] = least.emplace(queue.inode, queue.waiting_bytes);
      if (!is_new && queue.waiting_bytes < it->second) {
        it->second = queue.waiting_bytes;
        waited_us = 0;
      }
      is_behind = true;
    }
    if (!is_behind) return;
    if (waited_us >= kPatience_us) {
      for (const auto& [inode, waiting_bytes] : least) {
        given_up_[inode] = waiting_bytes;
        ever_given_up_.insert(inode);
      }
      return;
    }
    pause_(kPause_us);
    waited_us_ += kPause_us;
  }
}

}  // namespace shoal

#include "apps/shoal_play/receiver_queues.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

namespace shoal {

namespace {

constexpr int64_t kPause_us = 200;

/// Sets `words` to the first ones of a line; false: it has fewer.
bool TakeWords(std::string_view line, std::span<std::string_view> words) {
  for (std::string_view& word : words) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    word = line.substr(0, line.find(' '));
    line.remove_prefix(word.size());
  }
  return !words.back().empty();
}

/// Returns the number behind the colon of "00000000:1DF3"; 0: there is none.
int64_t HexadecimalBehindColon(std::string_view text) {
  constexpr int kHexadecimal = 16;
  text.remove_prefix(text.find(':') + 1);
  int64_t number = 0;
  (void)std::from_chars(text.data(), text.data() + text.size(), number, kHexadecimal);
  return number;
}

}  // namespace

std::vector<ReceiverQueue> ParseQueues(std::istream& table, const std::set<int>& ports,
                                       const std::set<std::string, std::less<>>& own) {
  // sl local_address rem_address st tx:rx tr:when retrnsmt uid timeout inode ref pointer drops
  constexpr size_t kLocalAddress = 1;
  constexpr size_t kQueues = 4;
  constexpr size_t kInode = 9;
  std::vector<ReceiverQueue> queues;
  std::array<std::string_view, kInode + 1> words;
  for (std::string line; std::getline(table, line);) {
    if (!TakeWords(line, words)) continue;
    const auto port = static_cast<int>(HexadecimalBehindColon(words[kLocalAddress]));
    if (!ports.contains(port) || own.contains(words[kInode])) continue;
    queues.push_back({.inode = std::string(words[kInode]),
                      .waiting_bytes = HexadecimalBehindColon(words[kQueues])});
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

ForeignQueues::ForeignQueues(std::set<int> ports, std::function<Inodes()> list_own)
    : ports_(std::move(ports)), list_own_(std::move(list_own)) {}

std::vector<ReceiverQueue> ForeignQueues::In(std::istream& table) {
  std::vector<ReceiverQueue> queues = ParseQueues(table, ports_, own_);
  const auto is_unknown = [&](const ReceiverQueue& queue) {
    return !foreign_.contains(queue.inode);
  };
  if (std::ranges::none_of(queues, is_unknown)) return queues;
  own_ = list_own_();
  std::erase_if(queues, [&](const ReceiverQueue& queue) { return own_.contains(queue.inode); });
  for (const ReceiverQueue& queue : queues) foreign_.insert(queue.inode);
  return queues;
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

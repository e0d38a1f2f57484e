#include "lib/bus/bus/socket_drops.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace shoal {

namespace {

/// The sockets of this process, by inode: /proc/self/fd/7 -> socket:[12345].
std::set<std::string> OwnSockets() {
  std::set<std::string> inodes;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string target = std::filesystem::read_symlink(entry.path(), error).string();
    constexpr std::string_view kPrefix = "socket:[";
    if (!target.starts_with(kPrefix)) continue;
    inodes.insert(target.substr(kPrefix.size(), target.size() - kPrefix.size() - 1));
  }
  return inodes;
}

}  // namespace

int64_t DroppedDatagrams(std::span<const int> ports) {
  // sl local_address rem_address st tx:rx tr:when retrnsmt uid timeout inode ref pointer drops
  constexpr size_t kLocalAddress = 1;
  constexpr size_t kInode = 9;
  constexpr size_t kDrops = 12;
  const std::set<std::string> own = OwnSockets();
  int64_t total = 0;
  std::ifstream table("/proc/net/udp");
  for (std::string line; std::getline(table, line);) {
    std::istringstream in(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
    if (words.size() <= kDrops || !own.contains(words[kInode])) continue;
    const std::string& address = words[kLocalAddress];
    const auto port = std::strtol(address.c_str() + address.find(':') + 1, nullptr, 16);
    if (std::find(ports.begin(), ports.end(), port) == ports.end()) continue;
    total += std::strtoll(words[kDrops].c_str(), nullptr, 10);
  }
  return total;
}

}  // namespace shoal

#include "lib/bus/bus/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <unordered_map>

#include "lib/base/check/check.h"
#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

namespace {

constexpr int kStepPorts = 2;

/// Of channels without a vehicle's name; all others are taken to have one.
ChannelHome HomeOf(std::string_view channel) {
  static const std::unordered_map<std::string_view, ChannelHome> homes = [] {
    std::unordered_map<std::string_view, ChannelHome> found;
    for (const ChannelRow& row : ChannelTable()) {
      if (row.home != ChannelHome::kVehicle) found.emplace(row.topic, row.home);
    }
    return found;
  }();
  const auto home = homes.find(channel);
  return home == homes.end() ? ChannelHome::kVehicle : home->second;
}

}  // namespace

std::string_view Name(Layout layout) {
  return layout == Layout::kShared ? "shared" : "communities";
}

PortPlan::PortPlan(int base, Layout layout, const std::vector<std::string>& vehicles)
    : base_(base), layout_(layout), num_vehicles_(static_cast<int>(vehicles.size())) {
  SHOAL_CHECK(base >= 1024 && base + num_ports() <= 65536,
              "the block of ports lies within 1024 to 65535");
  if (layout == Layout::kShared) return;
  for (size_t i = 0; i < vehicles.size(); ++i) {
    community_ports_[UpperCase(vehicles[i])] =
        shore_port() + 1 + static_cast<int>(i) % kMaxCommunities;
  }
}

int PortPlan::PortOf(std::string_view channel) const {
  switch (HomeOf(channel)) {
    case ChannelHome::kTickPort:
      return tick_port();
    case ChannelHome::kDonePort:
      return done_port();
    case ChannelHome::kShore:
      return shore_port();
    case ChannelHome::kVehicle:
      break;
  }
  if (layout_ == Layout::kShared) return shore_port();
  // Vehicle names may hold '_': the longest name that ends the channel's wins.
  for (size_t i = channel.find('_'); i != std::string_view::npos; i = channel.find('_', i + 1)) {
    const auto found = community_ports_.find(channel.substr(i + 1));
    if (found != community_ports_.end()) return found->second;
  }
  return shore_port();
}

std::vector<int> PortPlan::DataPorts() const {
  std::vector<int> ports;
  for (int port = shore_port(); port < base_ + num_ports(); ++port) ports.push_back(port);
  return ports;
}

int PortPlan::NumPorts(Layout layout, int num_vehicles) {
  const int communities = layout == Layout::kShared ? 0 : std::min(num_vehicles, kMaxCommunities);
  return kStepPorts + 1 + communities;
}

Layout PortPlan::Suggest(int num_vehicles) {
  return num_vehicles < 10 ? Layout::kShared : Layout::kCommunities;
}

int ReceiveBufferLimit() {
  int limit = 212992;
  std::ifstream("/proc/sys/net/core/rmem_max") >> limit;
  return limit;
}

std::string LcmUrl(int port) {
  static const int buffer = std::min(kWantedReceiveBuffer, ReceiveBufferLimit());
  return fmt::format("udpm://{}:{}?ttl=0&recv_buf_size={}", kLcmGroup, port, buffer);
}

}  // namespace shoal

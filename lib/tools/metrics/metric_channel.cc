#include "lib/tools/metrics/metric_channel.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

Result<const ChannelRow*> FindMetricChannel(const Mission& mission, std::string_view channel) {
  std::vector<std::string> names;
  for (const ChannelRow& row : ChannelTable()) {
    const auto is_it = [&](std::string name) {
      const bool is_same = name == channel;
      if (row.logged) names.push_back(std::move(name));
      return is_same;
    };
    bool is_found = false;
    if (row.home != ChannelHome::kVehicle) {
      is_found = is_it(std::string(row.topic));
    } else {
      for (const Vehicle& vehicle : mission.vehicles) {
        is_found |= is_it(fmt::format("{}_{}", row.topic, UpperCase(vehicle.name)));
      }
    }
    if (!is_found) continue;
    if (row.logged) return &row;
    return Error{fmt::format("{} is not in a mission's log: name a channel that is", channel)};
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string hint = DidYouMean(channel, candidates);
  if (hint.empty()) hint = "; docs/reference/channels.md has them all";
  return Error{fmt::format("the mission has no channel {}{}", Quoted(channel), hint)};
}

}  // namespace shoal

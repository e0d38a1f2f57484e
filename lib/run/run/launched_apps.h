// What the launcher needs of apps that it does not link: the one that it runs itself, and what
// those of other processes read.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/director.h"
#include "lib/run/run/roster.h"

namespace shoal {

struct LaunchedApps {
  /// Makes the director of a mission, which outlives it.
  std::function<std::unique_ptr<Director>(const Mission& mission, Bus& bus)> make_director;
  /// Returns the channels to which one of shoal's own apps subscribes.
  std::function<std::vector<std::string>(const RosterEntry& entry, const Mission& mission)>
      subscriptions_of;
};

}  // namespace shoal

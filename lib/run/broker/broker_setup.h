// What a broker needs to know before its first message, and the same as COMMS_RULES.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/comms/routing/router.h"
#include "lib/comms/routing/rules.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/model/mission.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/sea/acoustics/channel_plan.h"

namespace shoal {

struct BrokerSetup {
  RoutingRules rules;
  uint64_t seed = 1;
  int64_t start_utime = 0;  ///< A first step later than this means: started during the mission.
  int64_t tick_us = 100'000;
  std::vector<std::string> vehicles;                         ///< Of the mission.
  std::vector<std::pair<std::string, LinkFactors>> factors;  ///< Others than 1.
  MediaSetup media = {};
  std::vector<AcousticNode> nodes = {};  ///< The vehicles, in the same order.
  GeoPoint origin = {};                  ///< Of the mission's plane.

  /// True where media decide by where vehicles are in truth: NAV_V of the mission's vehicles.
  bool GoesByTruth() const { return media.acoustics.is_used || !media.of_vehicles.empty(); }
};

/// Returns the setup of a mission file.
[[nodiscard]] BrokerSetup SetupOf(const Mission& mission);

/// Returns the setup of a recorded COMMS_RULES, or an error where it holds something impossible.
[[nodiscard]] Result<BrokerSetup> SetupOf(const BrokerRules& rules);

/// Returns the rules in force, without a time; `setup` has what does not change.
[[nodiscard]] BrokerRules RulesNow(const BrokerSetup& setup, const Router& router);

}  // namespace shoal

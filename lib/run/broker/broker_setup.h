// What a broker needs to know before its first message, and the same as COMMS_RULES.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
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
#include "lib/sea/acoustics/ray_channel.h"

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
  /// What channels of sound name and do not hold, as far as it could be read: the sea floor, and
  /// tables of arrivals by their file.
  std::optional<SeaFloor> floor = {};
  std::map<std::string, std::shared_ptr<const ArrivalTable>> arrivals = {};

  /// True where media decide by where vehicles are in truth: NAV_V of the mission's vehicles.
  bool GoesByTruth() const { return media.acoustics.is_used || !media.of_vehicles.empty(); }
  /// True where sound bends in a network, and the motion of vehicles matters.
  bool HasRays() const;
  /// Returns what a network's channel names.
  RaySurroundings SurroundingsOf(const Acoustics& acoustics) const;
  /// Returns why a network's channel lacks what it names; empty: it lacks nothing.
  std::string MissingOf(const Acoustics& acoustics) const;
};

/// Returns the setup of a mission file.
[[nodiscard]] BrokerSetup SetupOf(const Mission& mission);

/// Returns the setup of a recorded COMMS_RULES, or an error where it holds something impossible.
[[nodiscard]] Result<BrokerSetup> SetupOf(const BrokerRules& rules);

/// Returns the rules in force, without a time; `setup` has what does not change.
[[nodiscard]] BrokerRules RulesNow(const BrokerSetup& setup, const Router& router);

}  // namespace shoal

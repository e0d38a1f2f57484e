// The participants of a mission and their names on the bus.
#pragma once

#include <string>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

/// One participant of the step protocol.
struct RosterEntry {
  std::string name;          ///< On the bus: "helm_alpha", "shore_broker", the user's own name.
  std::string app = {};      ///< Which of shoal's programs; empty: a user's own.
  std::string vehicle = {};  ///< As the mission writes it; empty: not of one vehicle.
  size_t vehicle_place = 0;  ///< Of `vehicle` in the mission.
  Provider provider = Provider::kShoal;
  std::vector<std::string> command = {};  ///< Of a user's own; empty: the user starts it.
  std::string host = {};                  ///< The [[host]] on which it runs; empty: this computer.
};

/// Returns all participants but the launcher's own ("shoal") and those whose provider is kNone.
std::vector<RosterEntry> MakeRoster(const Mission& mission, bool with_recorder);

/// Returns the name on the bus of a vehicle's app, such as "helm_alpha".
std::string ParticipantName(std::string_view app, std::string_view vehicle);

/// Returns the vehicles' names in mission order.
std::vector<std::string> VehicleNames(const Mission& mission);

}  // namespace shoal

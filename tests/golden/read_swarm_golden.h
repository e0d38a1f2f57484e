// Reads the vehicles of munet/recovery.json and munet/receive_handlers.json: what they
// are and know of their group.
#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/group_state.h"
#include "lib/comms/swarm/swarm_field.h"
#include "tests/golden/read_golden.h"

namespace shoal {

/// JSON has no NaN and no infinities; the files spell them.
inline double GoldenNumber(const nlohmann::json& number) {
  if (number.is_number()) return number.get<double>();
  const double infinity = std::numeric_limits<double>::infinity();
  if (number == "inf") return infinity;
  if (number == "-inf") return -infinity;
  EXPECT_EQ(number, "nan");
  return std::nan("");
}

/// Returns nothing for a name that no field has.
inline std::optional<SwarmField> FieldNamed(std::string_view name) {
  for (size_t i = 0; i < kNumSwarmFields; ++i) {
    if (kSwarmFieldNames.At(i) == name) return static_cast<SwarmField>(i);
  }
  return std::nullopt;
}

inline Eigen::Vector3d GoldenVector(const nlohmann::json& numbers) {
  return {GoldenNumber(numbers[0]), GoldenNumber(numbers[1]), GoldenNumber(numbers[2])};
}

inline Motion GoldenMotion(const nlohmann::json& position, const nlohmann::json& velocity) {
  return {.position_m = GoldenVector(position), .velocity_mps = GoldenVector(velocity)};
}

inline SwarmContact GoldenContact(const nlohmann::json& model) {
  const std::string group = model["groupId"];
  SwarmContact contact = PlacedContact(model["id"], static_cast<uint8_t>(group[0]),
                                       GoldenMotion(model["eta"], model["velocity"]));
  contact.report.next = GoldenMotion(model["nextEta"], model["nextVel"]);
  contact.has_reported = !model["log"].empty();
  contact.reported_us = Microseconds(GoldenNumber(model["timeLastMsg"]));
  for (const nlohmann::json& entry : model["log"]) {
    AppendToLog({.time_us = Microseconds(GoldenNumber(entry["t"])),
                 .motion = GoldenMotion(entry["pos"], entry["vel"])},
                &contact.log);
  }
  return contact;
}

inline GroupState GoldenState(const nlohmann::json& vehicle) {
  const std::string group = vehicle["groupId"];
  GroupState state{.own_id = vehicle["id"],
                   .group_id = static_cast<uint8_t>(group[0]),
                   .is_leader = vehicle["isLeader"],
                   .episode_us = Microseconds(GoldenNumber(vehicle["epsdDur"])),
                   .response_order = vehicle["rspnSched"],
                   .response_start_us = Microseconds(GoldenNumber(vehicle["rspnFrame"]))};
  for (const nlohmann::json& member : vehicle["group"]) {
    state.members.push_back(GoldenContact(member));
  }
  if (!vehicle["target"].is_null()) state.target = GoldenContact(vehicle["target"]);
  return state;
}

inline int64_t GoldenClock_us(const nlohmann::json& vehicle) {
  return Microseconds(GoldenNumber(vehicle["clock"]));
}

}  // namespace shoal

// Vessels with helms that weigh aims, in the set-up of tests/golden/helm: exact reports every 0.5
// s, a decision every 0.25 s, kinematic vessels.
//
//   const Meeting meeting = RunMeeting(ReadGoldenJson("helm/scenarios.json").at("headon_avoid"),
//   {}); EXPECT_GT(meeting.ClosestOf("abe", "ben"), 20);
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lib/behaviors/contact_ledger.h"
#include "lib/colregs/encounter_geometry.h"

namespace shoal {

struct MeetingOptions {
  ContactLimits contacts = {};
  double min_dwell_s = 3;
};

struct MeetingRow {
  double time_s = 0;
  VesselMotion motion = {};
};

struct Meeting {
  std::map<std::string, std::vector<MeetingRow>> tracks = {};  ///< At 1 Hz.
  /// Of each pair in alphabetical order.
  std::map<std::pair<std::string, std::string>, double> closest_m = {};
  /// Roles of one vessel toward another in their order, without sub-modes: "head-on cpa none".
  std::map<std::pair<std::string, std::string>, std::string> roles = {};
  std::map<std::pair<std::string, std::string>, int> num_role_changes = {};  ///< With sub-modes.
  std::vector<std::pair<double, std::string>> events = {};  ///< "abe: avd_ben ..." of helms.

  double ClosestOf(const std::string& a, const std::string& b) const {
    return closest_m.at({a, b});
  }
};

/// Runs a scenario of scenarios.json. Its behaviors: Waypoint, AvoidCollision, AvdColregsV22,
/// Trail.
[[nodiscard]] Meeting RunMeeting(const nlohmann::json& scenario, const MeetingOptions& options);

}  // namespace shoal

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

#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/contact_ledger.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "tests/golden/read_golden.h"

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
  /// Of helms: "abe: spawn avd_ben", and "abe: role ben head-on", "tail: REGION inside radius".
  std::vector<std::pair<double, std::string>> events = {};

  double ClosestOf(const std::string& a, const std::string& b) const {
    return closest_m.at({a, b});
  }
};

/// A decision of the original, and ours in the same state.
struct JudgedDecision {
  double time_s = 0;
  std::string vessel;
  HelmPoint theirs = {};
  HelmPoint ours = {};
  std::map<std::string, std::string> roles = {};  ///< Ours, by contact.
  double utility = 0;                             ///< The weighted sum at ours ...
  double utility_theirs = 0;                      ///< ... and at theirs.
};

struct JudgedMeeting {
  std::vector<JudgedDecision> decisions = {};  ///< At the full seconds.
  Meeting meeting = {};                        ///< Its events and roles.
};

/// Takes all vessels along the tracks of the original, and asks shoal's helms what they decide
/// there: their contacts and roles are those of the same history.
[[nodiscard]] JudgedMeeting JudgeAlong(const nlohmann::json& scenario,
                                       const std::vector<GoldenRow>& track,
                                       const MeetingOptions& options);

/// Runs a scenario of scenarios.json. Its behaviors: Waypoint, AvoidCollision, AvdColregsV22,
/// Trail.
[[nodiscard]] Meeting RunMeeting(const nlohmann::json& scenario, const MeetingOptions& options);

}  // namespace shoal

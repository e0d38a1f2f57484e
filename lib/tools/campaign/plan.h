// What a campaign runs: its cases, and the overrides of each of their trials.
//
//   const MadePlan made = MakePlan(campaign, BuildId());
//   LoadMissionText(made.plan.mission_text, campaign.mission_file,
//                   OverridesOf(campaign, made.plan, 0, 17));
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/tools/campaign/campaign.h"
#include "lib/tools/campaign/results.h"

namespace shoal {

struct Plan {
  std::string mission_text;         ///< Of the mission file, as it was when the plan was made.
  std::string build;                ///< Of the programs (lib/run/command_line/build_id.h).
  std::string arithmetic;           ///< Theirs; empty in folders of 0.2.
  std::string identity;             ///< Of all that every trial depends on, cases aside.
  std::vector<CampaignCase> cases;  ///< In the order of CampaignResults::cases.
  std::vector<MetricName> metrics;
  std::vector<MetricSpec> metric_specs;  ///< Checked against the mission.
};

struct MadePlan {
  Plan plan;
  /// Why there is no plan: the mission cannot be read, or is wrong in every case, or metrics name
  /// what it has not. Empty: the plan can be used.
  std::vector<std::string> errors;
  /// Cases whose missions are wrong: their trials will be errors. Each with its errors.
  std::vector<std::string> bad_cases;
  /// What the missions of the cases start or open beside shoal's own processes, each once: "mine:
  /// /usr/bin/planner --fast", "netsim: TCP ports; positions to gps.txt".
  std::vector<std::string> programs;
};

/// Returns the programs that the mission starts, and the files and ports that it opens, but not
/// shoal's own processes: as in MadePlan::programs.
[[nodiscard]] std::vector<std::string> ProgramsOf(const Mission& mission);

/// Returns the swept keys, in the order of the file.
[[nodiscard]] std::vector<std::string> SweepKeys(const Campaign& campaign);

/// Loads the mission of every case and gives each case its name.
[[nodiscard]] MadePlan MakePlan(const Campaign& campaign, const std::string& build);

/// Returns "comms.comms_range=100, policy=B", or "all" where there is only one.
[[nodiscard]] std::string CaseText(const Campaign& campaign, const CampaignCase& each);

/// Returns what the trial changes in the mission, as `--set` takes it, the seed last.
[[nodiscard]] std::vector<std::string> OverridesOf(const Campaign& campaign, const Plan& plan,
                                                   size_t case_number, int64_t repetition);

}  // namespace shoal

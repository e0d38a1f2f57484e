// `shoal encounters`: mission files of encounters, and trials of many.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/tools/analysis/encounter_mission.h"

namespace shoal {

/// Which encounter, and at which size.
struct EncounterChoice {
  std::string set = "random";  ///< imazu, overtaking, single or random.
  int number = 1;              ///< Of Imazu's cases, and of overtaking.
  std::string name = {};       ///< Of single targets.
  int num_vessels = 0;         ///< Of random ones; 0: 2 to 8, by seed.
  uint64_t seed = 1;
  EncounterMissionOptions mission = {};
};

/// An encounter with its mission file.
struct ChosenEncounter {
  EncounterScenario scenario;
  std::string mission;
};

/// Returns the encounter; the error states which names there are.
[[nodiscard]] Result<ChosenEncounter> ChooseEncounter(const EncounterChoice& choice);

/// Prints the mission file. Returns the exit code.
int WriteEncounter(const EncounterChoice& choice, std::ostream& out, std::ostream& err);

/// Prints the names of all encounters, one per line with what it is.
int ListEncounters(std::ostream& out);

struct EncounterTrialsOptions {
  EncounterChoice choice = {};  ///< Its set: of imazu and single all cases, each with every seed.
  uint64_t first_seed = 1;
  int64_t num_seeds = 100;
  std::vector<std::string> overrides = {};  ///< As --set takes them.
};

/// Runs encounters one after the other in this process, and prints one line of CSV for each; on
/// `err` a summary. Returns the exit code: kExitMissionFailed where vessels collided.
int RunEncounterTrials(const EncounterTrialsOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal

// Writes what /api/setup answers: what does not change while a mission runs.
#pragma once

#include <string>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

/// `protocol` of the answer: another number where a member of any answer was renamed or removed.
inline constexpr int kViewProtocol = 2;

/// What the answer shows beside the mission.
struct SetupFacts {
  std::string mode = "live";  ///< Or "recorded".
  std::string boot;
  bool commands = false;     ///< The client may send commands.
  bool knows_models = true;  ///< False: the mission was found in a log, which shows no models.
  double begin_s = 0;
  double end_s = 0;
  std::vector<std::string> notes;
};

/// Returns the answer. `floor_json`: FloorJson of the same mission.
[[nodiscard]] std::string SetupJson(const Mission& mission, const SetupFacts& facts,
                                    const std::string& floor_json);

/// Returns the sea floor as the answer has it, sampled over the area of starts, points and op_area;
/// "null" where the depth is not known. Where the mission names a floor that cannot be made, a note
/// in `notes` states why. Takes some 0.1 s.
[[nodiscard]] std::string FloorJson(const Mission& mission, std::vector<std::string>* notes);

}  // namespace shoal

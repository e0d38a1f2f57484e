// Reads mission files.
//
//   LoadedMission loaded = LoadMission("missions/berta.toml", {"mission.seed=7"});
//   if (!loaded.errors.empty()) { print them; exit 2; }
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

struct LoadedMission {
  Mission mission;  ///< Usable only where `errors` is empty.
  std::vector<std::string>
      errors;  ///< "file:line:column: what is wrong and how to fix it", in file order.
  std::vector<std::string> warnings;  ///< The same for what is suspicious but legal.
  size_t num_sure_failures = 0;       ///< Of the warnings: by which the mission fails for certain.
};

/// Reads `path` and applies `overrides`, each "key.path=value" with a TOML value (a bare word is
/// taken as a string); a vehicle is addressed by its name: "vehicle.alpha.start.x_m=5".
[[nodiscard]] LoadedMission LoadMission(const std::string& path,
                                        const std::vector<std::string>& overrides = {});

/// The same for text that is already in memory; `name` stands for the file in messages.
[[nodiscard]] LoadedMission LoadMissionText(std::string_view text, const std::string& name,
                                            const std::vector<std::string>& overrides = {});

/// Returns the mission as a mission file with every default filled in: what `shoal check
/// --explain` prints. Loading that text gives an equal mission.
[[nodiscard]] std::string Explain(const Mission& mission);

}  // namespace shoal

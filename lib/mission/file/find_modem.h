// Finds the file of an acoustic modem by its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/sea/acoustics/modem_preset.h"

namespace shoal {

struct NamedModem {
  ModemPreset modem;                  ///< Usable only where `problems` is empty.
  std::vector<std::string> problems;  ///< What is wrong, and how to fix it.
};

/// Reads the modem that a mission file names: a file relative to `folder`, the mission file's, with
/// or without .toml, or else one of those that come with shoal (data/modems), by its bare name.
[[nodiscard]] NamedModem FindModem(std::string_view name, const std::string& folder);

}  // namespace shoal

// `stealth = vname=alpha, stealth=0.8` of uFldNodeComms.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/tools/moos/moos_file.h"

namespace shoal {

struct LinkFactorSetting {
  std::string vehicle;
  std::string key;    ///< "stealth" or "earange".
  std::string value;  ///< As TOML.
};

[[nodiscard]] bool IsLinkFactor(std::string_view moos_key);

/// @pre IsLinkFactor(line.key)
/// Returns nothing where the value is not vname=NAME, KEY=NUMBER.
[[nodiscard]] std::optional<LinkFactorSetting> ParseLinkFactor(const MoosLine& line);

}  // namespace shoal

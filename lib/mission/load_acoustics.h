// The acoustic network as a text of its own, as COMMS_RULES carries it in logs.
//
//   const std::string text = ExplainAcoustics(mission.acoustics);
//   LoadedAcoustics loaded = LoadAcousticsText(text, "COMMS_RULES");
//   if (!loaded.errors.empty()) ...
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/acoustics/channel_plan.h"
#include "lib/mission/mission.h"

namespace shoal {

struct LoadedAcoustics {
  Acoustics acoustics;              ///< Usable only where `errors` is empty.
  std::vector<std::string> errors;  ///< "name:line:column: what is wrong", in order.
};

/// Returns the table [acoustics] with every default filled in, the modem's data included. Loading
/// that text gives equal acoustics; where they are not used, a line before the table states it.
[[nodiscard]] std::string ExplainAcoustics(const Acoustics& acoustics);

/// Reads such a text; `name` stands for the file in messages. Opens no file: a modem must be
/// written as a table.
[[nodiscard]] LoadedAcoustics LoadAcousticsText(std::string_view text, const std::string& name);

/// Returns the nodes of a network of unknown size.
[[nodiscard]] std::vector<AcousticNode> AnyNode();

}  // namespace shoal

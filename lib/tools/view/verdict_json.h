// Writes what /api/verdict answers.
#pragma once

#include <optional>
#include <string>

#include "lib/run/verdict/mission_verdict.h"

namespace shoal {

/// Returns the answer; without a verdict {"verdict": null}.
[[nodiscard]] std::string VerdictJson(const std::optional<MissionVerdict>& verdict);

/// Returns the verdict.txt beside a log; nothing where there is none.
[[nodiscard]] std::optional<MissionVerdict> VerdictBeside(const std::string& log);

}  // namespace shoal

// Writes what /api/fates answers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lib/tools/view/fate_history.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/scene.h"

namespace shoal {

/// Returns the fates of `history` that match `query`; times count from the scene's start.
[[nodiscard]] std::string FatesJson(const FateHistory& history, const FateQuery& query,
                                    const Scene& scene);

/// Writes an array of fates.
void WriteFates(const std::vector<const KeptFate*>& fates, const Scene& scene, JsonWriter* json);

}  // namespace shoal

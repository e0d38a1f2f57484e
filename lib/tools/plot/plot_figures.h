// The figures of `shoal plot`: docs/missions/logs.md shows what is on each.
#pragma once

#include <vector>

#include "lib/tools/plot/plot_data.h"
#include "lib/tools/plot/plot_script.h"
#include "lib/tools/plot/plot_setting.h"

namespace shoal {

/// Returns all eight figures: tracks, depth, track_error, distances, actuators, speed, age, layers;
/// those without data show a note.
[[nodiscard]] std::vector<Figure> DrawFigures(const PlotData& data, const PlotSetting& setting,
                                              bool png);

}  // namespace shoal

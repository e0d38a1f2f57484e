// The plan view of `shoal plot`.
#pragma once

#include <string>
#include <vector>

#include "lib/tools/plot/plot_data.h"
#include "lib/tools/plot/plot_script.h"
#include "lib/tools/plot/plot_setting.h"

namespace shoal {

/// Returns the figure `tracks`: where the vehicles went and where they were sent, with equal axes,
/// marks of time, and the sea floor's contour where it is known. `colors`: one for each vehicle.
[[nodiscard]] Figure DrawTracks(const PlotData& data, const PlotSetting& setting,
                                const std::vector<std::string>& colors, bool png);

/// Returns "Tracks: berta, seed 1", or what is known of it.
[[nodiscard]] std::string TitleOf(const std::string& what, const PlotSetting& setting);

/// Returns the legend's entries for the vehicles; none for one vehicle alone, or for more than can
/// be distinguished.
[[nodiscard]] std::vector<LegendEntry> VehicleLegend(const PlotData& data,
                                                     const std::vector<std::string>& colors);

}  // namespace shoal

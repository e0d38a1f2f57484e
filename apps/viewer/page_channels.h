// What a mission's channels carried, for a page that is one file: some messages of each, evenly
// over the recording. web/net/page_channels.js reads them.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/viewer/channel_source.h"

namespace shoal {

struct PageChannelsOptions {
  size_t max_samples = 240;       ///< Of each channel.
  size_t max_values = 1'500'000;  ///< Of all messages; of more, fewer samples of each channel.
};

/// Returns, for each channel that has messages,
///
///     {"name": "NAV_ALPHA", "type": "nav_t", "count": 2000, "rate_hz": 10,
///      "fields": [["x_m", true], ["y_m", true]],       path, is it a number?
///      "samples": [[0.1, 108, "66.1", "-2.5"], ...]}   time, bytes, a text for each field or null
///
/// and adds a line to `notes` that states how many there are. @pre begin_s <= end_s
[[nodiscard]] nlohmann::json ChannelsForPage(ChannelSource& channels, double begin_s, double end_s,
                                             const PageChannelsOptions& options,
                                             std::vector<std::string>* notes);

}  // namespace shoal

// The backgrounds of a page that is one file (page_recording.h).
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lib/mission/file/background_files.h"

namespace shoal {

/// Returns, of the files in `backgrounds` that `max_bytes` have room for, in their order:
///
///     {"file": "charts/bay.png", "bytes": "iVBOR...", "world": "MjAK..."}     world: or ""
///
/// bytes in base64. Adds to `notes` a line for each other one: why, and what to do.
[[nodiscard]] nlohmann::json BackgroundsForPage(const BackgroundFolder& backgrounds,
                                                size_t max_bytes, std::vector<std::string>* notes);

}  // namespace shoal

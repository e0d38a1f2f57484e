// A skippable frame that stands first in the compressed logs that FrameWriter writes: one of them
// without a list of frames was not closed.
#pragma once

#include <cstdint>
#include <string_view>

namespace shoal {

inline constexpr uint32_t kOwnMarkMagic = 0x184D2A50;
inline constexpr std::string_view kOwnMark = "shoallog";

}  // namespace shoal

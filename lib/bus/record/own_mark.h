// The skippable frame with which FrameWriter begins a compressed log. A log that has it, and has no
// list of frames, was not closed.
#pragma once

#include <cstdint>
#include <string_view>

namespace shoal {

inline constexpr uint32_t kOwnMarkMagic = 0x184D2A50;
inline constexpr std::string_view kOwnMark = "shoallog";

}  // namespace shoal

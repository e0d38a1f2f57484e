// Numbers in MOOS text. Nothing is rounded: what is written reads back as the same number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace shoal {

/// Returns the fewest digits that read back as `number`, -0 as "-0.0"; "nan" or "inf" for what is
/// no number.
[[nodiscard]] std::string NumberText(double number);

/// Returns microseconds as decimal seconds, exactly: "12.3", "-0.000001".
[[nodiscard]] std::string SecondsText(int64_t utime);

}  // namespace shoal

// The gateways that have forwarded a report or a message, as a text.
//
//   "buoy"        by the buoy
//   "buoy:mast"   by the buoy, then by the mast
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns how many gateways the text names.
[[nodiscard]] int NumHops(std::string_view via);

/// Returns true where one of them is `name`, without regard to case.
[[nodiscard]] bool IsVia(std::string_view via, std::string_view name);

/// Returns the text with one more at its end.
[[nodiscard]] std::string WithHop(std::string_view via, std::string_view name);

}  // namespace shoal

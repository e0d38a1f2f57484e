// Which colour each vehicle of a mission has: the same one in plots and in the viewer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// Returns 0xRRGGBB of a name of CSS (case, spaces and underscores do not matter: "dodger_blue") or
/// of "#rrggbb"; nothing for what is neither.
[[nodiscard]] std::optional<uint32_t> ColorOf(std::string_view name);

/// Returns one colour, 0xRRGGBB, for each of `requested`, the vehicles' own colours by name:
/// - a colour that a vehicle requests is given to the first that does;
/// - the others, and those whose colour is unknown, get colours that differ from all of these, as
///   clearly as their number allows.
/// What draws them makes them lighter or darker for its ground.
[[nodiscard]] std::vector<uint32_t> ChooseColors(const std::vector<std::string>& requested);

/// Returns the same as "#rrggbb", those too light for white paper darkened.
[[nodiscard]] std::vector<std::string> AssignColors(const std::vector<std::string>& requested);

/// Returns "#rrggbb".
[[nodiscard]] std::string ColorText(uint32_t color);

}  // namespace shoal

// Which colour each vehicle has on white paper.
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

/// Returns one colour, "#rrggbb", for each of `requested`, the vehicles' own colours by name:
/// - a colour that a vehicle requests is given to the first that does;
/// - the others, and those whose colour is unknown, get colours that differ from all of these, as
///   clearly as their number allows.
/// Those too light for white paper are darkened.
[[nodiscard]] std::vector<std::string> AssignColors(const std::vector<std::string>& requested);

}  // namespace shoal

// --allow-tiles: the one server beside the viewer that its page may ask, for tiles of a map.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns what is wrong with the address of tiles, "https://HOST/{z}/{x}/{y}.png"; empty: nothing.
/// It goes into a header and into a script's data: letters of both are refused.
[[nodiscard]] std::string OutsideTilesProblem(std::string_view url);

/// Returns "https://HOST:PORT" of it, as a security policy names it. @pre the address is sound
[[nodiscard]] std::string OriginOf(std::string_view url);

}  // namespace shoal

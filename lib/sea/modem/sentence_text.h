// Numbers and bytes as a modem's sentences write and read them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// Returns the number with `decimals` decimals: "0.4000". @pre number is finite.
[[nodiscard]] std::string FixedText(double number, int decimals);

/// Returns "1,2,ok" of "1", "2", "ok".
[[nodiscard]] std::string JoinFields(std::span<const std::string> fields);

/// Reads one to nine digits, and nothing else.
[[nodiscard]] std::optional<int> ParseDigits(std::string_view text);

/// Returns two lower-case digits for each byte.
[[nodiscard]] std::string HexText(std::span<const uint8_t> bytes);

/// Reads pairs of hex digits of either case. Nothing for an odd number and for other letters.
[[nodiscard]] std::optional<std::vector<uint8_t>> ParseHex(std::string_view text);

}  // namespace shoal

// Bytes as text: the standard alphabet of RFC 4648, section 4.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// Returns one line, padded with '=' to a multiple of four letters.
[[nodiscard]] std::string Base64(std::span<const uint8_t> bytes);

/// Reads what Base64 writes, with or without its padding. Nothing when there is any other letter
/// (white space too), padding before the end or too much of it, a single letter too many, or a
/// last letter with bits that belong to no byte: each byte string has one text, so that a cut or
/// damaged text is noticed where it can be.
[[nodiscard]] std::optional<std::vector<uint8_t>> DecodeBase64(std::string_view text);

}  // namespace shoal

#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns `text` with each byte that is not part of well-formed UTF-8 (RFC 3629) replaced by
/// U+FFFD: what arrived damaged over the acoustic network may hold any bytes, and readers of CSV
/// need text.
[[nodiscard]] std::string ValidUtf8(std::string_view text);

}  // namespace shoal

// Bytes as text, for pages that are one file.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns the bytes in base64 (RFC 4648, section 4), padded.
[[nodiscard]] std::string Base64(std::string_view bytes);

}  // namespace shoal

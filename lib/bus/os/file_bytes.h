// All of a buffer, written or read, whatever signals and pipes cut short.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace shoal {

/// Writes all bytes. Returns false if that failed; errno holds the reason, and some of them may be
/// written.
[[nodiscard]] bool WriteAll(int fd, std::string_view bytes);

/// Fills `bytes`. Returns false if the file ends before, or cannot be read.
[[nodiscard]] bool ReadAll(int fd, std::span<char> bytes);

/// Appends what can be read until the file ends, the other end of a pipe is closed, or `text` has
/// more than `most_bytes`: then one piece more than these. Returns false if it cannot be read;
/// errno holds the reason.
[[nodiscard]] bool ReadToEnd(int fd, size_t most_bytes, std::string* text);

}  // namespace shoal

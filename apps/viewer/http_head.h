// The first check of what comes over a socket, before cpp-httplib sees it: cpp-httplib sets no
// limit on the number and total size of headers, and answers headers that the viewer has no use for
// (ranges, compression, 100-continue, chunked bodies). It is given a head that holds only what the
// viewer uses.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace shoal {

inline constexpr size_t kMaxHeadBytes = size_t{16} * 1024;
inline constexpr size_t kMaxTargetBytes = size_t{4} * 1024;
inline constexpr size_t kMaxHeaders = 100;
inline constexpr size_t kMaxBodyBytes = size_t{64} * 1024;

struct CheckedHead {
  int status = 0;            ///< 0: it has not ended yet; 200: it is sound; else what is wrong.
  std::string message = {};  ///< What is wrong.
  size_t size = 0;           ///< Sound: bytes that it takes, with the empty line.
  std::string head = {};     ///< Sound: what is left of it, written again.
  bool keeps_alive = true;   ///< Sound: another request may follow on this connection.
};

/// Checks the bytes that have come so far. Never throws.
[[nodiscard]] CheckedHead CheckHead(std::string_view bytes);

}  // namespace shoal

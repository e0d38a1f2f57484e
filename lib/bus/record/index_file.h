// LOG.idx, a file beside a log that keeps what was worked out by reading the whole log, so that the
// log opens at once the next time.
//
//   if (const auto bytes = ReadIndexPart(reader, IndexPart::kTimes, "2")) ...   // the second time
//   KeepIndexPart(reader, IndexPart::kTimes, "2", bytes);                       // the first time
//
// All numbers are little-endian. An index that does not fit its log is rewritten:
//
//   magic            8 bytes   "SHOALIDX"
//   format           4 bytes   1
//   size             8 bytes   of the log's file
//   time             8 bytes   its last change, nanoseconds
//   digest           8 bytes   of its first and last bytes, and of some between
//
// Then each part:
//
//   number           4 bytes   of IndexPart
//   key                        4 bytes of length, then the text
//   length           8 bytes   of the part
//   compressed       8 bytes   length of the part as it is in the file
//   digest           8 bytes   of the part as it is in the file
//   part                       compressed by zstd
//
// An index may be damaged, of another log, or made to mislead: whoever reads a part checks all of
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/record/log_reader.h"

namespace shoal {

enum class IndexPart : uint32_t { kTimes = 1, kInfo = 2, kView = 3 };

/// Smaller logs have no index: they are read as fast as one.
inline constexpr uint64_t kLeastIndexedLog_bytes = uint64_t{64} << 20;
/// A part is read into memory as a whole: no index is larger, and no part of it.
inline constexpr uint64_t kMaxIndex_bytes = uint64_t{256} << 20;

/// Returns the name of the index of a log.
[[nodiscard]] std::string IndexPath(const std::string& log);

/// Returns a part that was kept for the log in its present state, if its key is the same. The key
/// names the format of the part, and what it depends on beside the log.
[[nodiscard]] std::optional<std::vector<uint8_t>> ReadIndexPart(
    const LogReader& log, IndexPart part, std::string_view key,
    uint64_t least_bytes = kLeastIndexedLog_bytes);

/// Keeps a part beside the log, and the other parts that fit the log. Does nothing if the log is
/// smaller than `least_bytes` or changed while it was read, if its folder cannot be written, or if
/// the file of this name is not an index.
void KeepIndexPart(const LogReader& log, IndexPart part, std::string_view key,
                   std::span<const uint8_t> bytes, uint64_t least_bytes = kLeastIndexedLog_bytes);

}  // namespace shoal

// What was worked out of a whole log, kept beside it in LOG.idx, so that the log opens at once when
// it is opened again.
//
//   if (const auto bytes = ReadIndexPart(reader, IndexPart::kTimes, "2")) ...   // the second time
//   KeepIndexPart(reader, IndexPart::kTimes, "2", bytes);                       // the first time
//
// All numbers are little-endian. The file is rewritten where it does not fit the log:
//
//   magic            8 bytes   "SHOALIDX"
//   format           4 bytes   1
//   size             8 bytes   of the log's file
//   time             8 bytes   its last change, nanoseconds
//   digest           8 bytes   of its first and last bytes, and of some between
//   then each part:  number (4), key (text behind its length, 4), length (8), bytes in the file
//   (8),
//                    their digest (8), bytes, compressed by zstd
//
// An index may be damaged, of another log, or made to mislead: what reads a part checks all of it.
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

/// Logs of fewer bytes are read as fast as an index is.
inline constexpr uint64_t kLeastIndexedLog_bytes = uint64_t{64} << 20;
/// No index is larger, and no part of it: it is read into memory as a whole.
inline constexpr uint64_t kMaxIndex_bytes = uint64_t{256} << 20;

/// Returns the name of the index of a log.
[[nodiscard]] std::string IndexPath(const std::string& log);

/// Returns a part that was kept for the log as it is now, under this key: the format of the part
/// and what else it depends on.
[[nodiscard]] std::optional<std::vector<uint8_t>> ReadIndexPart(
    const LogReader& log, IndexPart part, std::string_view key,
    uint64_t least_bytes = kLeastIndexedLog_bytes);

/// Keeps a part beside the log, with the other parts that fit it. Does nothing for a log that is
/// smaller, that changed while it was read, or whose folder cannot be written, and where a file of
/// the index's name is no index.
void KeepIndexPart(const LogReader& log, IndexPart part, std::string_view key,
                   std::span<const uint8_t> bytes, uint64_t least_bytes = kLeastIndexedLog_bytes);

}  // namespace shoal

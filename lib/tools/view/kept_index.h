// The index of a log (log_index.h) as bytes, to be kept beside it (lib/bus/record/index_file.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/tools/view/log_index.h"

namespace shoal {

/// An index with what else a view takes from the reading of its log.
struct KeptIndex {
  LogIndex index;
  std::vector<std::string> vehicles = {};  ///< Of the scene at the log's end, in its order.
  std::vector<std::string> troubles = {};  ///< Notes about the log.
};

/// Returns what an index depends on beside its log.
[[nodiscard]] std::string IndexKey(const Scene& blank, const Mission& mission, LogStamps stamps);

/// Returns an index as bytes, empty for one that is too large to be kept; `kept` stays as it is.
[[nodiscard]] std::vector<uint8_t> IndexBytes(KeptIndex* kept);

/// Returns the index that IndexBytes has written of a log of `log_size` bytes. The bytes may be
/// anything: nothing for those that no index can have.
[[nodiscard]] std::optional<KeptIndex> IndexFrom(std::span<const uint8_t> bytes, const Scene& blank,
                                                 uint64_t log_size);

}  // namespace shoal

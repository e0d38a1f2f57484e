// The user's own fields of a message: an array of key_value_t, such as `extra` of a node report.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/schema/walk.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_reader.h"

namespace shoal {

/// Returns the first member of `type` that is a list of shoal.key_value_t; nullptr: it has none.
[[nodiscard]] const Member* ExtraMember(const Schema& schema, const StructType& type);

/// Keys and values, which point into the message.
using ExtraFields = std::vector<std::pair<std::string_view, std::string_view>>;

/// Returns the fields of a message.
/// @pre FindWireFault() finds none.
[[nodiscard]] ExtraFields ExtraFieldsOf(const Schema& schema, const StructType& type,
                                        std::span<const uint8_t> message);

/// The keys of the messages of one type on one channel.
struct ExtraKeys {
  static constexpr size_t kMaxKeys = 64;  ///< Further keys have no columns; rows have all.

  std::vector<std::string> keys = {};      ///< In order of appearance, as UTF-8.
  std::vector<int64_t> num_messages = {};  ///< For each of `keys`, how many messages have it.
  int64_t num_all_messages = 0;

  /// Returns the keys that every message has.
  [[nodiscard]] std::vector<std::string> Common() const;
};

/// The keys of a log.
class ExtraKeyTable {
 public:
  /// Reads the log from its begin to its end or first damage.
  ExtraKeyTable(const Schema& schema, const LogSelection& selection, LogReader reader);

  /// Returns the keys of that type on that channel; empty where there are none.
  [[nodiscard]] const ExtraKeys& Of(std::string_view channel, const StructType& type) const;

 private:
  std::map<std::pair<std::string, const StructType*>, ExtraKeys> keys_;
};

}  // namespace shoal

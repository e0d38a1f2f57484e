// Which acknowledged messages have been here before.
#pragma once

#include <deque>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace shoal {

class RepeatMemory {
 public:
  /// The number of messages that are remembered, the last ones.
  static constexpr size_t kRemembered = 1000;

  /// Remembers a message by its source and ack_id (of which the first 100 bytes count). Returns
  /// true where it is remembered already.
  bool IsRepeat(std::string_view source_key, std::string_view ack_id);

 private:
  std::deque<std::pair<std::string, std::string>> recent_;  ///< Oldest first.
  std::set<std::pair<std::string, std::string>> seen_;      ///< The same.
};

}  // namespace shoal

// The destinations of a node message.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// The parts of `dest_node`: names joined by ':', or `all`.
struct Destinations {
  bool all = false;
  std::vector<std::string> names;  ///< As written, without blanks around; none empty, each once.
  bool too_many = false;           ///< More than kMaxNames; then `names` is cut.
  static constexpr size_t kMaxNames = 1000;
};

/// Returns the parts. Names without regard to case, "all" too; empty parts are passed over.
[[nodiscard]] Destinations ParseDestinations(std::string_view dest_node);

}  // namespace shoal

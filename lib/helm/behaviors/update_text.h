// Texts that change a running behavior: "points = 0,0:10,0 # speed = 2".
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/helm/behaviors/any_behavior.h"

namespace shoal {

/// One `key = value` of an update.
struct UpdateItem {
  std::string key;
  std::string value;  ///< As written, without blanks around it.

  bool operator==(const UpdateItem&) const = default;
};

/// Splits a text at each # that is outside quotes, and each part at its first =.
[[nodiscard]] Result<std::vector<UpdateItem>> ParseUpdate(std::string_view text);

/// Returns `options` with all items applied, or what is wrong with the first bad one; then nothing
/// of the text counts. `position_m` is where the vessel is. Keys, ranges and messages are those of
/// mission files (lib/mission/toml/update_reader.h).
using ReadUpdate = std::function<Result<BehaviorOptions>(const BehaviorOptions& options,
                                                         std::span<const UpdateItem> items,
                                                         const Eigen::Vector2d& position_m)>;

}  // namespace shoal

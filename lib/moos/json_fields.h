// The JSON that MOOS apps write instead of comma-separated fields: {"NAME":"alpha","X":51.7}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/check/result.h"
#include "lib/moos/fields.h"

namespace shoal {

/// Returns the members of the JSON object `text` in order; names may come more than once. Strings
/// are what they mean, numbers and words as they are written, arrays and objects compact JSON.
[[nodiscard]] Result<std::vector<MoosField>> ParseJsonFields(std::string_view text);

/// Appends `text` as a JSON string. Bytes that are not UTF-8 become U+FFFD: JSON cannot hold them.
void AppendJsonString(std::string_view text, std::string* out);

}  // namespace shoal

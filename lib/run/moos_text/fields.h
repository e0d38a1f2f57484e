// The comma-separated KEY=VALUE text that MOOS apps write.
//
//   NAME=alpha,X=51.7,MODE=MODE@ACTIVE:LOITERING,NOTE="a, b",TRAJECTORY={1,2:3,4}
//
// Blanks around keys and values do not count, nor do empty fields (",,"). A value may hold anything
// but a comma; one with a comma is in double quotes, or begins with '{' and runs to the '}'
// that closes it. Within double quotes \" \\ \n \r \t and \x1b stand for one character each; any
// other backslash is itself. Keys may be in double quotes too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/text/blanks.h"

namespace shoal {

struct MoosField {
  std::string key;
  std::string value;

  bool operator==(const MoosField&) const = default;
};

/// Returns the fields of `text` in order; keys may come more than once. The error names the field
/// that is wrong and how to write it.
[[nodiscard]] Result<std::vector<MoosField>> ParseFields(std::string_view text);

/// Appends KEY=VALUE, behind a comma where `out` holds something already: one line of text,
/// whatever is in the value, that ParseFields reads back as the same field.
void AppendField(std::string_view key, std::string_view value, std::string* out);

}  // namespace shoal

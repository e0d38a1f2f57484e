// Files that take their place whole: readers see the old one or the new one.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns the name under which a file is written before it takes the place of `path`: one of this
/// process alone, since shards of a campaign on several machines write the same results.
[[nodiscard]] std::string PartPath(const std::string& path);

/// Writes a file in place of the one of this name. Returns why it could not be written, or an empty
/// string; then the old one is as it was.
[[nodiscard]] std::string ReplaceFile(const std::string& path, std::string_view text);

}  // namespace shoal

// Files that take their place whole: readers see the old one or the new one.
#pragma once

#include <string>

namespace shoal {

/// Returns the name under which a file is written before it takes the place of `path`: one of this
/// process alone, since shards of a campaign on several machines write the same results.
[[nodiscard]] std::string PartPath(const std::string& path);

}  // namespace shoal

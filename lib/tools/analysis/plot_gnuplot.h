// Runs gnuplot, without a shell and without a user's own settings of it.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

/// Returns the first executable file called `name` in the folders of `search_path`, which is
/// written as PATH is; empty: there is none. Empty folders, which would mean the current one, do
/// not count.
[[nodiscard]] std::string FindExecutable(std::string_view name, std::string_view search_path);

/// Runs `program` with the script of this name in `folder` and waits for its end. The error
/// contains gnuplot's output. The script's name must not begin with a hyphen.
[[nodiscard]] Result<bool> RunGnuplot(const std::string& program, const std::string& folder,
                                      const std::string& script);

}  // namespace shoal

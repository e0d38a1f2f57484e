// Runs gnuplot, without a shell and without a user's own settings of it.
#pragma once

#include <string>

#include "lib/base/check/result.h"

namespace shoal {

/// Runs `program` with the script of this name in `folder` and waits for its end. The error
/// contains gnuplot's output. The script's name must not begin with a hyphen.
[[nodiscard]] Result<bool> RunGnuplot(const std::string& program, const std::string& folder,
                                      const std::string& script);

}  // namespace shoal

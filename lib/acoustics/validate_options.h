#pragma once

#include <span>
#include <string>
#include <vector>

#include "lib/acoustics/acoustic_options.h"
#include "lib/acoustics/channel_plan.h"

namespace shoal {

/// Something in AcousticOptions that cannot be, and how to mend it.
struct OptionProblem {
  std::string option;   ///< Its name in AcousticOptions.
  std::string message;  ///< With the numbers: "must be more than 0, not -3".
};

/// Returns what is wrong with these options for these nodes; empty: nothing. Numbers first; what
/// spans several options (does the band hold a channel for each node?) only where each alone is
/// right.
[[nodiscard]] std::vector<OptionProblem> FindProblems(const AcousticOptions& options,
                                                      std::span<const AcousticNode> nodes);

}  // namespace shoal

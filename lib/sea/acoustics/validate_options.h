#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/sea/acoustics/acoustic_options.h"
#include "lib/sea/acoustics/channel_plan.h"

namespace shoal {

/// What a number among AcousticOptions has to lie in.
struct OptionRange {
  std::string_view option;  ///< Its name in AcousticOptions, and in mission files.
  double AcousticOptions::*value;
  double low;
  bool low_is_allowed;
  double high;
};

/// All of them, in the order of AcousticOptions; broadcast_address, which is no double, is from 0
/// to kMaxBroadcastAddress.
[[nodiscard]] std::span<const OptionRange> OptionRanges();

/// Something in AcousticOptions that is invalid, and how to fix it.
struct OptionProblem {
  std::string option;   ///< Its name in AcousticOptions.
  std::string message;  ///< With the numbers: "must be more than 0, not -3".
};

/// Returns what is wrong with these options for these nodes; empty: nothing. Numbers first; what
/// spans several options (does the band hold a channel for each node?) only where each alone is
/// right, and of the sea and the modem.
[[nodiscard]] std::vector<OptionProblem> FindProblems(const AcousticOptions& options,
                                                      std::span<const AcousticNode> nodes);

}  // namespace shoal

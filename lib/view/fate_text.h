// A fate in words, with the numbers that decided: "alpha to bravo: out of range, 312.4 m of 250.0
// m".
#pragma once

#include <string>
#include <string_view>

#include "lib/view/fate_facts.h"

namespace shoal {

/// Returns "out of range".
[[nodiscard]] std::string_view CauseWords(Cause cause);

/// Returns the numbers that decided: "312.4 m of 250.0 m"; empty where there are none. Without a
/// view's colliders they are counted, not named.
[[nodiscard]] std::string DecidingNumbers(const FateView& fate);
[[nodiscard]] std::string DecidingNumbers(const FateFacts& facts);

/// Returns names, cause and numbers; "alpha to 12 others: ..." where they are not told apart,
/// "alpha: ..." where there is no destination. Names are cut after 64 bytes.
[[nodiscard]] std::string FateText(const FateView& fate);
/// The same; of a kind or cause that nobody knows, what the fate calls it.
[[nodiscard]] std::string FateText(const fate_t& fate);

}  // namespace shoal

// A fate as text, with the numbers that decided: "alpha to bravo: out of range, 312.4 m of 250.0
// m". The texts are those of the table of causes (lib/comms/routing/cause.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/view/fate_facts.h"

namespace shoal {

/// What CauseRow::text may hold in braces, and the members of fate_t, of its path and of
/// fate_medium_t that it shows.
struct FateNumber {
  std::string_view name;
  std::string_view members;  ///< Separated by blanks.
};
[[nodiscard]] std::vector<FateNumber> FateNumbers();

/// Returns "out of range".
[[nodiscard]] std::string_view CauseWords(Cause cause);

/// Returns the numbers that decided: "312.4 m of 250.0 m"; empty where there are none. Without a
/// view's colliders they are counted, not named.
[[nodiscard]] std::string DecidingNumbers(const FateView& fate);
[[nodiscard]] std::string DecidingNumbers(const FateFacts& facts);
/// The same of what COMMS_MEDIA has of a fate; empty too where its kind or cause is unknown.
[[nodiscard]] std::string DecidingNumbers(const fate_medium_t& fate);

/// Returns names, cause, numbers and medium; "alpha to 12 others: ..." where their fates are
/// counted together, "alpha: ..." where there is no destination. Names are cut after 64 bytes.
[[nodiscard]] std::string FateText(const FateView& fate);
/// The same; of an unknown kind or cause, what the fate calls it.
[[nodiscard]] std::string FateText(const fate_t& fate);

}  // namespace shoal

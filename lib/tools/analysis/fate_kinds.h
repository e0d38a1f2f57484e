// The titles of the kinds of transmissions in tables of links.
#pragma once

#include <string_view>

#include "lib/comms/routing/fate.h"

namespace shoal {

inline constexpr EnumTable<Kind, std::string_view> kKindTitles = {"Node reports", "Node messages",
                                                                  "Acks", "Packets"};

/// Returns the title of the kind with this number; kNumKinds: of kinds that shoal does not publish.
inline std::string_view KindTitle(int kind) {
  return kind < kNumKinds ? kKindTitles[static_cast<Kind>(kind)] : "Of other kinds";
}

/// Returns the number of the kind with this text in fate_t::kind; kNumKinds where there is none.
inline int KindNumber(std::string_view text) {
  int kind = 0;
  while (kind < kNumKinds && KindText(static_cast<Kind>(kind)) != text) ++kind;
  return kind;
}

}  // namespace shoal

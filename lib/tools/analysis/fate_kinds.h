// The titles of the kinds of transmissions in tables of links.
#pragma once

#include <array>
#include <string_view>

#include "lib/comms/routing/fate.h"

namespace shoal {

/// By the kind's number; the last is for kinds that shoal does not publish.
inline constexpr std::array<std::string_view, kNumKinds + 1> kKindTitles = {
    "Node reports", "Node messages", "Acks", "Packets", "Of other kinds"};

/// Returns the number of the kind with this text in fate_t::kind; kNumKinds where there is none.
inline int KindNumber(std::string_view text) {
  int kind = 0;
  while (kind < kNumKinds && KindText(static_cast<Kind>(kind)) != text) ++kind;
  return kind;
}

}  // namespace shoal

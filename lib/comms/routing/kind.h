// The kinds of transmissions between vehicles.
#pragma once

#include <cstdint>
#include <string_view>

#include "lib/base/check/enum_table.h"

namespace shoal {

/// What is sent from vehicle to vehicle; each source numbers each kind from 0.
enum class Kind : uint8_t {
  kReport,
  kMessage,
  kAck,
  kPacket,  ///< Bytes for the acoustic network: ACOUSTIC_TX.
};
inline constexpr int kNumKinds = static_cast<int>(kNumEnumerators<Kind>);

/// Returns what COMMS_FATES and mission files write: "report".
[[nodiscard]] constexpr std::string_view KindText(Kind kind) {
  constexpr EnumTable<Kind, std::string_view> kTexts = {"report", "message", "ack", "packet"};
  return kTexts[kind];
}

/// A set of kinds.
class KindSet {
 public:
  template <class... Kinds>
  constexpr explicit KindSet(Kinds... kinds)
      : bits_(static_cast<uint8_t>((0U | ... | (1U << static_cast<unsigned>(kinds))))) {}

  /// Returns the set of all kinds.
  static constexpr KindSet All() {
    KindSet all;
    for (const Kind kind : kEnumerators<Kind>) all.bits_ |= KindSet(kind).bits_;
    return all;
  }

  constexpr bool Has(Kind kind) const { return ((bits_ >> static_cast<unsigned>(kind)) & 1U) != 0; }
  constexpr bool empty() const { return bits_ == 0; }

 private:
  uint8_t bits_;
};

}  // namespace shoal

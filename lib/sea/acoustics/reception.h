// What became of one packet at one receiver, and why.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lib/base/check/enum_table.h"
#include "lib/sea/acoustics/ray_channel.h"

namespace shoal {

/// Every packet gets exactly one of these at every receiver it was meant for: the first that holds.
enum class AcousticFate : uint8_t {
  kNotListening,  ///< The receiver does not receive on this channel; only in tdma_lf.
  kNoPath,        ///< A position is not known, or farther than sound can come.
  kShadowZone,    ///< Sound bends away: no path without a bounce, and none that is strong enough.
  kHalfDuplex,    ///< The receiver was sending meanwhile.
  kCollided,      ///< Others on the channel overlapped it; only where collisions drop packets.
  kLost,          ///< Packet loss.
  kDamagedByCollision,  ///< Delivered, with bytes changed by others that overlapped it.
  kDamagedByBitErrors,  ///< Delivered, with bits flipped.
  kDelivered,           ///< As it was sent.
};
inline constexpr size_t kNumAcousticFates = kNumEnumerators<AcousticFate>;

/// Returns "not_listening", "damaged_by_collision" ...
[[nodiscard]] std::string_view AcousticFateText(AcousticFate fate);

/// True for the fates with which bytes reach the receiver, damaged or not.
[[nodiscard]] constexpr bool HandsOver(AcousticFate fate) {
  return fate >= AcousticFate::kDamagedByCollision;
}

/// Names a packet: each source numbers its own from 0.
struct PacketId {
  int32_t source = -1;
  int64_t number = -1;

  auto operator<=>(const PacketId&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

/// At most this many of the packets that overlapped one are named; all are counted.
inline constexpr int kMaxNamedColliders = 4;

/// One packet at one receiver. A number that played no part is -1, or absent.
struct Reception {
  PacketId packet;
  int32_t receiver = -1;
  int32_t channel = -1;  ///< Index into ChannelPlan::channels.
  AcousticFate fate = AcousticFate::kDelivered;

  double sent_s = 0;   ///< The first byte left the source.
  double start_s = 0;  ///< The first byte arrived: sent_s + travel_s + jitter_s.
  double end_s = 0;    ///< The last byte arrived: start_s + air_s.
  double air_s = 0;    ///< From the first byte to the last.
  double travel_s = -1;
  double jitter_s = -1;
  double range_m = -1;  ///< Between the two at sent_s.

  std::optional<double> snr_db = std::nullopt;  ///< In the modem's band, where a model asks for it.
  std::optional<RayReception> rays = std::nullopt;  ///< What arrived, where sound bends.
  double loss_probability = -1;
  double bit_error_probability = -1;  ///< Of each bit.
  int64_t num_bits_flipped = 0;
  int64_t num_colliders = 0;  ///< Packets that overlapped it.
  /// The first of them by source and number where they are no more than this; else some.
  std::array<PacketId, kMaxNamedColliders> colliders;
  int64_t own_number = -1;  ///< kHalfDuplex: the packet that the receiver was sending.

  /// What the receiver gets; empty where nothing is handed over. Valid until the network's next
  /// call.
  std::span<const uint8_t> bytes = {};
};

}  // namespace shoal

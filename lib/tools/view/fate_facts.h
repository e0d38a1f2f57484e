// Fates as the viewer keeps them: the numbers without the texts; and a reader of COMMS_FATES that
// copies nothing.
//
// Measured, since this is a form of a fate beside Decision and fate_t (release build, the log of
// missions/swarm20.toml: 895 MB, 1.5 million fates): ReadFates takes 0.09 s, the generated decoder
// with ViewOf 0.25 s, of 0.95 s that opening the log takes. 144 bytes are kept of each fate,
// without memory of their own; fate_t has 264, its path 136, and 6 texts. (Of a log of 0.2, which
// has comms_fates_t.)
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lib/base/time/time_units.h"
#include "lib/comms/routing/fate.h"
#include "shoal/fate_medium_t.hpp"
#include "shoal/fate_t.hpp"

namespace shoal {

/// What fate_t and its path hold, without names. A number that was not used is -1; numbers of
/// the path have their defaults where there is no path.
struct FateFacts {
  int64_t utime = 0;   ///< Of the step that decided; kept within kFarthest_us.
  int64_t number = 0;  ///< Of the transmission; counts per source and kind.
  int32_t count = 1;   ///< Destinations; more than 1 only for "*". At least 0.
  Kind kind = Kind::kReport;
  Cause cause = Cause::kDelivered;
  OverrideRule override_rule = OverrideRule::kNone;
  bool has_path = false;  ///< It went over the acoustic network.
  float range_m = -1;
  float limit_m = -1;
  float age_s = -1;
  float age_limit_s = -1;
  float wait_s = -1;
  float loss_pct = -1;
  int32_t length_bytes = -1;
  int32_t length_limit_bytes = -1;
  // Of the path.
  int64_t sent_utime = 0;  ///< Kept within kFarthest_us.
  int64_t own_packet = -1;
  int64_t bits_flipped = -1;
  float air_s = 0;
  float travel_s = 0;
  float jitter_s = 0;
  float snr_db = 0;
  float loss_probability = -1;
  float bit_error_probability = -1;
  int32_t channel = -1;
  int32_t num_colliders = 0;
  // Of the medium, as COMMS_MEDIA has them; loss_probability is also radio's.
  float depth_m = -1;
  float depth_limit_m = -1;
  float horizon_m = -1;
  float path_loss_db = -1;
  float path_loss_limit_db = -1;
  float radio_delay_s = -1;
  int32_t hop = -1;
};
static_assert(std::is_trivially_copyable_v<FateFacts> && sizeof(FateFacts) <= 144);

/// One fate of a message; the views live as long as the message's bytes.
struct FateView {
  FateFacts facts;
  std::string_view source;
  std::string_view destination;  ///< Empty: refused at intake; "*": others.
  std::vector<std::string_view> colliders = {};
  std::string_view medium = {};  ///< Empty: none, or not known.
};

/// A decoded message of COMMS_FATES. Its memory is used again by the next ReadFates.
struct FatesView {
  int64_t utime = 0;
  std::vector<FateView> fates;  ///< Only the first `num_fates` are valid.
  size_t num_fates = 0;
  int64_t num_strange = 0;  ///< Fates of an unknown kind or cause: not among `fates`.

  std::span<const FateView> all() const { return {fates.data(), num_fates}; }
};

/// Decodes an encoded comms_fate_columns_t or comms_fates_t, or returns false for bytes that are
/// not one whole such message; then `message` is not valid. Never allocates more than the bytes
/// could fill.
[[nodiscard]] bool ReadFates(std::span<const uint8_t> data, FatesView* message);

/// Returns the same of a decoded fate; false where its kind or cause is unknown.
[[nodiscard]] bool ViewOf(const fate_t& fate, int64_t utime, FateView* view);
/// Returns what COMMS_MEDIA has of a fate; false likewise.
[[nodiscard]] bool ViewOf(const fate_medium_t& fate, int64_t utime, FateView* view);

/// Adds to a fate what `medium` has of the same fate.
void AddMediumNumbers(const FateFacts& medium, FateFacts* facts);

}  // namespace shoal

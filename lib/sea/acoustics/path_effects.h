// Effects of the path on a packet, collisions apart: jitter, packet loss and bit errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "lib/base/random/stream.h"
#include "lib/sea/acoustics/acoustic_options.h"
#include "lib/sea/acoustics/modem_preset.h"
#include "lib/sea/acoustics/ray_channel.h"

namespace shoal {

/// Of one packet; -1 where the effect is off. Reception has the meanings.
struct PathEffects {
  double jitter_s = -1;
  std::optional<double> snr_db;
  double loss_probability = -1;
  double bit_error_probability = -1;
  int64_t num_wrong_bits = 0;  ///< Bits to flip if the packet is handed over.
  bool is_lost = false;        ///< Unless something else happens to it.
  /// It is lost for want of a path without a bounce: more likely than not, and there is none.
  bool is_in_shadow = false;
};

class PathModel {
 public:
  /// @pre FindProblems(options, nodes).empty()
  explicit PathModel(const AcousticOptions& options);

  /// Draws the effects on a packet of `num_bytes` over `range_m`; `key` is that of the packet and
  /// its receiver. The first number of its stream is the jitter's, the second the packet loss's,
  /// whether or not there are such effects; the number of wrong bits comes from those that follow.
  /// `data_rate_bps`: of this packet; absent: the modem's own. Models that are no modem's do not
  /// ask for it.
  /// `rays`: what arrives, where AcousticOptions::rays is there; its powers then take the place of
  /// the range.
  [[nodiscard]] PathEffects Draw(double range_m, double freq_khz, size_t num_bytes,
                                 const StreamKey& key,
                                 std::optional<double> data_rate_bps = std::nullopt,
                                 const RayReception* rays = nullptr) const;

  /// The band in which rays travel, where a model is by the modem.
  [[nodiscard]] RayBand band() const;

 private:
  LinkBudget BudgetOf(double range_m, std::optional<double> data_rate_bps,
                      const RayReception* rays) const;
  double LossByModem(const LinkBudget& budget, size_t num_bytes, const RayReception* rays) const;

  AcousticOptions options_;
  std::optional<LinkModel> link_;  ///< Where packet loss or bit errors are by the modem.
};

}  // namespace shoal

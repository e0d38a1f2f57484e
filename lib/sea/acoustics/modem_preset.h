// An acoustic modem as its data sheet has it, and the link budget between two of them.
//
//   const LinkModel model(preset, sea);
//   const LinkBudget link = model.At(1500);                       // metres
//   const double loss = PacketErrorRate(link.bit_error_rate, 37, preset.code);
//
// Presets are files, data/modems/*.toml; LoadModem (lib/mission/file/load_modem.h) reads them.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "lib/sea/acoustics/absorption.h"
#include "lib/sea/acoustics/ambient_noise.h"
#include "lib/sea/acoustics/modulation.h"
#include "lib/sea/acoustics/modulation_code.h"
#include "lib/sea/ocean/sound_speed.h"

namespace shoal {

struct ModemPreset {
  std::string name;
  double low_khz = 0;  ///< The band; 0 < low_khz < high_khz <= kMaxFrequency_khz.
  double high_khz = 0;
  double data_rate_bps = 0;      ///< Of the user's bits, a code's check bits not counted; > 0.
  int64_t max_packet_bytes = 0;  ///< Of the user's bytes; > 0.
  double source_level_db = 0;    ///< Re 1 uPa at 1 m, in the whole band.
  double typical_range_m = 0;    ///< The manufacturer's figure, for comparison; > 0.
  Modulation modulation = Modulation::kNoncoherentFsk;
  Fading fading = Fading::kRayleigh;
  BlockCode code = {};
  /// Where each number is from, by its key in the file; "estimate: ..." where no data sheet has it.
  std::map<std::string, std::string> sources = {};

  bool operator==(const ModemPreset&) const = default;
};

/// The sea between the modems: the same everywhere, without surface and bottom.
struct Sea {
  SeaWater water = {};
  AmbientNoise noise = {};
  AbsorptionModel absorption = AbsorptionModel::kFrancoisGarrison;
  double spreading_exponent = 1.5;  ///< lib/sea/acoustics/propagation.h.

  bool operator==(const Sea&) const = default;
};

/// What decided whether a packet came through, in the order in which it was computed.
struct LinkBudget {
  double transmission_loss_db = 0;
  double noise_level_db = 0;  ///< In the modem's band, what disturbs included.
  double snr_db = 0;          ///< In the modem's band.
  double eb_over_n0_db = 0;   ///< Per transmitted bit, a code's check bits counted.
  double bit_error_rate = 0;  ///< Of transmitted bits, before a code corrects; [0, 0.5].

  bool operator==(const LinkBudget&) const = default;
};

/// Two modems in a sea; all that does not depend on the distance is computed once.
class LinkModel {
 public:
  LinkModel(const ModemPreset& modem, const Sea& sea);

  /// Returns the budget over `range_m`. An invalid range, modem or sea gives a link with a
  /// bit error rate of 0.5.
  [[nodiscard]] LinkBudget At(double range_m) const { return At(range_m, data_rate_bps_); }
  /// The same at another rate of the user's bits than the modem's own: the slower, the more energy
  /// has each bit.
  [[nodiscard]] LinkBudget At(double range_m, double data_rate_bps) const;
  /// The same where two powers arrive, relative to that at 1 m: one that is the signal, and one
  /// that disturbs like noise. @pre neither is negative
  [[nodiscard]] LinkBudget OfPowers(double signal, double interference, double data_rate_bps) const;
  [[nodiscard]] LinkBudget OfPowers(double signal, double interference) const {
    return OfPowers(signal, interference, data_rate_bps_);
  }

  /// At the middle of the band.
  double absorption_dbpkm() const { return absorption_dbpkm_; }
  double noise_level_db() const { return noise_level_db_; }

 private:
  void AddBitErrors(double data_rate_bps, LinkBudget* link) const;

  double source_level_db_;
  double bandwidth_khz_;
  double data_rate_bps_;
  double code_rate_;
  Modulation modulation_;
  Fading fading_;
  double spreading_exponent_;
  double absorption_dbpkm_;
  double noise_level_db_;
};

}  // namespace shoal

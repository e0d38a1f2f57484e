#include "lib/sea/acoustics/modem_preset.h"

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/sea/acoustics/propagation.h"

namespace shoal {

LinkModel::LinkModel(const ModemPreset& modem, const Sea& sea)
    : source_level_db_(modem.source_level_db),
      bandwidth_khz_(modem.high_khz - modem.low_khz),
      data_rate_bps_(modem.data_rate_bps),
      code_rate_(CodeRate(modem.code)),
      modulation_(modem.modulation),
      fading_(modem.fading),
      spreading_exponent_(sea.spreading_exponent),
      absorption_dbpkm_(
          Absorption(sea.absorption, (modem.low_khz + modem.high_khz) / 2, sea.water)),
      noise_level_db_(NoiseBandLevel(sea.noise, modem.low_khz, modem.high_khz)) {}

LinkBudget LinkModel::At(double range_m, double data_rate_bps) const {
  LinkBudget link;
  link.transmission_loss_db = TransmissionLoss(range_m, spreading_exponent_, absorption_dbpkm_);
  link.noise_level_db = noise_level_db_;
  link.snr_db = SignalToNoise(source_level_db_, link.transmission_loss_db, noise_level_db_);
  AddBitErrors(data_rate_bps, &link);
  return link;
}

LinkBudget LinkModel::OfPowers(double signal, double interference, double data_rate_bps) const {
  LinkBudget link;
  link.transmission_loss_db = signal > 0 ? -10 * Log10(signal) : kInfinity;
  link.noise_level_db = interference > 0 ? 10 * Log10(Pow(10, noise_level_db_ / 10) +
                                                      interference * Pow(10, source_level_db_ / 10))
                                         : noise_level_db_;
  link.snr_db = SignalToNoise(source_level_db_, link.transmission_loss_db, link.noise_level_db);
  AddBitErrors(data_rate_bps, &link);
  return link;
}

void LinkModel::AddBitErrors(double data_rate_bps, LinkBudget* link) const {
  link->eb_over_n0_db =
      EnergyPerBitToNoise(link->snr_db, bandwidth_khz_, data_rate_bps / code_rate_);
  link->bit_error_rate = BitErrorRate(modulation_, fading_, link->eb_over_n0_db);
}

}  // namespace shoal

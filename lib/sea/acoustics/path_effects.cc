#include "lib/sea/acoustics/path_effects.h"

#include "lib/base/check/check.h"
#include "lib/base/random/discrete.h"
#include "lib/sea/acoustics/loss_models.h"

namespace shoal {

namespace {

std::optional<LinkModel> MakeLink(const AcousticOptions& options) {
  if (options.packet_loss_model != PacketLossModel::kModem &&
      options.bit_error_model != BitErrorModel::kModem) {
    return std::nullopt;
  }
  SHOAL_CHECK(options.modem.has_value(), "FindProblems(options, nodes).empty()");
  return LinkModel(*options.modem, options.sea);
}

}  // namespace

PathModel::PathModel(const AcousticOptions& options)
    : options_(options), link_(MakeLink(options)) {}

PathEffects PathModel::Draw(double range_m, double freq_khz, size_t num_bytes, const StreamKey& key,
                            std::optional<double> data_rate_bps) const {
  Stream stream(key);
  const double jitter_draw = stream.Uniform();
  const double loss_draw = stream.Uniform();
  PathEffects effects;
  effects.jitter_s =
      options_.jitter == JitterModel::kUniform ? jitter_draw * options_.max_jitter_s : 0;
  double wrong_by_modem = 0;  // The probability that a bit is wrong.
  if (link_) {
    const LinkBudget budget =
        data_rate_bps ? link_->At(range_m, *data_rate_bps) : link_->At(range_m);
    effects.snr_db = budget.snr_db;
    wrong_by_modem = budget.bit_error_rate;
  }
  if (options_.packet_loss_model != PacketLossModel::kOff) {
    effects.loss_probability =
        options_.packet_loss_model == PacketLossModel::kModem
            ? PacketErrorRate(wrong_by_modem, num_bytes, options_.modem->code)
            : PacketLossProbability(options_, range_m, freq_khz);
    effects.is_lost = loss_draw < effects.loss_probability;
  }
  if (options_.bit_error_model != BitErrorModel::kOff) {
    effects.bit_error_probability = options_.bit_error_model == BitErrorModel::kModem
                                        ? wrong_by_modem
                                        : BitErrorProbability(options_, range_m);
    effects.num_wrong_bits =
        DrawBinomial(static_cast<int64_t>(8 * num_bytes), effects.bit_error_probability, &stream);
  }
  return effects;
}

}  // namespace shoal

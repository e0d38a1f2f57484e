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

RayBand PathModel::band() const {
  if (!link_) return {};
  return {.hz = 500 * (options_.modem->low_khz + options_.modem->high_khz),
          .absorption_dbpkm = link_->absorption_dbpkm()};
}

LinkBudget PathModel::BudgetOf(double range_m, std::optional<double> data_rate_bps,
                               const RayReception* rays) const {
  const double rate_bps = data_rate_bps.value_or(options_.modem->data_rate_bps);
  return rays != nullptr ? link_->OfPowers(rays->signal, rays->interference, rate_bps)
                         : link_->At(range_m, rate_bps);
}

double PathModel::LossByModem(const LinkBudget& budget, size_t num_bytes,
                              const RayReception* rays) const {
  if (rays != nullptr && !options_.rays->packet_errors.empty()) {
    return LossOf(options_.rays->packet_errors, budget.snr_db);
  }
  return PacketErrorRate(budget.bit_error_rate, num_bytes, options_.modem->code);
}

PathEffects PathModel::Draw(double range_m, double freq_khz, size_t num_bytes, const StreamKey& key,
                            std::optional<double> data_rate_bps, const RayReception* rays) const {
  Stream stream(key);
  const double jitter_draw = stream.Uniform();
  const double loss_draw = stream.Uniform();
  PathEffects effects;
  effects.jitter_s =
      options_.jitter == JitterModel::kUniform ? jitter_draw * options_.max_jitter_s : 0;
  LinkBudget budget;
  if (link_) {
    budget = BudgetOf(range_m, data_rate_bps, rays);
    effects.snr_db = budget.snr_db;
  }
  if (options_.packet_loss_model != PacketLossModel::kOff) {
    effects.loss_probability = options_.packet_loss_model == PacketLossModel::kModem
                                   ? LossByModem(budget, num_bytes, rays)
                                   : PacketLossProbability(options_, range_m, freq_khz);
    effects.is_lost = loss_draw < effects.loss_probability;
    effects.is_in_shadow = effects.is_lost && rays != nullptr &&
                           rays->shadow != ShadowReason::kNone && effects.loss_probability >= 0.5;
  }
  if (options_.bit_error_model != BitErrorModel::kOff) {
    effects.bit_error_probability = options_.bit_error_model == BitErrorModel::kModem
                                        ? budget.bit_error_rate
                                        : BitErrorProbability(options_, range_m);
    effects.num_wrong_bits =
        DrawBinomial(static_cast<int64_t>(8 * num_bytes), effects.bit_error_probability, &stream);
  }
  return effects;
}

}  // namespace shoal

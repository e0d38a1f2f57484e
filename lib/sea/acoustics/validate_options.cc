#include "lib/sea/acoustics/validate_options.h"

#include <string_view>

#include "lib/base/check/bounds.h"
#include "lib/sea/acoustics/number_text.h"
#include "lib/sea/acoustics/propagation.h"

namespace shoal {

namespace {

constexpr bool kFrom = true;
constexpr bool kMoreThan = false;

/// Limits only keep arithmetic finite and memory bounded; they are far beyond any modem. At speed 0
/// a packet would be in transit for ever.
constexpr double kMinSpeed_mps = 1;
constexpr double kMaxSpeed_mps = 100'000;
constexpr double kMaxFreq_khz = 100'000;
constexpr double kMinWidth_khz = 1e-4;
constexpr double kMaxRate_bps = 1e9;
constexpr double kMinRate_bps = 0.1;
constexpr double kMaxJitter_s = 86'400;
constexpr double kMaxDistance_m = 1e9;
constexpr double kMaxDecibels = 1000;

using Options = AcousticOptions;
constexpr OptionRange kRanges[] = {
    {"sound_speed_mps", &Options::sound_speed_mps, kMinSpeed_mps, kFrom, kMaxSpeed_mps},
    {"base_freq_khz", &Options::base_freq_khz, 0, kMoreThan, kMaxFreq_khz},
    {"bandwidth_khz", &Options::bandwidth_khz, 0, kMoreThan, kMaxFreq_khz},
    {"guard_band_khz", &Options::guard_band_khz, 0, kFrom, kMaxFreq_khz},
    {"channel_bandwidth_khz", &Options::channel_bandwidth_khz, kMinWidth_khz, kFrom, kMaxFreq_khz},
    {"data_rate_bps", &Options::data_rate_bps, kMinRate_bps, kFrom, kMaxRate_bps},
    {"max_jitter_s", &Options::max_jitter_s, 0, kFrom, kMaxJitter_s},
    {"nominal_distance_m", &Options::nominal_distance_m, 0, kMoreThan, kMaxDistance_m},
    {"packet_loss", &Options::packet_loss, 0, kFrom, 1},
    {"packet_loss_distance_m", &Options::packet_loss_distance_m, 0, kMoreThan, kMaxDistance_m},
    // At 0.5 a bit carries no information; beyond, its complement would carry some again.
    {"bit_error_rate", &Options::bit_error_rate, 0, kFrom, 0.5},
    {"bit_error_distance_m", &Options::bit_error_distance_m, 0, kMoreThan, kMaxDistance_m},
    {"snr_nominal_db", &Options::snr_nominal_db, -kMaxDecibels, kFrom, kMaxDecibels},
    {"snr_slope", &Options::snr_slope, 0, kFrom, kMaxDecibels},
};

void Check(const OptionRange& range, double value, std::vector<OptionProblem>* problems) {
  const bool is_high_enough = value > range.low || (range.low_is_allowed && value == range.low);
  if (is_high_enough && value <= range.high) return;  // NaN is neither.
  problems->push_back({std::string(range.option),
                       "must be " + std::string(range.low_is_allowed ? "from " : "more than ") +
                           RoundedText(range.low) +
                           (range.low_is_allowed ? " to " : " and at most ") +
                           RoundedText(range.high) + ", not " + RoundedText(value)});
}

bool IsSea(const Sea& sea) {
  return IsSeaWater(sea.water) && IsBetween(sea.noise.shipping, 0, 1) &&
         IsBetween(sea.noise.wind_mps, 0, kMaxWind_mps) &&
         IsBetween(sea.spreading_exponent, kMinSpreadingExponent, kMaxSpreadingExponent);
}

/// Returns what is wrong with the numbers that LinkModel computes with; empty where nothing is.
std::string ProblemOf(const ModemPreset& modem) {
  if (!(modem.low_khz > 0 && modem.low_khz < modem.high_khz &&
        modem.high_khz <= kMaxFrequency_khz)) {
    return "a modem's band must begin above 0 kHz and end above that, at most at " +
           RoundedText(kMaxFrequency_khz) + ", not " + RoundedText(modem.low_khz) + " to " +
           RoundedText(modem.high_khz);
  }
  if (!IsBetween(modem.data_rate_bps, kMinRate_bps, kMaxRate_bps)) {
    return "a modem's data_rate_bps must be from " + RoundedText(kMinRate_bps) + " to " +
           RoundedText(kMaxRate_bps) + ", not " + RoundedText(modem.data_rate_bps);
  }
  if (!IsBetween(modem.source_level_db, -kMaxDecibels, kMaxDecibels)) {
    return "a modem's source_level_db must be within " + RoundedText(kMaxDecibels) + " dB, not " +
           RoundedText(modem.source_level_db);
  }
  return ProblemOf(modem.code);
}

bool HasCheckBits(const BlockCode& code) {
  return code.corrected_bits > 0 || code.block_bits != code.data_bits;
}

/// What the model rays of the channel needs.
void CheckRays(const AcousticOptions& options, std::vector<OptionProblem>* problems) {
  const std::string problem = ProblemOf(*options.rays);
  if (!problem.empty()) problems->push_back({"channel", problem});
  if (options.packet_loss_model == PacketLossModel::kModem ||
      options.bit_error_model == BitErrorModel::kModem) {
    return;
  }
  problems->push_back({"channel",
                       "model = \"rays\" finds levels of sound, and only a modem knows what they "
                       "mean: name one, as in modem = \"whoi_micromodem2\", and let "
                       "packet_loss_model or bit_error_model be \"modem\""});
}

/// What the models that ask for a modem need.
void CheckModem(const AcousticOptions& options, std::vector<OptionProblem>* problems) {
  const bool loses = options.packet_loss_model == PacketLossModel::kModem;
  const bool damages = options.bit_error_model == BitErrorModel::kModem;
  if (!IsSea(options.sea)) {
    problems->push_back({"sea", "the sea is out of the range of the models of sound in it"});
  }
  if (options.modem) {
    const std::string problem = ProblemOf(*options.modem);
    if (!problem.empty()) problems->push_back({"modem", problem});
  } else if (loses || damages) {
    problems->push_back({loses ? "packet_loss_model" : "bit_error_model",
                         std::string(loses ? "packet_loss_model" : "bit_error_model") +
                             " = \"modem\" needs a modem; name one, as in modem = "
                             "\"whoi_micromodem2\", or choose another model"});
  }
  if (options.rays) CheckRays(options, problems);
  if (loses && damages) {
    problems->push_back(
        {"bit_error_model",
         "packet_loss_model = \"modem\" already loses the packets in which bits are wrong: with "
         "bit_error_model = \"modem\" too they would count twice; set one of the two to \"off\""});
  } else if (damages && options.modem && HasCheckBits(options.modem->code)) {
    problems->push_back(
        {"bit_error_model",
         "bit_error_model = \"modem\" is for modems without a code, and '" + options.modem->name +
             "' has one that corrects " + std::to_string(options.modem->code.corrected_bits) +
             " of " + std::to_string(options.modem->code.block_bits) +
             " bits; use packet_loss_model = \"modem\" and bit_error_model = \"off\""});
  }
}

}  // namespace

std::span<const OptionRange> OptionRanges() { return kRanges; }

std::vector<OptionProblem> FindProblems(const AcousticOptions& options,
                                        std::span<const AcousticNode> nodes) {
  std::vector<OptionProblem> problems;
  for (const OptionRange& range : kRanges) Check(range, options.*range.value, &problems);
  Check({"broadcast_address", nullptr, 0, kFrom, kMaxBroadcastAddress}, options.broadcast_address,
        &problems);
  CheckModem(options, &problems);
  if (!problems.empty()) return problems;

  const double lowest_khz = options.base_freq_khz - options.bandwidth_khz / 2;
  if (lowest_khz < 0) {
    problems.push_back({"bandwidth_khz", "the band begins at base_freq_khz - bandwidth_khz / 2 = " +
                                             RoundedText(options.base_freq_khz) + " - " +
                                             RoundedText(options.bandwidth_khz) + " / 2 = " +
                                             RoundedText(lowest_khz) + " kHz, below 0"});
  }
  const Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
  if (!plan.ok()) {
    const bool fits =
        ChannelCapacity(options) >= (options.access_mode == AccessMode::kTdmaLf ? 2 : 1);
    const bool lacks_a_leader = options.access_mode == AccessMode::kTdmaLf && fits;
    problems.push_back({lacks_a_leader ? "access_mode" : "bandwidth_khz", plan.error()});
  }
  return problems;
}

}  // namespace shoal

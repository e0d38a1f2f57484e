#include "lib/acoustics/validate_options.h"

#include <string_view>

#include "lib/acoustics/number_text.h"

namespace shoal {

namespace {

/// What a number has to lie in.
struct Range {
  std::string_view option;
  double value;
  double low;
  bool low_is_allowed;
  double high;
};

constexpr bool kFrom = true;
constexpr bool kMoreThan = false;

/// Upper limits only keep arithmetic finite and memory bounded; they are far beyond any modem.
constexpr double kMaxSpeed_mps = 100'000;
constexpr double kMaxFreq_khz = 100'000;
constexpr double kMinWidth_khz = 1e-4;
constexpr double kMaxRate_bps = 1e9;
constexpr double kMinRate_bps = 0.1;
constexpr double kMaxJitter_s = 86'400;
constexpr double kMaxDistance_m = 1e9;
constexpr double kMaxDecibels = 1000;

void Check(const Range& range, std::vector<OptionProblem>* problems) {
  const bool is_high_enough =
      range.value > range.low || (range.low_is_allowed && range.value == range.low);
  if (is_high_enough && range.value <= range.high) return;  // NaN is neither.
  problems->push_back({std::string(range.option),
                       "must be " + std::string(range.low_is_allowed ? "from " : "more than ") +
                           NumberText(range.low) +
                           (range.low_is_allowed ? " to " : " and at most ") +
                           NumberText(range.high) + ", not " + NumberText(range.value)});
}

}  // namespace

std::vector<OptionProblem> FindProblems(const AcousticOptions& options,
                                        std::span<const AcousticNode> nodes) {
  std::vector<OptionProblem> problems;
  const Range ranges[] = {
      {"sound_speed_mps", options.sound_speed_mps, 0, kMoreThan, kMaxSpeed_mps},
      {"base_freq_khz", options.base_freq_khz, 0, kMoreThan, kMaxFreq_khz},
      {"bandwidth_khz", options.bandwidth_khz, 0, kMoreThan, kMaxFreq_khz},
      {"guard_band_khz", options.guard_band_khz, 0, kFrom, kMaxFreq_khz},
      {"channel_bandwidth_khz", options.channel_bandwidth_khz, kMinWidth_khz, kFrom, kMaxFreq_khz},
      {"broadcast_address", static_cast<double>(options.broadcast_address), 0, kFrom, 1e9},
      {"data_rate_bps", options.data_rate_bps, kMinRate_bps, kFrom, kMaxRate_bps},
      {"max_jitter_s", options.max_jitter_s, 0, kFrom, kMaxJitter_s},
      {"nominal_distance_m", options.nominal_distance_m, 0, kMoreThan, kMaxDistance_m},
      {"packet_loss", options.packet_loss, 0, kFrom, 1},
      {"packet_loss_distance_m", options.packet_loss_distance_m, 0, kMoreThan, kMaxDistance_m},
      // At 0.5 a bit says nothing any more; beyond, it would say the opposite.
      {"bit_error_rate", options.bit_error_rate, 0, kFrom, 0.5},
      {"bit_error_distance_m", options.bit_error_distance_m, 0, kMoreThan, kMaxDistance_m},
      {"snr_nominal_db", options.snr_nominal_db, -kMaxDecibels, kFrom, kMaxDecibels},
      {"snr_slope", options.snr_slope, 0, kFrom, kMaxDecibels},
  };
  for (const Range& range : ranges) Check(range, &problems);
  if (!problems.empty()) return problems;

  const double lowest_khz = options.base_freq_khz - options.bandwidth_khz / 2;
  if (lowest_khz < 0) {
    problems.push_back({"bandwidth_khz", "the band begins at base_freq_khz - bandwidth_khz / 2 = " +
                                             NumberText(options.base_freq_khz) + " - " +
                                             NumberText(options.bandwidth_khz) +
                                             " / 2 = " + NumberText(lowest_khz) + " kHz, below 0"});
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

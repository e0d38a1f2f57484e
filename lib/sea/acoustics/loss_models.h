// muNet's models of packet loss and bit errors, as probabilities. They are rules of thumb, not
// physics: nothing in them knows of sound levels or noise.
#pragma once

#include "lib/sea/acoustics/acoustic_options.h"

namespace shoal {

/// Returns the probability, in [0, 1], that a packet which has come this far is lost. With P =
/// `packet_loss`, d the range over the nominal distance, D = `packet_loss_distance_m` and f =
/// 1 + 0.01 (freq_khz - base_freq_khz):
///   uniform       P
///   exp_simple    P f e^((range_m - nominal_distance_m) / D)
///   sonar_simple  P f e^((range_m - nominal_distance_m) / D) d^1.5
/// f is a factor of 1 % per kHz, below 1 under the base frequency.
/// 0 for modem, which is no formula of the range alone: lib/sea/acoustics/modem_preset.h has it.
[[nodiscard]] double PacketLossProbability(const AcousticOptions& options, double range_m,
                                           double freq_khz);

/// Returns the probability, in [0, 0.5], that a bit which has come this far is wrong. With B =
/// `bit_error_rate`, d the range over the nominal distance and D = `bit_error_distance_m`:
///   poisson     B (the name is muNet's; errors are independent, their number binomial)
///   exp_simple  B e^((range_m - nominal_distance_m) / D)
///   snr         B 10^(snr_slope 15 log10 d): errors grow with the decibels that practical
///               spreading (15 dB per decade) takes off `snr_nominal_db`, which has no effect
///               itself.
/// A bit that is wrong every second time carries nothing, so 0.5 is the limit. 0 for modem.
[[nodiscard]] double BitErrorProbability(const AcousticOptions& options, double range_m);

}  // namespace shoal

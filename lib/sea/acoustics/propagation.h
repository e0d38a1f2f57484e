// Transmission loss and the passive sonar equation, SNR = SL - TL - NL. All levels
// re 1 uPa; source levels at 1 m.
#pragma once

namespace shoal {

/// Spreading exponents: 1 cylindrical (shallow water that traps all sound), 2 spherical (deep
/// water), 1.5 in between, "practical" (Urick, Principles of Underwater Sound, 3rd ed., ch. 5).
constexpr double kMinSpreadingExponent = 0.5;
constexpr double kMaxSpreadingExponent = 4;

/// Returns the transmission loss in dB over `range_m`: spreading_exponent x 10 log10(range / 1 m)
/// plus absorption. Never negative, never falls with range. Source levels are those at 1 m and the
/// field of a transducer has no such law nearer than that, so spreading is 0 dB within 1 m.
/// Infinity where the range is NaN or negative, or another argument is NaN or negative.
[[nodiscard]] double TransmissionLoss(double range_m, double spreading_exponent,
                                      double absorption_dbpkm);

/// Returns the signal-to-noise ratio in dB at an omnidirectional receiver, in the band that
/// `noise_level_db` is of. Minus infinity where that is not a number.
[[nodiscard]] double SignalToNoise(double source_level_db, double transmission_loss_db,
                                   double noise_level_db);

}  // namespace shoal

// From the signal-to-noise ratio to the probability that a bit is wrong, for the modulations that
// acoustic modems use. Ideal receivers: perfectly synchronised, equalised, in white Gaussian noise;
// what a real modem loses to multipath and Doppler is not in it, but for Rayleigh fading.
//
// Proakis, J. G., Digital Communications, 4th ed. (2001): sections 5.2 (coherent, AWGN), 5.2.8
// (DPSK), 5.4.2 (non-coherent FSK), 14.3 (Rayleigh fading, eqs. 14-3-7 to 14-3-12).
#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace shoal {

/// Binary, or quaternary with Gray coding where bits are decided one by one (QPSK).
enum class Modulation { kCoherentPsk, kDifferentialPsk, kCoherentFsk, kNoncoherentFsk };

constexpr std::array<std::pair<std::string_view, Modulation>, 4> kModulations = {{
    {"coherent_psk", Modulation::kCoherentPsk},
    {"differential_psk", Modulation::kDifferentialPsk},
    {"coherent_fsk", Modulation::kCoherentFsk},
    {"noncoherent_fsk", Modulation::kNoncoherentFsk},
}};

/// Rayleigh: the signal comes over many paths of like strength and none direct. The signal-to-noise
/// ratio is then that of the mean power, and every bit fades by itself, as behind an interleaver.
enum class Fading { kNone, kRayleigh };

constexpr std::array<std::pair<std::string_view, Fading>, 2> kFadings = {{
    {"none", Fading::kNone},
    {"rayleigh", Fading::kRayleigh},
}};

/// Returns Eb/N0 in dB from the signal-to-noise ratio in a band of `bandwidth_khz`, for
/// `data_rate_bps` bits per second: SNR + 10 log10(bandwidth / data rate). Minus infinity where
/// that is not a number or a rate or bandwidth is not positive.
[[nodiscard]] double EnergyPerBitToNoise(double snr_db, double bandwidth_khz, double data_rate_bps);

/// Returns the probability in [0, 0.5] that a bit is wrong. 0.5 where Eb/N0 is NaN.
[[nodiscard]] double BitErrorRate(Modulation modulation, Fading fading, double eb_over_n0_db);

}  // namespace shoal

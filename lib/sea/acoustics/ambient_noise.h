// The noise of the sea, by the curves of Wenz in closed form. Levels of a spectrum are in dB re 1
// uPa^2/Hz, levels of a band in dB re 1 uPa^2.
//
// Wenz, G. M. (1962), Acoustic ambient noise in the ocean: spectra and sources, J. Acoust. Soc. Am.
// 34(12), 1936-1956, as fitted by Coates, R. (1989), Underwater Acoustic Systems, Wiley; the four
// formulas are eq. (7) of Stojanovic, M. (2007), On the relationship between capacity and distance
// in an underwater acoustic communication channel, ACM MC2R 11(4), 34-43. They follow Wenz's
// averages to a few dB; rain, ice, surf and animals are not in them.
#pragma once

namespace shoal {

struct AmbientNoise {
  double shipping = 0.5;  ///< Distant traffic: 0 negligible, 1 heavy.
  double wind_mps = 5;    ///< [0, kMaxWind_mps].

  bool operator==(const AmbientNoise&) const = default;
};

constexpr double kMaxWind_mps = 40;

// Each returns the level of one component's spectrum at `frequency_khz`, in (0, 1000]. Infinity
// where an argument is out of its range: no signal is received then.

/// Turbulence of the water; matters below 10 Hz.
[[nodiscard]] double TurbulenceNoise(double frequency_khz);
/// Distant ships; matter from 10 to 100 Hz. `shipping` in [0, 1].
[[nodiscard]] double ShippingNoise(double frequency_khz, double shipping);
/// Waves that the wind raises; they matter from 100 Hz to 100 kHz.
[[nodiscard]] double WindNoise(double frequency_khz, double wind_mps);
/// The water's molecules at the receiver (Mellen 1952); matter above 100 kHz.
[[nodiscard]] double ThermalNoise(double frequency_khz);

/// Returns the level of the whole spectrum: the four components' powers together.
[[nodiscard]] double NoiseSpectrumLevel(const AmbientNoise& noise, double frequency_khz);

/// Returns the level of the noise from `low_khz` to `high_khz`: the integral of the spectrum, not
/// its centre times the bandwidth, which is 0.5 dB wrong for a band of one octave and more for a
/// wider one. Minus infinity for a band without width; infinity where an argument is out of its
/// range or low_khz > high_khz.
[[nodiscard]] double NoiseBandLevel(const AmbientNoise& noise, double low_khz, double high_khz);

}  // namespace shoal

#include "lib/sea/acoustics/loss_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "tests/golden/read_golden.h"

namespace shoal::loss_models_test {

constexpr double kRelativeError = 1e-12;

void ExpectClose(double actual, double expected, const std::string& where) {
  EXPECT_NEAR(actual, expected, kRelativeError * std::max(std::abs(expected), 1e-300)) << where;
}

TEST(PacketLossProbability, FollowsTheGoldenCurves) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/plr_curves.csv")) {
    AcousticOptions options;
    options.packet_loss_model = FindChoice<PacketLossModel>(row.at("model")).value();
    options.packet_loss = Number(row, "PLR");
    options.packet_loss_distance_m = Number(row, "PLR_CHARDIST");
    options.nominal_distance_m = Number(row, "NOM_DIST");
    options.base_freq_khz = Number(row, "BASE_FREQ");
    ExpectClose(PacketLossProbability(options, Number(row, "distance_m"), Number(row, "freq_kHz")),
                Number(row, "p_drop"), row.at("model") + " at " + row.at("distance_m"));
  }
}

TEST(BitErrorProbability, FollowsTheGoldenCurvesUpToOneHalf) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/ber_curves.csv")) {
    AcousticOptions options;
    options.bit_error_model = FindChoice<BitErrorModel>(row.at("model")).value();
    options.bit_error_rate = Number(row, "BER");
    options.bit_error_distance_m = Number(row, "BER_CHARDIST");
    options.nominal_distance_m = Number(row, "NOM_DIST");
    options.snr_nominal_db = Number(row, "SNR_NOMINAL");
    options.snr_slope = Number(row, "SNR_SLOPE");
    const double probability = BitErrorProbability(options, Number(row, "distance_m"));
    const std::string where = row.at("model") + " at " + row.at("distance_m");
    const double golden = Number(row, "ber_eff");
    ExpectClose(probability, std::min(golden, 0.5), where);
    if (golden > 0.5) continue;
    const double num_bits = 8 * Number(row, "bytes");
    ExpectClose(num_bits * probability, Number(row, "binomial_expected_flips"), where);
    EXPECT_NEAR(-std::expm1(num_bits * std::log1p(-probability)),
                Number(row, "binomial_p_any_flip"), 1e-12)
        << where;
  }
}

TEST(LossModels, StayProbabilitiesForAnyInput) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double range_m : {0.0, 1e-300, 1e7, 1e300, infinity, nan}) {
    for (const double freq_khz : {-1e6, 0.0, 1e6, nan}) {
      for (int model = 0; model < 4; ++model) {
        for (const double nominal : {0.0, 0.02, 1.0, infinity, nan}) {
          AcousticOptions options;
          options.packet_loss_model = static_cast<PacketLossModel>(model);
          options.bit_error_model = static_cast<BitErrorModel>(model);
          options.packet_loss = nominal;
          options.bit_error_rate = nominal;
          const double loss = PacketLossProbability(options, range_m, freq_khz);
          const double error = BitErrorProbability(options, range_m);
          EXPECT_TRUE(loss >= 0 && loss <= 1) << loss;
          EXPECT_TRUE(error >= 0 && error <= 0.5) << error;
        }
      }
    }
  }
}

}  // namespace shoal::loss_models_test

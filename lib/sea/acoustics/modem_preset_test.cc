#include "lib/sea/acoustics/modem_preset.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/sea/acoustics/propagation.h"

namespace shoal::modem_preset_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const ModemPreset kModem = {.name = "test",
                            .low_khz = 23,
                            .high_khz = 27,
                            .data_rate_bps = 1000,
                            .max_packet_bytes = 64,
                            .source_level_db = 170,
                            .typical_range_m = 2000,
                            .modulation = Modulation::kDifferentialPsk,
                            .fading = Fading::kNone,
                            .code = {},
                            .sources = {}};

TEST(LinkModel, IsTheChainOfTheModels) {
  const Sea sea;
  const LinkBudget link = LinkModel(kModem, sea).At(1500);
  EXPECT_EQ(link.transmission_loss_db,
            TransmissionLoss(1500, 1.5, FrancoisGarrisonAbsorption(25, sea.water)));
  EXPECT_EQ(link.noise_level_db, NoiseBandLevel(sea.noise, 23, 27));
  EXPECT_EQ(link.snr_db, 170 - link.transmission_loss_db - link.noise_level_db);
  EXPECT_NEAR(link.eb_over_n0_db, link.snr_db + 10 * std::log10(4), 1e-12);
  EXPECT_EQ(link.bit_error_rate,
            BitErrorRate(Modulation::kDifferentialPsk, Fading::kNone, link.eb_over_n0_db));
}

TEST(LinkModel, SpendsEnergyOnTheCheckBitsOfACode) {
  ModemPreset coded = kModem;
  coded.code = {.block_bits = 24, .data_bits = 12, .corrected_bits = 3};
  EXPECT_NEAR(
      LinkModel(kModem, {}).At(1500).eb_over_n0_db - LinkModel(coded, {}).At(1500).eb_over_n0_db,
      10 * std::log10(2), 1e-12);
}

TEST(LinkModel, ReturnsWhatItHasComputedOnce) {
  const Sea sea = {.water = {.temperature_degc = 20},
                   .noise = {.shipping = 0, .wind_mps = 10},
                   .absorption = AbsorptionModel::kThorp,
                   .spreading_exponent = 2};
  const LinkModel model(kModem, sea);
  EXPECT_EQ(model.absorption_dbpkm(), ThorpAbsorption(25));
  EXPECT_EQ(model.noise_level_db(), NoiseBandLevel(sea.noise, 23, 27));
  EXPECT_EQ(model.At(100).transmission_loss_db, TransmissionLoss(100, 2, ThorpAbsorption(25)));
}

TEST(LinkModel, ReceivesNothingWhereAnyInputIsInvalid) {
  for (const double nonsense : {kNaN, kInfinity, -1.0}) {
    EXPECT_EQ(LinkModel(kModem, {}).At(nonsense).bit_error_rate, 0.5) << nonsense;
  }
  EXPECT_EQ(LinkModel({}, {}).At(100).bit_error_rate, 0.5);
  ModemPreset broken = kModem;
  broken.high_khz = kNaN;
  EXPECT_EQ(LinkModel(broken, {}).At(100).bit_error_rate, 0.5);
  broken = kModem;
  broken.code.block_bits = 0;
  broken.code.data_bits = 0;
  EXPECT_EQ(LinkModel(broken, {}).At(100).bit_error_rate, 0.5);
  EXPECT_EQ(LinkModel(kModem, {.water = {.temperature_degc = 100}}).At(100).bit_error_rate, 0.5);
  EXPECT_EQ(LinkModel(kModem, {.noise = {.wind_mps = kNaN}}).At(100).bit_error_rate, 0.5);
  EXPECT_EQ(LinkModel(kModem, {.spreading_exponent = kNaN}).At(100).bit_error_rate, 0.5);
}

RC_GTEST_PROP(LinkModel, GetsNoBetterWithDistance, ()) {
  const double range_m = *rc::gen::inRange(0, 2'000'000) / 100.0;
  const double step_m = *rc::gen::inRange(1, 100'000) / 100.0;
  const LinkModel model(kModem, {});
  const LinkBudget near = model.At(range_m);
  const LinkBudget far = model.At(range_m + step_m);
  RC_ASSERT(far.snr_db <= near.snr_db);
  RC_ASSERT(far.bit_error_rate >= near.bit_error_rate);
  RC_ASSERT(PacketErrorRate(far.bit_error_rate, 37) >= PacketErrorRate(near.bit_error_rate, 37));
}

}  // namespace shoal::modem_preset_test

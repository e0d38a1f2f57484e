#include "lib/sea/acoustics/acoustic_options.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/sea/acoustics/validate_options.h"

namespace shoal::acoustic_options_test {

std::vector<AcousticNode> Nodes(int count) {
  std::vector<AcousticNode> nodes;
  for (int i = 1; i <= count; ++i) {
    nodes.push_back({.name = "node_" + std::to_string(i), .address = i});
  }
  return nodes;
}

template <class Choice>
void ExpectEachTextToBeItsOwnChoice(size_t count) {
  EXPECT_EQ(kNumEnumerators<Choice>, count);
  for (size_t i = 0; i < count; ++i) {
    const auto choice = static_cast<Choice>(i);
    EXPECT_EQ(FindChoice<Choice>(ChoiceText(choice)), choice);
  }
  EXPECT_EQ(FindChoice<Choice>("FDMA"), std::nullopt);
  EXPECT_EQ(FindChoice<Choice>(""), std::nullopt);
}

TEST(Choices, AreWrittenAndReadTheSameWay) {
  ExpectEachTextToBeItsOwnChoice<AccessMode>(4);
  ExpectEachTextToBeItsOwnChoice<ChannelOrder>(2);
  ExpectEachTextToBeItsOwnChoice<JitterModel>(2);
  ExpectEachTextToBeItsOwnChoice<CollisionModel>(3);
  ExpectEachTextToBeItsOwnChoice<PacketLossModel>(5);
  ExpectEachTextToBeItsOwnChoice<BitErrorModel>(5);
  EXPECT_EQ(ChoiceText(AccessMode::kTdmaLf), "tdma_lf");
  EXPECT_EQ(ChoiceText(ChannelOrder::kEdgeIn), "edge_in");
  EXPECT_EQ(ChoiceText(JitterModel::kOff), "off");
  EXPECT_EQ(ChoiceText(CollisionModel::kCorrupt), "corrupt");
  EXPECT_EQ(ChoiceText(PacketLossModel::kSonarSimple), "sonar_simple");
  EXPECT_EQ(ChoiceText(BitErrorModel::kSnr), "snr");
}

TEST(FindProblems, FindsNoneInTheDefaultsForSevenNodes) {
  EXPECT_TRUE(FindProblems({}, Nodes(7)).empty());
}

TEST(FindProblems, ShowsTheArithmeticOfABandThatIsTooNarrow) {
  const std::vector<OptionProblem> problems = FindProblems({}, Nodes(8));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].option, "bandwidth_khz");
  EXPECT_TRUE(problems[0].message.starts_with("fdma: 8 nodes need 10.25 kHz"))
      << problems[0].message;
}

TEST(FindProblems, AsksTdmaLfForALeaderAndRoomForTwoChannels) {
  AcousticOptions options;
  options.access_mode = AccessMode::kTdmaLf;
  std::vector<AcousticNode> nodes = Nodes(3);
  ASSERT_EQ(FindProblems(options, nodes).size(), 1U);
  EXPECT_EQ(FindProblems(options, nodes)[0].option, "access_mode");
  nodes[1].is_leader = true;
  EXPECT_TRUE(FindProblems(options, nodes).empty());
  options.bandwidth_khz = 2;
  ASSERT_EQ(FindProblems(options, nodes).size(), 1U);
  EXPECT_EQ(FindProblems(options, nodes)[0].message,
            "tdma_lf needs 2 channels (2.75 kHz), bandwidth_khz = 2 holds 1");
}

TEST(FindProblems, RefusesABandBelowZero) {
  AcousticOptions options;
  options.base_freq_khz = 4;
  const std::vector<OptionProblem> problems = FindProblems(options, Nodes(1));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].message,
            "the band begins at base_freq_khz - bandwidth_khz / 2 = 4 - 10 / 2 = -1 kHz, below 0");
}

struct NumberOption {
  std::string name;
  double AcousticOptions::*value;
  double impossible;
};

TEST(FindProblems, NamesEveryNumberThatIsImpossible) {
  const std::vector<NumberOption> options = {
      {"sound_speed_mps", &AcousticOptions::sound_speed_mps, 0},
      {"base_freq_khz", &AcousticOptions::base_freq_khz, 0},
      {"bandwidth_khz", &AcousticOptions::bandwidth_khz, 0},
      {"guard_band_khz", &AcousticOptions::guard_band_khz, -0.1},
      {"channel_bandwidth_khz", &AcousticOptions::channel_bandwidth_khz, 0},
      {"data_rate_bps", &AcousticOptions::data_rate_bps, 0},
      {"max_jitter_s", &AcousticOptions::max_jitter_s, -1},
      {"nominal_distance_m", &AcousticOptions::nominal_distance_m, 0},
      {"packet_loss", &AcousticOptions::packet_loss, 1.01},
      {"packet_loss_distance_m", &AcousticOptions::packet_loss_distance_m, 0},
      {"bit_error_rate", &AcousticOptions::bit_error_rate, 0.51},
      {"bit_error_distance_m", &AcousticOptions::bit_error_distance_m, 0},
      {"snr_nominal_db", &AcousticOptions::snr_nominal_db, 1e9},
      {"snr_slope", &AcousticOptions::snr_slope, -0.1},
  };
  for (const NumberOption& option : options) {
    for (const double value :
         {option.impossible, std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
      AcousticOptions changed;
      changed.*option.value = value;
      const std::vector<OptionProblem> problems = FindProblems(changed, Nodes(1));
      ASSERT_EQ(problems.size(), 1U) << option.name << " = " << value;
      EXPECT_EQ(problems[0].option, option.name);
      EXPECT_NE(problems[0].message.find("must be "), std::string::npos);
    }
  }
  AcousticOptions changed;
  changed.packet_loss = 1.5;
  changed.broadcast_address = -1;
  const std::vector<OptionProblem> problems = FindProblems(changed, Nodes(1));
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].message, "must be from 0 to 1, not 1.5");
  EXPECT_EQ(problems[1].option, "broadcast_address");
  EXPECT_EQ(problems[1].message, "must be from 0 to 1e+09, not -1");
}

/// Returns the messages about options with a modem that has this code, one per line.
std::string ProblemsOfModem(PacketLossModel packet_loss, BitErrorModel bit_errors,
                            const BlockCode& code) {
  AcousticOptions options;
  options.packet_loss_model = packet_loss;
  options.bit_error_model = bit_errors;
  options.modem =
      ModemPreset{.name = "m", .low_khz = 23, .high_khz = 27, .data_rate_bps = 80, .code = code};
  std::string all;
  for (const OptionProblem& problem : FindProblems(options, Nodes(1))) {
    all += problem.option + ": " + problem.message + "\n";
  }
  return all;
}

TEST(FindProblems, LetsAModemDecideOverLossOrOverBitErrors) {
  const BlockCode golay = {.block_bits = 23, .data_bits = 12, .corrected_bits = 3};
  EXPECT_EQ(ProblemsOfModem(PacketLossModel::kModem, BitErrorModel::kOff, golay), "");
  EXPECT_EQ(ProblemsOfModem(PacketLossModel::kModem, BitErrorModel::kPoisson, {}), "");
  EXPECT_EQ(ProblemsOfModem(PacketLossModel::kOff, BitErrorModel::kModem, {}), "");
  EXPECT_EQ(ProblemsOfModem(PacketLossModel::kOff, BitErrorModel::kModem,
                            {.block_bits = 8, .data_bits = 8, .corrected_bits = 0}),
            "");
  EXPECT_EQ(
      ProblemsOfModem(PacketLossModel::kModem, BitErrorModel::kModem, {}),
      "bit_error_model: packet_loss_model = \"modem\" already loses the packets in which bits "
      "are wrong: with bit_error_model = \"modem\" too they would count twice; set one of the "
      "two to \"off\"\n");
  EXPECT_EQ(
      ProblemsOfModem(PacketLossModel::kOff, BitErrorModel::kModem, golay),
      "bit_error_model: bit_error_model = \"modem\" is for modems without a code, and 'm' has "
      "one that corrects 3 of 23 bits; use packet_loss_model = \"modem\" and bit_error_model "
      "= \"off\"\n");
}

TEST(FindProblems, AsksForAModemWhereAModelNeedsOne) {
  AcousticOptions options;
  options.packet_loss_model = PacketLossModel::kModem;
  std::vector<OptionProblem> problems = FindProblems(options, Nodes(1));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].option, "packet_loss_model");
  EXPECT_EQ(problems[0].message,
            "packet_loss_model = \"modem\" needs a modem; name one, as in modem = "
            "\"whoi_micromodem2\", or choose another model");
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kModem;
  problems = FindProblems(options, Nodes(1));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].option, "bit_error_model");
}

TEST(FindProblems, RefusesInvalidModemsAndSeas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ModemPreset sound = {
      .name = "m", .low_khz = 23, .high_khz = 27, .data_rate_bps = 80, .source_level_db = 180};
  const auto option_of = [](const ModemPreset& modem, const Sea& sea) {
    AcousticOptions options;
    options.modem = modem;
    options.sea = sea;
    const std::vector<OptionProblem> problems = FindProblems(options, Nodes(1));
    return problems.empty() ? "" : problems[0].option;
  };
  EXPECT_EQ(option_of(sound, {}), "");
  EXPECT_EQ(option_of({}, {}), "modem");
  for (const double wrong : {nan, 0.0, -1.0, 2000.0}) {
    ModemPreset modem = sound;
    modem.high_khz = wrong;
    EXPECT_EQ(option_of(modem, {}), "modem") << wrong;
  }
  ModemPreset modem = sound;
  modem.data_rate_bps = nan;
  EXPECT_EQ(option_of(modem, {}), "modem");
  modem = sound;
  modem.source_level_db = nan;
  EXPECT_EQ(option_of(modem, {}), "modem");
  modem = sound;
  modem.code = {.block_bits = 7, .data_bits = 4, .corrected_bits = 2};
  EXPECT_EQ(option_of(modem, {}), "modem");
  EXPECT_EQ(option_of(sound, {.water = {.temperature_degc = 40}}), "sea");
  EXPECT_EQ(option_of(sound, {.noise = {.wind_mps = nan}}), "sea");
  EXPECT_EQ(option_of(sound, {.spreading_exponent = 0}), "sea");
}

}  // namespace shoal::acoustic_options_test

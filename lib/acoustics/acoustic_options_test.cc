#include "lib/acoustics/acoustic_options.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/acoustics/validate_options.h"

namespace shoal {
namespace {

std::vector<AcousticNode> Nodes(int count) {
  std::vector<AcousticNode> nodes;
  for (int i = 1; i <= count; ++i) {
    nodes.push_back({.name = "node_" + std::to_string(i), .address = i});
  }
  return nodes;
}

template <class Choice>
void ExpectEachTextToBeItsOwnChoice(size_t count) {
  const auto texts = ChoiceTexts(Choice{});
  EXPECT_EQ(texts.size(), count);
  for (size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(FindChoice<Choice>(texts[i]), static_cast<Choice>(i));
    EXPECT_EQ(ChoiceText(static_cast<Choice>(i)), texts[i]);
  }
  EXPECT_EQ(FindChoice<Choice>("FDMA"), std::nullopt);
  EXPECT_EQ(FindChoice<Choice>(""), std::nullopt);
}

TEST(Choices, AreWrittenAndReadTheSameWay) {
  ExpectEachTextToBeItsOwnChoice<AccessMode>(4);
  ExpectEachTextToBeItsOwnChoice<ChannelOrder>(2);
  ExpectEachTextToBeItsOwnChoice<JitterModel>(2);
  ExpectEachTextToBeItsOwnChoice<CollisionModel>(3);
  ExpectEachTextToBeItsOwnChoice<PacketLossModel>(4);
  ExpectEachTextToBeItsOwnChoice<BitErrorModel>(4);
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

TEST(FindProblems, TellsTheArithmeticOfABandThatIsTooNarrow) {
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
  EXPECT_EQ(problems[0].message, "must be from 0 to 1e+09, not -1");
  EXPECT_EQ(problems[1].message, "must be from 0 to 1, not 1.5");
}

}  // namespace
}  // namespace shoal

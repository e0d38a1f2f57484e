#include "lib/tools/view/fate_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lib/tools/view/view_testing.h"

namespace shoal::fate_text_test {

std::string TextOf(std::string_view cause, void (*fill)(fate_t*)) {
  fate_t fate = FateOf("alpha", "bravo", cause);
  fill(&fate);
  return FateText(fate);
}

std::string TextOnTheWay(std::string_view cause, void (*fill)(acoustic_path_t*)) {
  acoustic_path_t path = CalmPath(0);
  fill(&path);
  return FateText(Through(FateOf("alpha", "bravo", cause), path));
}

void Nothing(fate_t*) {}

TEST(FateText, StatesRangeAndLimitOfWhatIsDelivered) {
  EXPECT_EQ(TextOf("delivered",
                   [](fate_t* fate) {
                     fate->range_m = 18.24;
                     fate->limit_m = 250;
                   }),
            "alpha to bravo: delivered, 18.2 m of 250.0 m");
  EXPECT_EQ(TextOf("delivered", [](fate_t* fate) { fate->range_m = 18.24; }),
            "alpha to bravo: delivered, 18.2 m, no limit");
  EXPECT_EQ(TextOf("delivered",
                   [](fate_t* fate) {
                     fate->range_m = 18.24;
                     fate->limit_m = 10;
                     fate->override_rule = "critical_range";
                   }),
            "alpha to bravo: delivered, 18.2 m of 10.0 m, by critical_range");
  EXPECT_EQ(TextOf("delivered", [](fate_t* fate) { fate->override_rule = "full_report"; }),
            "alpha to bravo: delivered, by a full report request");
  EXPECT_EQ(TextOnTheWay("delivered", [](acoustic_path_t* path) { path->jitter_s = 0.01; }),
            "alpha to bravo: delivered, 0.46 s by sound");
}

TEST(FateText, StatesTheNumbersThatTheRulesDecidedBy) {
  EXPECT_EQ(TextOf("out_of_range",
                   [](fate_t* fate) {
                     fate->range_m = 312.4;
                     fate->limit_m = 250;
                   }),
            "alpha to bravo: out of range, 312.4 m of 250.0 m");
  EXPECT_EQ(TextOf("too_soon", [](fate_t* fate) { fate->wait_s = 12.25; }),
            "alpha to bravo: too soon, 12.2 s too early");
  EXPECT_EQ(TextOf("too_long",
                   [](fate_t* fate) {
                     fate->length_bytes = 1200;
                     fate->length_limit_bytes = 1000;
                   }),
            "alpha to bravo: too long, 1200 bytes of 1000");
  const auto silence = [](fate_t* fate) {
    fate->age_s = 6.04;
    fate->age_limit_s = 5;
  };
  EXPECT_EQ(TextOf("stale_receiver", silence),
            "alpha to bravo: stale receiver, silent for 6.0 s of 5.0 s");
  EXPECT_EQ(TextOf("dropped", [](fate_t* fate) { fate->loss_pct = 12.5; }),
            "alpha to bravo: dropped at random, 12.5 % are");
}

TEST(FateText, StatesCausesThatNoNumberDecided) {
  EXPECT_EQ(TextOf("unknown_source", Nothing), "alpha to bravo: unknown source");
  EXPECT_EQ(TextOf("unknown_destination", Nothing), "alpha to bravo: unknown destination");
  EXPECT_EQ(TextOf("other_group", Nothing), "alpha to bravo: other group");
  EXPECT_EQ(TextOf("no_channel", Nothing), "alpha to bravo: no acoustic channel");
  EXPECT_EQ(TextOf("in_transit", Nothing), "alpha to bravo: in transit");
  EXPECT_EQ(TextOf("no_path", Nothing), "alpha to bravo: farther than sound comes");
}

TEST(FateText, NamesNoVehicleWhereThereIsNoDestination) {
  EXPECT_EQ(FateText(FateOf("alpha", "", "invalid")), "alpha: invalid");
  EXPECT_EQ(FateText(FateOf("alpha", "", "ignored_group")), "alpha: of the ignored group");
  EXPECT_EQ(FateText(FateOf("alpha", "", "too_many_vehicles")), "alpha: too many vehicles");
  EXPECT_EQ(FateText(FateOf("alpha", "", "no_destination")), "alpha: no destination");
  fate_t far = FateOf("alpha", "*", "out_of_range");
  far.count = 12;
  EXPECT_EQ(FateText(far), "alpha to 12 others: out of range");
}

TEST(FateText, StatesWhatHappenedInTheAcousticNetwork) {
  EXPECT_EQ(TextOnTheWay("not_listening", [](acoustic_path_t* path) { path->channel = 3; }),
            "alpha to bravo: receiver not listening, channel 3");
  EXPECT_EQ(TextOnTheWay("half_duplex", [](acoustic_path_t* path) { path->own_packet = 12; }),
            "alpha to bravo: receiver was sending, its own packet 12");
  EXPECT_EQ(TextOnTheWay("packet_loss",
                         [](acoustic_path_t* path) {
                           path->loss_probability = 0.3125;
                           path->snr_db = 4.2;
                         }),
            "alpha to bravo: packet loss, probability 0.312, SNR 4.2 dB");
  EXPECT_EQ(
      TextOnTheWay("packet_loss", [](acoustic_path_t* path) { path->loss_probability = 0.5; }),
      "alpha to bravo: packet loss, probability 0.5");
  EXPECT_EQ(TextOnTheWay("bit_errors",
                         [](acoustic_path_t* path) {
                           path->bits_flipped = 17;
                           path->bit_error_probability = 0.001;
                         }),
            "alpha to bravo: bit errors, 17 bits flipped, each with probability 0.001");
  const auto damage = [](acoustic_path_t* path) {
    path->bits_flipped = 1;
    path->num_colliders = path->num_named = 1;
    path->colliders = {"charlie 4"};
  };
  EXPECT_EQ(TextOnTheWay("rejected", damage),
            "alpha to bravo: rejected as damaged, 1 bit flipped, with charlie 4");
  EXPECT_EQ(TextOnTheWay("damaged", damage),
            "alpha to bravo: delivered damaged, 1 bit flipped, with charlie 4");
}

/// A fate of radio over vhf with all its numbers.
fate_medium_t OverRadio(std::string_view cause) {
  fate_medium_t fate{};
  fate.kind = "report";
  fate.source = "alpha";
  fate.destination = "bravo";
  fate.cause = cause;
  fate.medium = "vhf";
  fate.depth_m = 0.25;
  fate.depth_limit_m = 0.5;
  fate.range_m = 900;
  fate.limit_m = 1000;
  fate.horizon_m = 8000;
  fate.path_loss_db = 118.25;
  fate.path_loss_limit_db = 130;
  fate.loss_probability = 0.05;
  fate.delay_s = 0.25;
  return fate;
}

std::string TextOverRadio(const fate_medium_t& fate) {
  FateView view;
  EXPECT_TRUE(ViewOf(fate, 0, &view));
  return FateText(view);
}

TEST(FateText, StatesTheNumbersThatDecidedARadioLink) {
  EXPECT_EQ(TextOverRadio(OverRadio("delivered")),
            "alpha to bravo: delivered, 900.0 m of 1000.0 m, 0.25 s by radio, path loss 118.2 dB "
            "of 130.0 dB (margin 11.8 dB), over vhf");
  fate_medium_t submerged = OverRadio("submerged");
  submerged.depth_m = 12;
  submerged.hop = 1;
  EXPECT_EQ(TextOverRadio(submerged),
            "alpha to bravo: antenna submerged, depth 12.00 m of 0.50 m, over vhf, hop 1");
  fate_medium_t weak = OverRadio("weak_signal");
  weak.path_loss_db = 133.5;
  EXPECT_EQ(TextOverRadio(weak),
            "alpha to bravo: signal too weak, 900.0 m of 1000.0 m, path loss 133.5 dB of 130.0 dB "
            "(margin -3.5 dB), horizon 8000.0 m, over vhf");
  fate_medium_t far = OverRadio("out_of_range");
  far.range_m = 1200;
  EXPECT_EQ(TextOverRadio(far),
            "alpha to bravo: out of range, 1200.0 m of 1000.0 m, horizon 8000.0 m, over vhf");
  fate_medium_t hidden = OverRadio("below_horizon");
  hidden.range_m = 9000;
  hidden.limit_m = hidden.horizon_m;
  EXPECT_EQ(TextOverRadio(hidden),
            "alpha to bravo: below the radio horizon, 9000.0 m of 8000.0 m, over vhf");
  EXPECT_EQ(TextOverRadio(OverRadio("packet_loss")),
            "alpha to bravo: packet loss, probability 0.05, over vhf");
}

TEST(FateText, LeavesOutRadiosNumbersWhereThereAreNone) {
  fate_medium_t fate = OverRadio("delivered");
  fate.medium = "direct";
  fate.depth_m = fate.depth_limit_m = fate.range_m = fate.limit_m = fate.horizon_m = -1;
  fate.path_loss_db = fate.path_loss_limit_db = fate.loss_probability = -1;
  fate.delay_s = 0;
  EXPECT_EQ(TextOverRadio(fate), "alpha to bravo: delivered, over direct");
}

TEST(FateText, NamesColliders) {
  const auto text = [](int num, std::vector<std::string> names) {
    acoustic_path_t path = CalmPath(0);
    path.num_colliders = num;
    path.num_named = static_cast<int32_t>(names.size());
    path.colliders = std::move(names);
    return FateText(Through(FateOf("alpha", "bravo", "collision"), path));
  };
  EXPECT_EQ(text(1, {"charlie 4"}), "alpha to bravo: collision, with charlie 4");
  EXPECT_EQ(text(2, {"charlie 4", "delta 7"}),
            "alpha to bravo: collision, with charlie 4, delta 7");
  EXPECT_EQ(text(5, {"c 1", "d 2", "e 3", "f 4"}),
            "alpha to bravo: collision, with c 1, d 2, e 3 and 2 others");
  EXPECT_EQ(text(1, {}), "alpha to bravo: collision, with 1 other");
}

TEST(FateText, HasWordsOfItsOwnForEveryCause) {
  std::set<std::string_view> words;
  for (int i = 0; i < kNumCauses; ++i) {
    const auto cause = static_cast<Cause>(i);
    EXPECT_FALSE(CauseWords(cause).empty());
    words.insert(CauseWords(cause));
    EXPECT_EQ(FateText(FateOf("alpha", "bravo", CauseText(cause))),
              "alpha to bravo: " + std::string(CauseWords(cause)))
        << "without numbers";
  }
  EXPECT_EQ(words.size(), static_cast<size_t>(kNumCauses));
}

TEST(FateText, KnowsEveryNumberThatATextOfACauseHolds) {
  std::set<std::string_view> known;
  for (const FateNumber& number : FateNumbers()) {
    EXPECT_TRUE(known.insert(number.name).second) << number.name;
    EXPECT_FALSE(number.members.empty()) << number.name;
  }
  for (const CauseRow& row : kCauseTable) {
    std::string_view text = row.text;
    const auto num_parts = 1 + std::ranges::count(text, ',');
    EXPECT_EQ(std::ranges::count(text, '{'), num_parts - 1) << text << ": one number for each part";
    while (text.find('{') != text.npos) {
      text.remove_prefix(text.find('{') + 1);
      EXPECT_TRUE(known.contains(text.substr(0, text.find('}')))) << row.text;
    }
  }
}

TEST(FateText, CutsLongNamesAndShowsUnknownCausesAsTheyAre) {
  fate_t fate = FateOf(std::string(1'000'000, 'x'), "bravo", "eaten_by_a_whale");
  EXPECT_EQ(FateText(fate), std::string(64, 'x') + " to bravo: eaten_by_a_whale");
}

}  // namespace shoal::fate_text_test

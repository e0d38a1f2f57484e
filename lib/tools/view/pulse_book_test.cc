#include "lib/tools/view/pulse_book.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "lib/tools/view/view_testing.h"
#include "shoal/comms_pulse_columns_t.hpp"

namespace shoal::pulse_book_test {

void AddPulses(PulseBook* book, int64_t utime, std::vector<comms_pulse_t> pulses) {
  ASSERT_TRUE(book->Add(Encoded(PulsesOf(utime, std::move(pulses)))));
}

TEST(PulseBook, KeepsAPulseUntilItIsOver) {
  PulseBook book;
  AddPulses(&book, kSecond_us, {PulseOf("A2B", "nrep", 10)});
  ASSERT_EQ(book.NotOver(kSecond_us).size(), 1U);
  const ViewPulse& pulse = *book.NotOver(kSecond_us)[0];
  EXPECT_EQ(pulse.label, "A2B");
  EXPECT_EQ(pulse.color, "orange");
  EXPECT_FALSE(pulse.of_message);
  EXPECT_EQ(pulse.tx_m, 80);
  EXPECT_EQ(pulse.width_m, 10);
  EXPECT_EQ(book.NotOver(11 * kSecond_us - 1).size(), 1U);
  EXPECT_TRUE(book.NotOver(11 * kSecond_us).empty());
}

/// The columns that a list stands for, with an end for each pulse's source and destination.
comms_pulse_columns_t ColumnsOf(const comms_pulses_t& list) {
  comms_pulse_columns_t columns{};
  columns.utime = list.utime;
  for (const comms_pulse_t& pulse : list.pulses) {
    const size_t two = pulse.label.find('2');
    const size_t end = std::min(pulse.label.find('_'), pulse.label.size());
    columns.ends.push_back({pulse.label.substr(0, two), pulse.sx_m, pulse.sy_m});
    columns.ends.push_back({pulse.label.substr(two + 1, end - two - 1), pulse.tx_m, pulse.ty_m});
    pulse_style_t style{};
    style.duration_s = pulse.duration_s;
    style.fill = pulse.fill;
    style.label_end = pulse.label.substr(end);
    style.ptype = pulse.ptype;
    style.fill_color = pulse.fill_color;
    columns.styles.push_back(style);
    columns.style.push_back(static_cast<int16_t>(columns.source.size()));
    columns.source.push_back(static_cast<int16_t>(columns.ends.size() - 2));
    columns.destination.push_back(static_cast<int16_t>(columns.ends.size() - 1));
    columns.beam_width_m.push_back(pulse.beam_width_m);
  }
  columns.num_ends = static_cast<int32_t>(columns.ends.size());
  columns.num_styles = static_cast<int32_t>(columns.styles.size());
  columns.num_pulses = static_cast<int32_t>(columns.source.size());
  return columns;
}

TEST(PulseBook, ReadsColumnsAsTheListThatTheyStandFor) {
  const comms_pulses_t list =
      PulsesOf(kSecond_us, {PulseOf("A2B", "nrep", 10), PulseOf("LONG2OTHER_MSG", "msg", 3)});
  PulseBook of_list;
  PulseBook of_columns;
  ASSERT_TRUE(of_list.Add(Encoded(list)));
  ASSERT_TRUE(of_columns.Add(Encoded(ColumnsOf(list))));
  EXPECT_EQ(of_columns.last_utime(), kSecond_us);
  const auto expected = of_list.NotOver(kSecond_us);
  const auto read = of_columns.NotOver(kSecond_us);
  ASSERT_EQ(read.size(), 2U);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i]->id, expected[i]->id);
    EXPECT_EQ(read[i]->label, expected[i]->label);
    EXPECT_EQ(read[i]->color, expected[i]->color);
    EXPECT_EQ(read[i]->of_message, expected[i]->of_message);
    EXPECT_EQ(read[i]->sx_m, expected[i]->sx_m);
    EXPECT_EQ(read[i]->sy_m, expected[i]->sy_m);
    EXPECT_EQ(read[i]->tx_m, expected[i]->tx_m);
    EXPECT_EQ(read[i]->ty_m, expected[i]->ty_m);
    EXPECT_EQ(read[i]->width_m, expected[i]->width_m);
    EXPECT_EQ(read[i]->duration_s, expected[i]->duration_s);
    EXPECT_EQ(read[i]->fill, expected[i]->fill);
  }
}

TEST(PulseBook, TakesNothingOfColumnsThatDoNotFitOneAnother) {
  const comms_pulse_columns_t sound = ColumnsOf(PulsesOf(0, {PulseOf("A2B", "nrep", 10)}));
  PulseBook book;
  for (int16_t* (*index)(comms_pulse_columns_t*) :
       {+[](comms_pulse_columns_t* columns) { return &columns->source[0]; },
        +[](comms_pulse_columns_t* columns) { return &columns->destination[0]; },
        +[](comms_pulse_columns_t* columns) { return &columns->style[0]; }}) {
    for (const int16_t wrong : {int16_t{-1}, int16_t{2}}) {
      comms_pulse_columns_t columns = sound;
      *index(&columns) = wrong;
      EXPECT_FALSE(book.Add(Encoded(columns)));
    }
  }
  Bytes cut = Encoded(sound);
  cut.pop_back();
  EXPECT_FALSE(book.Add(cut));
  cut.resize(cut.size() + 2);
  EXPECT_FALSE(book.Add(cut));
  EXPECT_EQ(book.last_order(), 0);
}

TEST(PulseBook, ReplacesThePulseOfTheSameLabel) {
  PulseBook book;
  AddPulses(&book, 0, {PulseOf("A2B", "nrep", 10), PulseOf("A2B_MSG", "msg", 10)});
  const int64_t first_id = book.NotOver(0)[0]->id;
  AddPulses(&book, kSecond_us, {PulseOf("A2B", "nrep", 10)});
  const auto pulses = book.NotOver(kSecond_us);
  ASSERT_EQ(pulses.size(), 2U);
  EXPECT_EQ(pulses[1]->label, "A2B");
  EXPECT_EQ(pulses[1]->utime, kSecond_us);
  EXPECT_NE(pulses[1]->id, first_id);
}

TEST(PulseBook, GivesTheSamePulseTheSameId) {
  PulseBook first;
  PulseBook second;
  AddPulses(&second, 0, {PulseOf("X2Y", "nrep", 10)});
  AddPulses(&first, kSecond_us, {PulseOf("A2B", "nrep", 10)});
  AddPulses(&second, kSecond_us, {PulseOf("A2B", "nrep", 10)});
  EXPECT_EQ(first.NotOver(kSecond_us)[0]->id, second.NotOver(kSecond_us)[1]->id);
  EXPECT_LT(first.NotOver(kSecond_us)[0]->id, int64_t{1} << 53);
}

TEST(PulseBook, ReturnsNewMessagesBeforeNewReports) {
  PulseBook book;
  AddPulses(&book, 0, {PulseOf("OLD", "nrep", 10)});
  const int64_t order = book.last_order();
  AddPulses(&book, 0,
            {PulseOf("R1", "nrep", 10), PulseOf("M1", "msg", 10), PulseOf("R2", "nrep", 10)});
  int64_t num_left_out = 0;
  const auto pulses = book.TakeForStream(order, 0, 10, &num_left_out);
  ASSERT_EQ(pulses.size(), 3U);
  EXPECT_EQ(pulses[0]->label, "M1");
  EXPECT_EQ(pulses[1]->label, "R2");
  EXPECT_EQ(num_left_out, 0);
  EXPECT_TRUE(book.TakeForStream(book.last_order(), 0, 10, &num_left_out).empty());
}

TEST(PulseBook, StreamsEachLinkNowAndThenWhereThereAreTooMany) {
  constexpr int kLinks = 100;
  PulseBook book;
  std::set<std::string> seen;
  for (int round = 0; round < 5; ++round) {
    const int64_t order = book.last_order();
    std::vector<comms_pulse_t> pulses;
    for (int i = 0; i < kLinks; ++i) {
      pulses.push_back(PulseOf("R" + std::to_string(i), "nrep", 10));
    }
    AddPulses(&book, round, std::move(pulses));
    int64_t num_left_out = 0;
    const auto taken = book.TakeForStream(order, round, 20, &num_left_out);
    ASSERT_EQ(taken.size(), 20U);
    EXPECT_EQ(num_left_out, 80);
    for (const ViewPulse* pulse : taken) seen.insert(pulse->label);
  }
  EXPECT_EQ(seen.size(), static_cast<size_t>(kLinks)) << "a chosen one is among them";
}

TEST(PulseBook, LetsMessagesReplaceReportsWhereThereIsNoRoom) {
  PulseBook book;
  for (size_t i = 0; i < PulseBook::kMaxPulses + 100; ++i) {
    AddPulses(&book, 0, {PulseOf("R" + std::to_string(i), "nrep", 10)});
  }
  EXPECT_EQ(book.NotOver(0).size(), PulseBook::kMaxPulses);
  EXPECT_EQ(book.num_left_out(), 100);
  AddPulses(&book, 0, {PulseOf("M", "msg", 10)});
  EXPECT_EQ(book.NotOver(0).size(), PulseBook::kMaxPulses);
  EXPECT_EQ(book.NotOver(0).back()->label, "M");
  EXPECT_EQ(book.num_left_out(), 101);
  AddPulses(&book, 20 * kSecond_us, {PulseOf("LATER", "nrep", 10)});
  ASSERT_EQ(book.NotOver(20 * kSecond_us).size(), 1U) << "those that are over make room";
}

TEST(PulseBook, MakesRoomAgainAfterAllWereOverAtOnce) {
  PulseBook book;
  for (const int64_t t_s : {0, 20, 40}) {
    for (size_t i = 0; i <= PulseBook::kMaxPulses; ++i) {
      AddPulses(&book, t_s * kSecond_us,
                {PulseOf(std::to_string(t_s) + "_" + std::to_string(i), "nrep", 10)});
    }
    EXPECT_EQ(book.NotOver(t_s * kSecond_us).size(), PulseBook::kMaxPulses) << t_s;
  }
}

TEST(PulseBook, MakesRoomAgainAfterAMessageFromFarInTheFuture) {
  PulseBook book;
  for (size_t i = 0; i <= PulseBook::kMaxPulses; ++i) {
    AddPulses(&book, 0, {PulseOf("A" + std::to_string(i), "nrep", 10)});
  }
  for (size_t i = 0; i <= PulseBook::kMaxPulses; ++i) {
    AddPulses(&book, 1'000'000 * kSecond_us, {PulseOf("B" + std::to_string(i), "nrep", 10)});
  }
  AddPulses(&book, kSecond_us, {PulseOf("C", "nrep", 10)});
  EXPECT_EQ(book.NotOver(kSecond_us).size(), 1U);
}

TEST(PulseBook, RefusesBytesThatAreNoPulses) {
  PulseBook book;
  Bytes bytes = Encoded(PulsesOf(0, {PulseOf("A2B", "nrep", 10), PulseOf("C2D", "nrep", 10)}));
  bytes.pop_back();
  EXPECT_FALSE(book.Add(bytes));
  EXPECT_FALSE(book.Add({}));
  EXPECT_FALSE(book.Add(Encoded(NavAt(0, 0, 0))));
  EXPECT_TRUE(book.NotOver(0).empty()) << "not half of them either";
}

TEST(PulseBook, DrawsNoPulseOfImpossibleNumbers) {
  PulseBook book;
  comms_pulse_t nowhere = PulseOf("A2B", "nrep", 10);
  nowhere.tx_m = std::numeric_limits<double>::quiet_NaN();
  comms_pulse_t endless = PulseOf("C2D", "nrep", std::numeric_limits<double>::infinity());
  AddPulses(&book, 0,
            {nowhere, PulseOf("E2F", "nrep", std::numeric_limits<double>::quiet_NaN()),
             PulseOf("G2H", "nrep", -1), endless});
  ASSERT_EQ(book.NotOver(0).size(), 1U);
  EXPECT_EQ(book.NotOver(0)[0]->duration_s, 3600) << "an hour is the longest";
  EXPECT_EQ(book.num_left_out(), 3);
}

}  // namespace shoal::pulse_book_test

#include "lib/bus/bus/pulse_columns.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::pulse_columns_test {

/// A report from alpha to bravo, and a message back.
comms_pulse_columns_t TwoPulses() {
  comms_pulse_columns_t columns{};
  columns.utime = 7;
  columns.ends.resize(2);
  columns.ends[0].vehicle = "ALPHA";
  columns.ends[0].x_m = 1;
  columns.ends[0].y_m = 2;
  columns.ends[1].vehicle = "BRAVO";
  columns.ends[1].x_m = 3;
  columns.ends[1].y_m = 4;
  columns.styles.resize(2);
  columns.styles[0].duration_s = 10;
  columns.styles[0].fill = 0.35;
  columns.styles[0].ptype = "nrep";
  columns.styles[0].fill_color = "red";
  columns.styles[0].edge_color = "green";
  columns.styles[0].edge_size = 1;
  columns.styles[1].label_end = "_MSG";
  columns.styles[1].ptype = "msg";
  columns.source = {0, 1};
  columns.destination = {1, 0};
  columns.style = {0, 1};
  columns.beam_width_m = {12.5, 5};
  return columns;
}

/// Sets the lengths to those of the arrays.
Bytes Encoded(comms_pulse_columns_t columns) {
  columns.num_ends = static_cast<int32_t>(columns.ends.size());
  columns.num_styles = static_cast<int32_t>(columns.styles.size());
  columns.num_pulses = static_cast<int32_t>(columns.source.size());
  Bytes bytes;
  EncodeInto(columns, &bytes);
  return bytes;
}

TEST(PulseColumns, DecodeAsTheListThatTheyStandFor) {
  comms_pulses_t list;
  ASSERT_TRUE(Decode(Encoded(TwoPulses()), &list));
  EXPECT_EQ(list.utime, 7);
  ASSERT_EQ(list.num_pulses, 2);
  const comms_pulse_t& report = list.pulses[0];
  EXPECT_EQ(report.sx_m, 1);
  EXPECT_EQ(report.sy_m, 2);
  EXPECT_EQ(report.tx_m, 3);
  EXPECT_EQ(report.ty_m, 4);
  EXPECT_EQ(report.beam_width_m, 12.5);
  EXPECT_EQ(report.duration_s, 10);
  EXPECT_EQ(report.fill, 0.35);
  EXPECT_EQ(report.label, "ALPHA2BRAVO");
  EXPECT_EQ(report.ptype, "nrep");
  EXPECT_EQ(report.fill_color, "red");
  EXPECT_EQ(report.edge_color, "green");
  EXPECT_EQ(report.edge_size, 1);
  EXPECT_EQ(list.pulses[1].label, "BRAVO2ALPHA_MSG");
  EXPECT_EQ(list.pulses[1].beam_width_m, 5);
}

TEST(PulseColumns, BecomeTheBytesOfAList) {
  Bytes storage;
  const auto bytes = WithPulsesAsList(Encoded(TwoPulses()), &storage);
  comms_pulses_t list;
  ASSERT_EQ(list.decode(bytes.data(), 0, static_cast<int>(bytes.size())),
            static_cast<int>(bytes.size()));
  ASSERT_EQ(list.num_pulses, 2);
  EXPECT_EQ(list.pulses[0].label, "ALPHA2BRAVO");
  const Bytes again(bytes.begin(), bytes.end());
  EXPECT_EQ(WithPulsesAsList(again, &storage).data(), again.data()) << "a list stays as it is";
  comms_pulses_t read;
  EXPECT_TRUE(Decode(again, &read));
  EXPECT_EQ(read.pulses[1].label, "BRAVO2ALPHA_MSG");
}

TEST(PulseColumns, ThatDoNotFitOneAnotherAreNoMessage) {
  const auto refuses = [](void (*change)(comms_pulse_columns_t*)) {
    comms_pulse_columns_t columns = TwoPulses();
    change(&columns);
    comms_pulses_t list;
    return !ListOf(columns, &list);
  };
  EXPECT_FALSE(refuses([](comms_pulse_columns_t*) {}));
  EXPECT_TRUE(refuses([](comms_pulse_columns_t* columns) { columns->source[1] = 2; }));
  EXPECT_TRUE(refuses([](comms_pulse_columns_t* columns) { columns->source[1] = -1; }));
  EXPECT_TRUE(refuses([](comms_pulse_columns_t* columns) { columns->destination[0] = 2; }));
  EXPECT_TRUE(refuses([](comms_pulse_columns_t* columns) { columns->style[0] = 2; }));
  EXPECT_TRUE(refuses([](comms_pulse_columns_t* columns) { columns->beam_width_m.pop_back(); }));
  Bytes storage;
  comms_pulse_columns_t columns = TwoPulses();
  columns.style[0] = 9;
  const Bytes bytes = Encoded(columns);
  EXPECT_EQ(WithPulsesAsList(bytes, &storage).data(), bytes.data());
}

TEST(PulseColumns, WhoseTextsWouldFillMemoryAreNoMessage) {
  comms_pulse_columns_t columns = TwoPulses();
  columns.ends[0].vehicle = std::string(size_t{1} << 20, 'A');
  columns.source.assign(100, 0);
  columns.destination.assign(100, 0);
  columns.style.assign(100, 0);
  columns.beam_width_m.assign(100, 5);
  comms_pulses_t list;
  EXPECT_FALSE(ListOf(columns, &list)) << "200 MB of labels";
  columns.ends[0].vehicle = "ALPHA";
  EXPECT_TRUE(ListOf(columns, &list));
}

}  // namespace shoal::pulse_columns_test

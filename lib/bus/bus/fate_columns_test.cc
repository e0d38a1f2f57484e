#include "lib/bus/bus/fate_columns.h"

#include <gtest/gtest.h>

namespace shoal::fate_columns_test {

/// Three fates of two transmissions: with a range, with a wait and a path, and of five others.
comms_fate_columns_t ThreeFates() {
  comms_fate_columns_t columns{};
  columns.utime = 7;
  columns.senders.resize(2);
  columns.senders[0].kind = "report";
  columns.senders[0].source = "alpha";
  columns.senders[0].number = 3;
  columns.senders[0].num_fates = 1;
  columns.senders[1].kind = "packet";
  columns.senders[1].source = "bravo";
  columns.senders[1].num_fates = 2;
  columns.cases.resize(3);
  columns.cases[0].cause = "delivered";
  columns.cases[0].age_s = 0.5;
  columns.cases[0].has_range = 1;
  columns.cases[1].cause = "too_soon";
  columns.cases[1].has_wait = 1;
  columns.cases[1].has_path = 1;
  columns.cases[2].cause = "out_of_range";
  columns.cases[2].has_count = 1;
  columns.names = {"bravo", "*"};
  columns.destination = {0, 0, 1};
  columns.which_case = {0, 1, 2};
  columns.range_m = {12.5};
  columns.wait_s = {2};
  columns.count = {5};
  columns.path.resize(1);
  columns.path[0].packet = 99;
  return columns;
}

/// Sets the lengths to those of the arrays.
Bytes Encoded(comms_fate_columns_t columns) {
  columns.num_senders = static_cast<int32_t>(columns.senders.size());
  columns.num_cases = static_cast<int32_t>(columns.cases.size());
  columns.num_names = static_cast<int32_t>(columns.names.size());
  columns.num_fates = static_cast<int32_t>(columns.destination.size());
  columns.num_ranges = static_cast<int32_t>(columns.range_m.size());
  columns.num_waits = static_cast<int32_t>(columns.wait_s.size());
  columns.num_counts = static_cast<int32_t>(columns.count.size());
  columns.num_paths = static_cast<int32_t>(columns.path.size());
  Bytes bytes;
  EncodeInto(columns, &bytes);
  return bytes;
}

TEST(FateColumns, DecodeAsTheListThatTheyStandFor) {
  comms_fates_t list;
  ASSERT_TRUE(Decode(Encoded(ThreeFates()), &list));
  EXPECT_EQ(list.utime, 7);
  ASSERT_EQ(list.num_fates, 3);
  EXPECT_EQ(list.fates[0].kind, "report");
  EXPECT_EQ(list.fates[0].source, "alpha");
  EXPECT_EQ(list.fates[0].destination, "bravo");
  EXPECT_EQ(list.fates[0].number, 3);
  EXPECT_EQ(list.fates[0].count, 1);
  EXPECT_EQ(list.fates[0].cause, "delivered");
  EXPECT_EQ(list.fates[0].range_m, 12.5);
  EXPECT_EQ(list.fates[0].age_s, 0.5);
  EXPECT_EQ(list.fates[0].wait_s, -1);
  EXPECT_EQ(list.fates[0].num_paths, 0);
  EXPECT_EQ(list.fates[1].source, "bravo");
  EXPECT_EQ(list.fates[1].range_m, -1);
  EXPECT_EQ(list.fates[1].wait_s, 2);
  ASSERT_EQ(list.fates[1].num_paths, 1);
  EXPECT_EQ(list.fates[1].path[0].packet, 99);
  EXPECT_EQ(list.fates[2].destination, "*");
  EXPECT_EQ(list.fates[2].count, 5);
}

TEST(FateColumns, AreRefusedWhereTheyDoNotFitOneAnother) {
  const auto is_refused = [](auto change) {
    comms_fate_columns_t columns = ThreeFates();
    change(&columns);
    comms_fates_t list;
    return !Decode(Encoded(columns), &list);
  };
  EXPECT_FALSE(is_refused([](auto*) {}));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->destination[2] = 2; }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->destination[2] = -1; }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->which_case[0] = 3; }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->range_m.clear(); }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->wait_s.push_back(1); }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->path.clear(); }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->senders.pop_back(); }));
  EXPECT_TRUE(is_refused([](auto* columns) { columns->senders[1].num_fates = 3; }));
}

TEST(FateColumns, AreRefusedWhereALongNameWouldStandForMany) {
  comms_fate_columns_t columns = ThreeFates();
  columns.names[0] = std::string(1 << 20, 'b');
  const auto repeat = [&](size_t num_fates) {
    columns.destination.assign(num_fates, 0);
    columns.which_case.assign(num_fates, 2);
    columns.count.assign(num_fates, 1);
    columns.range_m.clear();
    columns.wait_s.clear();
    columns.path.clear();
    columns.senders[1].num_fates = static_cast<int32_t>(num_fates) - 1;
    comms_fates_t list;
    return Decode(Encoded(columns), &list);
  };
  EXPECT_TRUE(repeat(64)) << "the 64 MiB of any number of fates";
  EXPECT_FALSE(repeat(65));
}

TEST(FateColumns, StandForTheSameBytesAsTheList) {
  const Bytes columns = Encoded(ThreeFates());
  comms_fates_t list;
  ASSERT_TRUE(Decode(columns, &list));
  Bytes expected;
  EncodeInto(list, &expected);
  Bytes storage;
  const auto bytes = WithFatesAsList(columns, &storage);
  EXPECT_TRUE(std::ranges::equal(bytes, expected));
  comms_fates_t again;
  EXPECT_TRUE(Decode(bytes, &again));
  EXPECT_EQ(WithFatesAsList(expected, &storage).data(), expected.data());
}

}  // namespace shoal::fate_columns_test

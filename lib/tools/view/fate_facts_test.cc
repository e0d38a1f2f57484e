#include "lib/tools/view/fate_facts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "lib/tools/view/view_testing.h"

namespace shoal::fate_facts_test {

fate_t DrawFate() {
  fate_t fate = FateOf(*rc::gen::container<std::string>(rc::gen::inRange('a', 'd')),
                       *rc::gen::element<std::string>("", "*", "bravo", "charlie"),
                       CauseText(static_cast<Cause>(*rc::gen::inRange(0, kNumCauses))));
  fate.kind = KindText(static_cast<Kind>(*rc::gen::inRange(0, kNumKinds)));
  fate.number = *rc::gen::arbitrary<int64_t>();
  fate.count = *rc::gen::inRange(0, 100);
  fate.range_m = *rc::gen::arbitrary<float>();
  fate.length_bytes = *rc::gen::arbitrary<int32_t>();
  fate.override_rule = *rc::gen::element<std::string>("", "critical_range", "full_report", "odd");
  if (*rc::gen::arbitrary<bool>()) {
    acoustic_path_t path = CalmPath(*rc::gen::inRange<int64_t>(0, 1'000'000'000));
    path.bits_flipped = *rc::gen::arbitrary<int64_t>();
    path.num_colliders = *rc::gen::inRange(0, 5);
    path.num_named = *rc::gen::inRange(0, path.num_colliders + 1);
    for (int i = 0; i < path.num_named; ++i) path.colliders.push_back("alpha 1");
    fate = Through(fate, path);
  }
  return fate;
}

bool AreSame(const FateView& a, const FateView& b) {
  const FateFacts& f = a.facts;
  const FateFacts& g = b.facts;
  return a.source == b.source && a.destination == b.destination && a.colliders == b.colliders &&
         f.utime == g.utime && f.number == g.number && f.count == g.count && f.kind == g.kind &&
         f.cause == g.cause && f.override_rule == g.override_rule && f.has_path == g.has_path &&
         (f.range_m == g.range_m || f.range_m != f.range_m) && f.length_bytes == g.length_bytes &&
         f.sent_utime == g.sent_utime && f.bits_flipped == g.bits_flipped && f.air_s == g.air_s &&
         f.num_colliders == g.num_colliders && f.own_packet == g.own_packet;
}

RC_GTEST_PROP(ReadFates, ReadsWhatTheGeneratedCodeReads, ()) {
  std::vector<fate_t> fates(*rc::gen::inRange<size_t>(0, 8));
  for (fate_t& fate : fates) fate = DrawFate();
  const Bytes bytes = Encoded(FatesOf(7'000'000, fates));
  FatesView message;
  message.fates.resize(3);
  message.fates[0].facts.bits_flipped = 99;
  message.fates[0].colliders = {"left over"};
  RC_ASSERT(ReadFates(bytes, &message));
  RC_ASSERT(message.num_fates == fates.size());
  for (size_t i = 0; i < fates.size(); ++i) {
    FateView expected;
    RC_ASSERT(ViewOf(fates[i], 7'000'000, &expected));
    RC_ASSERT(AreSame(message.fates[i], expected));
  }
}

RC_GTEST_PROP(ReadFates, RefusesWhatTheGeneratedCodeRefuses, ()) {
  Bytes bytes = Encoded(FatesOf(7, {DrawFate(), DrawFate()}));
  const int num_changes = *rc::gen::inRange(0, 3);
  for (int i = 0; i < num_changes; ++i) {
    bytes[*rc::gen::inRange<size_t>(0, bytes.size())] =
        *rc::gen::element<uint8_t>(0, 1, 7, 127, 255);
  }
  bytes.resize(*rc::gen::oneOf(rc::gen::just(bytes.size()),
                               rc::gen::inRange<size_t>(0, bytes.size()),
                               rc::gen::just(bytes.size() + 1)));
  comms_fates_t decoded;
  FatesView message;
  const bool is_read = ReadFates(bytes, &message);
  RC_ASSERT(is_read == Decode(bytes, &decoded));
  if (!is_read) RC_ASSERT(message.all().empty());
}

/// Each fate with a sender and a case of its own, as columns may have them.
comms_fate_columns_t ColumnsOf(const comms_fates_t& list) {
  comms_fate_columns_t columns{};
  columns.utime = list.utime;
  for (const fate_t& fate : list.fates) {
    columns.senders.push_back({fate.kind, fate.source, fate.number, 1});
    fate_case_t of{};
    of.cause = fate.cause;
    of.override_rule = fate.override_rule;
    of.limit_m = fate.limit_m;
    of.age_s = fate.age_s;
    of.age_limit_s = fate.age_limit_s;
    of.loss_pct = fate.loss_pct;
    of.length_bytes = fate.length_bytes;
    of.length_limit_bytes = fate.length_limit_bytes;
    of.has_range = of.has_wait = of.has_count = 1;
    of.has_path = static_cast<int8_t>(fate.num_paths);
    columns.cases.push_back(of);
    columns.names.push_back(fate.destination);
    columns.destination.push_back(static_cast<int16_t>(columns.destination.size()));
    columns.which_case.push_back(static_cast<int16_t>(columns.which_case.size()));
    columns.range_m.push_back(fate.range_m);
    columns.wait_s.push_back(fate.wait_s);
    columns.count.push_back(fate.count);
    columns.path.insert(columns.path.end(), fate.path.begin(), fate.path.end());
  }
  const auto size = [](const auto& column) { return static_cast<int32_t>(column.size()); };
  columns.num_senders = size(columns.senders);
  columns.num_cases = size(columns.cases);
  columns.num_names = size(columns.names);
  columns.num_fates = size(columns.destination);
  columns.num_ranges = size(columns.range_m);
  columns.num_waits = size(columns.wait_s);
  columns.num_counts = size(columns.count);
  columns.num_paths = size(columns.path);
  return columns;
}

RC_GTEST_PROP(ReadFates, ReadsColumnsAsTheListThatTheyStandFor, ()) {
  std::vector<fate_t> fates(*rc::gen::inRange<size_t>(0, 8));
  for (fate_t& fate : fates) fate = DrawFate();
  const comms_fates_t list = FatesOf(7'000'000, fates);
  FatesView of_list;
  FatesView of_columns;
  const Bytes as_list = Encoded(list);
  RC_ASSERT(ReadFates(as_list, &of_list));
  const Bytes columns = Encoded(ColumnsOf(list));
  RC_ASSERT(ReadFates(columns, &of_columns));
  RC_ASSERT(of_columns.num_fates == of_list.num_fates);
  for (size_t i = 0; i < of_list.num_fates; ++i) {
    RC_ASSERT(AreSame(of_columns.fates[i], of_list.fates[i]));
  }
}

RC_GTEST_PROP(ReadFates, RefusesColumnsThatTheGeneratedCodeRefuses, ()) {
  Bytes bytes = Encoded(ColumnsOf(FatesOf(7, {DrawFate(), DrawFate()})));
  const int num_changes = *rc::gen::inRange(0, 4);
  for (int i = 0; i < num_changes; ++i) {
    bytes[*rc::gen::inRange<size_t>(0, bytes.size())] =
        *rc::gen::element<uint8_t>(0, 1, 2, 7, 127, 255);
  }
  bytes.resize(
      *rc::gen::oneOf(rc::gen::just(bytes.size()), rc::gen::inRange<size_t>(0, bytes.size())));
  comms_fates_t decoded;
  FatesView message;
  const bool is_read = ReadFates(bytes, &message);
  RC_ASSERT(is_read == Decode(bytes, &decoded));
  if (!is_read) RC_ASSERT(message.all().empty());
}

TEST(ReadFates, CountsFatesOfUnknownKindOrCauseAndReadsOn) {
  fate_t odd_kind = FateOf("alpha", "bravo", "delivered");
  odd_kind.kind = "rumour";
  const Bytes bytes = Encoded(FatesOf(
      7, {odd_kind, FateOf("alpha", "bravo", "eaten"), FateOf("alpha", "bravo", "dropped")}));
  FatesView message;
  ASSERT_TRUE(ReadFates(bytes, &message));
  EXPECT_EQ(message.num_strange, 2);
  ASSERT_EQ(message.num_fates, 1U);
  EXPECT_EQ(message.all()[0].facts.cause, Cause::kDropped);
}

TEST(ReadFates, ClampsTimesAndCounts) {
  fate_t fate =
      Through(FateOf("a", "b", "delivered"), CalmPath(std::numeric_limits<int64_t>::min()));
  fate.count = -5;
  FatesView message;
  ASSERT_TRUE(ReadFates(Encoded(FatesOf(std::numeric_limits<int64_t>::max(), {fate})), &message));
  EXPECT_EQ(message.utime, kFarthest_us);
  EXPECT_EQ(message.all()[0].facts.sent_utime, -kFarthest_us);
  EXPECT_EQ(message.all()[0].facts.count, 0);
}

}  // namespace shoal::fate_facts_test

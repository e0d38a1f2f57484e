#include "lib/tools/view/link_book.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "lib/tools/view/view_testing.h"

namespace shoal::link_book_test {

FateView ViewAt(const fate_t& fate, int64_t utime) {
  FateView view;
  EXPECT_TRUE(ViewOf(fate, utime, &view));
  return view;
}

TEST(LinkBook, CountsByKindAndCauseInEachDirection) {
  LinkBook book({"alpha", "Bravo"});
  book.Add(ViewAt(FateOf("alpha", "Bravo", "delivered"), 5));
  book.Add(ViewAt(FateOf("ALPHA", "bravo", "out_of_range"), 6));
  fate_t packet = FateOf("alpha", "Bravo", "damaged");
  packet.kind = "packet";
  book.Add(ViewAt(packet, 7));
  const LinkCounts* link = book.Find(0, 1);
  ASSERT_NE(link, nullptr);
  EXPECT_EQ(link->Offered(), 3U);
  EXPECT_EQ(link->Received(), 2U) << "what came damaged counts as received";
  EXPECT_EQ(link->offered[static_cast<size_t>(Kind::kPacket)], 1U);
  EXPECT_EQ(link->by_cause[static_cast<size_t>(Cause::kOutOfRange)], 1U);
  EXPECT_EQ(link->last_received_utime, 7);
  EXPECT_EQ(link->last.cause, Cause::kDamaged);
  EXPECT_EQ(book.Find(1, 0), nullptr);
  EXPECT_EQ(book.Find(-1, 5), nullptr);
}

TEST(LinkBook, CountsFatesWithoutLinkElsewhere) {
  LinkBook book({"alpha"});
  fate_t far = FateOf("alpha", "*", "out_of_range");
  far.count = 30;
  EXPECT_EQ(book.Add(ViewAt(far, 0)).link, -1);
  book.Add(ViewAt(FateOf("alpha", "", "invalid"), 0));
  book.Add(ViewAt(FateOf("", "alpha", "delivered"), 0));
  EXPECT_EQ(book.num_fates(), 32);
  EXPECT_EQ(book.num_elsewhere(), 32);
  EXPECT_TRUE(book.links().empty());
}

TEST(LinkBook, AddsUnregisteredVehiclesUntilThereAreTooMany) {
  LinkBook book({"alpha"});
  for (int i = 0; i < 500; ++i) {
    book.Add(ViewAt(FateOf("alpha", "visitor" + std::to_string(i), "delivered"), 0));
  }
  EXPECT_EQ(book.names().size(), 1 + LinkBook::kMaxUnregistered);
  EXPECT_EQ(book.links().size(), LinkBook::kMaxUnregistered);
  EXPECT_EQ(book.num_elsewhere(), 300);
  ASSERT_NE(book.Find(0, 200), nullptr);
  EXPECT_EQ(book.names().at(200), "visitor199");
}

TEST(LinkBook, KeepsABoundedNumberOfLinks) {
  LinkBook book;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      book.Add(ViewAt(FateOf("v" + std::to_string(i), "v" + std::to_string(j), "dropped"), 0));
    }
  }
  EXPECT_EQ(book.links().size(), LinkBook::kMaxLinks);
  EXPECT_EQ(book.num_fates(), 40'000);
  EXPECT_EQ(book.num_elsewhere(), 20'000);
}

TEST(LinkBook, StopsCountersAtTheirEnd) {
  LinkBook book({"a", "b"});
  fate_t fate = FateOf("a", "b", "delivered");
  fate.count = std::numeric_limits<int32_t>::max();
  for (int i = 0; i < 3; ++i) book.Add(ViewAt(fate, 0));
  EXPECT_EQ(book.Find(0, 1)->Received(), std::numeric_limits<uint32_t>::max());
}

TEST(LinkBook, IsCopiedByValue) {
  LinkBook book({"a", "b"});
  book.Add(ViewAt(FateOf("a", "b", "delivered"), 0));
  const LinkBook copy = book;
  book.Add(ViewAt(FateOf("a", "b", "delivered"), 0));
  book.Add(ViewAt(FateOf("a", "newcomer", "delivered"), 0));
  EXPECT_EQ(copy.Find(0, 1)->Received(), 1U);
  EXPECT_EQ(copy.names().size(), 2U);
  EXPECT_EQ(book.Find(0, 1)->Received(), 2U);
  EXPECT_NE(book.Find(0, 2), nullptr);
}

RC_GTEST_PROP(LinkBook, KeepsEveryFate, ()) {
  LinkBook book({"alpha", "bravo", "charlie"});
  std::map<std::pair<std::string, std::string>, uint64_t> offered;
  int64_t total = 0;
  const int num_fates = *rc::gen::inRange(0, 200);
  for (int i = 0; i < num_fates; ++i) {
    const auto source = *rc::gen::element<std::string>("alpha", "bravo", "charlie", "delta");
    const auto destination = *rc::gen::element<std::string>("alpha", "delta", "*", "", "all");
    fate_t fate = FateOf(source, destination,
                         CauseText(static_cast<Cause>(*rc::gen::inRange(0, kNumCauses))));
    fate.count = *rc::gen::inRange(0, 20);
    book.Add(ViewAt(fate, i));
    total += fate.count;
    offered[{source, destination}] += static_cast<uint64_t>(fate.count);
  }
  uint64_t of_links = 0;
  for (const LinkCounts& link : book.links()) {
    uint64_t of_causes = 0;
    for (const uint32_t count : link.by_cause) of_causes += count;
    RC_ASSERT(of_causes == link.Offered());
    RC_ASSERT(link.Offered() == (offered[{book.names().at(link.from), book.names().at(link.to)}]));
    RC_ASSERT(&link == book.Find(link.from, link.to));
    of_links += link.Offered();
  }
  RC_ASSERT(book.num_fates() == total);
  RC_ASSERT(static_cast<int64_t>(of_links) + book.num_elsewhere() == total);
}

}  // namespace shoal::link_book_test

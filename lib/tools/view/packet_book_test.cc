#include "lib/tools/view/packet_book.h"

#include <gtest/gtest.h>

#include "lib/tools/view/view_testing.h"

namespace shoal::packet_book_test {

void AddFate(PacketBook* book, const fate_t& fate, int64_t utime) {
  FateView view;
  ASSERT_TRUE(ViewOf(fate, utime, &view));
  book->Add(view, std::pair(1.0, -3.0));
}

fate_t PacketFate(std::string_view destination, int64_t number, double travel_s,
                  std::string_view cause = "delivered") {
  acoustic_path_t path = CalmPath(12 * kSecond_us);
  path.travel_s = travel_s;
  fate_t fate = Through(FateOf("alpha", destination, cause), path);
  fate.kind = "packet";
  fate.number = number;
  return fate;
}

TEST(PacketBook, GroupsTheReceiversOfATransmission) {
  PacketBook book;
  AddFate(&book, PacketFate("bravo", 7, 0.05), 13 * kSecond_us);
  AddFate(&book, PacketFate("bravo", 8, 0.05), 13 * kSecond_us);
  AddFate(&book, PacketFate("charlie", 7, 1.5, "collision"), 14 * kSecond_us);
  const auto packets = book.Since(0, 14 * kSecond_us);
  ASSERT_EQ(packets.size(), 2U);
  const AcousticPacket& packet = *packets[0];
  EXPECT_EQ(packet.source, "alpha");
  EXPECT_EQ(packet.number, 7);
  EXPECT_EQ(packet.sent_utime, 12 * kSecond_us);
  EXPECT_NEAR(packet.air_s, 0.4, 1e-6);
  ASSERT_EQ(packet.to.size(), 2U);
  EXPECT_EQ(packet.to[0].name, "bravo");
  EXPECT_NEAR(static_cast<double>(packet.to[0].utime), 12.45e6, 1);
  EXPECT_EQ(packet.to[1].cause, Cause::kCollision);
  EXPECT_NEAR(static_cast<double>(packet.to[1].utime), 13.9e6, 1);
  EXPECT_EQ(packet.from_m, std::pair(1.0, -3.0));
}

TEST(PacketBook, ReturnsAPacketAgainWhenItArrivesElsewhere) {
  PacketBook book;
  AddFate(&book, PacketFate("bravo", 7, 0.05), 13 * kSecond_us);
  const int64_t order = book.last_order();
  EXPECT_TRUE(book.Since(order, 13 * kSecond_us).empty());
  AddFate(&book, PacketFate("charlie", 7, 1.5), 14 * kSecond_us);
  ASSERT_EQ(book.Since(order, 14 * kSecond_us).size(), 1U);
  EXPECT_EQ(book.Since(order, 14 * kSecond_us)[0]->to.size(), 2U);
}

TEST(PacketBook, ForgetsAfterAWhile) {
  PacketBook book;
  AddFate(&book, PacketFate("bravo", 7, 0.05), 0);
  EXPECT_EQ(book.Since(0, PacketBook::kMemory_us).size(), 1U);
  EXPECT_TRUE(book.Since(0, PacketBook::kMemory_us + 1).empty());
}

TEST(PacketBook, IgnoresFatesWithoutAnAcousticPath) {
  PacketBook book;
  AddFate(&book, FateOf("alpha", "bravo", "delivered"), 0);
  EXPECT_TRUE(book.Since(0, 0).empty());
}

TEST(PacketBook, IsBounded) {
  PacketBook book;
  for (int i = 0; i < 1000; ++i) AddFate(&book, PacketFate("bravo", 7, 0.05), 0);
  EXPECT_EQ(book.Since(0, 0)[0]->to.size(), PacketBook::kMaxArrivals);
  for (int i = 0; i < 2000; ++i) AddFate(&book, PacketFate("bravo", i, 0.05), 0);
  EXPECT_EQ(book.Since(0, 0).size(), PacketBook::kMaxPackets);
}

}  // namespace shoal::packet_book_test

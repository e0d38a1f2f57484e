#include "lib/run/hosts/link_outbox.h"

#include <gtest/gtest.h>

#include <vector>

namespace shoal::link_outbox_test {

/// A peer that takes some messages and no more.
struct Peer {
  size_t room = 0;
  bool is_gone = false;
  std::vector<Bytes> taken = {};

  LinkOutbox::SendNow Taking() {
    return [this](std::span<const uint8_t> bytes) {
      if (is_gone) return LinkOutbox::Sent::kGone;
      if (room == 0) return LinkOutbox::Sent::kLater;
      --room;
      taken.emplace_back(bytes.begin(), bytes.end());
      return LinkOutbox::Sent::kYes;
    };
  }
};

TEST(LinkOutbox, KeepsTheOrderOfWhatWaits) {
  Peer peer{.room = 1};
  LinkOutbox outbox;
  for (uint8_t i = 0; i < 3; ++i) EXPECT_TRUE(outbox.Send(Bytes{i}, peer.Taking()));
  EXPECT_EQ(outbox.waiting_bytes(), 2U);
  peer.room = 1;
  EXPECT_TRUE(outbox.Send(Bytes{3}, peer.Taking())) << "not before those that wait";
  EXPECT_EQ(peer.taken.size(), 1U);
  outbox.SendWaiting(peer.Taking());
  EXPECT_EQ(outbox.waiting_bytes(), 2U);
  peer.room = 9;
  outbox.SendWaiting(peer.Taking());
  EXPECT_EQ(peer.taken, (std::vector<Bytes>{{0}, {1}, {2}, {3}}));
  EXPECT_TRUE(outbox.IsIdle());
}

TEST(LinkOutbox, IsStuckOnceTooMuchWaitsAndKeepsNothingThen) {
  Peer peer;
  LinkOutbox outbox;
  EXPECT_TRUE(outbox.Send(Bytes(LinkOutbox::kMaxWaiting_bytes), peer.Taking()));
  EXPECT_FALSE(outbox.is_stuck());
  EXPECT_FALSE(outbox.Send(Bytes(1), peer.Taking()));
  EXPECT_TRUE(outbox.is_stuck());
  EXPECT_EQ(outbox.waiting_bytes(), 0U);
  peer.room = 9;
  EXPECT_FALSE(outbox.Send(Bytes(1), peer.Taking())) << "a message is missing already";
  EXPECT_TRUE(peer.taken.empty());
}

TEST(LinkOutbox, KeepsNothingForAPeerThatIsGone) {
  Peer peer{.is_gone = true};
  LinkOutbox outbox;
  EXPECT_FALSE(outbox.Send(Bytes{1}, peer.Taking()));
  peer.is_gone = false;
  EXPECT_TRUE(outbox.Send(Bytes{1}, peer.Taking()));
  peer.is_gone = true;
  outbox.SendWaiting(peer.Taking());
  EXPECT_TRUE(outbox.IsIdle());
}

TEST(LinkTurn, IsOverAfterSomeMessagesOrBytesOrTime) {
  LinkTurn few(100);
  for (size_t i = 0; i < LinkTurn::kMaxMessages; ++i) {
    EXPECT_FALSE(few.IsOver(100));
    few.Count(0);
  }
  EXPECT_TRUE(few.IsOver(100));
  LinkTurn large(100);
  large.Count(LinkTurn::kMaxBytes - 1);
  EXPECT_FALSE(large.IsOver(100));
  large.Count(1);
  EXPECT_TRUE(large.IsOver(100));
  const LinkTurn slow(100);
  EXPECT_FALSE(slow.IsOver(99 + LinkTurn::kLongest_us));
  EXPECT_TRUE(slow.IsOver(100 + LinkTurn::kLongest_us));
}

}  // namespace shoal::link_outbox_test

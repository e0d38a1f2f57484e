#include "apps/shoal_play/receiver_queues.h"

#include <gtest/gtest.h>

#include <sstream>

namespace shoal::receiver_queues_test {

TEST(ReceiverQueues, AreThoseOfOthersAtThePorts) {
  // Ports 7667 (1DF3) and 7668 (1DF4).
  std::istringstream table(
      "   sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout "
      "inode ref pointer drops\n"
      " 1: 00000000:1DF3 00000000:0000 07 00000000:00000A00 00:00000000 00000000 0 0 11 2 ffff 0\n"
      " 2: 00000000:1DF3 00000000:0000 07 00000000:00000000 00:00000000 00000000 0 0 12 2 ffff 5\n"
      " 3: 00000000:1DF4 00000000:0000 07 00000000:00000B00 00:00000000 00000000 0 0 13 2 ffff 0\n"
      " 4: 00000000:1DF3 00000000:0000 07 00000000:00000C00 00:00000000 00000000 0 0 14 2 ffff 0\n"
      " torn line\n");
  const std::vector<ReceiverQueue> queues = ParseQueues(table, {7667}, {"14"});
  ASSERT_EQ(queues.size(), 2U);
  EXPECT_EQ(queues[0].inode, "11");
  EXPECT_EQ(queues[0].waiting_bytes, 0xa00);
  EXPECT_EQ(queues[1].inode, "12");
}

/// The table of sockets at port 7667 with these inodes.
std::string TableOf(const std::vector<std::string>& inodes) {
  std::string table = "sl local_address ...\n";
  for (const std::string& inode : inodes) {
    table += "1: 0:1DF3 0:0 07 0:A00 0:0 0 0 0 " + inode + " 2 ffff 0\n";
  }
  return table;
}

TEST(ForeignQueues, ListTheOwnSocketsAgainOnlyForOnesThatAreNotKnown) {
  int num_lists = 0;
  ForeignQueues queues({7667}, [&] {
    ++num_lists;
    return num_lists == 1 ? ForeignQueues::Inodes{"1"} : ForeignQueues::Inodes{"1", "4"};
  });
  const auto inodes_in = [&](const std::vector<std::string>& all) {
    std::istringstream table(TableOf(all));
    std::string inodes;
    for (const ReceiverQueue& queue : queues.In(table)) inodes += queue.inode + " ";
    return inodes;
  };
  EXPECT_EQ(inodes_in({"1", "2"}), "2 ");
  EXPECT_EQ(inodes_in({"1", "2"}), "2 ");
  EXPECT_EQ(inodes_in({"1"}), "");
  EXPECT_EQ(num_lists, 1);
  EXPECT_EQ(inodes_in({"1", "2", "3", "4"}), "2 3 ");
  EXPECT_EQ(inodes_in({"1", "2", "3", "4"}), "2 3 ");
  EXPECT_EQ(num_lists, 2);
}

/// Counts datagrams.
class CountingTransport : public Transport {
 public:
  void Send(int, std::string_view, std::span<const uint8_t>) override { ++num_sent; }
  void Listen(int, const std::string&) override {}
  void ListenToAll(int) override {}

  int num_sent = 0;
};

class PacedTransportTest : public ::testing::Test {
 protected:
  void Send(PacedTransport* transport, int count) {
    for (int i = 0; i < count; ++i) transport->Send(7667, "A", std::vector<uint8_t>(100));
  }

  CountingTransport inner_;
  std::vector<ReceiverQueue> queues_ = {{.inode = "1"}};
};

TEST_F(PacedTransportTest, WaitsWhileAReceiverIsBehindAndNoLonger) {
  int num_pauses = 0;
  PacedTransport transport(
      &inner_, [this] { return queues_; },
      [&](int64_t) {
        ++num_pauses;
        queues_[0].waiting_bytes -= 50'000;  // It reads.
      });
  Send(&transport, 1000);
  EXPECT_EQ(num_pauses, 0);
  queues_[0].waiting_bytes = PacedTransport::kMaxWaiting_bytes + 120'000;
  Send(&transport, PacedTransport::kDatagramsBetweenLooks);
  EXPECT_EQ(num_pauses, 3);
  EXPECT_EQ(inner_.num_sent, 1000 + PacedTransport::kDatagramsBetweenLooks);
}

TEST_F(PacedTransportTest, LooksAfterLargeDatagramsToo) {
  int num_looks = 0;
  PacedTransport transport(
      &inner_,
      [&] {
        ++num_looks;
        return queues_;
      },
      [](int64_t) {});
  const int before = num_looks;
  transport.Send(7667, "A", std::vector<uint8_t>(60'000));
  EXPECT_EQ(num_looks, before + 1);
}

TEST_F(PacedTransportTest, DoesNotWaitForOneThatReadsNothingUntilItReadsAgain) {
  int64_t paused_us = 0;
  PacedTransport transport(
      &inner_, [this] { return queues_; }, [&](int64_t us) { paused_us += us; });
  queues_[0].waiting_bytes = 200'000;
  Send(&transport, 64);
  EXPECT_EQ(paused_us, PacedTransport::kPatience_us);
  Send(&transport, 1000);
  EXPECT_EQ(paused_us, PacedTransport::kPatience_us);
  EXPECT_EQ(transport.num_given_up(), 1);
  queues_[0].waiting_bytes = 100'000;
  Send(&transport, 32);
  EXPECT_EQ(paused_us, 2 * PacedTransport::kPatience_us);
  EXPECT_EQ(transport.num_given_up(), 1) << "the same again";
}

}  // namespace shoal::receiver_queues_test

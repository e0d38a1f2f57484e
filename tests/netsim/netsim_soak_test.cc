// Two hundred clients that behave as badly as they can, and one that does not.
#include <gtest/gtest.h>

#include "lib/mission/netsim/netsim_answer.h"
#include "lib/mission/netsim/netsim_testing.h"
#include "tests/netsim/rude_clients.h"
#include "tests/netsim/served_clients.h"

namespace shoal::netsim_soak_test {

constexpr size_t kNumRude = 200;
constexpr size_t kMaxLine_bytes = 4096;
constexpr size_t kMaxUnsent_bytes = 32 * 1024;
/// A line's buffer grows by doubling; a chunk of 16 KiB may hold answers beyond the limit.
constexpr size_t kMaxMemory_bytes = (kNumRude + 1) * (2 * kMaxLine_bytes + 2 * kMaxUnsent_bytes);

/// Without navs: each is accepted.
std::string RequestWithId(uint8_t id) { return LineOf({8, id}) + "\n"; }
std::string ResponseToId(uint8_t id) {
  return LineOf({8, id, 16, 1}, "netsim.protobuf.NetSimManagerResponse") + "\n";
}

TEST(NetsimSoak, OneClientIsAnsweredWhateverTwoHundredOthersDo) {
  const NetsimOptions options = TwoNetsimVehicles();
  NetsimCounts counts;
  size_t num_positions = 0;
  const auto server =
      ListenOrFail({.max_connections = kNumRude + 1, .max_unsent_bytes = kMaxUnsent_bytes},
                   kMaxLine_bytes, [&](const auto& address, auto line) {
                     const NetsimReply reply = AnswerLine(line, address, options);
                     counts.Add(reply.outcome);
                     num_positions += reply.positions.size();
                     return reply.answer;
                   });
  ASSERT_NE(server, nullptr);
  TcpClient polite(server->port());
  std::string expected;
  size_t most_memory_bytes = 0;
  {
    RudeClients rude(server->port(), kNumRude, /*seed=*/7, RequestWithId(1));
    for (int round = 0; round < 500; ++round) {
      for (int i = 0; i < 20; ++i) rude.Act();
      const auto id = static_cast<uint8_t>(round % 100);
      expected += ResponseToId(id);
      polite.Send(RequestWithId(id));
      ASSERT_TRUE(ReceiveBytes(server.get(), round * 1000, &polite, expected.size()));
      most_memory_bytes = std::max(most_memory_bytes, server->num_waiting_bytes());
    }
  }
  EXPECT_EQ(ReceiveAll(server.get(), 1'000'000, &polite), expected);
  EXPECT_TRUE(ServeUntil(server.get(), 1'000'000, [&] { return server->num_clients() == 0; }));
  EXPECT_EQ(server->num_waiting_bytes(), 0U);

  EXPECT_LT(most_memory_bytes, kMaxMemory_bytes);
  EXPECT_GT(counts.Of(NetsimOutcome::kAccepted), 10'000);
  EXPECT_GT(counts.Of(NetsimOutcome::kNoMessage), 100);
  EXPECT_GT(server->counts().broken, 100);
  EXPECT_EQ(num_positions, 0U);
}

}  // namespace shoal::netsim_soak_test

#include "lib/bus/seal.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/bus/bus.h"
#include "shoal/nav_t.hpp"

namespace shoal::seal_test {

TEST(Seal, ComesBackAsItWasPut) {
  std::vector<uint8_t> bytes = {1, 2, 3};
  AppendSeal({.publisher = "helm_alpha", .mission_id = -5, .step = 1LL << 40, .sequence = 7},
             &bytes);
  const Unsealed unsealed = Unseal(bytes);
  ASSERT_TRUE(unsealed.seal.has_value());
  EXPECT_EQ(unsealed.seal->publisher, "helm_alpha");
  EXPECT_EQ(unsealed.seal->mission_id, -5);
  EXPECT_EQ(unsealed.seal->step, 1LL << 40);
  EXPECT_EQ(unsealed.seal->sequence, 7U);
  EXPECT_EQ(std::vector<uint8_t>(unsealed.message.begin(), unsealed.message.end()),
            (std::vector<uint8_t>{1, 2, 3}));
}

TEST(Seal, HasTheBytesThatTheProtocolPageStates) {
  std::vector<uint8_t> bytes = {0xaa};
  AppendSeal(
      {.publisher = "ab", .mission_id = 0x0102030405060708, .step = 9, .sequence = 0x0a0b0c0d},
      &bytes);
  EXPECT_EQ(bytes, (std::vector<uint8_t>{0xaa, 'a',  'b',  2,    1,   2,   3,   4,  5, 6,
                                         7,    8,    0,    0,    0,   0,   0,   0,  0, 9,
                                         0x0a, 0x0b, 0x0c, 0x0d, 'S', 'H', 'O', 'L'}));
}

TEST(Seal, DoesNotKeepLcmFromDecodingTheMessage) {
  nav_t nav{};
  nav.x_m = 12.5;
  Bytes bytes;
  EncodeInto(nav, &bytes);
  AppendSeal({.publisher = "vehicle_sim_alpha", .mission_id = 1, .step = 2, .sequence = 3}, &bytes);
  nav_t decoded{};
  EXPECT_GT(decoded.decode(bytes.data(), 0, static_cast<int>(bytes.size())), 0);
  EXPECT_EQ(decoded.x_m, 12.5);
}

RC_GTEST_PROP(Seal, IsNeverFoundWhereThereIsNone, (std::vector<uint8_t> bytes)) {
  const Unsealed unsealed = Unseal(bytes);
  RC_ASSERT(unsealed.message.size() <= bytes.size());
  if (!unsealed.seal) RC_ASSERT(unsealed.message.size() == bytes.size());
}

RC_GTEST_PROP(Seal, SurvivesTruncationWithoutHarm, (std::vector<uint8_t> message)) {
  AppendSeal({.publisher = "x", .mission_id = 1, .step = 2, .sequence = 3}, &message);
  for (size_t size = 0; size < message.size(); ++size) {
    const Unsealed unsealed = Unseal(std::span(message).first(size));
    RC_ASSERT(unsealed.message.size() <= size);
  }
}

}  // namespace shoal::seal_test

#include "lib/base/codec/crc32.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string_view>
#include <vector>

namespace shoal::crc32_test {

uint32_t Crc32Of(std::string_view text) {
  return Crc32(std::vector<uint8_t>(text.begin(), text.end()));
}

// The check value is that of the catalogue of parametrised CRC algorithms (CRC-32/ISO-HDLC); the
// others are zlib's.
TEST(Crc32, HasTheValuesOfTheStandard) {
  EXPECT_EQ(Crc32Of("123456789"), 0xCBF43926U);
  EXPECT_EQ(Crc32Of(""), 0U);
  EXPECT_EQ(Crc32Of("a"), 0xE8B7BE43U);
  EXPECT_EQ(Crc32Of(std::string_view("\0\0\0\0", 4)), 0x2144DF1CU);
  EXPECT_EQ(Crc32Of("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
}

RC_GTEST_PROP(Crc32, FindsUpToThreeWrongBits, (std::vector<uint8_t> bytes)) {
  bytes.push_back(0);
  const uint32_t right = Crc32(bytes);
  const int num_bits = static_cast<int>(8 * bytes.size());
  std::vector<uint8_t> damaged = bytes;
  const int num_wrong = *rc::gen::inRange(1, 4);
  for (int i = 0; i < num_wrong; ++i) {
    const int bit = *rc::gen::inRange(0, num_bits);
    damaged[static_cast<size_t>(bit / 8)] ^= static_cast<uint8_t>(1 << (bit % 8));
  }
  RC_ASSERT((Crc32(damaged) == right) == (damaged == bytes));
}

}  // namespace shoal::crc32_test

#include "lib/base/codec/little_endian.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::little_endian_test {

TEST(LittleEndian, WritesTheLeastSignificantByteFirst) {
  std::vector<uint8_t> bytes;
  AppendLittleEndian<uint32_t>(0x01020304, &bytes);
  AppendLittleEndian<float>(1.0F, &bytes);  // 0x3F800000
  AppendLittleEndian<uint8_t>(9, &bytes);
  EXPECT_EQ(bytes, (std::vector<uint8_t>{4, 3, 2, 1, 0, 0, 0x80, 0x3F, 9}));
}

RC_GTEST_PROP(LittleEndian, ReadsWhatItHasWritten, (uint32_t word, uint64_t id, int16_t count)) {
  std::vector<uint8_t> bytes;
  AppendLittleEndian(word, &bytes);
  AppendLittleEndian(id, &bytes);
  AppendLittleEndian(count, &bytes);
  LittleEndianReader reader(bytes);
  RC_ASSERT(reader.Take<uint32_t>() == word);
  RC_ASSERT(reader.Take<uint64_t>() == id);
  RC_ASSERT(reader.Take<int16_t>() == count);
  RC_ASSERT(reader.num_left() == 0U);
}

}  // namespace shoal::little_endian_test

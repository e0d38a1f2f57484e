#include "lib/base/check/enum_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace shoal::enum_table_test {

enum class Jitter : uint8_t { kUniform, kOff };
enum Plain { kNorth, kEast, kSouth };
enum class Empty {};

TEST(EnumTable, CountsEnumerators) {
  EXPECT_EQ(kNumEnumerators<Jitter>, 2U);
  EXPECT_EQ(kNumEnumerators<Plain>, 3U);
  EXPECT_EQ(kNumEnumerators<Empty>, 0U);
  EXPECT_EQ(kEnumerators<Plain>, (std::array{kNorth, kEast, kSouth}));
}

TEST(EnumTable, FindsAValueByItsEnumeratorAndTheOtherWayRound) {
  constexpr EnumTable<Jitter, std::string_view> kTexts = {"uniform", "off"};
  EXPECT_EQ(kTexts[Jitter::kOff], "off");
  EXPECT_EQ(kTexts.Find("uniform"), Jitter::kUniform);
  EXPECT_EQ(kTexts.Find("on"), std::nullopt);
}

}  // namespace shoal::enum_table_test

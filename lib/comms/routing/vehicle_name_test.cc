#include "lib/comms/routing/vehicle_name.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::vehicle_name_test {

TEST(VehicleName, MayHaveLettersDigitsAndUnderscores) {
  EXPECT_TRUE(IsLegalVehicleName("a"));
  EXPECT_TRUE(IsLegalVehicleName("Auv_07"));
  EXPECT_TRUE(IsLegalVehicleName(std::string(32, 'x')));
}

TEST(VehicleName, MayNotHaveAnythingElse) {
  EXPECT_FALSE(IsLegalVehicleName(""));
  EXPECT_FALSE(IsLegalVehicleName(std::string(33, 'x')));
  EXPECT_FALSE(IsLegalVehicleName("a b"));
  EXPECT_FALSE(IsLegalVehicleName("a-b"));
  EXPECT_FALSE(IsLegalVehicleName("a:b"));
  EXPECT_FALSE(IsLegalVehicleName("f\xc3\xbcnf"));
  EXPECT_FALSE(IsLegalVehicleName(std::string("a\0", 2)));
}

TEST(VehicleName, MayNotBeAReservedWordInAnyCase) {
  EXPECT_FALSE(IsLegalVehicleName("local"));
  EXPECT_FALSE(IsLegalVehicleName("Unc"));
  EXPECT_FALSE(IsLegalVehicleName("ALL"));
  EXPECT_TRUE(IsLegalVehicleName("all1"));
}

TEST(VehicleKey, IsOneForAllSpellings) { EXPECT_EQ(VehicleKey("Alpha_B"), VehicleKey("aLPHA_b")); }

}  // namespace shoal::vehicle_name_test

#include "lib/vehicle/vehicle/contact.h"

#include <gtest/gtest.h>

#include <limits>

namespace shoal::contact_test {

const Eigen::Vector3d kHere_m(20000, -20000, 30);

TEST(Contact, IsCloserThanTheMeanOfTheLengthsInAnyDirection) {
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0, 0, 1),
        Eigen::Vector3d(0.6, 0, -0.8)}) {
    EXPECT_TRUE(InContact(kHere_m, 1.6, kHere_m + 1.5999 * direction, 1.6));
    EXPECT_FALSE(InContact(kHere_m, 1.6, kHere_m + 1.6001 * direction, 1.6));
    EXPECT_TRUE(InContact(kHere_m, 1.6, kHere_m + 2.7999 * direction, 4));
    EXPECT_FALSE(InContact(kHere_m + 2.8001 * direction, 4, kHere_m, 1.6));
  }
}

TEST(Contact, IsThereForVehiclesThatCoincideAndNotForThoseWithoutLength) {
  EXPECT_TRUE(InContact(kHere_m, 1.6, kHere_m, 1.6));
  EXPECT_FALSE(InContact(kHere_m, 0, kHere_m, 0));
}

TEST(Contact, IsNotMadeByPositionsThatAreNoNumbers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double strange : {std::nan(""), kInfinity, -kInfinity, 1e308, -1e308}) {
    const Eigen::Vector3d there_m(strange, strange, strange);
    EXPECT_FALSE(InContact(there_m, 1.6, kHere_m, 1.6)) << strange;
    EXPECT_FALSE(InContact(there_m, 1.6, -there_m, 1.6)) << strange;
  }
}

}  // namespace shoal::contact_test

#include "lib/vehicle/guidance/route_rounds.h"

#include <gtest/gtest.h>

namespace shoal::route_rounds_test {

TEST(RouteRounds, PassesThePointsInOrderAndStaysAtTheLastOfItsRounds) {
  RouteRounds rounds(3);
  for (const size_t next : {1U, 2U, 0U, 1U, 2U}) {
    EXPECT_FALSE(rounds.IsEnd(2));
    EXPECT_TRUE(rounds.Pass(2));
    EXPECT_EQ(rounds.index(), next);
  }
  EXPECT_EQ(rounds.num_rounds(), 1);
  EXPECT_TRUE(rounds.IsEnd(2));
  EXPECT_FALSE(rounds.Pass(2));
  EXPECT_EQ(rounds.index(), 2U);
  EXPECT_EQ(rounds.num_rounds(), 2);
  EXPECT_EQ(rounds.num_reached(), 6);
}

TEST(RouteRounds, NeverEndWithoutANumberOfRounds) {
  RouteRounds rounds(2);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(rounds.Pass());
  EXPECT_EQ(rounds.num_rounds(), 50);
  EXPECT_FALSE(rounds.IsEnd(0));
}

TEST(RouteRounds, EndAtTheEndOfTheListWhereverTheyBegin) {
  RouteRounds rounds(4, 2);
  EXPECT_TRUE(rounds.Pass(1));
  EXPECT_TRUE(rounds.IsLast());
  EXPECT_FALSE(rounds.Pass(1));
  EXPECT_EQ(rounds.num_reached(), 2);
}

TEST(RouteRounds, EndAtTheNextLastPointWhereTheirNumberWasLowered) {
  RouteRounds rounds(1);
  EXPECT_TRUE(rounds.Pass(5));
  EXPECT_TRUE(rounds.Pass(5));
  EXPECT_FALSE(rounds.Pass(1));
}

TEST(RouteRounds, GoToAnotherPointAndKeepTheirCount) {
  RouteRounds rounds(3);
  EXPECT_TRUE(rounds.Pass());
  rounds.GoTo(0);
  EXPECT_EQ(rounds.index(), 0U);
  EXPECT_EQ(rounds.num_reached(), 1);
}

}  // namespace shoal::route_rounds_test

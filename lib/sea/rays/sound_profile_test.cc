#include "lib/sea/rays/sound_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/sea/rays/rays_testing.h"

namespace shoal::sound_profile_test {

TEST(SoundProfile, IsLinearBetweenItsPointsAndConstantBeyond) {
  const SoundProfile profile = ProfileOf({{10, 1500}, {30, 1480}, {50, 1490}});
  EXPECT_EQ(profile.SpeedAt(0), 1500);
  EXPECT_EQ(profile.SpeedAt(10), 1500);
  EXPECT_EQ(profile.SpeedAt(20), 1490);
  EXPECT_EQ(profile.SpeedAt(30), 1480);
  EXPECT_EQ(profile.SpeedAt(45), 1487.5);
  EXPECT_EQ(profile.SpeedAt(1000), 1490);
  EXPECT_FALSE(profile.is_constant());
  EXPECT_TRUE(SoundProfile(1490).is_constant());
}

TEST(SoundProfile, RefusesWhatIsNoProfileAndNamesThePoint) {
  const auto error = [](std::vector<SpeedPoint> points) {
    const Result<SoundProfile> profile = SoundProfile::Make(std::move(points));
    return profile.ok() ? "" : profile.error();
  };
  EXPECT_EQ(error({}), "a sound speed profile needs at least one point");
  EXPECT_EQ(error({{0, 1500}, {0, 1500}}),
            "point 2 (depth 0 m, speed 1500 m/s): depths must grow from point to point");
  EXPECT_EQ(error({{-1, 1500}}),
            "point 1 (depth -1 m, speed 1500 m/s): the depth must be between 0 and 12000 m");
  EXPECT_EQ(error({{0, 340}}),
            "point 1 (depth 0 m, speed 340 m/s): the speed must be between 1000 and 2000 m/s");
  EXPECT_NE(error({{0, std::nan("")}}), "");
  EXPECT_NE(error(std::vector<SpeedPoint>(kMaxProfilePoints + 1)), "");
}

TEST(SoundProfile, HasTheHarmonicMeanOfItsColumn) {
  const SoundProfile profile = ProfileOf({{0, 1500}, {100, 1450}, {200, 1450}});
  // 100 m at 1450 to 1500: ln(1500 / 1450) / 0.5 s.
  const double upper_s = std::log(1500.0 / 1450) / 0.5;
  EXPECT_NEAR(profile.MeanSpeed(0, 100), 100 / upper_s, 1e-9);
  EXPECT_NEAR(profile.MeanSpeed(200, 0), 200 / (upper_s + 100 / 1450.0), 1e-9);
  EXPECT_NEAR(profile.MeanSpeed(40, 40), 1480, 1e-9);
  EXPECT_NEAR(profile.MeanSpeed(120, 300), 1450, 1e-9);
}

TEST(MunksProfile, HasItsAxisAndItsKnownValues) {
  const Result<SoundProfile> munk = MunkProfile({}, 5000, 50);
  ASSERT_TRUE(munk.ok());
  EXPECT_NEAR(munk->SpeedAt(1300), 1500, 1e-9);
  EXPECT_NEAR(munk->SpeedAt(0), 1548.52, 0.005);
  EXPECT_NEAR(munk->SpeedAt(5000), 1551.91, 0.005);
  EXPECT_EQ(munk->points().size(), 101U);
  EXPECT_FALSE(MunkProfile({}, 5000, 0).ok());
  EXPECT_FALSE(MunkProfile({}, 5000, 0.1).ok());
  EXPECT_FALSE(MunkProfile({.scale_m = 0}, 5000, 50).ok());
}

TEST(ProfileOfACast, IsMackenziesAtEachPoint) {
  const std::vector<CastPoint> cast = {{0, 20, 35}, {1000, 25, 35}};
  const Result<SoundProfile> profile = ProfileOfCast(cast);
  ASSERT_TRUE(profile.ok());
  EXPECT_NEAR(profile->SpeedAt(1000), 1550.744, 0.0005);
  const Result<SoundProfile> fresh = ProfileOfCast(std::vector<CastPoint>{{0, 10, 5}});
  ASSERT_FALSE(fresh.ok());
  EXPECT_NE(fresh.error().find("point 1 (depth 0 m, 10 degC, 5 ppt) is outside Mackenzie's"),
            std::string::npos)
      << fresh.error();
}

}  // namespace shoal::sound_profile_test

// What is judged by the smallest and the largest that it ever was: track, distance, altitude.
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>

#include "lib/run/verdict/extreme_watch.h"
#include "lib/run/verdict/judge.h"

namespace shoal::extremes_test {

constexpr int64_t kStart = 5'000'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

int64_t At(double seconds) { return kStart + static_cast<int64_t>(seconds * 1e6); }

TEST(ExtremeWatch, HasSeenNothingAtFirst) {
  ExtremeWatch watch;
  EXPECT_FALSE(watch.has_seen());
  watch.Look(kNan, 1);
  EXPECT_FALSE(watch.has_seen());
}

TEST(ExtremeWatch, RemembersBothExtremesAndWhenTheyWereFirst) {
  ExtremeWatch watch;
  watch.Look(3, 1);
  watch.Look(5, 2);
  watch.Look(kNan, 3);
  watch.Look(2, 4);
  watch.Look(2, 5);
  watch.Look(5, 6);
  ASSERT_TRUE(watch.has_seen());
  EXPECT_EQ(watch.smallest().value, 2);
  EXPECT_EQ(watch.smallest().time_s, 4);
  EXPECT_EQ(watch.largest().value, 5);
  EXPECT_EQ(watch.largest().time_s, 2);
}

/// A judge of three vehicles, alpha, bravo and Charlie, with one expectation.
class ExtremesTest : public testing::Test {
 protected:
  Judge& For(const decltype(Expectation::what)& what) {
    mission_.start_utime = kStart;
    mission_.duration_s = 900;
    mission_.vehicles.resize(3);
    mission_.vehicles[0].name = "alpha";
    mission_.vehicles[1].name = "bravo";
    mission_.vehicles[2].name = "Charlie";
    mission_.expectations = {{.where = "m.toml:8", .what = what}};
    return judge_.emplace(mission_);
  }
  /// One step in which a helm reports its cross-track error.
  void Track(size_t vehicle, std::optional<double> cross_track_error_m, double time_s) {
    judge_->TakeHelm(vehicle,
                     {.state = "DRIVE", .task = "path", .cross_track_error_m = cross_track_error_m},
                     At(time_s));
    judge_->EndStep(At(time_s));
  }
  ExpectationVerdict Only() const { return judge_->Verdicts().at(0); }

  Mission mission_;
  std::optional<Judge> judge_;
};

TEST_F(ExtremesTest, PassesATrackThatIsKeptOnEitherSide) {
  For(TrackExpectation{.vehicle = "alpha", .max_m = 3});
  Track(0, 1, 10);
  Track(0, -3, 20);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at most 3 m off its track");
  EXPECT_EQ(Only().numbers, "most 3.00 m at 20.0 s");
}

TEST_F(ExtremesTest, FailsATrackThatWasLeftOnceAndShowsByHowMuch) {
  For(TrackExpectation{.vehicle = "alpha", .max_m = 3});
  Track(0, -3.5, 20);
  Track(0, 0, 30);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "most 3.50 m at 20.0 s, 0.5 m beyond");
}

TEST_F(ExtremesTest, JudgesATrackFromItsTimeOn) {
  For(TrackExpectation{.vehicle = "alpha", .max_m = 3, .from_s = 60});
  Track(0, 30, 59.9);
  Track(0, 1, 60);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at most 3 m off its track from 60 s on");
  EXPECT_EQ(Only().numbers, "most 1.00 m at 60.0 s");
  Track(0, 4, 61);
  EXPECT_FALSE(Only().passed);
}

TEST_F(ExtremesTest, DoesNotPassATrackThatWasNeverReported) {
  For(TrackExpectation{.vehicle = "alpha", .max_m = 3, .from_s = 60});
  EXPECT_EQ(Only().numbers, "no track was seen");
  Track(0, 0, 30);
  Track(0, std::nullopt, 70);
  Track(0, kNan, 80);
  Track(1, 0, 90);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "no track was seen");
}

TEST_F(ExtremesTest, WantsTheTrackOfEveryVehicle) {
  For(TrackExpectation{.vehicle = "all", .max_m = 3});
  Track(0, 1, 10);
  Track(1, 4, 20);
  Track(2, 2, 30);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().text, "every vehicle at most 3 m off its track");
  EXPECT_EQ(Only().numbers, "1 of 3 failed: bravo: most 4.00 m at 20.0 s, 1.0 m beyond");
}

TEST_F(ExtremesTest, NamesTheVehicleThatKeptItsTrackMostNarrowly) {
  For(TrackExpectation{.vehicle = "all", .max_m = 3});
  Track(0, 1, 10);
  Track(1, 2.5, 20);
  Track(2, 2, 30);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().numbers, "all 3; narrowest bravo: most 2.50 m at 20.0 s");
}

TEST_F(ExtremesTest, PassesADistanceWithinItsLimits) {
  Judge& judge =
      For(DistanceExpectation{.vehicle = "alpha", .to = "charlie", .min_m = 5, .max_m = 20});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(2, {0, 3, 4});
  judge.EndStep(At(10));
  judge.TakeNav(2, {0, 0, 20});
  judge.EndStep(At(20));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at least 5 m and at most 20 m from charlie");
  EXPECT_EQ(Only().numbers, "least 5.00 m at 10.0 s, most 20.00 m at 20.0 s");
}

TEST_F(ExtremesTest, FailsADistanceBeyondEitherLimit) {
  Judge& judge =
      For(DistanceExpectation{.vehicle = "alpha", .to = "charlie", .min_m = 6, .max_m = 18});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(2, {0, 3, 4});
  judge.EndStep(At(10));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "least 5.00 m at 10.0 s, 1.0 m beyond, most 5.00 m at 10.0 s");
  judge.TakeNav(2, {0, 0, 20});
  judge.EndStep(At(20));
  EXPECT_EQ(Only().numbers,
            "least 5.00 m at 10.0 s, 1.0 m beyond, most 20.00 m at 20.0 s, 2.0 m beyond");
}

TEST_F(ExtremesTest, JudgesADistanceFromItsTimeOnAndByOneLimitOnly) {
  Judge& judge =
      For(DistanceExpectation{.vehicle = "alpha", .to = "bravo", .max_m = 50, .from_s = 100});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {500, 0, 0});
  judge.EndStep(At(99.9));
  EXPECT_EQ(Only().numbers, "no distance was seen");
  judge.TakeNav(1, {50, 0, 0});
  judge.EndStep(At(100));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at most 50 m from bravo from 100 s on");
  EXPECT_EQ(Only().numbers, "most 50.00 m at 100.0 s");
}

TEST_F(ExtremesTest, DoesNotPutTheDistanceToAVehicleToItself) {
  Judge& judge = For(DistanceExpectation{.vehicle = "all", .to = "alpha", .min_m = 5});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {10, 0, 0});
  judge.TakeNav(2, {20, 0, 0});
  judge.EndStep(At(1));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "every vehicle at least 5 m from alpha");
  EXPECT_EQ(Only().numbers, "all 2; narrowest bravo: least 10.00 m at 1.0 s");
}

TEST_F(ExtremesTest, PutsTheDistanceToAllToEachPairButNotToOneself) {
  Judge& judge = For(DistanceExpectation{.vehicle = "all", .to = "all", .min_m = 5, .max_m = 25});
  judge.TakeNav(0, {0, 0, 0});
  judge.TakeNav(1, {10, 0, 0});
  judge.TakeNav(2, {20, 0, 0});
  judge.EndStep(At(1));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "every vehicle at least 5 m and at most 25 m from every vehicle");
  judge.TakeNav(1, {16, 0, 0});
  judge.EndStep(At(2));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers,
            "2 of 3 failed: bravo: least 4.00 m at 2.0 s, 1.0 m beyond, most 16.00 m at 2.0 s; "
            "Charlie: least 4.00 m at 2.0 s, 1.0 m beyond, most 20.00 m at 1.0 s");
}

TEST_F(ExtremesTest, DoesNotPassADistanceToAVehicleThatWasNeverSeen) {
  Judge& judge = For(DistanceExpectation{.vehicle = "alpha", .to = "bravo", .max_m = 50});
  judge.TakeNav(0, {0, 0, 0});
  judge.EndStep(At(1));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "no distance was seen");
}

TEST_F(ExtremesTest, PassesAnAltitudeJustKept) {
  Judge& judge = For(AltitudeExpectation{.vehicle = "alpha", .min_m = 5});
  judge.TakeNav(0, {0, 0, 40}, 12);
  judge.EndStep(At(1));
  judge.TakeNav(0, {0, 0, 47}, 5);
  judge.EndStep(At(2));
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at least 5 m above the sea floor");
  EXPECT_EQ(Only().numbers, "least 5.00 m at 2.0 s");
}

TEST_F(ExtremesTest, FailsAnAltitudeOnceTooLow) {
  Judge& judge = For(AltitudeExpectation{.vehicle = "all", .min_m = 5});
  for (size_t vehicle = 0; vehicle < 3; ++vehicle) judge.TakeNav(vehicle, {0, 0, 40}, 12);
  judge.EndStep(At(1));
  judge.TakeNav(1, {0, 0, 52}, 0);
  judge.EndStep(At(2));
  judge.TakeNav(1, {0, 0, 40}, 12);
  judge.EndStep(At(3));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "1 of 3 failed: bravo: least 0.00 m at 2.0 s, 5.0 m beyond");
}

TEST_F(ExtremesTest, DoesNotTakeAnUnknownAltitudeForALowOne) {
  Judge& judge = For(AltitudeExpectation{.vehicle = "alpha", .min_m = 5});
  judge.TakeNav(0, {0, 0, 40}, -1);
  judge.EndStep(At(1));
  judge.TakeNav(0, {0, 0, 40}, kNan);
  judge.EndStep(At(2));
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "no altitude was seen");
}

TEST_F(ExtremesTest, JudgesHowFarAVehicleIsFromWhereItBelievesToBe) {
  For(NavigationErrorExpectation{.vehicle = "alpha", .max_m = 5, .from_s = 60});
  const auto step = [&](double x_m, double time_s) {
    judge_->TakeNav(0, {3, 4, 20});
    judge_->TakeEstimate(0, {x_m, 4});
    judge_->EndStep(At(time_s));
  };
  judge_->TakeNav(0, {3, 4, 20});
  judge_->EndStep(At(60));
  EXPECT_EQ(Only().numbers, "no estimate was seen");
  step(50, 59.9);
  EXPECT_EQ(Only().numbers, "no estimate was seen");
  step(8, 61);
  EXPECT_TRUE(Only().passed);
  EXPECT_EQ(Only().text, "alpha at most 5 m from where it believes to be from 60 s on");
  EXPECT_EQ(Only().numbers, "most 5.00 m at 61.0 s");
  judge_->TakeEstimate(0, {kNan, 4});
  step(-2.5, 62);
  EXPECT_FALSE(Only().passed);
  EXPECT_EQ(Only().numbers, "most 5.50 m at 62.0 s, 0.5 m beyond");
}

}  // namespace shoal::extremes_test

#include "lib/sea/media/radio_link.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal::radio_link_test {

RadioLink LinkOver(const RadioOptions& options, double range_m, double depth_m = 0) {
  const RadioEnd near = {.position_m = {0, 0, depth_m}};
  const RadioEnd far = {.position_m = {range_m, 0, depth_m}};
  return DecideRadio(options, near, far);
}

TEST(SurfaceRule, LetsAnAntennaThroughJustAboveItsDepthAndAtIt) {
  const RadioOptions options = {.surface_depth_m = 0.5};
  EXPECT_EQ(LinkOver(options, 100, 0.499).fault, RadioFault::kNone);
  EXPECT_EQ(LinkOver(options, 100, 0.5).fault, RadioFault::kNone);
}

TEST(SurfaceRule, StopsWhatIsDeeperAtEitherEnd) {
  const RadioOptions options = {.surface_depth_m = 0.5};
  const RadioEnd above = {.position_m = {0, 0, 0}};
  const RadioEnd below = {.position_m = {10, 0, 0.501}};
  for (const RadioLink& link :
       {DecideRadio(options, above, below), DecideRadio(options, below, above)}) {
    EXPECT_EQ(link.fault, RadioFault::kSubmerged);
    EXPECT_EQ(link.depth_m, 0.501);
    EXPECT_EQ(link.depth_limit_m, 0.5);
    EXPECT_EQ(link.range_m, -1) << "the range was not asked for";
  }
}

TEST(RangeRule, LetsThroughJustInsideTheRangeOnly) {
  const RadioOptions options = {.range_m = 800};
  EXPECT_EQ(LinkOver(options, 799.999).fault, RadioFault::kNone);
  EXPECT_EQ(LinkOver(options, 800).fault, RadioFault::kOutOfRange);
  EXPECT_EQ(LinkOver(options, 800.001).fault, RadioFault::kOutOfRange);
  EXPECT_EQ(LinkOver(options, 800.001).limit_m, 800);
  EXPECT_EQ(LinkOver({.range_m = -1}, 1e6).fault, RadioFault::kNone) << "without a range";
}

TEST(HorizonRule, HidesWhatLiesBehindTheHorizonOnly) {
  const RadioOptions options = {.range_m = -1, .antenna_height_m = 2, .horizon = true};
  const double horizon_m = RadioHorizon_m(2, 2);
  EXPECT_EQ(LinkOver(options, horizon_m - 1e-3).fault, RadioFault::kNone);
  EXPECT_EQ(LinkOver(options, horizon_m).fault, RadioFault::kBelowHorizon);
  EXPECT_EQ(LinkOver(options, horizon_m + 1e-3).fault, RadioFault::kBelowHorizon);
  EXPECT_EQ(LinkOver(options, horizon_m + 1e-3).horizon_m, horizon_m);
}

TEST(HorizonRule, CountsHeightsFromTheWaterAndTakesAVehiclesOwn) {
  const RadioOptions options = {
      .range_m = -1, .surface_depth_m = 0.5, .antenna_height_m = 2, .horizon = true};
  EXPECT_EQ(LinkOver(options, 100, 0.5).horizon_m, RadioHorizon_m(1.5, 1.5));
  const RadioEnd mast = {.position_m = {0, 0, 0}, .antenna_height_m = 30};
  const RadioEnd boat = {.position_m = {100, 0, 0}};
  EXPECT_EQ(DecideRadio(options, mast, boat).horizon_m, RadioHorizon_m(30, 2));
}

TEST(SignalRule, LetsThroughWhileTheLossIsAtMostWhatTheReceiverBears) {
  for (const PathLossModel model : {PathLossModel::kLogDistance, PathLossModel::kTwoRay}) {
    const RadioOptions options = {
        .range_m = -1, .path_loss = model, .power_dbm = 20, .sensitivity_dbm = -90};
    const double reach_m = model == PathLossModel::kTwoRay ? TwoRayReach_m(110, 900, 2, 2)
                                                           : LogDistanceReach_m(110, 900, 2);
    EXPECT_EQ(LinkOver(options, reach_m - 1e-6).fault, RadioFault::kNone);
    const RadioLink beyond = LinkOver(options, reach_m + 1e-3);
    EXPECT_EQ(beyond.fault, RadioFault::kWeakSignal);
    EXPECT_GT(beyond.path_loss_db, 110);
    EXPECT_EQ(beyond.path_loss_limit_db, 110);
    EXPECT_NEAR(beyond.limit_m, reach_m, 1e-9);
  }
}

TEST(SignalRule, ReturnsTheLeastLimitOfAWorkingLink) {
  const RadioLink link = LinkOver({.range_m = 500,
                                   .horizon = true,
                                   .path_loss = PathLossModel::kLogDistance,
                                   .sensitivity_dbm = -100},
                                  400);
  EXPECT_EQ(link.fault, RadioFault::kNone);
  EXPECT_EQ(link.limit_m, 500);
  EXPECT_NEAR(link.path_loss_db, FreeSpaceLoss_db(400, 900), 1e-9);
}

TEST(Passage, TakesAirLatencyAndJitter) {
  const RadioOptions options = {.rate_bps = 8000, .latency_s = 0.2, .jitter_s = 0.1};
  const RadioPassage passage =
      DrawPassage(options, 500, RadioDrawsOf(3, "vhf", "report", "a", "b"), 0);
  EXPECT_DOUBLE_EQ(passage.air_s, 0.5);
  EXPECT_GE(passage.delay_s, 0.7);
  EXPECT_LT(passage.delay_s, 0.8);
  EXPECT_FALSE(passage.is_lost);
  EXPECT_EQ(DrawPassage({}, 500, RadioDrawsOf(3, "vhf", "report", "a", "b"), 0).delay_s, 0);
}

TEST(Passage, LosesTheShareThatIsAskedFor) {
  const RadioDraws draws = RadioDrawsOf(5, "vhf", "report", "a", "b");
  const auto num_lost = [&](double loss) {
    int lost = 0;
    for (int64_t number = 0; number < 4000; ++number) {
      lost += DrawPassage({.loss = loss}, 1, draws, number).is_lost ? 1 : 0;
    }
    return lost;
  };
  EXPECT_EQ(num_lost(0), 0);
  EXPECT_EQ(num_lost(1), 4000);
  EXPECT_NEAR(num_lost(0.3), 1200, 4 * std::sqrt(4000 * 0.3 * 0.7));
}

TEST(Passage, DrawsForEachMediumLinkAndTransmissionAnew) {
  const RadioOptions options = {.jitter_s = 1};
  const auto delay_s = [&](std::string_view medium, std::string_view kind, std::string_view source,
                           std::string_view receiver, int64_t number) {
    const RadioDraws draws = RadioDrawsOf(1, medium, kind, source, receiver);
    return DrawPassage(options, 0, draws, number).delay_s;
  };
  const double first_s = delay_s("vhf", "report", "a", "b", 0);
  EXPECT_EQ(delay_s("vhf", "report", "a", "b", 0), first_s);
  EXPECT_NE(delay_s("uhf", "report", "a", "b", 0), first_s);
  EXPECT_NE(delay_s("vhf", "message", "a", "b", 0), first_s);
  EXPECT_NE(delay_s("vhf", "report", "c", "b", 0), first_s);
  EXPECT_NE(delay_s("vhf", "report", "a", "c", 0), first_s);
  EXPECT_NE(delay_s("vhf", "report", "a", "b", 1), first_s);
}

}  // namespace shoal::radio_link_test

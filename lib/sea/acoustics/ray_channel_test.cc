#include "lib/sea/acoustics/ray_channel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/random/stream.h"

namespace shoal::ray_channel_test {

/// A summer's thermocline.
const std::vector<SpeedPoint> kSummer = {{0, 1524},  {12, 1523.5}, {18, 1516},   {25, 1503},
                                         {32, 1496}, {45, 1492},   {70, 1490.5}, {100, 1490}};

RayChannelOptions Summer() {
  RayChannelOptions options;
  options.profile = kSummer;
  options.bottom = *FindBottomType("sand");
  return options;
}

RayEnd At(double x_m, double y_m, double z_m) { return {.position_m = {x_m, y_m, z_m}}; }

double Decibels(double power) { return 10 * std::log10(power); }

TEST(RayChannel, HasTheDirectPathInWaterOfConstantSpeed) {
  RayChannelOptions options;
  options.bottom = {1500, 1, 0};  // It swallows all.
  RayChannel channel(options, {}, {.hz = 25'000, .absorption_dbpkm = 5});
  const RayReception reception = channel.Receive(At(0, 0, 30), At(600, 800, 60));
  EXPECT_EQ(reception.num_arrivals, 2);  // And the one that the surface returns.
  EXPECT_NEAR(reception.travel_s, std::sqrt(1000.0 * 1000 + 30 * 30) / 1500, 1e-6);
  EXPECT_NEAR(Decibels(reception.signal), -60 - 5 + 3, 0.1);
  EXPECT_EQ(reception.interference, 0);
  EXPECT_EQ(reception.num_surface, 0);
  EXPECT_EQ(reception.shadow, ShadowReason::kNone);
  EXPECT_NEAR(reception.delay_spread_s, 0.669361221 - 0.666966599, 1e-5);
}

TEST(RayChannel, TakesWhatComesAfterItsWindowForInterference) {
  RayChannelOptions options;
  options.bottom = {1500, 1, 0};
  options.window_s = 0.001;  // The surface's arrival is 2.4 ms late.
  RayChannel channel(options, {}, {});
  const RayReception reception = channel.Receive(At(0, 0, 30), At(1000, 0, 60));
  EXPECT_NEAR(Decibels(reception.signal), -60, 0.1);
  EXPECT_NEAR(Decibels(reception.interference), -60.04, 0.1);
  EXPECT_EQ(reception.num_arrivals, 2);
}

TEST(RayChannel, TakesWhatIsShiftedTooMuchForInterference) {
  RayChannelOptions options;
  options.bottom = {1500, 1, 0};
  options.max_doppler_mps = 2;
  RayChannel channel(options, {}, {});
  RayEnd from = At(0, 0, 30);
  from.velocity_mps = {1.5, 0, 0};
  RayEnd to = At(1000, 0, 30);
  const RayReception slow = channel.Receive(from, to);
  EXPECT_NEAR(slow.doppler_mps, 1.5, 1e-3);
  EXPECT_GT(slow.signal, 0);
  to.velocity_mps = {-1, 0, 0};
  const RayReception fast = channel.Receive(from, to);
  EXPECT_NEAR(fast.doppler_mps, 2.5, 2e-3);
  EXPECT_EQ(fast.signal, 0);
  EXPECT_GT(fast.interference, 0);
  // A vehicle that dives toward a receiver below it.
  from.velocity_mps = {0, 0, 1};
  const RayReception dive = channel.Receive(from, At(0.1, 0, 80));
  EXPECT_NEAR(dive.doppler_mps, 1, 1e-2);
}

TEST(RayChannel, StatesWhyThereIsAShadow) {
  RayChannelOptions options = Summer();
  options.bottom = {1490, 1, 0};
  RayChannel channel(options, {}, {});
  const RayReception near = channel.Receive(At(0, 0, 8), At(200, 0, 6));
  EXPECT_EQ(near.shadow, ShadowReason::kNone);
  // From below the thermocline to the warm layer, far off: rays that come so high are too steep.
  const RayReception far = channel.Receive(At(0, 0, 60), At(3000, 0, 6));
  EXPECT_EQ(far.num_arrivals, 0);
  EXPECT_EQ(far.shadow, ShadowReason::kBendsDown);
  EXPECT_EQ(ShadowText(far.shadow), "sound is slower below and bends down");

  options.profile = {{0, 1480}, {50, 1520}, {100, 1480}};
  RayChannel barrier(options, {}, {});
  EXPECT_EQ(barrier.Receive(At(0, 0, 5), At(3000, 0, 95)).shadow, ShadowReason::kFastLayer);
  options.profile = {{0, 1480}, {100, 1530}};
  options.bottom = {1530, 1, 0};
  RayChannel upward(options, {}, {});
  EXPECT_EQ(upward.Receive(At(0, 0, 90), At(6000, 0, 90)).shadow, ShadowReason::kBendsUp);
  EXPECT_EQ(upward.Receive(At(0, 0, 10), At(600, 0, 20)).shadow, ShadowReason::kNone);
}

/// A ridge that runs North, 20 m below the surface at x = 500 m.
SeaFloor Ridge() {
  std::vector<float> depths_m;
  for (int row = 0; row < 2; ++row) {
    for (const float depth_m : {100.0F, 100.0F, 20.0F, 100.0F, 100.0F}) depths_m.push_back(depth_m);
  }
  const GridFrame frame = {
      .columns = 5, .rows = 2, .south_west_m = {0, -1000}, .cell_m = {250, 2000}};
  return SeaFloor(std::make_shared<const DepthGrid>(frame, depths_m));
}

TEST(RayChannel, FollowsTheSeaFloor) {
  RayChannelOptions options;
  options.follows_floor = true;
  RayChannel channel(options, {.floor = Ridge()}, {});
  EXPECT_EQ(channel.Receive(At(0, 0, 60), At(1000, 0, 60)).shadow, ShadowReason::kBottomBetween);
  // The same way along the valley.
  const RayReception along = channel.Receive(At(0, -500, 60), At(0, 500, 60));
  EXPECT_EQ(along.shadow, ShadowReason::kNone);
  EXPECT_NEAR(along.travel_s, 1000 / 1500.0, 1e-6);
}

TEST(RayChannel, SeesTheSameWhereSeaAndPlacesAreTurned) {
  RayChannelOptions options;
  options.follows_floor = true;
  std::vector<float> depths_m;  // The same ridge, running East.
  for (const float depth_m : {100.0F, 100.0F, 20.0F, 100.0F, 100.0F}) {
    depths_m.insert(depths_m.end(), 2, depth_m);
  }
  const GridFrame turned = {
      .columns = 2, .rows = 5, .south_west_m = {-1000, 0}, .cell_m = {2000, 250}};
  RayChannel channel(options, {.floor = Ridge()}, {});
  RayChannel other(options,
                   {.floor = SeaFloor(std::make_shared<const DepthGrid>(turned, depths_m))}, {});
  const RayReception a = channel.Receive(At(100.5, 0.5, 60.5), At(700.5, 0.5, 10.5));
  const RayReception b = other.Receive(At(0.5, 100.5, 60.5), At(0.5, 700.5, 10.5));
  EXPECT_NEAR(a.travel_s, b.travel_s, 1e-12);
  EXPECT_NEAR(Decibels(a.signal), Decibels(b.signal), 1e-6);
}

/// Delays by cells against those of the places themselves, which a cell without width has.
TEST(RayChannelCells, KeepDelaysWithinTheirBound) {
  RayChannelOptions options = Summer();
  options.window_s = 10;
  RayChannelOptions exact_options = options;
  exact_options.cell_m = 1000;  // Links shorter than 100 km are not kept.
  RayChannel kept(options, {}, {});
  RayChannel exact(exact_options, {}, {});
  Stream stream(3, "cells");
  double largest_s = 0;
  double largest_db = 0;
  for (int i = 0; i < 300; ++i) {
    const RayEnd from = At(0, 0, 35 + 60 * stream.Uniform());
    const RayEnd to = At(100 + 900 * stream.Uniform(), 0, 35 + 60 * stream.Uniform());
    const RayReception a = kept.Receive(from, to);
    const RayReception b = exact.Receive(from, to);
    ASSERT_GT(b.num_arrivals, 0);
    if (a.num_arrivals != b.num_arrivals) continue;
    largest_s = std::max(largest_s, std::abs(a.travel_s - b.travel_s));
    largest_db = std::max(largest_db, std::abs(Decibels(a.signal / b.signal)));
  }
  EXPECT_LT(largest_s, 1 / (200 * 1490.0));
  EXPECT_LT(largest_db, 1);
  EXPECT_GT(largest_s, 1e-9);
}

TEST(RayChannelCells, AnswerTheSameInAnyOrder) {
  const RayChannelOptions options = Summer();
  std::vector<std::pair<RayEnd, RayEnd>> links;
  Stream stream(4, "order");
  for (int i = 0; i < 200; ++i) {
    links.emplace_back(At(3 * stream.Uniform(), 0, 5 + 3 * stream.Uniform()),
                       At(500 + 3 * stream.Uniform(), 2 * stream.Uniform(), 40));
  }
  RayChannel forward(options, {}, {});
  RayChannel backward(options, {}, {});
  std::vector<RayReception> first;
  for (const auto& [from, to] : links) first.push_back(forward.Receive(from, to));
  for (size_t i = links.size(); i-- > 0;) {
    const RayReception again = backward.Receive(links[i].first, links[i].second);
    EXPECT_EQ(again.travel_s, first[i].travel_s);
    EXPECT_EQ(again.signal, first[i].signal);
    EXPECT_EQ(again.interference, first[i].interference);
    EXPECT_EQ(again.num_arrivals, first[i].num_arrivals);
  }
}

TEST(RayChannel, HasAPathStraightDownAndBetweenTouchingModems) {
  RayChannel channel(Summer(), {}, {});
  const RayReception down = channel.Receive(At(0, 0, 1), At(0, 0, 81));
  EXPECT_EQ(down.shadow, ShadowReason::kNone);
  EXPECT_NEAR(down.travel_s, 80 / channel.profile().MeanSpeed(1, 81), 1e-5);
  EXPECT_GT(channel.Receive(At(0, 0, 50), At(0, 0, 50)).num_arrivals, 0);
  // On the surface and in the bottom: a transducer hangs within the water.
  EXPECT_GT(channel.Receive(At(0, 0, 0), At(300, 0, 120)).num_arrivals, 0);
}

TEST(RayChannel, TakesTheArrivalsOfAFile) {
  const Result<ArrivalTable> table = ReadBellhopArrivals(
      "bay.arr", "'2D'\n25000\n1 30\n2 10 60\n1 1000\n1\n0\n1\n1e-3 0 0.7 0 1.5 2.5 0 1\n");
  ASSERT_TRUE(table.ok()) << (table.ok() ? "" : table.error());
  RayChannelOptions options;
  options.arrivals_file = "bay.arr";
  RayChannel channel(options, {.arrivals = std::make_shared<const ArrivalTable>(*table)}, {});
  const RayReception reception = channel.Receive(At(0, 0, 30), At(990, 0, 55));
  EXPECT_EQ(reception.travel_s, 0.7);
  EXPECT_NEAR(Decibels(reception.signal), -60, 1e-9);
  EXPECT_EQ(reception.num_bottom, 1);
  EXPECT_EQ(channel.Receive(At(0, 0, 30), At(990, 0, 12)).num_arrivals, 0);
}

TEST(PacketErrorTable, IsLinearAndConstantBeyondItsEnds) {
  const std::vector<PacketErrorPoint> table = {{0, 1}, {10, 0.5}, {20, 0}};
  EXPECT_EQ(LossOf(table, -5), 1);
  EXPECT_EQ(LossOf(table, 5), 0.75);
  EXPECT_EQ(LossOf(table, 15), 0.25);
  EXPECT_EQ(LossOf(table, 25), 0);
  EXPECT_EQ(LossOf(table, -INFINITY), 1);
}

TEST(RayChannelOptions, AreRefusedWithTheReason) {
  RayChannelOptions options;
  EXPECT_EQ(ProblemOf(options), "");
  options.packet_errors = {{10, 0.5}, {0, 1}};
  EXPECT_EQ(ProblemOf(options),
            "row 2 of the packet error table: snr_db must grow from row to row");
  options = {};
  options.profile = {};
  EXPECT_NE(ProblemOf(options), "");
  options = {};
  options.max_launch_deg = 90;
  EXPECT_NE(ProblemOf(options), "");
}

}  // namespace shoal::ray_channel_test

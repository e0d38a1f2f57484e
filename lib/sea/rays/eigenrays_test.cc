// Rays against closed forms: images, arcs, Munk's channel, Lloyd's mirror, the shadow's edge.
#include "lib/sea/rays/eigenrays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "lib/sea/rays/rays_testing.h"

namespace shoal::eigenrays_test {

struct Image {
  double delay_s = 0;
  double amplitude = 0;
  int num_surface = 0;
  int num_bottom = 0;
};

/// The image sources of a flat rigid bottom below a free surface, within a fan: at 2 m D +- source
/// depth. The path of one crosses each of the planes in between once.
std::vector<Image> ImagesWithin(double depth_m, double source_m, double receiver_m, double range_m,
                                double max_launch_rad) {
  constexpr double kSpeed_mps = 1500;
  std::vector<Image> images;
  for (int m = -60; m <= 60; ++m) {
    for (const int sign : {1, -1}) {
      const double height_m = 2 * m * depth_m + sign * source_m - receiver_m;
      if (std::atan2(std::abs(height_m), range_m) > max_launch_rad) continue;
      const double length_m = std::hypot(range_m, height_m);
      const int num_bottom = std::abs(m);
      const int num_surface = sign > 0 ? num_bottom : std::abs(m - 1);
      const bool is_below = sign < 0 && m > 0;
      images.push_back({length_m / kSpeed_mps, 1 / length_m,
                        is_below ? num_bottom - 1 : num_surface, num_bottom});
    }
  }
  std::ranges::sort(images, {}, &Image::delay_s);
  return images;
}

TEST(Eigenrays, AreTheImagesInWaterOfConstantSpeed) {
  const RayLimits limits = Fan(59.9);
  const RayScene scene = LayeredScene(SoundProfile(1500), 100);
  for (const RayScene& each : {scene, AsTraced(scene, 1000)}) {
    const std::vector<RayArrival> arrivals = FindEigenrays(each, {0, 30}, {1000, 60}, limits);
    const std::vector<Image> images = ImagesWithin(100, 30, 60, 1000, limits.max_launch_rad);
    ASSERT_EQ(images.size(), 35U);
    ASSERT_EQ(arrivals.size(), images.size());
    for (size_t i = 0; i < images.size(); ++i) {
      EXPECT_NEAR(arrivals[i].delay_s, images[i].delay_s, 1e-9);
      EXPECT_NEAR(20 * std::log10(arrivals[i].amplitude / images[i].amplitude), 0, 1e-6);
      EXPECT_EQ(arrivals[i].num_surface, images[i].num_surface) << i;
      EXPECT_EQ(arrivals[i].num_bottom, images[i].num_bottom) << i;
    }
  }
}

TEST(Eigenrays, HaveTheClosedFormOfALinearGradient) {
  // t = acosh(1 + g^2 (R^2 + dz^2) / (2 c1 c2)) / g, c = 1500 + 0.017 z.
  const RayScene scene = LayeredScene(ProfileOf({{0, 1500}, {1000, 1517}}), 1000);
  for (const RayScene& each : {scene, AsTraced(scene, 5000)}) {
    const std::vector<RayArrival> arrivals = FindEigenrays(each, {0, 100}, {5000, 500}, Fan(15));
    ASSERT_FALSE(arrivals.empty());
    const double g = 0.017;
    const double ratio = g * g * (5000.0 * 5000 + 400.0 * 400) / (2 * 1501.7 * 1508.5);
    EXPECT_NEAR(arrivals[0].delay_s, std::acosh(1 + ratio) / g, 1e-9);
    EXPECT_NEAR(arrivals[0].delay_s, 3.332214918, 1e-9);
    EXPECT_EQ(arrivals[0].num_surface + arrivals[0].num_bottom, 0);
  }
}

TEST(Eigenrays, HaveThePublishedDelaysInMunksChannel) {
  const Result<SoundProfile> munk = MunkProfile({}, 5000, 5);
  ASSERT_TRUE(munk.ok());
  std::vector<RayArrival> arrivals =
      FindEigenrays(LayeredScene(*munk, 5000), {0, 1000}, {100'000, 800}, Fan(15));
  std::erase_if(arrivals,
                [](const RayArrival& each) { return each.num_surface + each.num_bottom > 0; });
  ASSERT_EQ(arrivals.size(), 2U);
  EXPECT_NEAR(arrivals[0].delay_s, 66.606233, 1e-6);
  EXPECT_NEAR(arrivals[0].launch_rad / kDegree, 9.5696, 1e-3);
  EXPECT_NEAR(arrivals[0].arrive_rad / kDegree, -8.8849, 1e-3);
  EXPECT_NEAR(arrivals[1].delay_s, 66.648265, 1e-6);
  EXPECT_NEAR(arrivals[1].launch_rad / kDegree, 5.9303, 1e-3);
  EXPECT_NEAR(arrivals[1].arrive_rad / kDegree, 4.7392, 1e-3);
}

TEST(Eigenrays, AreTracedStepByStepAsInLayersInMunksChannel) {
  const Result<SoundProfile> munk = MunkProfile({}, 5000, 50);
  ASSERT_TRUE(munk.ok());
  const RayScene scene = LayeredScene(*munk, 5000);
  const auto exact = FindEigenrays(scene, {0, 1000}, {60'000, 800}, Fan(13));
  const auto traced = FindEigenrays(AsTraced(scene, 60'000), {0, 1000}, {60'000, 800}, Fan(13));
  ASSERT_EQ(exact.size(), traced.size());
  ASSERT_GE(exact.size(), 3U);
  for (size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(traced[i].delay_s, exact[i].delay_s, 1e-8);
    EXPECT_EQ(traced[i].num_caustics, exact[i].num_caustics);
  }
}

TEST(Eigenrays, InterfereAsLloydsMirror) {
  // Far below the surface's interference, the pressure vanishes where the paths differ by a whole
  // number of wavelengths: zs zr = n wavelength R / 2, nearly.
  RayScene scene = LayeredScene(SoundProfile(1500), 5000);
  scene.bottom_reflector = HalfSpace{1500, 1, 0};
  scene.hz = 1000;
  const double wavelength_m = 1.5;
  const auto pressure = [&](double receiver_m) {
    std::complex<double> sum = 0;
    for (const RayArrival& each : FindEigenrays(scene, {0, 10}, {1000, receiver_m}, Fan(40))) {
      sum += std::polar(each.amplitude,
                        each.phase_rad - 2 * std::numbers::pi * scene.hz * each.delay_s);
    }
    return std::abs(sum);
  };
  for (const int n : {1, 2, 3}) {
    // sqrt(R^2 + (zr + zs)^2) - sqrt(R^2 + (zr - zs)^2) = n wavelength.
    double low_m = 1, high_m = 500;
    while (high_m - low_m > 1e-9) {
      const double middle_m = (low_m + high_m) / 2;
      const double difference = std::hypot(1000, middle_m + 10) - std::hypot(1000, middle_m - 10);
      (difference < n * wavelength_m ? low_m : high_m) = middle_m;
    }
    EXPECT_LT(pressure(low_m), 2e-3 / 1000 * n * 40) << low_m;
    EXPECT_LT(pressure(low_m), pressure(low_m - 10) / 10);
    EXPECT_LT(pressure(low_m), pressure(low_m + 10) / 10);
  }
}

TEST(Eigenrays, EndAtTheEdgeOfTheShadow) {
  // Sound slower below bends down: the last ray to a depth grazes the surface. Ranges from where an
  // arc of radius c0 / g is horizontal to a depth z: sqrt(z (2 c0 / g - z)).
  const double g = 0.1;
  RayScene scene = LayeredScene(ProfileOf({{0, 1520}, {400, 1480}}), 400);
  scene.bottom_reflector = HalfSpace{1480, 1, 0};
  const auto range_to = [&](double depth_m) {
    return std::sqrt(depth_m * (2 * 1520 / g - depth_m));
  };
  for (const double receiver_m : {40.0, 200.0}) {
    const double edge_m = range_to(50) + range_to(receiver_m);
    EXPECT_EQ(FindEigenrays(scene, {0, 50}, {edge_m + 0.01, receiver_m}, Fan(60)).size(), 0U);
    const auto inside = FindEigenrays(scene, {0, 50}, {edge_m - 0.05, receiver_m}, Fan(60));
    EXPECT_EQ(inside.size(), 2U);  // The direct ray, and one that the surface returns.
  }
  // The usual approximation, R = sqrt(2 c / g) (sqrt(z1) + sqrt(z2)).
  EXPECT_NEAR(range_to(50) + range_to(40),
              std::sqrt(2 * 1520 / g) * (std::sqrt(50) + std::sqrt(40)), 3);
}

TEST(Eigenrays, AreStraightBetweenEqualDepths) {
  const RayScene scene = LayeredScene(SoundProfile(1500), 100);
  const auto arrivals = FindEigenrays(scene, {0, 50}, {300, 50}, Fan(30));
  ASSERT_FALSE(arrivals.empty());
  EXPECT_DOUBLE_EQ(arrivals[0].delay_s, 0.2);
  EXPECT_DOUBLE_EQ(arrivals[0].amplitude, 1.0 / 300);
  EXPECT_EQ(arrivals[0].launch_rad, 0);
  // And where a hair parts them.
  const auto nearly = FindEigenrays(scene, {0, 50}, {300, 50 + 1e-7}, Fan(30));
  ASSERT_EQ(nearly.size(), arrivals.size());
  EXPECT_NEAR(nearly[0].delay_s, 0.2, 1e-12);
}

TEST(Eigenrays, AreNoneOutsideTheWaterOrAtOneRange) {
  const RayScene scene = LayeredScene(SoundProfile(1500), 100);
  EXPECT_TRUE(FindEigenrays(scene, {0, 50}, {300, 101}, {}).empty());
  EXPECT_TRUE(FindEigenrays(scene, {0, -1}, {300, 50}, {}).empty());
  EXPECT_TRUE(FindEigenrays(scene, {0, 50}, {0, 60}, {}).empty());
}

TEST(Eigenrays, OfAWindySurfaceLoseAtEachBounce) {
  RayScene scene = LayeredScene(SoundProfile(1500), 100);
  const auto calm = FindEigenrays(scene, {0, 30}, {1000, 60}, Fan(30));
  scene.surface_reflector = WindySurface{10};
  const auto rough = FindEigenrays(scene, {0, 30}, {1000, 60}, Fan(30));
  ASSERT_EQ(calm.size(), rough.size());
  for (size_t i = 0; i < calm.size(); ++i) {
    EXPECT_EQ(calm[i].delay_s, rough[i].delay_s);
    if (calm[i].num_surface == 0) {
      EXPECT_EQ(calm[i].amplitude, rough[i].amplitude);
    } else {
      EXPECT_LT(rough[i].amplitude, calm[i].amplitude);
    }
  }
}

TEST(PowerOfAnArrival, LosesWhatTheWaterAbsorbs) {
  RayArrival arrival;
  arrival.amplitude = 1e-3;
  arrival.length_m = 2000;
  EXPECT_NEAR(10 * std::log10(PowerOf(arrival, 5)), -70, 1e-9);
}

}  // namespace shoal::eigenrays_test

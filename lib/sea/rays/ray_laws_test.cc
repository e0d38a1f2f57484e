// What holds of rays in every sea: reciprocity, conserved energy, and no preferred place or
// direction. And the waves that they stand for: Pekeris's guide by its modes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "lib/base/random/stream.h"
#include "lib/sea/rays/rays_testing.h"

namespace shoal::ray_laws_test {

double Between(Stream* stream, double low, double high) {
  return low + (high - low) * stream->Uniform();
}

/// Water of some layers over sand.
RayScene DrawLayered(Stream* stream) {
  std::vector<SpeedPoint> points = {{0, Between(stream, 1480, 1530)}};
  while (points.size() < 6) {
    points.push_back({points.back().depth_m + Between(stream, 5, 40),
                      points.back().speed_mps + Between(stream, -8, 6)});
  }
  RayScene scene = LayeredScene(ProfileOf(points), 120);
  scene.bottom_reflector = *FindBottomType("sand");
  return scene;
}

/// The same with a front and a sloping bottom.
RayScene DrawRangeDependent(Stream* stream) {
  RayScene scene = DrawLayered(stream);
  std::vector<SpeedPoint> far(scene.water[0].profile.points().begin(),
                              scene.water[0].profile.points().end());
  for (SpeedPoint& point : far) point.speed_mps += Between(stream, -3, 3);
  scene.water.push_back({1500, ProfileOf(far)});
  scene.bottom = {{0, 120}, {600, Between(stream, 100, 130)}, {1500, Between(stream, 100, 130)}};
  return scene;
}

/// Looks at the arrivals of a link from both ends. With a hair's difference an arrival at the edge
/// of a history is there or not: what has no partner must be one of these.
void ExpectReciprocal(const RayScene& scene, const SectionPoint& a, const SectionPoint& b) {
  const RayLimits limits = Fan(50);
  const auto there = FindEigenrays(scene, a, b, limits);
  const auto back = FindEigenrays(scene, b, a, limits);
  const double c_a = SpeedAt(scene, a.range_m, a.depth_m);
  const double c_b = SpeedAt(scene, b.range_m, b.depth_m);
  ASSERT_GE(there.size(), 2U);
  int num_pairs = 0;
  for (const RayArrival& each : there) {
    const auto other = std::ranges::find_if(back, [&](const RayArrival& that) {
      return std::abs(that.launch_rad + each.arrive_rad) < 1e-6 &&
             std::abs(that.arrive_rad + each.launch_rad) < 1e-6;
    });
    // Of one fan a ray can leave the other.
    if (std::abs(each.arrive_rad) > 0.999 * limits.max_launch_rad) continue;
    ASSERT_NE(other, back.end()) << each.launch_rad << " " << each.delay_s;
    ++num_pairs;
    EXPECT_NEAR(other->delay_s, each.delay_s, 1e-12);
    EXPECT_EQ(other->num_surface, each.num_surface);
    EXPECT_EQ(other->num_bottom, each.num_bottom);
    EXPECT_EQ(other->num_caustics, each.num_caustics);
    const double factor =
        IsLayered(scene)
            ? 1
            : std::sqrt(c_b * std::cos(each.launch_rad) / (c_a * std::cos(each.arrive_rad)));
    EXPECT_NEAR(each.amplitude / other->amplitude / factor, 1, 1e-4);
  }
  EXPECT_GE(num_pairs, 2);
}

TEST(Reciprocity, HoldsInLayers) {
  for (int i = 0; i < 20; ++i) {
    Stream stream(7, "reciprocity", i);
    const RayScene scene = DrawLayered(&stream);
    ExpectReciprocal(scene, {0, Between(&stream, 2, 118)},
                     {Between(&stream, 100, 1500), Between(&stream, 2, 118)});
  }
}

TEST(Reciprocity, HoldsWithTheFactorOfSpeedAndAngleAlongARange) {
  const RayScene scene = GoldenCase("range_dep").scene;
  ExpectReciprocal(scene, {0, 30}, {1250, 90});
  Stream stream(8, "reciprocity");
  ExpectReciprocal(DrawRangeDependent(&stream), {50, 20}, {1100, 60});
}

TEST(Energy, IsConservedInALosslessGuide) {
  // Through a cylinder at any range comes what the fan has sent: per tube of rays
  // amplitude^2 r cos(arrive) dz c_s / c_r = cos(launch) d launch.
  struct Case {
    RayScene scene;
    double tolerance;  ///< Caustics are integrable poles, which a sum over depths meets by chance.
  };
  const RayScene iso = LayeredScene(SoundProfile(1500), 100);
  const RayScene bent = LayeredScene(ProfileOf({{0, 1500}, {100, 1510}}), 100);
  for (const auto& [scene, tolerance] : {Case{iso, 0.01}, Case{bent, 0.03}}) {
    const RayLimits limits = Fan(30);
    const double c_source = SpeedAt(scene, 0, 40);
    for (const double range_m : {300.0, 2000.0}) {
      double power = 0;
      constexpr int kDepths = 2000;
      for (int i = 0; i < kDepths; ++i) {
        const double depth_m = 100 * (i + 0.5) / kDepths;
        for (const RayArrival& each : FindEigenrays(scene, {0, 40}, {range_m, depth_m}, limits)) {
          power += each.amplitude * each.amplitude * range_m * std::cos(each.arrive_rad) *
                   c_source / SpeedAt(scene, range_m, depth_m) * 100 / kDepths;
        }
      }
      EXPECT_NEAR(power / (2 * std::sin(limits.max_launch_rad)), 1, tolerance) << range_m;
    }
  }
}

TEST(Scenes, HaveNoPreferredPlace) {
  Stream stream(9, "translation");
  const RayScene scene = DrawRangeDependent(&stream);
  RayScene moved = scene;
  for (auto* boundary : {&moved.surface, &moved.bottom}) {
    for (BoundaryPoint& point : *boundary) point.range_m += 10'000;
  }
  for (ProfileAtRange& each : moved.water) each.range_m += 10'000;
  const auto here = FindEigenrays(scene, {50, 20}, {1100, 60}, Fan(40));
  const auto there = FindEigenrays(moved, {10'050, 20}, {11'100, 60}, Fan(40));
  ASSERT_EQ(here.size(), there.size());
  ASSERT_GT(here.size(), 5U);
  for (size_t i = 0; i < here.size(); ++i) {
    EXPECT_NEAR(here[i].delay_s, there[i].delay_s, 1e-12);
    EXPECT_NEAR(here[i].amplitude / there[i].amplitude, 1, 1e-7);
  }
}

/// Pekeris's guide by its normal modes: water of 1500 m/s and density 1 over a fluid without loss
/// (Jensen, Kuperman, Porter, Schmidt, Computational Ocean Acoustics, 2nd ed., sec. 2.4.5 and 5.4).
class PekerisModes {
 public:
  PekerisModes(double depth_m, double hz, const HalfSpace& below)
      : depth_m_(depth_m), below_(below) {
    const double omega = 2 * std::numbers::pi * hz;
    k_water_ = omega / 1500;
    k_below_ = omega / below.speed_mps;
    const double kz_max = std::sqrt(k_water_ * k_water_ - k_below_ * k_below_);
    // tan(kz D) = -rho2 kz / (rho1 gamma): one root in each ((n - 1/2) pi, n pi) of kz D.
    for (int n = 1; (n - 0.5) * std::numbers::pi / depth_m < kz_max; ++n) {
      double low = (n - 0.5) * std::numbers::pi / depth_m;
      double high = std::min(n * std::numbers::pi / depth_m, kz_max);
      for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (Excess(middle) < 0 ? low : high) = middle;
      }
      kz_.push_back((low + high) / 2);
    }
  }

  size_t count() const { return kz_.size(); }

  double PowerAt(double range_m, double source_m, double receiver_m) const {
    std::complex<double> sum = 0;
    for (const double kz : kz_) {
      const double kr = std::sqrt(k_water_ * k_water_ - kz * kz);
      const double gamma = Gamma(kz);
      const double end = std::sin(kz * depth_m_);
      const double norm = depth_m_ / 2 - std::sin(2 * kz * depth_m_) / (4 * kz) +
                          end * end / (2 * gamma * below_.density);
      sum += std::sin(kz * source_m) * std::sin(kz * receiver_m) / norm / std::sqrt(kr) *
             std::polar(1.0, kr * range_m);
    }
    return std::norm(sum) * 2 * std::numbers::pi / range_m;
  }

 private:
  double Gamma(double kz) const {
    return std::sqrt(std::max(1e-30, k_water_ * k_water_ - kz * kz - k_below_ * k_below_));
  }
  /// Grows from below 0 to above 0 within a mode's interval.
  double Excess(double kz) const {
    const bool falls = static_cast<int>(std::floor(kz * depth_m_ / std::numbers::pi)) % 2 == 0;
    const double value =
        std::sin(kz * depth_m_) * Gamma(kz) + below_.density * kz * std::cos(kz * depth_m_);
    return falls ? -value : value;
  }

  double depth_m_;
  HalfSpace below_;
  double k_water_ = 0;
  double k_below_ = 0;
  std::vector<double> kz_;
};

TEST(PekerisGuide, HasTheLevelsOfItsModes) {
  // Levels averaged over 40 ranges of 2.5 m each: single ranges interfere by displacements at the
  // bottom that geometric rays do not have (docs/communication/rays.md).
  const HalfSpace below = {1650, 1.9, 0};
  const double hz = 6000;
  const PekerisModes modes(60, hz, below);
  EXPECT_GT(modes.count(), 100U);
  RayScene scene = LayeredScene(SoundProfile(1500), 60);
  scene.bottom_reflector = below;
  scene.hz = hz;
  for (const double first_m : {800.0, 1500.0}) {
    double by_modes = 0;
    double by_rays = 0;
    for (int i = 0; i < 60; ++i) {
      const double range_m = first_m + 2.5 * i;
      by_modes += modes.PowerAt(range_m, 20, 35);
      std::complex<double> pressure = 0;
      for (const RayArrival& each : FindEigenrays(scene, {0, 20}, {range_m, 35}, Fan(60))) {
        pressure +=
            std::polar(each.amplitude, each.phase_rad - 2 * std::numbers::pi * hz * each.delay_s);
      }
      by_rays += std::norm(pressure);
    }
    EXPECT_NEAR(10 * std::log10(by_rays / by_modes), 0, 0.5) << first_m;
  }
}

}  // namespace shoal::ray_laws_test

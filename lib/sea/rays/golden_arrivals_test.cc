// Every arrival of tests/golden/rays that is flagged ok, and the levels there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>

#include "lib/sea/rays/rays_testing.h"

namespace shoal::golden_arrivals_test {

/// Thorp's absorption with Bellhop's numbers, dB/km.
double ThorpOfBellhop(double hz) {
  const double f = hz * hz / 1e6;
  return 3.3e-3 + 0.11 * f / (1 + f) + 44 * f / (4100 + f) + 3e-4 * f;
}

double Decibels(double ratio) { return std::abs(20 * std::log10(ratio)); }

class Receiver {
 public:
  explicit Receiver(const BellhopCase& golden) : golden_(golden) {
    limits_.max_launch_rad = std::max(-golden.first_launch_rad, golden.last_launch_rad);
  }

  /// Moves it there.
  void Place(double range_m, double depth_m) {
    if (range_m == range_m_ && depth_m == depth_m_) return;
    range_m_ = range_m;
    depth_m_ = depth_m;
    left_ = FindEigenrays(golden_.scene, {0, golden_.source_depths_m.front()}, {range_m, depth_m},
                          limits_);
  }

  /// Takes the arrival with these bounces, launched within 1e-4 deg.
  std::optional<RayArrival> Take(int num_surface, int num_bottom, double launch_deg) {
    const auto found = std::ranges::find_if(left_, [&](const RayArrival& each) {
      return each.num_surface == num_surface && each.num_bottom == num_bottom &&
             std::abs(each.launch_rad / kDegree - launch_deg) < 1e-4;
    });
    if (found == left_.end()) return std::nullopt;
    const RayArrival arrival = *found;
    left_.erase(found);
    return arrival;
  }

  const std::vector<RayArrival>& left() const { return left_; }

 private:
  const BellhopCase& golden_;
  RayLimits limits_;
  double range_m_ = -1;
  double depth_m_ = -1;
  std::vector<RayArrival> left_;
};

void ExpectRow(const GoldenRow& row, const RayArrival& arrival, const BellhopCase& golden) {
  EXPECT_NEAR(arrival.delay_s, Number(row, "delay_s"), 2e-9);
  EXPECT_NEAR(arrival.launch_rad / kDegree, Number(row, "launch_deg"), 1e-5);
  EXPECT_NEAR(arrival.arrive_rad / kDegree, Number(row, "arrive_deg"), 1e-5);
  EXPECT_LT(Decibels(arrival.amplitude / Number(row, "amp")), 1e-3);
  EXPECT_LT(Decibels(arrival.reflection / Number(row, "refl")), 1e-3);
  EXPECT_NEAR(std::remainder(arrival.phase_rad / kDegree - Number(row, "phase_deg"), 360), 0, 0.01);
  EXPECT_EQ(arrival.num_caustics, std::atoi(row.at("caustics").c_str()));
  EXPECT_NEAR(arrival.delay_s, Number(row, "o_delay_s"), 0.2e-6);
  EXPECT_LT(Decibels(arrival.amplitude / Number(row, "o_amp")), 0.1);
  EXPECT_NEAR(arrival.launch_rad / kDegree, Number(row, "o_launch_deg"), 0.1);
  if (golden.has_thorp_absorption) {
    const double nepers = ThorpOfBellhop(golden.scene.hz) / 8685.889638065035 * arrival.length_m;
    const double expected = Number(row, "delay_im_s");
    EXPECT_NEAR(-nepers / (2 * std::numbers::pi * golden.scene.hz), expected,
                1e-6 * std::abs(expected));
  }
}

class GoldenArrivals : public testing::TestWithParam<const char*> {};

TEST_P(GoldenArrivals, AreFoundWhereTheyAreOk) {
  const std::string name = GetParam();
  const BellhopCase golden = GoldenCase(name);
  Receiver receiver(golden);
  int num_ok = 0;
  for (const GoldenRow& row : ReadGoldenCsv("rays/" + name + ".csv")) {
    receiver.Place(Number(row, "r_m"), Number(row, "z_m"));
    const std::string& flag = row.at("flag");
    const int num_surface = std::atoi(row.at("n_top").c_str());
    const int num_bottom = std::atoi(row.at("n_bot").c_str());
    const auto arrival = receiver.Take(num_surface, num_bottom, Number(row, "launch_deg"));
    SCOPED_TRACE(row.at("r_m") + " m, " + row.at("z_m") + " m, launched at " +
                 row.at("launch_deg"));
    if (flag.find("edge") == std::string::npos) {
      EXPECT_TRUE(arrival.has_value()) << flag;
    }
    if (flag != "ok" || !arrival) continue;
    ++num_ok;
    ExpectRow(row, *arrival, golden);
  }
  EXPECT_GT(num_ok, 5);
}

TEST_P(GoldenArrivals, AreAllThatThereAre) {
  const std::string name = GetParam();
  const BellhopCase golden = GoldenCase(name);
  Receiver receiver(golden);
  const std::vector<GoldenRow> rows = ReadGoldenCsv("rays/" + name + ".csv");
  for (size_t i = 0; i < rows.size(); ++i) {
    receiver.Place(Number(rows[i], "r_m"), Number(rows[i], "z_m"));
    static_cast<void>(receiver.Take(std::atoi(rows[i].at("n_top").c_str()),
                                    std::atoi(rows[i].at("n_bot").c_str()),
                                    Number(rows[i], "launch_deg")));
    const bool is_last = i + 1 == rows.size() || rows[i + 1].at("r_m") != rows[i].at("r_m") ||
                         rows[i + 1].at("z_m") != rows[i].at("z_m");
    if (!is_last) continue;
    for (const RayArrival& more : receiver.left()) {
      EXPECT_LT(more.reflection, 0.005) << rows[i].at("r_m") << " m, " << rows[i].at("z_m")
                                        << " m, launched at " << more.launch_rad / kDegree;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, GoldenArrivals,
                         testing::Values("iso_rigid", "grad_up", "grad_down", "munk", "thermocline",
                                         "duct", "slope_down", "slope_up", "grid_bottom",
                                         "bottom_sand", "bottom_mud", "bottom_rock", "surface_loss",
                                         "surface_swell", "range_dep", "near_edges", "shadow",
                                         "channel_30km"),
                         [](const auto& scenario) { return std::string(scenario.param); });

TEST(GoldenArrivals, AreNoneInTheShadows) {
  const auto count = [](const std::string& name, double range_m, double depth_m) {
    const BellhopCase golden = GoldenCase(name);
    RayLimits limits;
    limits.max_launch_rad = golden.last_launch_rad;
    return FindEigenrays(golden.scene, {0, golden.source_depths_m.front()}, {range_m, depth_m},
                         limits)
        .size();
  };
  EXPECT_EQ(count("munk", 30'000, 800), 0U);
  EXPECT_EQ(count("munk", 30'000, 1300), 0U);
  EXPECT_EQ(count("shadow", 2500, 40), 0U);
  EXPECT_EQ(count("shadow", 3500, 40), 0U);
}

class GoldenLevels : public testing::TestWithParam<const char*> {};

TEST_P(GoldenLevels, AreTheSumsOfTheArrivals) {
  const std::string name = GetParam();
  const BellhopCase golden = GoldenCase(name);
  Receiver receiver(golden);
  const double omega = 2 * std::numbers::pi * golden.scene.hz;
  const double absorption_dbpkm = golden.has_thorp_absorption ? ThorpOfBellhop(golden.scene.hz) : 0;
  for (const GoldenRow& row : ReadGoldenCsv("rays/" + name + ".csv")) {
    receiver.Place(Number(row, "r_m"), Number(row, "z_m"));
    std::complex<double> pressure = 0;
    double power = 0;
    for (const RayArrival& arrival : receiver.left()) {
      const double one = PowerOf(arrival, absorption_dbpkm);
      power += one;
      pressure += std::polar(std::sqrt(one), arrival.phase_rad - omega * arrival.delay_s);
    }
    EXPECT_NEAR(-10 * std::log10(power), Number(row, "tl_inc_db"), 0.05) << row.at("r_m");
    EXPECT_NEAR(-20 * std::log10(std::abs(pressure)), Number(row, "tl_coh_db"),
                Number(row, "coh_db_per_10ns") / 10 + 0.02)
        << row.at("r_m");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, GoldenLevels,
                         testing::Values("tl_iso_sand", "tl_thermocline", "tl_slope"),
                         [](const auto& scenario) { return std::string(scenario.param); });

}  // namespace shoal::golden_arrivals_test

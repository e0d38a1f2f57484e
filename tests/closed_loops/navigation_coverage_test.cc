// Does the ellipse hold the truth as often as it claims? Whole missions of Remus 100s that turn, in
// currents that are drawn for each seed, with five ways to navigate: the truth moves as the
// vehicle's model does, not as the filter assumes.
//
// SHOAL_SEEDS=300 runs that many seeds instead of 40 and prints the shares.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"
#include "lib/mission/file/load.h"
#include "lib/vehicle/navigation/chi_square.h"
#include "sim/simulation.h"

namespace shoal::navigation_coverage_test {

constexpr int kNumPhases = 3;
constexpr double kDuration_s = 900;

struct Way {
  const char* name;
  const char* navigation;
};

constexpr std::array<Way, 5> kWays = {{
    {"reckons", R"(grade = "survey", gps = {fitted = false}, dvl = {fitted = false},
       ranging = {fitted = false})"},
    {"dvl", R"(grade = "survey", gps = {fitted = false}, dvl = {max_altitude_m = 300},
       ranging = {fitted = false})"},
    {"one_way", R"(grade = "survey", gps = {fitted = false}, dvl = {fitted = false},
       clock = {phase_sigma_ms = 5, drift_sigma_ppm = 5})"},
    {"low_cost", R"(grade = "low_cost", gps = {fitted = false},
       clock = {phase_sigma_ms = 5, drift_sigma_ppm = 5})"},
    {"usbl", R"(grade = "low_cost", gps = {fitted = false},
       ranging = {usbl = true, max_range_m = 600})"},
}};

/// The current is drawn as the filters assume it: 0.3 m/s of each component.
std::string MissionOf(uint64_t seed) {
  Stream draws(seed, "coverage current");
  const double east_mps = 0.3 * draws.Normal();
  const double north_mps = 0.3 * draws.Normal();
  std::string text = fmt::format(
      "[mission]\nduration_s = {}\nseed = {}\n[environment]\n"
      "current = {{speed_mps = {}, direction_deg = {}}}\n"
      "floor = {{style = \"flat\", depth_m = 200}}\n",
      kDuration_s, seed, std::hypot(east_mps, north_mps),
      Wrap360(RadToDeg(HeadingOf({east_mps, north_mps}))));
  const std::array<std::array<int, 3>, 3> places = {
      {{-300, 500, 0}, {900, 500, 3}, {300, -600, 6}}};
  for (const auto& [x_m, y_m, offset_s] : places) {
    text += fmt::format(
        "[[beacon]]\nname = \"b{}\"\npoint = [{}, {}]\ndepth_m = 150\nkind = \"one_way\"\n"
        "offset_s = {}\n",
        offset_s, x_m, y_m, offset_s);
  }
  text +=
      "[[beacon]]\nname = \"middle\"\npoint = [250, 100]\ndepth_m = 190\nkind = \"two_way\"\n"
      "interval_s = 20\n[template.auv]\nmodel = \"remus100\"\n"
      "helm_options = {deploy_at_start = true}\n";
  const std::array<double, kWays.size()> speeds_mps = {1.5, 2, 2, 1.5, 1.2};
  for (size_t i = 0; i < kWays.size(); ++i) {
    std::string navigation = kWays[i].navigation;
    for (char& letter : navigation) letter = letter == '\n' ? ' ' : letter;
    text += fmt::format(
        "[[vehicle]]\nname = \"{}\"\ntemplate = \"auv\"\nstart = {{x_m = {}, heading_deg = 90, "
        "depth_m = 20}}\nnavigation = {{report_every_s = 5, {}}}\n"
        "[[vehicle.task]]\nkind = \"path_follow\"\nspeed_mps = {}\nend = \"return_to_first\"\n"
        "points = [[0, 0, 20], [500, 0, 20], [500, 150, 30], [0, 150, 20], [250, 300, 20]]\n",
        kWays[i].name, -20.0 * static_cast<double>(i), navigation, speeds_mps[i]);
  }
  return text;
}

/// How often the ellipse held the truth, of how many times; in each phase of the mission.
struct Tally {
  std::array<int, kNumPhases> inside = {};
  std::array<int, kNumPhases> all = {};
  double most_m = 0;  ///< The farthest off.
};

/// The error of the estimate, squared and over its covariance.
double Distance2(const nav_t& truth, const navigation_t& estimate) {
  const double x_m = truth.x_m - estimate.x_m;
  const double y_m = truth.y_m - estimate.y_m;
  const double determinant = estimate.variance_x_m2 * estimate.variance_y_m2 -
                             estimate.covariance_xy_m2 * estimate.covariance_xy_m2;
  return (x_m * x_m * estimate.variance_y_m2 + y_m * y_m * estimate.variance_x_m2 -
          2 * x_m * y_m * estimate.covariance_xy_m2) /
         determinant;
}

void RunSeed(uint64_t seed, std::array<Tally, kWays.size()>* tallies) {
  const LoadedMission loaded = LoadMissionText(MissionOf(seed), "coverage.toml");
  for (const std::string& error : loaded.errors) FAIL() << error;
  Simulation simulation(loaded.mission, "");
  struct Pair {
    nav_t truth{};
    navigation_t estimate{};
  };
  std::array<Pair, kWays.size()> pairs = {};
  const auto compare = [&](size_t i) {
    const nav_t& truth = pairs[i].truth;
    const navigation_t& estimate = pairs[i].estimate;
    if (truth.utime != estimate.utime) return;
    const double time_s = static_cast<double>(estimate.utime - loaded.mission.start_utime) / 1e6;
    const auto phase =
        std::min(size_t{kNumPhases - 1}, static_cast<size_t>(time_s / (kDuration_s / kNumPhases)));
    const double distance2 = Distance2(truth, estimate);
    Tally& tally = (*tallies)[i];
    ++tally.all[phase];
    if (distance2 <= ChiSquareQuantile(2, 0.95)) ++tally.inside[phase];
    tally.most_m =
        std::max(tally.most_m, std::hypot(truth.x_m - estimate.x_m, truth.y_m - estimate.y_m));
  };
  for (size_t i = 0; i < kWays.size(); ++i) {
    Subscribe(simulation.bus(), channels::Nav(kWays[i].name), [&, i](const nav_t& nav) {
      pairs[i].truth = nav;
      compare(i);
    });
    Subscribe(simulation.bus(), channels::Navigation(kWays[i].name),
              [&, i](const navigation_t& estimate) {
                pairs[i].estimate = estimate;
                compare(i);
              });
  }
  while (simulation.Step()) {
  }
}

TEST(NavigationCoverage, TheEllipseHoldsTheTruthOfTheVehicleInEachPhaseOfTheMission) {
  const char* asked = std::getenv("SHOAL_SEEDS");
  const int num_seeds = asked == nullptr ? 40 : std::max(1, std::atoi(asked));
  std::array<Tally, kWays.size()> tallies;
  for (int seed = 1; seed <= num_seeds; ++seed) RunSeed(static_cast<uint64_t>(seed), &tallies);
  // The shares of 40 seeds scatter by 3 %, since one vehicle's errors are alike. Of 300 seeds two
  // of the 15 shares miss what is asked here, by 0.1 and 0.4 % (docs/vehicles/navigation.md).
  const double least = asked == nullptr ? 0.86 : 0.92;
  const double greatest = asked == nullptr ? 1 : 0.98;
  for (size_t i = 0; i < kWays.size(); ++i) {
    std::string line = fmt::format("{:10}", kWays[i].name);
    for (int phase = 0; phase < kNumPhases; ++phase) {
      ASSERT_GT(tallies[i].all[phase], 10 * num_seeds);
      const double share = static_cast<double>(tallies[i].inside[phase]) / tallies[i].all[phase];
      EXPECT_GE(share, least) << kWays[i].name << ", phase " << phase;
      EXPECT_LE(share, greatest) << kWays[i].name << ", phase " << phase;
      line += fmt::format(" {:6.1f} %", 100 * share);
    }
    if (asked != nullptr) fmt::print("{}, at most {:.1f} m off\n", line, tallies[i].most_m);
  }
}

}  // namespace shoal::navigation_coverage_test

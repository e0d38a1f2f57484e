// [vehicle.navigation], [[beacon]], what needs them, and their errors.
#include <gtest/gtest.h>

#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/mission/file/load_testing.h"

namespace shoal::load_navigation_test {

NavigationOptions NavigationOf(const std::string& more) {
  const LoadedMission loaded = LoadMissionText(std::string(kShortest) + more, "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return loaded.mission.vehicles.at(0).navigation;
}

TEST(LoadNavigation, IsNotFittedWithoutItsTable) { EXPECT_FALSE(NavigationOf("").is_fitted); }

TEST(LoadNavigation, HasTheDefaultsOfItsGrade) {
  NavigationOptions survey = NavigationOfGrade(NavigationGrade::kSurvey);
  survey.is_fitted = true;
  EXPECT_EQ(NavigationOf("[vehicle.navigation]\n"), survey);
  NavigationOptions low_cost = NavigationOfGrade(NavigationGrade::kLowCost);
  low_cost.is_fitted = true;
  EXPECT_EQ(NavigationOf("[vehicle.navigation]\ngrade = \"low_cost\"\n"), low_cost);
  EXPECT_FALSE(low_cost.dvl.fitted);
}

TEST(LoadNavigation, ChangesSingleKeysOfItsGrade) {
  const NavigationOptions options = NavigationOf(
      "[vehicle.navigation]\ngrade = \"low_cost\"\ndvl = {fitted = true, rate_hz = 5}\n"
      "[vehicle.navigation.compass]\ndeviation_deg = [0, 2, -1, 0.5, 0]\n");
  EXPECT_TRUE(options.dvl.fitted);
  EXPECT_EQ(options.dvl.rate_hz, 5);
  EXPECT_EQ(options.compass.noise_deg, 1);
  EXPECT_EQ(options.compass.deviation_deg, (std::vector<double>{0, 2, -1, 0.5, 0}));
}

TEST(LoadNavigation, BecomesInstrumentsInRadiansAndSeconds) {
  NavigationOptions options;
  options.gyro.bias_degph = 36;
  options.gyro.noise_deg_per_rth = 6;
  options.gyro.bias_walk_degph_per_rth = 216;
  options.compass.deviation_deg = {1, 2, 3, 4, 5};
  options.clock.phase_ms = 3;
  options.gps.fitted = false;
  const InstrumentOptions instruments = InstrumentsOf(options, 1480);
  EXPECT_NEAR(instruments.gyro.bias_radps, DegToRad(0.01), 1e-15);
  EXPECT_NEAR(instruments.gyro.noise_rad_per_rts, DegToRad(0.1), 1e-15);
  EXPECT_NEAR(instruments.gyro.bias_walk_radps_per_rts, DegToRad(0.001), 1e-15);
  EXPECT_NEAR(instruments.compass.deviation.d, DegToRad(4), 1e-15);
  EXPECT_NEAR(instruments.clock.phase_s, 0.003, 1e-15);
  EXPECT_FALSE(instruments.gps.has_value());
  EXPECT_EQ(instruments.ranging.value().sound_speed_mps, 1480);
}

TEST(LoadNavigation, RefusesTwoWaysOfKnowingThePosition) {
  EXPECT_EQ(ErrorsAfter("[vehicle.sensors]\n[vehicle.navigation]\n"),
            "6:1: a vehicle with [vehicle.navigation] knows where it is by its filter: leave "
            "[vehicle.sensors] out, or this table\n");
}

TEST(LoadNavigation, RefusesAVehicleThatIsNotSimulated) {
  EXPECT_EQ(ErrorsAfter("vehicle_sim = \"none\"\n[vehicle.navigation]\n"),
            "6:1: its filter runs in vehicle_sim, which this vehicle does not have: leave "
            "[vehicle.navigation] out\n");
}

TEST(LoadNavigation, RefusesADeviationWithSeveralReadingsForOneHeading) {
  const std::string begin = "[vehicle.navigation.compass]\ndeviation_deg = ";
  EXPECT_EQ(ErrorsAfter(begin + "[0, 1, 2]\n"),
            "6:17: deviation_deg needs five coefficients, [A, B, C, D, E], like [0, 2, -1, 0.5, "
            "0]\n");
  EXPECT_EQ(ErrorsAfter(begin + "[0, 28.6, 0, 0, 0]\n"), "");
  EXPECT_EQ(ErrorsAfter(begin + "[0, 28.7, 0, 0, 0]\n"),
            "6:17: |B| + |C| + 2 |D| + 2 |E| must be at most 28.6 degrees, and |A| at most 180: "
            "beyond that one heading has several readings\n");
}

TEST(LoadBeacons, ReadsEachKind) {
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) +
          "[vehicle.navigation]\n[acoustics]\n"
          "[[beacon]]\nname = \"a\"\npoint = [1, 2]\ndepth_m = 3\nturnaround_s = 0.5\n"
          "[[beacon]]\nname = \"b\"\npoint = [1, 2]\nkind = \"one_way\"\ninterval_s = 4\n"
          "[[beacon]]\nname = \"c\"\npoint = [1, 2]\nkind = \"packets\"\nsender = \"ALPHA\"\n",
      "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  ASSERT_EQ(loaded.mission.beacons.size(), 3U);
  EXPECT_EQ(loaded.mission.beacons[0].turnaround_s, 0.5);
  EXPECT_EQ(loaded.mission.beacons[1].interval_s, 4);
  EXPECT_EQ(loaded.mission.beacons[2].sender, "alpha");
}

TEST(LoadBeacons, RefusesPacketsWithoutANetworkAndNamesThatExist) {
  EXPECT_EQ(ErrorsAfter("[vehicle.navigation]\n"
                        "[[beacon]]\nname = \"a\"\npoint = [1, 2]\n"
                        "[[beacon]]\nname = \"A\"\npoint = [1, 2]\n"
                        "[[beacon]]\nname = \"c\"\npoint = [1, 2]\nkind = \"packets\"\n"
                        "sender = \"alpha\"\n"),
            "10:8: a beacon 'A' exists already; names must differ in more than case\n"
            "15:8: there are no packets without an acoustic network: write [acoustics], or kind = "
            "\"one_way\"\n");
}

TEST(LoadBeacons, WarnsWhereNoVehicleTakesRanges) {
  const LoadedMission loaded = LoadMissionText(
      std::string(kShortest) + "[[beacon]]\nname = \"a\"\npoint = [1, 2]\n", "m.toml");
  EXPECT_EQ(WarningsBesideConduct(loaded),
            (std::vector<std::string>{
                "m.toml:5:1: warning: no vehicle takes ranges: give one [vehicle.navigation]"}));
}

TEST(LoadNavigation, IsNeededByTasksAndExpectationsAboutIt) {
  EXPECT_EQ(
      ErrorsAfter("[[expect]]\nkind = \"navigation_error\"\nvehicle = \"all\"\nmax_m = 3\n"),
      "7:11: alpha knows where it is: give it [vehicle.navigation], or name the vehicles that "
      "have it\n");
  EXPECT_EQ(ErrorsAfter("model = \"remus100\"\n[[vehicle.task]]\nkind = \"surface_for_fix\"\n"),
            "7:8: without GPS there is no fix to come up for: write [vehicle.navigation] under the "
            "[[vehicle]], with gps.fitted = true\n");
  EXPECT_EQ(ErrorsAfter("model = \"remus100\"\n[[vehicle.task]]\nkind = \"surface_for_fix\"\n"
                        "[vehicle.navigation]\n[[expect]]\nkind = \"navigation_error\"\n"
                        "vehicle = \"alpha\"\nmax_m = 3\n"),
            "");
}

}  // namespace shoal::load_navigation_test

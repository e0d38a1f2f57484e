#include "lib/vehicle/sensors/forward_looking_sonar.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/sea/ocean/distribution_testing.h"
#include "tests/golden/read_golden.h"

namespace shoal::forward_looking_sonar_test {

Eigen::Vector3d ReadVector(const nlohmann::json& values) {
  return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

std::vector<SonarBeam> PingOnce(const SonarParams& params, const SonarPose& pose,
                                const SeaFloor& floor, const std::vector<SonarTarget>& others,
                                int64_t number = 0) {
  const ForwardLookingSonar sonar(params);
  std::vector<SonarBeam> beams(sonar.beam_count());
  sonar.Ping(pose, {.floor = floor, .vehicles = others}, number, beams);
  return beams;
}

SonarParams OneBeam() {
  return {.azimuth_beams = 1,
          .elevation_beams = 1,
          .max_range_m = 100,
          .range_steps = 20,
          .tilt_rad = 0};
}

double RangeToWall(const SonarPose& pose, const Polygon& wall_m) {
  const ForwardLookingSonar sonar(OneBeam());
  std::vector<SonarBeam> beams(1);
  const SeaFloor deep;
  const std::vector<Polygon> walls_m = {wall_m};
  sonar.Ping(pose, {.floor = deep, .walls_m = walls_m}, 0, beams);
  return beams[0].is_echo ? beams[0].range_m : -1;
}

const Polygon kRock = {{40, -10}, {60, -10}, {60, 10}, {40, 10}};

TEST(ForwardLookingSonar, SeesAnObstacleFromTheSurfaceToTheFloor) {
  for (const double z_m : {0.0, 20.0, 500.0}) {
    EXPECT_NEAR(RangeToWall({.position_m = {0, 0, z_m}}, kRock), 40, 1e-9) << z_m;
  }
  EXPECT_NEAR(RangeToWall({.position_m = {0, 5, 20}, .theta_rad = DegToRad(60)}, kRock), 80, 1e-9)
      << "along a beam that climbs at 60 degrees it is twice as far";
}

TEST(ForwardLookingSonar, SeesNoObstacleBesideAsternOrBeyondItsReach) {
  EXPECT_EQ(RangeToWall({.position_m = {0, 11, 20}}, kRock), -1);
  EXPECT_EQ(RangeToWall({.position_m = {70, 0, 20}}, kRock), -1);
  EXPECT_EQ(RangeToWall({.position_m = {-61, 0, 20}}, kRock), -1);
  EXPECT_NEAR(RangeToWall({.position_m = {-59, 0, 20}}, kRock), 99, 1e-9);
}

TEST(ForwardLookingSonar, InsideAnObstacleSeesItAtRangeZero) {
  EXPECT_EQ(RangeToWall({.position_m = {50, 0, 20}}, kRock), 0);
}

TEST(ForwardLookingSonar, SeesTheNearerOfObstacleAndVehicle) {
  const ForwardLookingSonar sonar(OneBeam());
  std::vector<SonarBeam> beams(1);
  const SeaFloor deep;
  const std::vector<Polygon> walls_m = {kRock};
  const std::vector<SonarTarget> vehicles = {{.position_m = {30, 0, 20}, .radius_m = 2}};
  sonar.Ping({.position_m = {0, 0, 20}}, {.floor = deep, .vehicles = vehicles, .walls_m = walls_m},
             0, beams);
  EXPECT_NEAR(beams[0].range_m, 28, 1e-9);
}

TEST(ForwardLookingSonar, SeesWhatMunetsSees) {
  int echoes_of_vehicles = 0;
  int directions = 0;
  for (const auto& golden : ReadGoldenJson("munet/forward_looking_sonar.json")) {
    const SonarParams params{.azimuth_beams = golden.at("nBeamsAz"),
                             .elevation_beams = golden.at("nBeamsEl"),
                             .max_range_m = golden.at("maxRange"),
                             .range_steps = golden.at("nStepsRange"),
                             .tilt_rad = DegToRad(golden.at("tilt_deg")),
                             .width_rad = DegToRad(golden.at("hFov_deg")),
                             .height_rad = DegToRad(golden.at("vFov_deg"))};
    const auto& eta = golden.at("eta");
    std::vector<SonarTarget> others;
    for (const auto& other : golden.at("others")) {
      others.push_back({ReadVector(other.at("pos")), other.at("L")});
    }
    const std::vector<SonarBeam> beams = PingOnce(params, {ReadVector(eta), eta[3], eta[4], eta[5]},
                                                  FlatFloor(golden.at("floor_z")), others);
    size_t i = 0;
    for (size_t azimuth = 0; azimuth < golden.at("ranges_az_el").size(); ++azimuth) {
      for (size_t elevation = 0; elevation < golden.at("ranges_az_el")[0].size(); ++elevation) {
        const SonarBeam& beam = beams.at(i++);
        const double range_m = golden.at("ranges_az_el")[azimuth][elevation];
        EXPECT_NEAR(beam.range_m, range_m, 1e-12 * range_m) << azimuth << " " << elevation;
        if (std::fmod(range_m, 5) != 0) ++echoes_of_vehicles;
        if (golden.at("dirs_az_el").is_null()) continue;
        ++directions;
        EXPECT_TRUE(beam.direction.isApprox(ReadVector(golden.at("dirs_az_el")[azimuth][elevation]),
                                            1e-12));
      }
    }
    EXPECT_EQ(i, beams.size());
  }
  EXPECT_GT(echoes_of_vehicles, 10);
  EXPECT_GT(directions, 100);
}

TEST(ForwardLookingSonar, SeesTheFloorInStepsOfItsRange) {
  SonarParams params = OneBeam();
  params.tilt_rad = kPi / 6;  // The floor, 16 m below, is 32 m along the beam.
  const SonarBeam beam = PingOnce(params, {.position_m = {0, 0, 4}}, FlatFloor(20), {})[0];
  EXPECT_TRUE(beam.is_echo);
  EXPECT_EQ(beam.range_m, 35);
}

TEST(ForwardLookingSonar, SeesASphereWhereTheBeamEntersIt) {
  const SonarBeam beam = PingOnce(OneBeam(), {}, SeaFloor(), {{{50, 0, 0}, 3}})[0];
  EXPECT_TRUE(beam.is_echo);
  EXPECT_DOUBLE_EQ(beam.range_m, 47);
}

TEST(ForwardLookingSonar, SeesASphereWhoseMiddleIsOutOfRange) {
  EXPECT_DOUBLE_EQ(PingOnce(OneBeam(), {}, SeaFloor(), {{{102, 0, 0}, 3}})[0].range_m, 99);
}

TEST(ForwardLookingSonar, SeesTheNearestOfAll) {
  const std::vector<SonarTarget> others = {{{70, 0, 0}, 3}, {{50, 0, 0}, 3}, {{60, 0, 0}, 3}};
  EXPECT_DOUBLE_EQ(PingOnce(OneBeam(), {}, SeaFloor(), others)[0].range_m, 47);
}

TEST(ForwardLookingSonar, SeesNothingBesideBehindOrTooFarAway) {
  for (const SonarTarget& other : std::vector<SonarTarget>{
           {{50, 3.01, 0}, 3}, {{-50, 0, 0}, 3}, {{104, 0, 0}, 3}, {{50, 0, 0}, 0}}) {
    const SonarBeam beam = PingOnce(OneBeam(), {}, SeaFloor(), {other})[0];
    EXPECT_FALSE(beam.is_echo);
    EXPECT_EQ(beam.range_m, 100);
  }
}

TEST(ForwardLookingSonar, SeesWhatSurroundsItAtZeroRangeInEveryBeam) {
  const SonarPose pose{.position_m = {1, 2, 3}};
  for (const Eigen::Vector3d& position_m :
       {pose.position_m, Eigen::Vector3d(0, 2, 3), Eigen::Vector3d(2, 2, 3)}) {
    for (const SonarBeam& beam : PingOnce({}, pose, SeaFloor(), {{position_m, 1.6}})) {
      EXPECT_TRUE(beam.is_echo);
      EXPECT_EQ(beam.range_m, 0);
    }
  }
}

TEST(ForwardLookingSonar, TurnsWithTheHull) {
  const SonarPose north{.position_m = {0, 0, 10}, .psi_rad = kPi / 2};
  EXPECT_TRUE(
      PingOnce(OneBeam(), north, SeaFloor(), {})[0].direction.isApprox(Eigen::Vector3d::UnitY()));
  const SonarPose bow_up{.position_m = {0, 0, 10}, .theta_rad = 0.3};
  EXPECT_LT(PingOnce(OneBeam(), bow_up, SeaFloor(), {})[0].direction.z(), 0);
}

TEST(ForwardLookingSonar, SeesPortAndStarboardAlike) {
  const auto ranges = [](double y) {
    return PingOnce({}, {.position_m = {0, 0, 10}}, FlatFloor(30), {{{40, y, 12}, 1.6}});
  };
  const std::vector<SonarBeam> one = ranges(6);
  const std::vector<SonarBeam> other = ranges(-6);
  for (size_t azimuth = 0; azimuth < 11; ++azimuth) {
    for (size_t elevation = 0; elevation < 5; ++elevation) {
      EXPECT_NEAR(one[azimuth * 5 + elevation].range_m,
                  other[(10 - azimuth) * 5 + elevation].range_m, 1e-9);
    }
  }
}

TEST(SonarNoise, IsGaussianOnWhatIsSeenAndNowhereElse) {
  SonarParams params = OneBeam();
  params.azimuth_beams = 2;  // One of them sees the target.
  params.width_rad = kPi / 2;
  params.range_noise = {.sigma = 0.2, .key = StreamKey(4, "sonar")};
  const Eigen::Vector3d seen_at(std::cos(kPi / 4) * 50, std::sin(kPi / 4) * 50, 0);
  std::vector<double> errors_m;
  for (int number = 0; number < 2000; ++number) {
    const std::vector<SonarBeam> beams = PingOnce(params, {}, SeaFloor(), {{seen_at, 3}}, number);
    EXPECT_EQ(beams[0].range_m, 100);
    errors_m.push_back(beams[1].range_m - 47);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors_m, [](double e) { return NormalCumulative(e / 0.2); }),
            kKolmogorov999);
}

TEST(SonarNoise, OfOneBeamDoesNotDependOnWhatOthersSee) {
  SonarParams params;
  params.range_noise = {.sigma = 0.2, .key = StreamKey(4, "sonar")};
  const SonarPose pose{.position_m = {0, 0, 20}};
  const std::vector<SonarBeam> without = PingOnce(params, pose, FlatFloor(30), {});
  const std::vector<SonarBeam> with = PingOnce(params, pose, FlatFloor(30), {{{20, -9, 20}, 1.6}});
  size_t changed = 0;
  for (size_t i = 0; i < with.size(); ++i) {
    if (with[i].range_m != without[i].range_m) ++changed;
  }
  EXPECT_GT(changed, 0U);
  EXPECT_LT(changed, 11U);
}

RC_GTEST_PROP(ForwardLookingSonar, GivesFiniteRangesAndUnitVectorsForAnyScene, ()) {
  const auto any = [] {
    const double value = *rc::gen::arbitrary<double>();
    return std::isfinite(value) ? value : 0.0;
  };
  const SonarPose pose{{any(), any(), any()}, any(), any(), any()};
  const std::vector<SonarTarget> others = {{{any(), any(), any()}, std::abs(any())}};
  SonarParams params;
  params.range_noise.sigma = *rc::gen::element(0.0, 1e5);
  for (const SonarBeam& beam : PingOnce(params, pose, FlatFloor(50), others)) {
    RC_ASSERT(beam.range_m >= 0);
    RC_ASSERT(beam.range_m <= params.max_range_m);
    RC_ASSERT(std::abs(beam.direction.norm() - 1) < 1e-9);
  }
}

TEST(SonarParameters, ThatAreNonsenseAreFound) {
  EXPECT_TRUE(IsSonar({}));
  for (const double nonsense :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0}) {
    for (double SonarParams::*number : {&SonarParams::max_range_m, &SonarParams::width_rad,
                                        &SonarParams::height_rad, &SonarParams::rate_hz}) {
      SonarParams params;
      params.*number = nonsense;
      EXPECT_FALSE(IsSonar(params)) << nonsense;
    }
  }
  SonarParams params;
  params.azimuth_beams = 0;
  EXPECT_FALSE(IsSonar(params));
  params = {};
  params.range_steps = 1'000'000;
  EXPECT_FALSE(IsSonar(params));
}

}  // namespace shoal::forward_looking_sonar_test

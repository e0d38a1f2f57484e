// Objective functions of behaviors of one vessel, held against those of MOOS-IvP's helm
// (tests/golden/README.md, helm/).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "lib/helm/behaviors/constant_heading.h"
#include "lib/helm/behaviors/constant_speed.h"
#include "lib/helm/behaviors/loiter.h"
#include "lib/helm/behaviors/op_region.h"
#include "lib/helm/behaviors/station_keep.h"
#include "lib/helm/behaviors/vessel_testing.h"
#include "lib/helm/behaviors/waypoint.h"
#include "tests/golden/read_golden.h"

namespace shoal::one_vessel_golden_test {

using Points = std::vector<Eigen::Vector2d>;

const Points kOctagon = {{11, 28},   {28, 11},   {28, -11}, {11, -28},
                         {-11, -28}, {-28, -11}, {-28, 11}, {-11, 28}};

/// How far the values of one kind are off.
struct Deviations {
  int num_functions = 0;
  double greatest = 0;
  double mean = 0;
  std::string worst_state = {};
};

class GoldenFunctions : public testing::Test {
 protected:
  using Make = std::function<std::unique_ptr<Behavior>()>;

  /// Makes a fresh behavior for each state, runs it there, and compares. `enters`: in the
  /// iteration before, the vessel was at (0, 0).
  static Deviations Compare(const std::string& title, const Make& make, bool enters = false) {
    static const std::vector<GoldenRow> states = ReadGoldenCsv("helm/states.csv");
    static const std::vector<GoldenRow> functions = ReadGoldenCsv("helm/functions.csv");
    Deviations deviations;
    int num_values = 0;
    for (const GoldenRow& row : functions) {
      if (row.at("behavior") != title) continue;
      const GoldenRow& state = states.at(static_cast<size_t>(Number(row, "state")) - 1);
      const std::unique_ptr<Behavior> behavior = make();
      TestVessel vessel;
      if (enters) (void)vessel.Run(*behavior);
      vessel.own.motion = {.position_m = {Number(state, "osx"), Number(state, "osy")},
                           .heading_deg = Number(state, "osh"),
                           .speed_mps = Number(state, "osv")};
      const BehaviorAnswer answer = vessel.RunAt(*behavior, 0.25);
      const auto values = row.find("values");
      const bool has_values = values != row.end() && !values->second.empty();
      EXPECT_EQ(answer.objective.has_value(), has_values) << title << " " << state.at("state");
      EXPECT_EQ(answer.error, "");
      if (!has_values || !answer.objective) continue;
      ++deviations.num_functions;
      std::istringstream numbers(values->second);
      for (int course = 0; course < 360; course += 10) {
        for (int speed = 0; speed <= 40; speed += 5) {
          double golden = 0;
          EXPECT_TRUE(numbers >> golden);
          const double off = std::abs(ValueAt(*answer.objective, course, speed) - golden);
          deviations.mean += off;
          ++num_values;
          if (off <= deviations.greatest) continue;
          deviations.greatest = off;
          deviations.worst_state = state.at("state");
        }
      }
    }
    if (num_values > 0) deviations.mean /= num_values;
    return deviations;
  }

  static void ExpectEqual(const std::string& title, int num_functions, double tolerance,
                          const Make& make, bool enters = false) {
    const Deviations deviations = Compare(title, make, enters);
    EXPECT_EQ(deviations.num_functions, num_functions);
    EXPECT_LE(deviations.greatest, tolerance) << "state " << deviations.worst_state;
    RecordProperty(title, std::to_string(deviations.greatest));
  }

  static WaypointOptions Waypoint(const std::string& ipf_type, double lead_m) {
    return {.points = {{100, 0}, {100, 100}},
            .speed = 2,
            .lead = lead_m,
            .lead_damper = lead_m > 0 ? 1.0 : -1.0,
            .ipf_type = ipf_type};
  }

  static LoiterOptions Loiter(const std::string& clockwise, const std::string& ipf_type) {
    return {.polygon = kOctagon,
            .speed = 1.5,
            .clockwise = clockwise,
            .radius = 8,
            .slip_radius = 15,
            .ipf_type = ipf_type};
  }
};

TEST_F(GoldenFunctions, OfTheWaypointAreThoseOfTheOriginal) {
  ExpectEqual("waypoint_zaic", 48, 0.02,
              [] { return std::make_unique<WaypointBehavior>(Waypoint("zaic", 8)); });
  ExpectEqual("waypoint_zaic_spd", 48, 0.02,
              [] { return std::make_unique<WaypointBehavior>(Waypoint("zaic_spd", -1)); });
}

TEST_F(GoldenFunctions, OfTheApproachAreNearThePiecesOfTheOriginal) {
  const Deviations deviations = Compare("waypoint_roc_pieces", [] {
    return std::make_unique<WaypointBehavior>(Waypoint("roc", -1));
  });
  EXPECT_EQ(deviations.num_functions, 48);
  EXPECT_LT(deviations.mean, 0.2);
  EXPECT_LT(deviations.greatest, 1) << "state " << deviations.worst_state;
  RecordProperty("mean", std::to_string(deviations.mean));
  RecordProperty("greatest", std::to_string(deviations.greatest));
}

TEST_F(GoldenFunctions, OfTheLoiterAreThoseOfTheOriginal) {
  ExpectEqual("loiter_zaic", 48, 0.02,
              [] { return std::make_unique<LoiterBehavior>(Loiter("false", "zaic")); });
  ExpectEqual("loiter_zaic_spd", 48, 0.02,
              [] { return std::make_unique<LoiterBehavior>(Loiter("true", "zaic_spd")); });
}

TEST_F(GoldenFunctions, OfTheStationAreThoseOfTheOriginal) {
  ExpectEqual("station_keep", 48, 0.02, [] {
    return std::make_unique<StationKeepBehavior>(
        StationKeepOptions{.station_pt = Eigen::Vector2d(0, 0),
                           .inner_radius = 10,
                           .outer_radius = 40,
                           .outer_speed = 1,
                           .transit_speed = 2});
  });
}

TEST_F(GoldenFunctions, OfTheOpRegionAreThoseOfTheOriginal) {
  ExpectEqual(
      "opregion_v24", 40, 0.1,
      [] {
        return std::make_unique<OpRegionBehavior>(
            OpRegionOptions{.core_poly = {{-20, -20}, {-20, 20}, {20, 20}, {20, -20}},
                            .save_dist = 5,
                            .recover_spd = 0.8});
      },
      true);
}

TEST_F(GoldenFunctions, OfOneVariableAreThoseOfTheOriginal) {
  ExpectEqual("constant_heading", 1, 0.02, [] {
    return std::make_unique<ConstantHeadingBehavior>(ConstantHeadingOptions{.heading = 45});
  });
  ExpectEqual("constant_speed", 1, 0.02, [] {
    return std::make_unique<ConstantSpeedBehavior>(ConstantSpeedOptions{.speed = 1.3});
  });
}

}  // namespace shoal::one_vessel_golden_test

// Encounters in closed loops, held against the tracks of MOOS-IvP's helm (tests/golden/README.md,
// helm/). docs/vehicles/colregs.md lists what differs, and why.
#include "tests/closed_loops/meeting_vessels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include "lib/base/geometry/angles.h"
#include "tests/golden/read_golden.h"

namespace shoal::meeting_vessels_test {

/// As the golden runs: contacts stand still between reports, or go on and decay; 2 x 45 s.
const MeetingOptions kFrozen = {
    .contacts = {.max_age_s = 90, .decay_start_s = 0, .decay_end_s = 0}};
const MeetingOptions kExtrapolated = {.contacts = {.max_age_s = 90}};
const MeetingOptions kDefault;

Meeting Sail(const std::string& scenario, const MeetingOptions& options) {
  static const nlohmann::json scenarios = ReadGoldenJson("helm/scenarios.json");
  return RunMeeting(scenarios.at(scenario), options);
}

/// How far one vessel's track is off, at the full seconds.
struct Difference {
  double distance_m = 0;
  double share_of_headings = 0;   ///< Off by more than 3 degrees.
  double share_of_positions = 0;  ///< Off by more than 0.5 m.
};

Difference Compare(const Meeting& meeting, const std::string& scenario, const std::string& vessel) {
  Difference difference;
  size_t num_rows = 0;
  const auto& track = meeting.tracks.at(vessel);
  for (const GoldenRow& row : ReadGoldenCsv("helm/tracks/" + scenario + ".csv")) {
    if (row.at("vehicle") != vessel) continue;
    const VesselMotion& motion = track.at(num_rows++).motion;
    const double distance_m =
        (motion.position_m - Eigen::Vector2d(Number(row, "x"), Number(row, "y"))).norm();
    const double turned_deg = Wrap180(motion.heading_deg - Number(row, "heading"));
    difference.distance_m = std::max(difference.distance_m, distance_m);
    if (std::abs(turned_deg) > 3) ++difference.share_of_headings;
    if (distance_m > 0.5) ++difference.share_of_positions;
  }
  EXPECT_EQ(num_rows, track.size());
  difference.share_of_headings /= static_cast<double>(num_rows);
  difference.share_of_positions /= static_cast<double>(num_rows);
  return difference;
}

struct GoldenMeeting {
  double closest_m = 0;
  std::string modes_of_a = {};
  std::string modes_of_b = {};
};

GoldenMeeting Golden(const std::string& scenario, const std::string& a, const std::string& b) {
  for (const GoldenRow& row : ReadGoldenCsv("helm/encounters.csv")) {
    if (row.at("scenario") == scenario && row.at("a") == a && row.at("b") == b) {
      return {.closest_m = Number(row, "min_distance_m"),
              .modes_of_a = row.at("modes_of_a_towards_b"),
              .modes_of_b = row.at("modes_of_b_towards_a")};
    }
  }
  ADD_FAILURE() << scenario << " has no pair " << a << ", " << b;
  return {};
}

/// Golden names of modes as ours, without the last one, "complete".
std::string InOurWords(const std::string& modes) {
  static const std::map<std::string, std::string> kNames = {{"headon", "head-on"},
                                                            {"giveway", "give-way"},
                                                            {"standon", "stand-on"},
                                                            {"standon_ot", "overtaken"}};
  std::istringstream words(modes);
  std::string ours;
  for (std::string word; words >> word;) {
    if (word == "complete") break;
    const auto name = kNames.find(word);
    ours += (ours.empty() ? "" : " ") + (name == kNames.end() ? word : name->second);
  }
  return ours;
}

void ExpectNearGolden(const Meeting& meeting, const std::string& scenario, double distance_m,
                      double share_of_headings = 0.13) {
  for (const auto& [name, track] : meeting.tracks) {
    const Difference difference = Compare(meeting, scenario, name);
    EXPECT_LE(difference.distance_m, distance_m) << scenario << " " << name;
    // A turn that begins one decision later is off by 4 degrees for as long as it lasts.
    EXPECT_LE(difference.share_of_headings, share_of_headings) << scenario << " " << name;
    ::testing::Test::RecordProperty("off_" + name, std::to_string(difference.distance_m));
  }
}

void ExpectSameRoles(const Meeting& meeting, const std::string& scenario, const std::string& a,
                     const std::string& b) {
  const GoldenMeeting golden = Golden(scenario, a, b);
  EXPECT_EQ(meeting.roles.at({a, b}), InOurWords(golden.modes_of_a)) << a << " to " << b;
  EXPECT_EQ(meeting.roles.at({b, a}), InOurWords(golden.modes_of_b)) << b << " to " << a;
}

TEST(HeadOnAvoid, RunsAsTheOriginal) {
  const Meeting meeting = Sail("headon_avoid", kFrozen);
  ExpectNearGolden(meeting, "headon_avoid", 2);
  EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden("headon_avoid", "abe", "ben").closest_m, 1);
}

TEST(HeadOnColregs, RunsAsTheOriginal) {
  const Meeting meeting = Sail("headon_colregs", kFrozen);
  ExpectNearGolden(meeting, "headon_colregs", 2);
  ExpectSameRoles(meeting, "headon_colregs", "abe", "ben");
  EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden("headon_colregs", "abe", "ben").closest_m, 1);
}

TEST(HeadOnColregs, PassesPortToPortOnTracksThatAreEachOthersImage) {
  const Meeting meeting = Sail("headon_colregs", kDefault);
  const auto& abe = meeting.tracks.at("abe");
  const auto& ben = meeting.tracks.at("ben");
  double apart_m = 0;
  double farthest_south_m = 0;
  for (size_t i = 0; i < 140; ++i) {
    // Turned by 180 degrees about (100, 0).
    const Eigen::Vector2d image_m = Eigen::Vector2d(200, 0) - ben[i].motion.position_m;
    apart_m = std::max(apart_m, (abe[i].motion.position_m - image_m).norm());
    farthest_south_m = std::min(farthest_south_m, abe[i].motion.position_m.y());
  }
  EXPECT_LE(apart_m, 1);
  EXPECT_LT(farthest_south_m, -10);  // Eastbound: to starboard.
  EXPECT_GE(meeting.ClosestOf("abe", "ben"), 0.9 * 25);
}

TEST(CrossingColregs, RunsAsTheOriginal) {
  const Meeting meeting = Sail("crossing_colregs", kFrozen);
  ExpectNearGolden(meeting, "crossing_colregs", 2);
  ExpectSameRoles(meeting, "crossing_colregs", "abe", "ben");
  EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden("crossing_colregs", "abe", "ben").closest_m,
              1);
}

TEST(CrossingColregs, LetsTheVesselThatStandsOnHoldCourseAndSpeed) {
  const Meeting meeting = Sail("crossing_colregs", kDefault);
  for (const MeetingRow& row : meeting.tracks.at("ben")) {
    if (row.time_s > 140) break;  // At its last point it stops.
    EXPECT_NEAR(Wrap180(row.motion.heading_deg), 0, 1) << row.time_s;
    EXPECT_NEAR(row.motion.speed_mps, 2, 0.1) << row.time_s;
  }
}

TEST(OvertakingColregs, RunsAsTheOriginalWithoutItsFlicker) {
  const Meeting meeting = Sail("overtaking_colregs", kFrozen);
  ExpectNearGolden(meeting, "overtaking_colregs", 2);
  EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden("overtaking_colregs", "abe", "ben").closest_m,
              1);
  // The original has 81 main modes in a row, most of them while the two are abreast.
  EXPECT_EQ(meeting.roles.at({"abe", "ben"}), "overtaking cpa none");
  EXPECT_LE(meeting.num_role_changes.at({"abe", "ben"}), 6);
}

TEST(ThreeVesselsColregs, RunsAsTheOriginal) {
  const std::string scenario = "three_vessels_colregs";
  const Meeting meeting = Sail(scenario, kFrozen);
  ExpectNearGolden(meeting, scenario, 2);
  for (const auto& [a, b] : {std::pair("abe", "ben"), {"abe", "cal"}, {"ben", "cal"}}) {
    EXPECT_NEAR(meeting.ClosestOf(a, b), Golden(scenario, a, b).closest_m, 1) << a << " " << b;
    ExpectSameRoles(meeting, scenario, a, b);
  }
}

TEST(LostReports, AreAsDangerousWithoutExtrapolationAsInTheOriginal) {
  for (const char* scenario : {"headon_avoid_lost_40s", "headon_avoid_lost_for_good"}) {
    const Meeting meeting = Sail(scenario, kFrozen);
    ExpectNearGolden(meeting, scenario, 2);
    EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden(scenario, "abe", "ben").closest_m, 2);
  }
}

TEST(LostReports, AreBridgedByExtrapolation) {
  for (const char* scenario :
       {"headon_avoid_lost_40s_extrapolated", "headon_avoid_lost_for_good_extrapolated"}) {
    const Meeting meeting = Sail(scenario, kExtrapolated);
    ExpectNearGolden(meeting, scenario, 2, 0.25);
    EXPECT_NEAR(meeting.ClosestOf("abe", "ben"), Golden(scenario, "abe", "ben").closest_m, 2);
    // And so with the age limit that a mission has without a word.
    EXPECT_GE(Sail(scenario, kDefault).ClosestOf("abe", "ben"),
              Golden(scenario, "abe", "ben").closest_m - 1);
  }
}

TEST(LostReports, EndTheAvoidanceOnceAtTheAgeLimit) {
  const Meeting meeting = Sail("headon_avoid_lost_for_good_extrapolated", kExtrapolated);
  int num_ends = 0;
  for (const auto& [time_s, event] : meeting.events) {
    if (event.find("abe: end avd_ben") == std::string::npos) continue;
    ++num_ends;
    EXPECT_GE(time_s, 114.5 - 0.25);  // The last report is of 24.5 s.
    EXPECT_LE(time_s, 115.25);
  }
  EXPECT_EQ(num_ends, 1);
}

TEST(Trail, FollowsTheOriginalButForTheChoiceAmongEqualInterceptions) {
  const Meeting meeting = Sail("trail", kFrozen);
  EXPECT_LE(Compare(meeting, "trail", "lead").distance_m, 0.5);
  const Difference tail = Compare(meeting, "trail", "tail");
  EXPECT_LE(tail.distance_m, 4);
  EXPECT_LE(tail.share_of_positions, 0.25);
}

}  // namespace shoal::meeting_vessels_test

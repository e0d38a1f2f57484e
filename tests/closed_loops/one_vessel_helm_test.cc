// Behaviors of one vessel in closed loops, held against the tracks of MOOS-IvP's helm
// (tests/golden/README.md, helm/). Each is run directly: conditions and flags are
// BehaviorSet's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lib/helm/behaviors/op_region.h"
#include "lib/helm/behaviors/waypoint.h"
#include "lib/helm/decision/decide.h"
#include "tests/closed_loops/kinematic_vessel.h"
#include "tests/golden/read_golden.h"

namespace shoal::one_vessel_helm_test {

using Points = std::vector<Eigen::Vector2d>;

struct Aim {
  double pwt = 100;
  std::unique_ptr<Behavior> behavior;
};

/// Something that a behavior posts or sets off.
struct Happening {
  double time_s = 0;
  std::string what;

  bool operator==(const Happening&) const = default;
};

/// A line of a track.
struct TrackRow {
  double time_s = 0;
  VesselMotion motion = {};
  KinematicCommand command = {};
};

struct Track {
  std::vector<TrackRow> rows = {};
  std::vector<Happening> happenings = {};

  std::vector<double> TimesOf(const std::string& what) const {
    std::vector<double> times_s;
    for (const Happening& happening : happenings) {
      if (happening.what == what) times_s.push_back(happening.time_s);
    }
    return times_s;
  }
};

/// A helm without conditions: every behavior runs until it completes.
class PlainHelm {
 public:
  PlainHelm(std::vector<Aim> aims, const VesselMotion& start)
      : aims_(std::move(aims)), motion_(start) {
    command_ = {.heading_deg = start.heading_deg, .speed_mps = 0};
  }

  Track Drive(double from_s, double to_s) {
    constexpr int kStepsPerDecision = 5;
    constexpr int kStepsPerRow = 20;
    Track track;
    const auto last = static_cast<int>(std::lround(to_s / kVesselStep_s));
    for (auto step = static_cast<int>(std::lround(from_s / kVesselStep_s)); step <= last; ++step) {
      const double time_s = step * kVesselStep_s;
      if (step % kStepsPerDecision == 0) Decide(time_s, track);
      if (step % kStepsPerRow == 0) {
        track.rows.push_back({.time_s = time_s, .motion = motion_, .command = command_});
      }
      motion_ = Step(motion_, command_);
    }
    return track;
  }

  void Replace(std::vector<Aim> aims) { aims_ = std::move(aims); }

 private:
  void Decide(double time_s, Track& track) {
    const BehaviorInputs inputs = {
        .time_s = time_s, .own = {.motion = motion_}, .domain = &domain_};
    std::vector<WeightedObjective> objectives;
    AllowedPart allowed;
    std::string error;
    for (Aim& aim : aims_) {
      if (aim.behavior == nullptr) continue;
      BehaviorAnswer answer = aim.behavior->Run(inputs);
      for (const std::string& flag : answer.flags) track.happenings.push_back({time_s, flag});
      for (const VariablePost& post : answer.posts) Note(time_s, post, track);
      if (!answer.error.empty()) error = answer.error;
      if (answer.completes) aim.behavior.reset();
      Restrict(&allowed, answer.allowed);
      if (!answer.objective) continue;
      objectives.push_back(
          {.weight = aim.pwt * answer.relevance, .objective = *std::move(answer.objective)});
    }
    if (!error.empty()) {
      track.happenings.push_back({time_s, error});
      command_ = {.heading_deg = motion_.heading_deg, .speed_mps = 0};
      return;
    }
    const DomainPoint point = shoal::Decide(domain_, objectives, allowed).point;
    if (point.course && point.speed) {
      num_empty_ = 0;
      command_ = {.heading_deg = static_cast<double>(*point.course),
                  .speed_mps = domain_.speed_mps.At(*point.speed)};
    } else if (++num_empty_ > 1) {
      command_ = {.heading_deg = motion_.heading_deg, .speed_mps = 0};
    }
  }

  void Note(double time_s, const VariablePost& post, Track& track) {
    if (post.variable != "WPT_INDEX" || post.value == last_index_) return;
    last_index_ = post.value;
    track.happenings.push_back({time_s, "WPT_INDEX"});
  }

  std::vector<Aim> aims_;
  VesselMotion motion_;
  KinematicCommand command_ = {};
  Domain domain_ = {};
  VariableValue last_index_ = {};
  int num_empty_ = 0;
};

void ExpectTrack(const Track& track, const std::string& name, double tolerance_m) {
  double farthest_m = 0;
  double at_s = 0;
  size_t num_compared = 0;
  for (const GoldenRow& row : ReadGoldenCsv("helm/tracks/" + name + ".csv")) {
    const double time_s = Number(row, "t");
    const auto same_time = [&](const TrackRow& mine) { return mine.time_s == time_s; };
    const auto mine = std::find_if(track.rows.begin(), track.rows.end(), same_time);
    if (mine == track.rows.end()) continue;
    ++num_compared;
    const Eigen::Vector2d golden_m(Number(row, "x"), Number(row, "y"));
    const double off_m = (mine->motion.position_m - golden_m).norm();
    if (off_m > farthest_m) {
      farthest_m = off_m;
      at_s = time_s;
    }
  }
  EXPECT_EQ(num_compared, track.rows.size());
  EXPECT_LE(farthest_m, tolerance_m) << "at " << at_s << " s";
  testing::Test::RecordProperty(name, std::to_string(farthest_m));
}

/// Expects that something happened at the times at which the original's file has it, to one tick.
void ExpectTimes(const Track& track, const std::string& what, const std::vector<double>& golden_s) {
  const std::vector<double> times_s = track.TimesOf(what);
  ASSERT_EQ(times_s.size(), golden_s.size()) << what;
  for (size_t i = 0; i < times_s.size(); ++i) EXPECT_NEAR(times_s[i], golden_s[i], 0.2501) << what;
}

std::unique_ptr<Behavior> Leading(const Points& points) {
  return std::make_unique<WaypointBehavior>(WaypointOptions{.points = points,
                                                            .speed = 2,
                                                            .capture_radius = 5,
                                                            .slip_radius = 15,
                                                            .lead = 8,
                                                            .lead_damper = 1,
                                                            .lead_to_start = true});
}

std::vector<Aim> OneAim(std::unique_ptr<Behavior> behavior) {
  std::vector<Aim> aims;
  aims.push_back({.behavior = std::move(behavior)});
  return aims;
}

TEST(OneVesselHelm, FollowsTheSquareAsTheOriginalDoes) {
  PlainHelm helm(OneAim(Leading({{100, 0}, {100, 100}, {0, 100}, {0, 0}})), {});
  const Track track = helm.Drive(0, 260);
  ExpectTrack(track, "waypoint_alone", 0.5);
  ExpectTimes(track, "WPT_INDEX", {0, 50.75, 100.75, 150.75});
  ExpectTimes(track, "cycleflag", {200.75});
}

TEST(OneVesselHelm, FollowsThePolygonOfAlphaAndReturns) {
  const VesselMotion start = {.position_m = {0, -20}, .heading_deg = 180};
  const Points polygon = {{60, -40}, {60, -160}, {150, -160}, {180, -100}, {150, -40}};
  PlainHelm helm(OneAim(std::make_unique<WaypointBehavior>(WaypointOptions{.points = polygon,
                                                                           .speed = 3,
                                                                           .speed_alt = 1.2,
                                                                           .use_alt_speed = true,
                                                                           .capture_radius = 5,
                                                                           .slip_radius = 15,
                                                                           .capture_line = true,
                                                                           .lead = 8,
                                                                           .lead_damper = 1,
                                                                           .lead_to_start = true})),
                 start);
  // The return begins one iteration after the survey has ended.
  Track track = helm.Drive(1, 332.7);
  helm.Replace(OneAim(std::make_unique<WaypointBehavior>(
      WaypointOptions{.points = {{0, -20}}, .speed = 2, .capture_radius = 2, .slip_radius = 8})));
  const Track back = helm.Drive(332.75, 520);
  track.rows.insert(track.rows.end(), back.rows.begin(), back.rows.end());
  ExpectTrack(track, "s1_alpha", 0.5);
  ExpectTimes(track, "WPT_INDEX", {1, 51.5, 150, 223.25, 277.75});
  ExpectTimes(track, "cycleflag", {332.5});
  ExpectTimes(back, "cycleflag", {409.5});
}

const Points kRegion = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};

std::vector<Aim> OutOf(const OpRegionOptions& region, double pwt) {
  std::vector<Aim> aims = OneAim(Leading({{150, 0}}));
  aims.push_back({.pwt = pwt, .behavior = std::make_unique<OpRegionBehavior>(region)});
  return aims;
}

const VesselMotion kEastward = {.heading_deg = 90};

TEST(OneVesselHelm, StopsOutsideItsRegionAsTheOldOpRegionDoes) {
  PlainHelm helm(OutOf({.core_poly = kRegion, .look_ahead = 0}, 100), kEastward);
  const Track track = helm.Drive(0, 60);
  ExpectTrack(track, "opregion_old_exit", 0.5);
  ExpectTimes(track, "breached_poly_flag", {27.5});
}

// The original's shares of course and speed change by turns. So do these.
TEST(OneVesselHelm, TurnsBackAtTheBorderAsOpRegionV24Does) {
  PlainHelm helm(OutOf({.core_poly = kRegion,
                        .save_dist = 5,
                        .halt_dist = 20,
                        .look_ahead = 0,
                        .recover_patience = {95, 80, 50, 20, 5}},
                       300),
                 kEastward);
  const Track track = helm.Drive(0, 120);
  ExpectTrack(track, "opregion_v24", 0.5);
  ASSERT_FALSE(track.TimesOf("save_flag").empty());
  EXPECT_NEAR(track.TimesOf("save_flag").front(), 29.5, 0.2501);
}

TEST(OneVesselHelm, StaysNearerToItsRegionWithoutTheOriginalsTurns) {
  const OpRegionOptions region = {.core_poly = kRegion, .save_dist = 5, .halt_dist = 20};
  PlainHelm helm(OutOf(region, 300), kEastward);
  double farthest_m = 0;
  const Track track = helm.Drive(0, 120);
  for (const TrackRow& row : track.rows) {
    farthest_m = std::max(farthest_m, row.motion.position_m.x());
  }
  ASSERT_FALSE(track.TimesOf("save_flag").empty());
  EXPECT_NEAR(track.TimesOf("save_flag").front(), 29.5, 0.2501);
  EXPECT_TRUE(track.TimesOf("breached_poly_flag").empty());
  EXPECT_LT(farthest_m, 62.4);
  testing::Test::RecordProperty("farthest", std::to_string(farthest_m));
}

TEST(OneVesselHelm, StaysInsideARegionThatItsGoalLiesOutsideOf) {
  PlainHelm helm(OutOf({.core_poly = kRegion}, 100), kEastward);
  double farthest_m = 0;
  const Track track = helm.Drive(0, 120);
  for (const TrackRow& row : track.rows) {
    farthest_m = std::max(farthest_m, row.motion.position_m.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(farthest_m, 49);  // It comes to the border, and not beyond.
  EXPECT_LE(farthest_m, 50);
  EXPECT_TRUE(track.TimesOf("breached_poly_flag").empty());
  testing::Test::RecordProperty("farthest", std::to_string(farthest_m));
}

}  // namespace shoal::one_vessel_helm_test

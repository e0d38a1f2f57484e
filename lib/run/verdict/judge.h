// Decides whether a mission achieves what it must, from what its vehicles did.
//
//   Judge judge(mission);
//   judge.TakeNav(0, position_m);              // what was published in the step of utime,
//   judge.TakeHelm(0, helm, utime);            // in any order,
//   judge.tally().fates(Kind::kReport).Add("alpha", "bravo", "delivered");
//   judge.EndStep(utime);                      // then this, once per step
//   for (const ExpectationVerdict& verdict : judge.Verdicts()) ...
//
// Vehicles are counted in the mission's order.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/helm/encounters/encounter_watch.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/model/mission.h"
#include "lib/run/verdict/arrival_watch.h"
#include "lib/run/verdict/coverage_watch.h"
#include "lib/run/verdict/extreme_watch.h"
#include "lib/run/verdict/fate_counts.h"
#include "lib/run/verdict/fate_tally.h"
#include "lib/run/verdict/outcome.h"
#include "lib/run/verdict/separation_watch.h"
#include "lib/sea/ocean/current_grid.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/vehicle/collision_watch.h"
#include "lib/vehicle/vehicle/grounding_watch.h"
#include "lib/vehicle/vehicle/obstacle_watch.h"

namespace shoal {

/// What became of one expectation.
struct ExpectationVerdict {
  std::string where;  ///< "file:line" of the expectation.
  std::string text;   ///< What was expected.
  bool passed = false;
  std::string numbers;  ///< What decided; on failure by how much: "closest: alpha-bravo 7.3 m ...".
  /// The number that decided; of several vehicles the worst one's, which is the one that has none
  /// where there is such a one. Absent: an arrival that never was, nothing offered, nothing seen.
  std::optional<double> value = {};
  std::string_view unit = {};         ///< Of `value`: UnitOf. Of static storage.
  std::optional<double> margin = {};  ///< MarginOf `value`.
};

/// What a helm reported last.
struct HelmFacts {
  std::string state;
  std::string task;
  int64_t laps_done = 0;                           ///< Of `task`.
  std::optional<double> cross_track_error_m = {};  ///< Absent: the task has no track.
};

/// What became of the messages that a member of the swarm received from one sender, so far.
struct SwarmShares {
  int64_t clean = 0;
  int64_t recovered = 0;
  int64_t rejected = 0;
};

/// Two vehicles that touched, or one and an obstacle, and when.
struct CollisionFact {
  Collision collision;       ///< Vehicles by their places in the mission.
  double time_s = 0;         ///< Mission time since the start.
  bool is_obstacle = false;  ///< collision.second is the place of an obstacle.
};

/// A vehicle that ran aground: where, when, and how deep the water is there.
struct GroundingFact {
  size_t vehicle = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  double floor_m = 0;
  double time_s = 0;  ///< Mission time since the start.
};

class Judge {
 public:
  static constexpr size_t kMaxCollisions = 1000;  ///< More are counted and not kept.
  static constexpr size_t kMaxGroundings = 1000;  ///< More are counted and not kept.

  /// `mission` must outlive this.
  explicit Judge(const Mission& mission);

  /// Takes a vehicle's true position (x East, y North, z down). Ignores numbers that are not finite
  /// or no place on Earth, and returns false then. `altitude_m` above the sea floor, negative where
  /// unknown.
  bool TakeNav(size_t vehicle, const Eigen::Vector3d& position_m, double altitude_m = -1);
  /// Takes a vehicle's heading and speed relative to the water, after its position. Ignores numbers
  /// that are not finite, and returns false then. Without them it has no encounters.
  bool TakeMotion(size_t vehicle, double heading_deg, double speed_mps);
  /// Takes where a vehicle believes to be. Ignores numbers that are not finite.
  void TakeEstimate(size_t vehicle, const Eigen::Vector2d& position_m);
  void TakeHelm(size_t vehicle, const HelmFacts& helm, int64_t utime);
  /// Takes what a member's acomms counts of one sender.
  void TakeSwarm(size_t vehicle, const std::string& sender, const SwarmShares& shares);
  /// Returns what became of messages of the swarm: clean, recovered, rejected.
  const FateCounts& swarm_counts() const { return swarm_counts_; }
  FateTally& tally() { return tally_; }
  const FateTally& tally() const { return tally_; }

  /// Evaluates the positions of all vehicles.
  void EndStep(int64_t utime);

  /// Returns one verdict per expectation, in the mission's order, should the mission end now.
  [[nodiscard]] std::vector<ExpectationVerdict> Verdicts() const;

  /// Returns the collisions so far: InContact, once per encounter
  /// (lib/vehicle/vehicle/collision_watch.h). Positions are compared where both came in the same
  /// step.
  const std::vector<CollisionFact>& collisions() const { return collisions_; }
  int64_t num_collisions() const { return num_collisions_; }
  /// Returns where vehicles ran aground so far: the floor of the mission's map lies at their keel,
  /// or above it. Not for what is moored; a recorded track's are in Warnings instead.
  const std::vector<GroundingFact>& groundings() const { return groundings_; }
  int64_t num_groundings() const { return num_groundings_; }
  /// Returns true if every expectation is met when the mission ends now, and no vehicle has
  /// collided or run aground, unless [mission] allows that.
  [[nodiscard]] bool Passed() const;
  /// Returns why the verdict may mean little: no vehicle deployed, none that moved, vehicles that
  /// received no report, expectations met from the start. One sentence each.
  [[nodiscard]] std::vector<std::string> Warnings() const;

  /// Returns what finds the encounters of the first expectation that asks for them, or nullptr.
  const EncounterWatch* encounter_watch() const {
    return encounters_.empty() ? nullptr : &encounters_.front();
  }

  const Sighting& sighting(size_t vehicle) const { return sightings_[vehicle]; }
  std::span<const Sighting> sightings() const { return sightings_; }
  /// Returns how far the vehicle went, from one position taken to the next.
  double travelled_m(size_t vehicle) const { return travelled_m_[vehicle]; }
  /// Returns what the vehicle's helm reported last, or nothing.
  const std::optional<HelmFacts>& helm(size_t vehicle) const { return helms_[vehicle]; }

 private:
  /// How far one vehicle came with the laps that an expectation asks for.
  struct LapsWatch {
    int64_t most = 0;                 ///< Laps done.
    std::optional<double> reached_s;  ///< When it was enough.
  };
  /// One expectation and what is watched for it: one watch per vehicle that it names.
  struct Case {
    const Expectation* expectation = nullptr;
    std::vector<size_t> vehicles;
    std::vector<ArrivalWatch> arrivals;
    std::vector<LapsWatch> laps;
    std::vector<ExtremeWatch> extremes;     ///< Of a track, distance, altitude or estimate.
    size_t encounters = 0;                  ///< Which of encounters_, of expectations of these.
    std::optional<CoverageWatch> coverage;  ///< Of all its vehicles together.
  };

  Judge(const Mission& mission, Ocean ocean);
  std::vector<size_t> VehiclesNamed(std::string_view name) const;
  int PlaceInCounts(std::string_view name) const;
  double SecondsSinceStart(int64_t utime) const;

  Outcome FindSeparation(const SeparationExpectation& separation) const;
  Outcome FindComms(const CommsExpectation& comms) const;
  Outcome FindHelm(const HelmExpectation& helm, size_t vehicle) const;
  void WatchCollisions(double time_s);
  void WatchGroundings(double time_s);
  void WatchEncounters(double time_s);
  std::string VehiclesWithoutReports() const;
  void WatchExtremes(Case* each, double time_s) const;
  Outcome FindLaps(const LapsExpectation& expected, const LapsWatch& watch) const;
  std::vector<Outcome> FindForVehicles(const Case& each) const;
  static std::optional<double> WorstValue(const Case& each, const std::vector<Outcome>& outcomes);
  Outcome Combine(const Case& each, const std::vector<Outcome>& outcomes) const;

  const Mission& mission_;
  std::shared_ptr<const CurrentGrid> current_grid_;  ///< Null: the mission has none.
  std::optional<SeaFloor> floor_;                    ///< Absent: the depth is not known.
  double floor_shallowest_m_;                        ///< Of floor_, anywhere.
  std::vector<bool> was_off_grid_;                   ///< Of the current.
  std::vector<Sighting> sightings_;
  std::vector<double> altitudes_m_;
  std::vector<std::optional<Eigen::Vector2d>> estimates_m_;
  std::vector<double> travelled_m_;
  std::vector<std::optional<HelmFacts>> helms_;
  FateTally tally_;
  FateCounts swarm_counts_;                                           ///< By outcome.
  std::map<std::pair<size_t, std::string>, SwarmShares> swarm_last_;  ///< By member and sender.
  std::vector<bool> has_left_park_;
  std::vector<Eigen::Vector3d> positions_m_;  ///< As sightings_ has them.
  std::vector<uint32_t> moved_now_;           ///< Vehicles whose position came in this step.
  CollisionWatch collision_watch_;
  ObstacleWatch obstacle_watch_;
  std::vector<CollisionFact> collisions_;
  int64_t num_collisions_ = 0;
  GroundingWatch grounding_watch_;
  std::vector<GroundingFact> groundings_;
  int64_t num_groundings_ = 0;
  std::vector<bool> has_track_in_ground_;
  SeparationWatch separation_;
  bool watches_separation_ = false;
  std::vector<VesselSample> motions_;       ///< For encounters.
  std::vector<double> motion_s_;            ///< When each was taken; < 0: never.
  std::vector<bool> has_new_motion_;        ///< Since the last step.
  std::vector<EncounterWatch> encounters_;  ///< One for each set of options.
  std::vector<Case> cases_;
};

}  // namespace shoal

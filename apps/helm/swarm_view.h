// What a helm knows of its swarm. By `swarm = "direct"` the truth of every other vehicle, as their
// NAV had it a step before; by `swarm = "acoustic"` what SWARM has of them, predicted from the
// time of their reports to now.
//
//   SwarmView swarm(mission, vehicle);
//   for (size_t i = 0; i < swarm.names().size(); ++i) {
//     SubscribeAs<NavNeighbour>(... swarm.OnNav(i, neighbour));
//   }
//   Subscribe(... swarm.OnSwarm(swarm_message));
//   fix.surroundings = swarm.Look(task, nav);
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/vehicle/guidance/echo_memory.h"
#include "lib/vehicle/guidance/surroundings.h"
#include "lib/vehicle/guidance/task.h"
#include "shoal/nav_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/swarm_t.hpp"

namespace shoal {

/// A vehicle as its NAV has it: the same for all that follow it.
struct NavNeighbour {
  explicit NavNeighbour(const nav_t& nav);

  Neighbour neighbour;        ///< Its id is for the receiver to fill in.
  bool is_plausible = false;  ///< Finite, and no farther or faster than the laws take.
};

class SwarmView {
 public:
  SwarmView(const Mission& mission, const Vehicle& vehicle);

  /// The vehicles whose NAV its tasks need: targets and groups, each once.
  const std::vector<std::string>& names() const { return names_; }

  /// Takes note of where another vehicle is, by its place in names(). What is not plausible is
  /// passed over.
  void OnNav(size_t place_in_names, const NavNeighbour& nav);
  /// Takes note of what acomms knows. Contacts with invalid numbers are passed over.
  void OnSwarm(const swarm_t& swarm);
  /// Takes note of what the sonar saw; it counts for kSonarMemory_s.
  void OnSonar(const sonar_t& ping);

  /// Returns what a task has to go by, valid until the next call; nullptr for tasks that neither
  /// follow a vehicle nor keep clear of any.
  const Surroundings* Look(const Task* task, const nav_t& own);

 private:
  /// Vehicles are known by their places in the mission.
  using Place = size_t;

  /// What a task wants to know of others. Pointers are into the task.
  struct Interest {
    const std::string* target = nullptr;              ///< nullptr: it follows none.
    const std::vector<std::string>* group = nullptr;  ///< nullptr: of no group.
    SwarmKnowledge swarm = SwarmKnowledge::kDirect;
    double smoothing_mps = 0;
    const VelocityCascade* cascade = nullptr;  ///< nullptr: it has another law.
  };

  /// The places that a task names, as its last Look had them.
  struct Cast {
    bool has_group = false;
    std::string target;
    std::vector<std::string> group;
    std::optional<Place> target_place;
    std::vector<Place> group_places;  ///< Without the target.
  };

  /// Returns nothing for tasks that go by no other vehicle and no sonar.
  static std::optional<Interest> InterestOf(const Task& task);
  /// Returns the members of the group that a task is interested in.
  std::vector<Place> MembersOf(const Interest& interest) const;
  const Cast& CastOf(const Interest& interest);
  std::optional<Place> PlaceOf(const std::string& name) const;
  /// Returns where another vehicle is at `utime`, by the knowledge that the task goes by.
  std::optional<Neighbour> Find(SwarmKnowledge swarm, Place place, int64_t utime) const;
  /// Moves `target` back to where it was expected before its last report came; from there it goes
  /// to where that puts it at `rate_mps`, beside its own motion. 0: at once.
  void Smooth(double rate_mps, Place place, int64_t utime, Neighbour* target);
  bool IsSilent(const swarm_contact_t& contact, int64_t utime) const;
  /// Fills echoes_ from the last ping, as seen with the attitude of `own`, and from memory for as
  /// long as the cascade's layers want to remember.
  void LookAhead(const VelocityCascade* cascade, const nav_t& own);

  std::map<std::string, Place> places_;
  Place own_;
  std::map<Place, std::vector<Place>> followers_;  ///< Of each target; not itself. By name.
  std::vector<Place> divers_;                      ///< The other underwater vehicles, by name.
  std::vector<std::string> names_;
  std::vector<Place> places_of_names_;
  std::optional<Cast> cast_;
  double silent_after_s_;
  std::vector<std::optional<Neighbour>> neighbours_;      ///< By NAV.
  std::vector<std::optional<swarm_contact_t>> contacts_;  ///< By acomms.
  /// The target of the last Look.
  struct Smoothed {
    Place place = 0;
    int64_t utime = 0;
    swarm_contact_t contact;                            ///< What the position went by then.
    Eigen::Vector3d ahead_m = Eigen::Vector3d::Zero();  ///< From the prediction to what was seen.
  };
  std::optional<Smoothed> smoothed_;
  std::vector<Neighbour> group_;
  sonar_t ping_{};
  std::vector<SonarEcho> echoes_;
  EchoMemory memory_;
  std::optional<int64_t> remembered_utime_;  ///< Of the last ping that it took.
  Surroundings surroundings_;
};

}  // namespace shoal

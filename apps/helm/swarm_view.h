// What a helm knows of its swarm, by `swarm = "direct"`: the truth of every other vehicle, as their
// NAV told it a step before.
//
//   SwarmView swarm(mission, vehicle);
//   for (const std::string& name : swarm.names()) Subscribe(... swarm.Hear(name, nav));
//   fix.surroundings = swarm.Look(task, nav);
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lib/guidance/surroundings.h"
#include "lib/guidance/task.h"
#include "lib/mission/mission.h"
#include "shoal/nav_t.hpp"

namespace shoal {

class SwarmView {
 public:
  SwarmView(const Mission& mission, const Vehicle& vehicle);

  /// Whose NAV its tasks ask for: targets and groups, each once.
  const std::vector<std::string>& names() const { return names_; }

  /// Takes note of where another vehicle is. Numbers that are not finite are passed over.
  void Hear(const std::string& name, const nav_t& nav);

  /// Returns what a task has to go by, valid until the next call; nullptr for tasks that look at
  /// nobody.
  const Surroundings* Look(const Task* task, const nav_t& own);

 private:
  /// Returns the members of a task's group.
  const std::vector<std::string>& GroupOf(const TargetTrackTask& task) const;

  std::string own_name_;
  std::map<std::string, int> ids_;                             ///< Place in the mission, by name.
  std::map<std::string, std::vector<std::string>> followers_;  ///< Of each target; not itself.
  std::vector<std::string> names_;
  std::map<std::string, Neighbour> heard_;
  std::vector<Neighbour> group_;
  Surroundings surroundings_;
};

}  // namespace shoal

// SWARM_<V> for tests.
#pragma once

#include <string>
#include <vector>

#include "shoal/swarm_t.hpp"

namespace shoal {

/// A contact that was received and was where it is at `report_utime`.
inline swarm_contact_t ContactAt(const std::string& name, int64_t report_utime,
                                 bool is_target = true) {
  swarm_contact_t contact{};
  contact.name = name;
  contact.is_target = is_target ? 1 : 0;
  contact.is_heard = contact.is_known = 1;
  contact.report_utime = report_utime;
  return contact;
}

inline swarm_t SwarmAt(int64_t utime, const std::string& vehicle,
                       std::vector<swarm_contact_t> contacts) {
  swarm_t swarm{};
  swarm.utime = utime;
  swarm.vehicle = vehicle;
  swarm.num_contacts = static_cast<int32_t>(contacts.size());
  swarm.contacts = std::move(contacts);
  return swarm;
}

inline void AddSourceTo(swarm_t* swarm, const std::string& name, int64_t clean, int64_t recovered,
                        int64_t rejected) {
  swarm_source_t source{};
  source.name = name;
  source.received = clean + recovered + rejected;
  source.clean = clean;
  source.recovered = recovered;
  source.rejected = rejected;
  swarm->sources.push_back(source);
  ++swarm->num_sources;
}

inline void AddCountTo(swarm_t* swarm, const std::string& outcome, const std::string& field,
                       const std::string& by, int64_t times) {
  swarm_count_t count{};
  count.outcome = outcome;
  count.field = field;
  count.by = by;
  count.count = times;
  swarm->counts.push_back(count);
  ++swarm->num_counts;
}

}  // namespace shoal

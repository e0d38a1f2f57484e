#include "apps/acomms/swarm_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/acomms/swarm_setup.h"
#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

template <class T>
int32_t SizeOf(const std::vector<T>& items) {
  return static_cast<int32_t>(items.size());
}

void AddCount(std::string_view outcome, std::string_view field, std::string_view by, int64_t count,
              std::vector<swarm_count_t>* counts) {
  if (count == 0) return;
  swarm_count_t row{};
  row.outcome = outcome;
  row.field = field;
  row.by = by;
  row.count = count;
  counts->push_back(row);
}

std::vector<swarm_count_t> WriteCounts(const ReceptionCounts& counts) {
  std::vector<swarm_count_t> rows;
  for (size_t field = 0; field < kNumSwarmFields; ++field) {
    for (size_t strategy = 0; strategy < kNumRecoveryStrategies; ++strategy) {
      AddCount("recovered", kSwarmFieldNames.At(field), kRecoveryStrategyNames.At(strategy),
               counts.recovered_by[field][strategy], &rows);
    }
  }
  for (size_t reason = 0; reason < kNumRejectReasons; ++reason) {
    AddCount("rejected", "", TextOf(static_cast<RejectReason>(reason)), counts.rejected_for[reason],
             &rows);
  }
  return rows;
}

}  // namespace

SwarmWriter::SwarmWriter(const Mission& mission, const Vehicle& vehicle)
    : name_(vehicle.name),
      start_utime_(mission.start_utime),
      silent_after_us_(Microseconds(OwnSwarm(mission, vehicle).silent_after_s)) {
  for (const Vehicle& each : mission.vehicles) vehicles_.push_back(each.name);
  for (const Vehicle* member : SwarmMembers(mission, vehicle))
    names_[SwarmIdOf(*member)] = member->name;
}

std::string SwarmWriter::NameOfId(int64_t id) const {
  const auto found = names_.find(static_cast<uint32_t>(id));
  return found == names_.end() ? fmt::format("id {}", id) : found->second;
}

void SwarmWriter::Count(const std::string& source, const SwarmReception& reception) {
  const bool is_known = std::find(vehicles_.begin(), vehicles_.end(), source) != vehicles_.end();
  SourceCounts& counts = sources_[is_known ? source : std::string(kOthers)];
  ++counts.received;
  if (reception.result == ReceptionResult::kRejected) {
    ++counts.rejected;
    return;
  }
  ++(reception.result == ReceptionResult::kClean ? counts.clean : counts.recovered);
  // A message of the leader may concern every member.
  if (reception.sender) recovered_[static_cast<uint32_t>(*reception.sender)].clear();
  for (const FieldRecovery& recovery : reception.recoveries) {
    if (recovery.id) recovered_[static_cast<uint32_t>(*recovery.id)].clear();
  }
  for (const FieldRecovery& recovery : reception.recoveries) {
    const std::optional<int64_t> about = recovery.id ? recovery.id : reception.sender;
    if (!about) continue;
    std::vector<std::string>& texts = recovered_[static_cast<uint32_t>(*about)];
    texts.push_back(fmt::format("{} {}", NameOf(recovery.field), NameOf(recovery.strategy)));
  }
}

swarm_contact_t SwarmWriter::WriteContact(const SwarmContact& contact, bool is_target,
                                          int64_t utime) const {
  swarm_contact_t written{};
  written.name = NameOfId(contact.id);
  written.is_target = is_target;
  written.is_heard = contact.has_reported;
  written.is_known = IsUsable(contact);
  const int64_t received_us = contact.has_reported ? contact.arrived_us : 0;
  written.heard_utime = start_utime_ + received_us;
  written.is_silent = utime - written.heard_utime > silent_after_us_;
  if (const auto found = recovered_.find(contact.id); found != recovered_.end()) {
    written.recovered = found->second;
  }
  written.num_recovered = SizeOf(written.recovered);
  if (!written.is_known) return written;
  const Motion& now = contact.report.now;
  written.report_utime = start_utime_ + contact.reported_us;
  written.x_m = now.position_m.x();
  written.y_m = now.position_m.y();
  written.z_m = now.position_m.z();
  written.x_mps = now.velocity_mps.x();
  written.y_mps = now.velocity_mps.y();
  written.z_mps = now.velocity_mps.z();
  written.has_next = is_target && KnowsNext(contact);
  if (!written.has_next) return written;
  const Motion& next = contact.report.next;
  written.next_x_m = next.position_m.x();
  written.next_y_m = next.position_m.y();
  written.next_z_m = next.position_m.z();
  written.next_x_mps = next.velocity_mps.x();
  written.next_y_mps = next.velocity_mps.y();
  written.next_z_mps = next.velocity_mps.z();
  return written;
}

swarm_t SwarmWriter::Write(const SwarmReceiver& receiver, int64_t utime) const {
  swarm_t swarm{};
  swarm.utime = utime;
  swarm.vehicle = name_;
  const GroupState& state = receiver.state;
  if (state.target) swarm.contacts.push_back(WriteContact(*state.target, true, utime));
  for (const SwarmContact& member : state.members) {
    swarm.contacts.push_back(WriteContact(member, false, utime));
  }
  swarm.num_contacts = SizeOf(swarm.contacts);
  std::vector<std::string> senders = vehicles_;
  senders.emplace_back(kOthers);
  for (const std::string& sender : senders) {
    const auto found = sources_.find(sender);
    if (found == sources_.end()) continue;
    swarm_source_t source{};
    source.name = sender;
    source.received = found->second.received;
    source.clean = found->second.clean;
    source.recovered = found->second.recovered;
    source.rejected = found->second.rejected;
    swarm.sources.push_back(source);
  }
  swarm.num_sources = SizeOf(swarm.sources);
  swarm.counts = WriteCounts(receiver.counts);
  swarm.num_counts = SizeOf(swarm.counts);
  return swarm;
}

}  // namespace shoal

#include "lib/comms/swarm/group_state.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

bool AreSame(const Motion& a, const Motion& b) {
  return a.position_m == b.position_m && a.velocity_mps == b.velocity_mps;
}

double SecondsSince(int64_t then_us, int64_t now_us) {
  return static_cast<double>(std::max<int64_t>(0, now_us - then_us)) * 1e-6;
}

}  // namespace

bool operator==(const TimedMotion& a, const TimedMotion& b) {
  return a.time_us == b.time_us && AreSame(a.motion, b.motion);
}

bool operator==(const SwarmContact& a, const SwarmContact& b) {
  const auto numbers = [](const SwarmContact& contact) {
    return std::tie(contact.id, contact.group_id, contact.is_known, contact.has_reported,
                    contact.has_answered, contact.reported_us, contact.arrived_us,
                    contact.log.entries, contact.log.capacity);
  };
  return numbers(a) == numbers(b) && AreSame(a.report.now, b.report.now) &&
         AreSame(a.report.next, b.report.next);
}

bool operator==(const GroupState& a, const GroupState& b) {
  const auto parts = [](const GroupState& state) {
    return std::tie(state.own_id, state.group_id, state.is_leader, state.members, state.target,
                    state.episode_us, state.response_order, state.response_start_us, state.request);
  };
  return parts(a) == parts(b);
}

void AppendToLog(const TimedMotion& entry, MotionLog* log) {
  std::deque<TimedMotion>& entries = log->entries;
  if (!entries.empty() && entry.time_us <= entries.back().time_us) {
    if (entry.time_us == entries.back().time_us) entries.back() = entry;
    return;
  }
  if (entries.size() >= log->capacity && log->capacity < MotionLog::kMaxCapacity) {
    ResizeLog(std::min(2 * log->capacity, MotionLog::kMaxCapacity), log);
  }
  if (entries.size() >= log->capacity) entries.pop_front();
  entries.push_back(entry);
}

void ResizeLog(size_t capacity, MotionLog* log) {
  SHOAL_CHECK(capacity > 0, "the capacity of a log is more than 0");
  log->capacity = capacity;
  std::deque<TimedMotion>& entries = log->entries;
  if (entries.size() > capacity) {
    entries.erase(entries.begin(), entries.end() - static_cast<std::ptrdiff_t>(capacity));
  }
}

std::vector<TimedMotion> LastEntries(const MotionLog& log, size_t n) {
  const size_t taken = std::min(n, log.entries.size());
  return {log.entries.end() - static_cast<std::ptrdiff_t>(taken), log.entries.end()};
}

SwarmContact PlacedContact(uint32_t id, uint8_t group_id, const Motion& motion) {
  return {
      .id = id, .group_id = group_id, .is_known = true, .report = {.now = motion, .next = motion}};
}

const SwarmContact* FindMember(const GroupState& state, int64_t id) {
  const auto found = std::find_if(state.members.begin(), state.members.end(),
                                  [&](const SwarmContact& member) { return member.id == id; });
  return found == state.members.end() ? nullptr : &*found;
}

SwarmContact* FindMember(GroupState* state, int64_t id) {
  return const_cast<SwarmContact*>(FindMember(*state, id));
}

bool IsUsable(const SwarmContact& contact) {
  const Motion& motion = contact.report.now;
  return contact.is_known && contact.reported_us >= 0 &&
         motion.position_m.x() != contact.sentinel.position_m &&
         motion.velocity_mps.x() != contact.sentinel.speed_mps;
}

bool KnowsNext(const SwarmContact& contact) {
  const Motion& next = contact.report.next;
  return contact.has_reported && next.position_m.x() != contact.sentinel.position_m &&
         next.velocity_mps.x() != contact.sentinel.speed_mps;
}

std::optional<Motion> PredictContact(const SwarmContact& contact, int64_t now_us) {
  if (!IsUsable(contact)) return std::nullopt;
  return PredictMember(contact.report.now, SecondsSince(contact.reported_us, now_us));
}

}  // namespace shoal

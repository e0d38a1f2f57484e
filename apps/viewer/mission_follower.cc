#include "apps/viewer/mission_follower.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "apps/viewer/access.h"
#include "lib/base/check/result.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"
#include "lib/run/verdict/mission_verdict.h"

namespace shoal {

namespace {

constexpr int64_t kFrameInterval_us = 1'000'000 / 15;
constexpr int64_t kIdleFrameInterval_us = 500'000;
constexpr int64_t kLookInterval_us = 250'000;
/// While there is no mission, so that little of the next is missed.
constexpr int64_t kWaitingLookInterval_us = 50'000;
/// Messages are handled in batches: to wake for each, as a wait on their sockets would, costs a
/// mission at --warp max more than the handling. Nothing else that it waits for has a descriptor:
/// frames are due by the clock, missions come and go as files.
constexpr useconds_t kPause_us = 15'000;

}  // namespace

MissionFollower::MissionFollower(const FollowOptions& options, EventHub& hub)
    : options_(options), hub_(hub), session_(std::make_shared<MissionSession>(NewToken())) {}

std::shared_ptr<MissionSession> MissionFollower::session() const {
  const std::lock_guard lock(mutex_);
  return session_;
}

std::shared_ptr<ViewSource> MissionFollower::source() const {
  {
    const std::lock_guard lock(mutex_);
    if (recording_) return recording_->source();
  }
  const std::shared_ptr<MissionSession> now = session();
  return {now, &now->view()};
}

std::shared_ptr<ChannelSource> MissionFollower::channels() const {
  const std::shared_ptr<MissionSession> now = session();
  return {now, &now->channels()};
}

PlanFile MissionFollower::plan_file() const {
  const RunningMission& running = session()->running();
  return {.file = running.file, .overrides = running.overrides};
}

std::string MissionFollower::StatusJson() { return session()->StatusJson(MonotonicMicroseconds()); }

WebAnswer MissionFollower::Command(const CommandWords& words) { return session()->Command(words); }

int MissionFollower::Run() {
  while (!stopped_) {
    const int64_t now_us = MonotonicMicroseconds();
    if (now_us >= next_look_us_) {
      Look();
      next_look_us_ = now_us + (session_->is_joined() ? kLookInterval_us : kWaitingLookInterval_us);
    }
    if (session_->is_joined()) {
      session_->Work(now_us);
      if (const std::string error = session_->error(); !error.empty()) {
        fmt::print(stderr, "shoal-viewer: {}\n", error);
        return kExitEnvironment;
      }
    }
    Show(now_us);
    usleep(kPause_us);  // kPause_us has the reason why this is not a wait for messages.
  }
  return kExitOk;
}

void MissionFollower::Look() {
  if (session_->is_joined()) LookAfterMission();
  if (!session_->is_joined()) LookForMission();
}

void MissionFollower::LookAfterMission() {
  const RunningMission& running = session_->running();
  // Before the missions are listed: listing them removes the entries of missions that have died.
  std::error_code error;
  const bool has_entry = std::filesystem::exists(EntryPath(running.port_base), error);
  const Result<std::vector<RunningMission>> missions = RunningMissions();
  const bool runs = missions.ok() && std::any_of(missions->begin(), missions->end(),
                                                 [&](const RunningMission& each) {
                                                   return each.mission_id == running.mission_id;
                                                 });
  if (runs) return;
  last_mission_id_ = running.mission_id;
  const RunningMission ended = running;
  session_->Leave(session_->is_ending() || !has_entry ? "ended" : "lost");
  ShowEnded(ended);
}

void MissionFollower::ShowEnded(const RunningMission& mission) {
  const std::optional<EndedMission> ended = FindEnded(mission.port_base, mission.mission_id);
  if (!ended) return;
  if (auto verdict = ReadVerdict(ended->verdict)) session_->view().SetVerdict(std::move(*verdict));
  if (ended->log.empty()) return;
  Result<std::unique_ptr<GrowingLog>> log = GrowingLog::Open(ended->log, "", MonotonicMicroseconds);
  if (!log.ok()) {
    fmt::print(stderr, "shoal-viewer: {}\n", log.error());
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    recording_ = std::move(*log);
  }
  hub_.EndStreams();
}

void MissionFollower::LookForMission() {
  const Result<RunningMission> found = FindRunningMission(
      options_.port_base, options_.allow_commands ? Purpose::kCommand : Purpose::kLook);
  if (!found.ok()) {
    if (found.error() != printed_) fmt::print(stderr, "shoal-viewer: waiting: {}\n", found.error());
    printed_ = found.error();
    return;
  }
  if (found->mission_id == last_mission_id_) return;
  printed_.clear();
  fmt::print(stderr, "shoal-viewer: {} ({}), LCM ports from {}\n", found->name, found->file,
             found->port_base);
  TurnTo(std::make_shared<MissionSession>(*found, NewToken(), options_.allow_commands));
}

void MissionFollower::TurnTo(std::shared_ptr<MissionSession> session) {
  {
    const std::lock_guard lock(mutex_);
    session_.swap(session);
    recording_.reset();
  }
  shown_changes_ = -1;
  hub_.EndStreams();
}

void MissionFollower::Show(int64_t now_us) {
  const bool has_readers = hub_.num_readers() > 0;
  const bool is_first = !std::exchange(had_readers_, has_readers);
  if (!has_readers) return;
  if (!has_shown_page_) {
    has_shown_page_ = true;
    fmt::print("viewer: a page is open\n");
    std::fflush(stdout);
  }
  const int64_t age_us = now_us - last_frame_us_;
  const int64_t num_changes = session_->view().num_changes();
  const bool is_due =
      num_changes != shown_changes_ ? age_us >= kFrameInterval_us : age_us >= kIdleFrameInterval_us;
  if (!is_due && !is_first) return;
  // Aligned with wall time, so that the pauses of this loop do not add up.
  last_frame_us_ = age_us < 2 * kFrameInterval_us ? last_frame_us_ + kFrameInterval_us : now_us;
  shown_changes_ = num_changes;
  hub_.Publish(session_->view().StreamFrameJson());
}

}  // namespace shoal

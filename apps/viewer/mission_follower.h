// Finds the running mission, follows it, and changes to the next when it has ended.
//
//   waiting --a mission runs--> following --its entry has gone--> ended --another runs--> following
//                                  |                                                          ^
//                                  +--its launcher died, its entry stays----> lost -------------+
//
// Of a mission that has ended it shows the verdict, and the recording where there is one.
//
// A page that stays open sees each: the stream ends where a mission begins, and the page asks
// everything again.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "apps/viewer/event_hub.h"
#include "apps/viewer/growing_log.h"
#include "apps/viewer/mission_session.h"
#include "apps/viewer/plan_desk.h"

namespace shoal {

struct FollowOptions {
  int port_base = 0;  ///< 0: see ChooseMission (lib/run/run/run_registry.h).
  bool allow_commands = false;
};

class MissionFollower {
 public:
  /// `hub` gets the frames, and must outlive this.
  MissionFollower(const FollowOptions& options, EventHub& hub);

  /// Follows until Stop(). Returns the exit code; an error has been printed.
  int Run();
  /// From any thread.
  void Stop() { stopped_ = true; }

  // From any thread:
  std::shared_ptr<ViewSource> source() const;
  std::shared_ptr<ChannelSource> channels() const;
  PlanFile plan_file() const;
  std::string StatusJson();
  WebAnswer Command(const CommandWords& words);

 private:
  void Look();
  void LookForMission();
  void LookAfterMission();
  /// Shows what the mission left: its verdict, its recording.
  void ShowEnded(const RunningMission& ended);
  void Show(int64_t now_us);
  void TurnTo(std::shared_ptr<MissionSession> session);
  std::shared_ptr<MissionSession> session() const;

  const FollowOptions options_;
  EventHub& hub_;
  std::atomic<bool> stopped_ = false;
  std::string printed_;          ///< What was printed last about waiting.
  int64_t last_mission_id_ = 0;  ///< Of the one that has ended, or cannot be joined.
  int64_t next_look_us_ = 0;
  int64_t last_frame_us_ = 0;
  int64_t shown_changes_ = -1;
  bool had_readers_ = false;
  bool has_shown_page_ = false;  ///< It was printed that a page is open.

  mutable std::mutex mutex_;
  std::shared_ptr<MissionSession> session_;
  std::shared_ptr<GrowingLog> recording_;  ///< Shown instead of the session; null: the session is.
};

}  // namespace shoal

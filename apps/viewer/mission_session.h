// One running mission as the viewer follows it: what it receives on the mission's bus goes to the
// LiveView, what users command goes out. It does not take part in stepping.
//
// Subscribes to what LiveView needs, COMMS_RULES_NOW, CLOCK_STATE and APPCAST; publishes
// COMMS_RULES_REQ until it has the rules, APPCAST_REQ while a page shows the status pages, and what
// CommandDesk publishes.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/viewer/live_channels.h"
#include "apps/viewer/status_board.h"
#include "apps/viewer/view_request.h"
#include "apps/viewer/web_request.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/bus/lcm_receiver.h"
#include "lib/mission/model/mission.h"
#include "lib/run/orders/command_desk.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"
#include "lib/tools/view/live_view.h"

namespace shoal {

class MissionSession {
 public:
  /// Waits for a mission: a view without one.
  explicit MissionSession(const std::string& boot);
  /// Joins the bus of `running`.
  MissionSession(const RunningMission& running, const std::string& boot, bool allow_commands);

  /// Handles what has come, and sends what is due; for the one thread that calls this and Leave().
  /// `now_us`: wall time that never jumps.
  void Work(int64_t now_us);
  /// Leaves the bus, and has the view show `state`: "ended" or "lost".
  void Leave(std::string_view state);
  /// True where the clock has published that the mission ends.
  bool is_ending() const { return is_ending_; }

  /// False before a mission and after it.
  bool is_joined() const { return joined_; }
  const RunningMission& running() const { return running_; }
  /// Why the bus does not work; empty: it does.
  std::string error() const;

  // From any thread:
  LiveView& view() { return *view_; }
  LiveChannels& channels() { return channels_; }
  std::string StatusJson(int64_t now_us) { return board_.Json(now_us); }
  WebAnswer Command(const CommandWords& words);

 private:
  void Join(bool allow_commands);
  void TakeClock(const Message& message);
  void TakeRules(const Message& message);
  void ShowCommands();
  void FollowAllChannels();
  /// Returns the message in `datagram`; nothing where it is of another mission, or not genuine.
  std::optional<std::span<const uint8_t>> MessageIn(std::string_view channel,
                                                    std::span<const uint8_t> datagram) const;

  RunningMission running_;
  std::vector<std::string> notes_;
  Mission mission_;
  std::unique_ptr<LiveView> view_;
  StatusBoard board_;
  bool joined_ = false;
  bool is_ending_ = false;  ///< CLOCK_STATE has stated so.
  int64_t clock_received_us_ =
      0;                    ///< When CLOCK_STATE came last; 0: not yet, or its silence is shown.
  bool has_rules_ = false;  ///< COMMS_RULES has come, or COMMS_RULES_NOW.
  int64_t next_rules_request_us_ = 0;
  int64_t rules_requests_ = 0;
  int64_t now_us_ = 0;
  std::atomic<int64_t> utime_ = 0;  ///< Of the clock's last step.
  std::vector<CommandRecord> shown_;
  std::unique_ptr<LcmBus> bus_;  ///< Of the stepping ports and the shore.
  std::optional<MissionSecret> secret_;
  std::unique_ptr<LcmReceiver> communities_;  ///< Absent in the `shared` layout.
  int64_t next_communities_us_ = 0;
  LiveChannels channels_{MonotonicMicroseconds};
  std::unique_ptr<LcmReceiver> all_channels_;  ///< Of everything, while a page asks for channels.

  std::mutex desk_mutex_;  ///< Of desk_, which is destroyed when the mission ends.
  std::unique_ptr<CommandDesk> desk_;
};

}  // namespace shoal

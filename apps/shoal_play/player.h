// Plays a recording on LCM. A playback is a mission whose participants are the one that publishes
// what the log holds, and those that a user starts beside it. Each jump in the log begins a mission
// with another id, so that viewers and participants start again.
//
//   open -> claim ports -> register -> [ session: gather, step, END ] -> count
//                              ^                 |
//                              +---- seek, loop -+
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/shoal_play/play_keys.h"
#include "apps/shoal_play/playback_app.h"
#include "apps/shoal_play/playback_log.h"
#include "apps/shoal_play/receiver_queues.h"
#include "lib/bus/bus/lcm_transport.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/mission/model/mission.h"
#include "lib/run/launch/launch_terminal.h"
#include "lib/run/run/run_registry.h"
#include "lib/run/run/step_clock.h"
#include "lib/run/run/step_group.h"

namespace shoal {

struct PlayOptions {
  std::string path;
  double warp = 1;      ///< Seconds of the log per wall second; 0: as fast as receivers can.
  double from_s = 0;    ///< Since the log's begin.
  bool loop = false;    ///< At the end, begins again at `from_s`.
  bool paused = false;  ///< Waits before the first step.
  bool quiet = false;
  int port_base = 0;  ///< 0: the first free block.
  ChannelChoice channels = {};
  std::vector<std::string> participants = {};  ///< Names of those that a user starts beside it.
  std::string answers_path = {};               ///< A log of what they publish; empty: none.
};

/// Returns an id that no other session has.
[[nodiscard]] int64_t RandomPlaybackId();

class Player {
 public:
  /// `mission`: the one that was recorded, as far as it is known. `running`: how the first session
  /// is registered. @pre the ports of `running` are claimed
  Player(const PlayOptions& options, PlaybackLog* log, const Mission& mission,
         const RunningMission& running, LogWriter* answers, int signal_fd);

  /// Returns the exit code.
  int Run();

 private:
  /// All that lasts from one jump in the log to the next.
  struct Session;

  std::unique_ptr<Session> MakeSession(int64_t from_utime);
  void Receive(Session* session, int port, std::string_view channel,
               std::span<const uint8_t> datagram);
  void Work(Session* session);
  void End(Session* session);
  void ObeyKeys(Session* session);
  void Order(Session* session, const std::string& command, double warp = 0);
  void SeekTo(double since_begin_s);
  void ShowProgress(Session& session);
  void Fail(const std::string& why);
  double At_s(const Session& session) const;

  const PlayOptions options_;
  PlaybackLog& log_;
  const Mission& mission_;
  RunningMission running_;
  LogWriter* const answers_;
  const int signal_fd_;
  const PortPlan ports_;
  MissionSecret secret_;
  LaunchTerminal terminal_;
  Keyboard keyboard_;
  double warp_;
  std::optional<int64_t> seek_utime_;
  bool is_paused_;
  bool has_begun_ = false;
  bool is_over_ = false;  ///< By a signal or a key.
  int exit_code_ = 0;
  int64_t next_progress_us_ = 0;
  PlaybackCounts counts_;  ///< Of the sessions before.
  int64_t num_given_up_ = 0;
  int64_t num_repeated_ = 0;
};

}  // namespace shoal

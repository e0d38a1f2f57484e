// The clock's side of the step protocol: one TICK when all participants have answered the last.
//
//   GATHERING --all sent hello--> RUNNING --last step answered--> ENDING --all answered--> ENDED
//       |                            |  TICK k, wait for STEP_DONE k of all, TICK k+1 with totals
//       |                            |  silence of 50 ms: the tick again
//       +--------- Stop() -----------+--------------------------> ENDING
//
// CLOCK_COMMAND pauses it, resumes it and changes its warp (lib/run/run/step_pace.h): when steps
// are taken, never what comes of them. While it is paused, the step under way is answered and no
// other begins. CLOCK_STATE shows what it does: at once after each command, and twice per second of
// wall time.
//
// Time comes in as an argument (wall time, microseconds, from any epoch, never backward). Pure but
// for the transport.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/mission_secret.h"
#include "lib/bus/bus/transport.h"
#include "lib/run/run/step_pace.h"
#include "shoal/clock_command_t.hpp"
#include "shoal/step_done_t.hpp"
#include "shoal/tick_t.hpp"

namespace shoal {

/// What the clock counts of the bus over a whole run.
struct RunCounters {
  int64_t messages = 0;     ///< Published by participants.
  int64_t repeated = 0;     ///< Datagrams asked for again.
  int64_t ticks_again = 0;  ///< Ticks sent again after silence.
  int64_t outside = 0;      ///< Messages from outside that some participant handled.
  int64_t foreign = 0;      ///< Messages of other missions, rejected.
  int64_t undecodable = 0;  ///< Messages whose bytes make no sense, dropped.
  int64_t refused = 0;  ///< Messages without a genuine seal, or without room; datagrams of none.
};

struct ClockOptions {
  int64_t mission_id = 0;
  MissionSecret secret = {};
  double warp = 1;  ///< Mission seconds per wall second at first; 0: as fast as possible.
  std::string fixed_pace = {};  ///< Why pace must stay as it is; empty: it may change.
  int64_t tick_us = 100'000;
  int64_t start_utime = 0;
  int64_t last_step = 0;
  int64_t timeout_us = 5'000'000;  ///< A participant silent for longer is lost.
};

class StepClock {
 public:
  enum class State { kGathering, kRunning, kEnding, kEnded };

  StepClock(ClockOptions options, std::vector<std::string> participants, PortPlan plan,
            Transport& transport);

  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us);
  /// Does what is due: next tick, ticks again, time-outs.
  void OnTime(int64_t wall_us);
  /// Returns the wall time at which OnTime has something to do.
  int64_t NextDeadline() const;

  /// Goes on without this participant, until it sends hello again.
  void Drop(const std::string& participant, int64_t wall_us);
  /// The same for a participant whose process has exited: answers with its process id are replays
  /// from now on, and refused.
  void DropExited(const std::string& participant, int64_t wall_us);
  /// Takes it that this participant has answered END: it has left, and its answer may be lost.
  void Leave(const std::string& participant, int64_t wall_us);
  /// Makes the present step the last one: as planned, but earlier.
  void MakeLast() { last_step_ = std::min(last_step_, std::max<int64_t>(step_, 0)); }
  /// Ends the mission after the present step, or at once if that does not end within
  /// `patience_us`.
  void Stop(int64_t wall_us, int64_t patience_us);

  State state() const { return state_; }
  bool paused() const { return pace_.is_paused(); }
  double warp() const { return pace_.warp(); }
  int64_t step() const { return step_; }  ///< The last one ticked; -1 before the first.
  /// Mission time of the last step that was run.
  int64_t utime() const;
  const RunCounters& counters() const { return counters_; }

  /// Participants that have not sent hello yet.
  std::vector<std::string> Awaited() const;
  /// Participants that were silent for longer than the time-out; each is named until dropped.
  std::vector<std::string> Silent(int64_t wall_us) const;
  /// The first fault that a participant reported ("helm_alpha: ..."), or empty.
  const std::string& fault() const { return fault_; }
  /// The first unregistered participant: the mission has none of its name; or empty.
  const std::string& unregistered() const { return unregistered_; }
  /// The first participant whose answer was refused: without a genuine seal; or empty.
  const std::string& refused() const { return refused_; }
  /// True where a participant was dropped or came back while running.
  bool membership_changed() const { return membership_changed_; }

 private:
  struct Member {
    bool present = false;     ///< Sent hello, or answers; false after Drop.
    bool joins_next = false;  ///< Sent hello while running; takes part from the next tick on.
    int32_t pid = 0;          ///< Of the process that plays it.
    int32_t former_pid = 0;   ///< Of the one that was dropped.
    int64_t hello_us = 0;     ///< When its last hello came, before the first step.
    std::set<int32_t> exited_pids = {};
    int64_t answered_step = -1;
    int64_t asked_at_us = 0;  ///< When the tick it owes an answer to was sent first.
    int64_t next_repeat_us = 0;
    // Totals since its start, as its last answer has them.
    int64_t repeated = 0;
    int64_t outside = 0;
    int64_t foreign = 0;
    int64_t undecodable = 0;
    int64_t refused = 0;
  };

  void OnAnswers(std::string_view channel, std::span<const uint8_t> datagram, int64_t wall_us);
  void OnDone(const step_done_t& done, int64_t wall_us);
  void SendTickDatagram();
  void ForgetSilentHellos(int64_t wall_us);
  std::string Execute(const clock_command_t& command, int64_t wall_us);
  std::string_view StateWord(bool is_awaiting) const;
  void SendState(int64_t wall_us);
  void SendTick(int64_t wall_us);
  bool AllAnswered() const;
  void Advance(int64_t wall_us);
  void CountOf(const Member& member);
  void UpdateCounters();

  const ClockOptions options_;
  const PortPlan plan_;
  Transport& transport_;
  StepPace pace_;
  std::map<std::string, Member, std::less<>> members_;
  State state_ = State::kGathering;
  int64_t step_ = -1;
  int64_t last_step_;
  tick_t tick_{};
  std::vector<step_total_t> next_totals_;  ///< Of the present step, as answers come.
  std::vector<std::string> joining_;       ///< Take part from the next tick on.
  int64_t num_commands_ = 0;
  std::string refusal_;        ///< "pause refused: ...", of the last command; or empty.
  int64_t next_state_us_ = 0;  ///< When CLOCK_STATE is due again.
  int64_t stop_deadline_us_ = 0;
  bool stop_wanted_ = false;
  bool membership_changed_ = false;
  int64_t last_time_us_ = 0;
  std::string unregistered_;
  std::string refused_;
  std::string fault_;
  RunCounters counters_;
};

}  // namespace shoal

// A participant's side of the step protocol: the Bus of an app that runs in a process of its own.
//
//     TICK that names it as joined                TICK k, all of step k-1 is here
//   HELLO ------------------> WAITING <------------------------------------------+
//     | STEP_DONE -1,           | TICK k, something is missing                   |
//     | every 0.2 s             v                                                |
//     +--                    COLLECTING -- RESEND every 50 ms; repeats arrive ---+
//                               | still missing after 3 s, or too many     handle, Tick, publish,
//                               v                                       STEP_DONE k
//                            STEP_DONE with a fault; the clock ends the mission
//
// TICK END: handle, App::End, STEP_DONE, then ended() is true. Time comes in as an argument (wall
// time, microseconds, from any epoch, never backward); nothing here reads a clock.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus.h"
#include "lib/bus/handler_table.h"
#include "lib/bus/layout.h"
#include "lib/bus/transport.h"
#include "lib/run/app.h"
#include "lib/run/step_inbox.h"
#include "shoal/step_done_t.hpp"
#include "shoal/tick_t.hpp"

namespace shoal {

struct ParticipantOptions {
  std::string name;
  int64_t mission_id = 0;  ///< 0: that of the first tick received.
  int32_t pid = 0;
  MissionSecret secret = {};
  /// For this long a missing message is asked for again. A repeat takes well under a millisecond;
  /// three seconds in vain mean that it never gets through. Less than the clock's time-out.
  int64_t give_up_us = 3'000'000;
};

class StepParticipant : public Bus {
 public:
  StepParticipant(ParticipantOptions options, PortPlan plan, Transport& transport);

  /// Gives it the app to step; called once, before any datagram.
  void Attach(App* app);

  // Bus.
  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override;
  void SubscribeBytes(const std::string& channel, Handler handler) override;
  void SubscribeAll(Handler handler) override;

  /// Takes a datagram from the transport.
  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us);
  /// Does what is due: hello, requests for what is missing.
  void OnTime(int64_t wall_us);
  /// Returns the wall time at which OnTime has something to do.
  int64_t NextDeadline() const;

  bool ended() const { return ended_; }
  /// Returns the app's page, with the bus's counters and warnings.
  StatusPage Status() const;
  int64_t step() const { return step_; }
  /// Ticks and messages of other missions that were rejected.
  int64_t num_foreign() const { return num_foreign_ticks_ + inbox_.counters().foreign; }

 private:
  struct Sent {
    std::string channel;
    Bytes datagram;
  };
  struct SentStep {
    int64_t step = -1;
    std::vector<Sent> messages;
  };

  void OnTick(const tick_t& tick, int64_t wall_us);
  bool TakesPart(const tick_t& tick) const;
  /// Takes apart a datagram of the step protocol itself. Absent: refused, and counted.
  std::optional<std::span<const uint8_t>> Open(std::string_view channel,
                                               std::span<const uint8_t> datagram);
  void TryStep();
  void RunStep();
  void SendDone(const std::string& fault);
  void RequestMissing(const std::vector<MiscountedMessages>& missing);
  void OnResend(std::span<const uint8_t> datagram, int64_t wall_us);
  void OnAppcastRequest(std::span<const uint8_t> datagram, int64_t wall_us);
  void OnAppRequest(std::string_view channel, std::span<const uint8_t> datagram, int64_t wall_us);
  template <class T>
  void SendSealed(const Channel<T>& channel, const T& message, int64_t step);
  int64_t num_refused() const;

  const ParticipantOptions options_;
  const PortPlan plan_;
  Transport& transport_;
  App* app_ = nullptr;
  StepInbox inbox_;
  HandlerTable handlers_;

  int64_t mission_id_ = 0;
  int64_t step_ = -1;              ///< Last step answered.
  int64_t utime_ = 0;              ///< Of that step.
  double warp_ = 0;                ///< Last given to the app.
  std::optional<tick_t> pending_;  ///< The tick whose messages are being collected.
  int64_t num_awaited_ = 0;        ///< Of its messages; where it is 0, they are counted again.
  int64_t collecting_since_ = 0;
  int64_t next_request_ = 0;
  int64_t next_hello_ = 0;
  int64_t next_page_ = 0;
  int64_t next_answer_ = 0;
  std::map<std::string, int64_t, std::less<>> next_resends_;  ///< By channel of its own.
  bool in_step_ = false;
  uint32_t sequence_ = 0;
  std::deque<SentStep> sent_;  ///< This step and the one before, for those who missed something.
  step_done_t done_{};         ///< The last answer, to be given again.
  int64_t num_requests_ = 0;   ///< Datagrams asked for again.
  int64_t num_foreign_ticks_ = 0;
  int64_t num_forged_ = 0;  ///< Of the step protocol's own messages.
  bool ended_ = false;
};

}  // namespace shoal

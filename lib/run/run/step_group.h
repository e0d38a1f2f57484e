// One process' side of the step protocol: the participants that run in it, one or many, each with a
// Bus and an App of its own.
//
//     TICK that names one as joined               TICK k, all of step k-1 is here
//   HELLO ------------------> WAITING <------------------------------------------+
//     | STEP_DONE -1,           | TICK k, something is missing                   |
//     | every 0.2 s             v                                                |
//     +--                    COLLECTING -- RESEND every 50 ms; repeats arrive ---+
//                               | still missing after 3 s, or too many     handle, Tick, publish,
//                               v                                       STEP_DONE k
//                            STEP_DONE with a fault; the clock ends the mission
//
// Several participants answer with one STEP_DONES. What one publishes reaches the others of the
// process within it (lib/bus/bus/memory_bus.h); it is sent out all the same, for other processes,
// the recorder and people, and what comes back of it is dropped.
//
// TICK END: handle, App::End, STEP_DONE, then ended() is true. Time comes in as an argument (wall
// time, microseconds, from any epoch, never backward); nothing here reads a clock.
//
//   StepGroup group(options, plan, transport);
//   HelmApp helm(mission, vehicle, group.Join("helm_alpha"));
//   group.Attach("helm_alpha", &helm);
//   group.Listen();
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/bus/bus/transport.h"
#include "lib/run/run/app.h"
#include "lib/run/run/channel_set.h"
#include "lib/run/run/sent_messages.h"
#include "lib/run/run/step_inbox.h"
#include "shoal/step_dones_t.hpp"
#include "shoal/tick_t.hpp"

namespace shoal {

struct StepGroupOptions {
  int64_t mission_id = 0;  ///< 0: that of the first tick received.
  int32_t pid = 0;
  MissionSecret secret = {};
  /// How long a missing message is asked for again. A repeat takes less than a millisecond, so
  /// after three seconds it will never arrive. Less than the time-out of the clock.
  int64_t give_up_us = 3'000'000;
};

class StepGroup {
 public:
  StepGroup(StepGroupOptions options, PortPlan plan, Transport& transport);

  /// Adds a participant and returns its bus, which lives as long as this. They are stepped in the
  /// order in which they join.
  /// @pre no participant of this name yet; before Listen
  Bus& Join(const std::string& name);
  /// Gives a participant the app to step.
  /// @pre it has joined; before Listen
  void Attach(std::string_view name, App* app);
  /// Listens to what the apps have subscribed to; called once, before any datagram.
  /// @pre each participant has its app
  void Listen();

  /// Takes a datagram from the transport.
  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us);
  /// Does what is due: hello, requests for what is missing.
  void OnTime(int64_t wall_us);
  /// Returns the wall time at which OnTime has something to do.
  int64_t NextDeadline() const;

  bool ended() const { return ended_; }
  /// True while nothing but a tick makes it go on: it has answered the last.
  bool awaits_tick() const { return step_ >= 0 && !pending_ && !ended_; }
  /// Returns the page of a participant, with the counters and warnings of the bus.
  StatusPage Status(std::string_view name) const;
  int64_t step() const { return step_; }
  /// Ticks and messages of other missions that were rejected.
  int64_t num_foreign() const { return num_foreign_ticks_ + inbox_.counters().foreign; }

 private:
  struct Member {
    std::string name;
    Bus* bus = nullptr;
    App* app = nullptr;
    std::map<std::string, int32_t, std::less<>> num_published = {};  ///< Of this step, by channel.
    int64_t next_page = 0;
    int64_t next_answer = 0;
  };

  /// Null: it runs in another process.
  Member* Find(std::string_view name) const;
  bool Wants(std::string_view channel) const;
  uint32_t NumberOf(const std::string& publisher);
  void OnTick(std::span<const uint8_t> datagram, int64_t wall_us);
  bool TakesPart(const tick_t& tick) const;
  /// Takes apart a datagram of the step protocol itself. Absent: refused, and counted.
  std::optional<std::span<const uint8_t>> Open(std::string_view channel,
                                               std::span<const uint8_t> datagram);
  void TryStep();
  void RunStep();
  void StepApps(const tick_t& tick);
  void SendPublished();
  void SendDone(const std::string& fault);
  step_done_t DoneOf(const Member& member) const;
  void SendDones();
  void RequestMissing(const std::vector<MiscountedMessages>& missing);
  void OnResend(std::span<const uint8_t> datagram, int64_t wall_us);
  void OnAppcastRequest(std::span<const uint8_t> datagram, int64_t wall_us);
  void OnAppRequest(std::string_view channel, std::span<const uint8_t> datagram, int64_t wall_us);
  StatusPage StatusOf(const Member& member) const;
  template <class T>
  void SendSealed(const Channel<T>& channel, const T& message, int64_t step);
  int64_t num_refused() const;
  int64_t NumPublished() const;

  const StepGroupOptions options_;
  const PortPlan plan_;
  Transport& transport_;
  MemoryBus hub_;
  std::deque<Member> members_;
  std::unordered_map<std::string, Member*, TextHash, std::equal_to<>> members_by_name_;
  ChannelSet wanted_;
  bool wants_all_ = false;
  std::unordered_map<std::string, uint32_t> numbers_;  ///< In the hub, of others, by name.
  StepInbox inbox_;

  int64_t mission_id_ = 0;
  int64_t step_ = -1;              ///< Last step answered.
  int64_t utime_ = 0;              ///< Of that step.
  double warp_ = 0;                ///< Last given to the apps.
  std::optional<tick_t> pending_;  ///< The tick whose messages are being collected.
  int64_t num_awaited_ = 0;        ///< Of its messages; where it is 0, they are counted again.
  int64_t collecting_since_ = 0;
  int64_t next_request_ = 0;
  int64_t next_hello_ = 0;
  /// By publisher and channel.
  std::map<std::pair<std::string, std::string>, int64_t> next_resends_;
  SentMessages sent_;
  int64_t num_sent_ = 0;
  step_dones_t dones_{};      ///< The last answers, to be given again.
  int64_t num_requests_ = 0;  ///< Datagrams asked for again.
  int64_t num_foreign_ticks_ = 0;
  int64_t num_forged_ = 0;  ///< Of the step protocol's own messages.
  bool ended_ = false;
};

}  // namespace shoal

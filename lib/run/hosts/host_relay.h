// A host's relay: on the host's own bus it plays the clock and the participants that run elsewhere.
//
//   batch of step k --> its messages onto the bus, then TICK k
//   all here have answered, and all that they announced is here --> one batch home: what was
//                     published in step k, then the answers, STEP_DONE k and STEP_DONES k
//   some are silent for 0.3 s --> what is complete goes home without them, the rest as it comes
//
// Time comes in as an argument. Pure but for the transport.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lib/run/hosts/relay_bus.h"

namespace shoal {

class HostRelay {
 public:
  using SendHome = std::function<void(LinkMessage message)>;

  /// `participants`: the names of those that run here.
  HostRelay(RelayOptions options, PortPlan plan, Transport& transport,
            std::set<std::string, std::less<>> participants, SendHome send);

  /// Takes a datagram from this host's bus.
  void OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                  int64_t wall_us);
  /// Takes a message of kind kTick or kAside. Returns what is wrong with it, or an empty text.
  std::string OnMessage(const LinkMessage& message, int64_t wall_us);
  /// Does what is due: TICK and requests again, answers of those that are not silent.
  void OnTime(int64_t wall_us);
  int64_t NextDeadline() const;

  /// Waits for this participant no longer: its process has ended. Of a process of several, each is
  /// to be forgotten.
  void Forget(const std::string& participant, int64_t wall_us);

  /// True while all have answered and messages that they announced are missing.
  bool awaits_data() const { return awaited_.empty() && !unsent_.empty(); }
  /// True where END has been answered by all.
  bool ended() const { return is_end_ && awaited_.empty() && unsent_.empty(); }
  int64_t step() const { return step_; }
  int64_t num_refused() const { return bus_.num_refused(); }

 private:
  /// The answer of one process: STEP_DONE of its participant, or STEP_DONES of several.
  struct Answer {
    LinkPart part;
    std::vector<step_done_t> dones;
  };

  void OnAnswer(std::string_view channel, std::span<const uint8_t> datagram, int64_t wall_us);
  std::string OnTick(const LinkMessage& message, int64_t wall_us);
  bool IsComplete(const Answer& answer) const;
  /// Calls `use(done, count)` for each step_count_t of an answer of which messages are missing.
  template <class Use>
  void ForEachMissing(const Answer& answer, Use use) const;
  void SendAnswers(int64_t wall_us);
  void SendAside(std::string_view channel, std::span<const uint8_t> datagram, LinkKind kind);

  RelayBus bus_;
  const std::set<std::string, std::less<>> participants_;
  SendHome send_;
  OutsideQueue outside_;
  int64_t step_ = -1;
  bool is_end_ = false;
  LinkPart tick_part_;
  int64_t tick_at_us_ = 0;
  int64_t next_repeat_us_ = 0;
  std::set<std::string, std::less<>> active_;             ///< Take part in stepping.
  std::set<std::string, std::less<>> awaited_;            ///< Of these: have not answered yet.
  std::vector<Answer> unsent_;                            ///< Have not gone home.
  std::map<std::string, int32_t, std::less<>> answered_;  ///< In this step, by which process.
};

}  // namespace shoal

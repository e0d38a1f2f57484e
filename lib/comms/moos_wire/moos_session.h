// One client of a MOOSDB: what it sends when, and what it makes of the answers. Knows neither
// socket nor clock.
//
//   MoosSession session({.name = "shoal_alpha", .warp = 4, .host = "lab"});
//   session.Register("NODE_REPORT_LOCAL", 0);
//   Send(session.Connect(wall_us, utc_us));          // the connection stands
//   session.Take(bytes, wall_us, utc_us);            // what came
//   for (const MoosMessage& mail : session.TakeMail()) ...
//   session.Notify("NAV_X", 3.5, utc_us);
//   Send(session.Flush(wall_us, utc_us));            // several times per second
//   if (session.IsDeaf(wall_us)) { Close(); session.Disconnect(); }
//
//     Connect          welcome                     Disconnect
//   away --> greeting --------> joined -----------------------> away
//                    \-------> refused (name taken, ...) -----> away
//
// What it must do, and why (the behavior of MOOSDB, not its specification):
//   - a MOOSDB reads the 32 bytes and the name of one client at a time, without limit: both are
//   sent
//     at once;
//   - 5 s of wall time without a byte end a client: a timing message goes out each second;
//   - a client to which a write of the MOOSDB blocked for 6 s gets nothing any more, and its
//     connection stays: without an answer to timing for kDeafAfter_us it is joined again;
//   - mail can wait in the MOOSDB until its client sends something that is not timing: a null
//     message fetches it;
//   - subscriptions end with the connection: they are made again in each.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/moos_wire/moos_message.h"
#include "lib/comms/moos_wire/moos_packet.h"

namespace shoal {

struct MoosSessionOptions {
  std::string name;  ///< Unique in the community.
  double warp = 1;   ///< MOOS time is Unix time times this. > 0.
  std::string host;  ///< Of this machine; where the MOOSDB's is another, its clock counts.
};

struct MoosSessionCounts {
  int64_t sent = 0;       ///< Notifies.
  int64_t received = 0;   ///< Notifies.
  int64_t discarded = 0;  ///< Notifies that were not sent: not joined, or too many waited.
  int64_t joined = 0;     ///< How often.
};

class MoosSession {
 public:
  enum class State { kAway, kGreeting, kJoined, kRefused };

  static constexpr int64_t kTimingInterval_us = 1'000'000;
  static constexpr int64_t kFetchInterval_us = 100'000;
  static constexpr int64_t kDeafAfter_us = 3'000'000;
  static constexpr int64_t kLongestHandshake_us = 10'000'000;
  static constexpr size_t kMaxWaiting = 20'000;  ///< Messages that wait to be sent, or to be taken.

  /// @pre options.warp > 0
  explicit MoosSession(MoosSessionOptions options);

  /// Subscribes to a variable, now and in each later connection. `interval_s`: of MOOS time.
  void Register(std::string_view key, double interval_s);
  /// Subscribes to the variables that fit a pattern with '*' and '?', of all sources.
  void RegisterPattern(std::string_view pattern, double interval_s);

  /// Begins: returns what is to be sent. @pre state() == kAway
  [[nodiscard]] std::string Connect(int64_t wall_us, int64_t utc_us);
  /// The connection has ended, whatever ended it. problem() stays until the next Connect.
  void Disconnect();
  /// Takes what the MOOSDB sent. After that problem() may state why to end the connection.
  void Take(std::string_view bytes, int64_t wall_us, int64_t utc_us);

  /// Sends a value as soon as it can, stamped with MOOS time; not before it has joined.
  void Notify(std::string_view key, double value, int64_t utc_us);
  void Notify(std::string_view key, std::string_view text, int64_t utc_us);
  /// Returns what is to be sent now: what waits, timing, or a null message that fetches mail.
  [[nodiscard]] std::string Flush(int64_t wall_us, int64_t utc_us);

  /// Returns the notifies that came, in order, and forgets them.
  [[nodiscard]] std::vector<MoosMessage> TakeMail();

  State state() const { return state_; }
  /// Why the connection is of no use: refused, bytes that are not MOOS's; else empty.
  const std::string& problem() const { return problem_; }
  /// True where the MOOSDB answers no timing, or has not welcomed: join again.
  bool IsDeaf(int64_t wall_us) const;

  /// MOOS time in seconds, by the MOOSDB's clock where that is on another machine.
  double Time_s(int64_t utc_us) const;
  /// The name of the community, as the MOOSDB has it; empty before the first welcome.
  const std::string& community() const { return community_; }
  /// The MOOSDB's time less this machine's, as measured last, in seconds of MOOS time.
  double skew_s() const { return skew_s_; }
  /// The warp of the MOOSDB, as its time shows it: off by a millionth where clocks differ by 30
  /// minutes. Nothing before the first welcome.
  std::optional<double> warp_of_server() const { return warp_of_server_; }
  const MoosSessionCounts& counts() const { return counts_; }

 private:
  double Bare_s(int64_t utc_us) const { return static_cast<double>(utc_us) / 1e6 * options_.warp; }
  void Stamp(MoosMessage* message, int64_t utc_us);
  void Queue(MoosMessage message, int64_t utc_us);
  void QueueRegister(const std::string& key, double interval_s, int64_t utc_us);
  void QueuePattern(const std::string& pattern, double interval_s, int64_t utc_us);
  void OnAnswer(const MoosMessage& message, int64_t utc_us);
  void OnTiming(const MoosMessage& message, int64_t utc_us);
  void OnWelcome(const MoosMessage& message, int64_t wall_us, int64_t utc_us);
  void OnMessage(const MoosMessage& message, int64_t wall_us, int64_t utc_us);

  const MoosSessionOptions options_;
  State state_ = State::kAway;
  std::string problem_;
  MoosPacketReader reader_;
  std::map<std::string, double> variables_;  ///< Subscriptions, with their intervals.
  std::map<std::string, double> patterns_;
  bool has_new_subscriptions_ = false;
  std::vector<MoosMessage> waiting_;
  std::vector<MoosMessage> mail_;
  std::string community_;
  bool keeps_own_clock_ = true;
  double skew_s_ = 0;
  std::optional<double> warp_of_server_;
  int32_t next_id_ = 0;
  int64_t connected_us_ = 0;
  int64_t timing_sent_us_ = 0;
  std::optional<int64_t> unanswered_since_us_;  ///< When the first timing without answer was sent.
  int64_t num_answers_ = 0;                     ///< To timing, in this connection.
  int64_t spoke_us_ = 0;                        ///< When something besides timing was sent.
  int64_t quiet_until_us_ = 0;                  ///< As the MOOSDB asked for.
  int64_t pause_us_ = 0;                        ///< After each packet, as the MOOSDB asks for.
  MoosSessionCounts counts_;
};

}  // namespace shoal

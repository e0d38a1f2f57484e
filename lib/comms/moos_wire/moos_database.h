// A MOOSDB: greets clients, keeps variables, passes on what is written. Knows neither socket nor
// clock.
//
//   MoosDatabase database({.community = "alpha", .host = "lab", .own_name = "shoal"});
//   database.OnConnect(id, now);
//   database.OnBytes(id, bytes, now);
//   database.Advance(now);            // several times per second: DB_TIME and the like; the silent
//   database.Write("NAV_X", 3.5, now);
//   for (const MoosOutput& each : database.TakeOutput()) {   // after each of these
//     Send(each.client, each.bytes);
//     if (each.closes) Close(each.client);
//   }
//
// Differs from MOOSDB where that is a trap: a client that does not introduce itself keeps no other
// waiting; mail leaves at once; subscriptions belong to the connection that asks for them, whatever
// name it gives as their source; each client, and all together, cost bounded memory. Not there:
// synchronous clients, server requests, DB_QOS, DB_RWSUMMARY and DB_VARSUMMARY.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/moos_wire/moos_packet.h"
#include "lib/comms/moos_wire/moos_variables.h"

namespace shoal {

struct MoosDatabaseOptions {
  std::string community;
  std::string host;  ///< Stated in the welcome: a client on a host of this name keeps its clock.
  std::string own_name;  ///< Of the one that calls Write: no client may take it.
  MoosLimits limits = {};
};

/// The time at a call.
struct MoosNow {
  int64_t wall_us = 0;  ///< Never goes back.
  double time_s = 0;    ///< MOOS time.
};

/// What is to be sent to a client.
struct MoosOutput {
  MoosClientId client = 0;
  std::string bytes = {};
  bool closes = false;  ///< The connection ends when the bytes have left.
};

struct MoosDatabaseCounts {
  int64_t joined = 0;
  int64_t refused = 0;   ///< Names that were taken, empty or long; synchronous clients.
  int64_t silent = 0;    ///< Closed: nothing came for kSilence_us.
  int64_t broken = 0;    ///< Closed: what came was not MOOS's.
  int64_t slow = 0;      ///< Closed: more waited for it than kMaxWaitingBytes.
  int64_t lost = 0;      ///< Writes that were not fetched with TakeMail.
  int64_t requests = 0;  ///< Server requests and messages of unknown types, not answered.
};

class MoosDatabase {
 public:
  static constexpr int64_t kSilence_us = 5'000'000;  ///< Of wall time, as MOOSDB's ClientTimeout.
  static constexpr double kOwnInterval_s = 2;        ///< MOOS time between updates of DB_TIME.
  static constexpr size_t kLongestName = 128;

  static constexpr size_t kMaxWaitingBytes = size_t{16} << 20;  ///< Of a client, between two calls.
  static constexpr size_t kMaxMail = 100'000;
  static constexpr size_t kMaxEvents = 100;

  explicit MoosDatabase(MoosDatabaseOptions options);

  void OnConnect(MoosClientId id, MoosNow now);
  void OnBytes(MoosClientId id, std::string_view bytes, MoosNow now);
  void OnClose(MoosClientId id, MoosNow now);
  void Advance(MoosNow now);

  void Write(std::string_view key, double value, MoosNow now);
  void Write(std::string_view key, std::string_view text, MoosNow now);

  /// Returns what is to be sent, and forgets it.
  [[nodiscard]] std::vector<MoosOutput> TakeOutput();
  /// Returns what clients have written, and forgets it.
  [[nodiscard]] std::vector<MoosMessage> TakeMail();
  /// Returns sentences about clients: joined, left, refused, closed; and forgets them.
  [[nodiscard]] std::vector<std::string> TakeEvents();

  const MoosVariables& variables() const { return variables_; }
  const MoosDatabaseCounts& counts() const { return counts_; }
  /// Returns the names of the clients that have joined, in the order in which they came.
  std::vector<std::string> ClientNames() const;

 private:
  struct Client {
    std::string name = {};      ///< Empty: it has not joined.
    std::string greeting = {};  ///< Of the first bytes, until there are enough.
    MoosPacketReader reader = MoosPacketReader();
    int64_t heard_us = 0;
    std::vector<MoosMessage> answers = {};  ///< To timing.
    std::vector<MoosMessage> mail = {};
    size_t num_mail_bytes = 0;
    std::string handshake = {};  ///< The answer to its name, to be sent first.
    bool is_closing = false;
    bool is_closed = false;  ///< TakeOutput has returned that.
  };

  void Begin(MoosNow now);
  void OnPackets(MoosClientId id, Client* client, std::string_view bytes, MoosNow now);
  void OnMessage(MoosClientId id, Client* client, const MoosMessage& message, MoosNow now);
  void Join(Client* client, const MoosMessage& message, MoosNow now);
  void Refuse(Client* client, const std::string& reason);
  void Event(std::string text);
  void TakeNotify(const Client& client, const MoosMessage& message, MoosNow now);
  /// Writes a variable of the database's own.
  void WriteOwn(MoosMessage message, MoosNow now);
  void UpdateOwn(MoosNow now);
  /// Writes, and hands what comes of it to its receivers.
  bool WriteMessage(const MoosMessage& message, MoosNow now);
  void Deliver(MoosMail mail);
  std::string ClientList() const;

  const MoosDatabaseOptions options_;
  std::map<MoosClientId, Client> clients_;
  MoosVariables variables_;
  std::vector<MoosMessage> mail_;
  std::vector<std::string> events_;
  MoosDatabaseCounts counts_;
  bool has_started_ = false;
  double started_s_ = 0;
  double updated_s_ = 0;  ///< DB_TIME and the like.
  int32_t next_id_ = 0;
};

}  // namespace shoal

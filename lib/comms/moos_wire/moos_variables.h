// The variables of a MOOS community and the clients that subscribe to each: the memory of a MOOSDB.
//
//   MoosVariables variables(limits);
//   variables.Subscribe(client, "NAV_X", 0.5, &mail);      // the present value comes at once
//   variables.Write(message, time_s, &mail);               // to those who want it
//   for (auto& [client, message] : mail) ...
//
// As a MOOSDB has it: the first write fixes a variable's type, and a write of another type is
// dropped; with an interval what comes too early is dropped and never sent later; a pattern also
// holds for variables that are written for the first time later, even after its end has been asked
// for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/comms/moos_wire/moos_message.h"

namespace shoal {

/// A client of a MOOSDB; never used again for another.
using MoosClientId = uint64_t;

/// Messages, each with the client that gets it, in order.
using MoosMail = std::vector<std::pair<MoosClientId, MoosMessage>>;

/// What clients can bring a MOOSDB to remember, at most.
struct MoosLimits {
  size_t max_variables = 20'000;  ///< Written or subscribed to.
  size_t max_key_bytes = 256;
  size_t max_value_bytes = size_t{64} << 20;  ///< Of all present values together.
  size_t max_subscriptions = 200'000;         ///< Of all clients, one per client and variable.
  size_t max_patterns = 64;                   ///< Per client.
};

struct MoosVariableCounts {
  int64_t written = 0;
  int64_t wrong_type = 0;  ///< Writes of another type than the variable's.
  int64_t beyond = 0;      ///< Writes and subscriptions beyond the limits.
};

/// A subscription to all variables of certain names and sources.
struct MoosPattern {
  std::string source = "*";
  std::string key = "*";
  double interval_s = 0;
};

/// Returns what "AppPattern=GLOB,VarPattern=GLOB,Interval=S" states; parts may be missing.
[[nodiscard]] MoosPattern ParseMoosPattern(std::string_view text);

class MoosVariables {
 public:
  explicit MoosVariables(MoosLimits limits = {}) : limits_(limits) {}

  /// Writes a variable; its subscribers get the message as it is. Returns false where it is
  /// dropped. `time_s`: now, for intervals.
  bool Write(const MoosMessage& message, double time_s, MoosMail* mail);

  /// Subscribes, or sets the interval of a subscription: its present value goes into `mail`, with
  /// id -1, where it has one.
  void Subscribe(MoosClientId client, const std::string& key, double interval_s, double time_s,
                 MoosMail* mail);
  void Unsubscribe(MoosClientId client, std::string_view key);
  void SubscribePattern(MoosClientId client, const MoosPattern& pattern, double time_s,
                        MoosMail* mail);
  /// Ends the subscriptions to what fits `pattern` now.
  void UnsubscribePattern(MoosClientId client, const MoosPattern& pattern);
  /// Forgets all subscriptions of a client.
  void Remove(MoosClientId client);

  /// Returns the last write of a variable; nullptr: it was never written.
  const MoosMessage* Find(std::string_view key) const;
  /// Returns the names of the variables that were written, in order.
  std::vector<std::string> Names() const;
  const MoosVariableCounts& counts() const { return counts_; }
  size_t num_subscriptions() const { return num_subscriptions_; }

 private:
  struct Subscription {
    double interval_s = 0;
    double sent_s = -1e300;  ///< When a value went out last.
  };
  struct Variable {
    std::optional<MoosMessage> last;
    std::map<MoosClientId, Subscription> subscribers;
  };
  using Variables = std::map<std::string, Variable, std::less<>>;

  Variable* FindOrMake(const std::string& key);
  /// Returns nullptr beyond the limits.
  Subscription* SubscribeTo(MoosClientId client, Variable* variable);
  void Present(MoosClientId client, double time_s, Variable* variable, MoosMail* mail);

  MoosLimits limits_;
  Variables variables_;
  std::map<MoosClientId, std::vector<MoosPattern>> patterns_;
  size_t num_value_bytes_ = 0;
  size_t num_subscriptions_ = 0;
  MoosVariableCounts counts_;
};

}  // namespace shoal

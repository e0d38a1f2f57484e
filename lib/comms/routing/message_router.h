// Decides node messages and their acks: what their source may send, which vehicles they are for,
// and their fate at each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/contact_book.h"
#include "lib/comms/routing/destinations.h"
#include "lib/comms/routing/fate_ledger.h"
#include "lib/comms/routing/rules.h"
#include "lib/comms/routing/transmission.h"

namespace shoal {

/// What the rules ask about a node message.
struct MessageFacts {
  std::string_view source;
  std::string_view dest_node = {};   ///< Names joined by ':', or all.
  std::string_view dest_group = {};  ///< A group, or all.
  int64_t length_bytes = 0;          ///< Of its string_val.
  bool is_sound = true;  ///< False: the caller found something missing or impossible in it.
  /// The gateway that sends it on, whose transmission it is: min_msg_interval is not asked.
  std::string_view gateway = {};
};

/// What the rules ask about an ack.
struct AckFacts {
  std::string_view source;
  std::string_view destination;
  bool is_sound = true;
  std::string_view gateway = {};  ///< As of a message.
};

class MessageRouter {
 public:
  /// All must outlive this.
  MessageRouter(const RoutingRules& rules, uint64_t seed, ContactBook& contacts, FateLedger& ledger)
      : rules_(rules), seed_(seed), contacts_(contacts), ledger_(ledger) {}

  /// From now on these vehicles, in any order, receive every message and ack, whoever it is for.
  void SetGateways(std::span<const std::string> names);

  /// See Router::RouteMessage and Router::RouteAck.
  void RouteMessage(const MessageFacts& message, int64_t utime, std::vector<Decision>* decisions,
                    std::vector<std::string>* unknown_names);
  void RouteAck(const AckFacts& ack, int64_t utime, std::vector<Decision>* decisions,
                std::vector<std::string>* unknown_names);

 private:
  /// The destinations of a message.
  struct Audience {
    std::vector<Contact*> contacts;  ///< In order of keys, known or not.
    std::vector<std::string> names;  ///< Of no contact, as written.
    std::vector<Contact*> gateways;  ///< Known, and not among the contacts.
  };
  void AddGateways(const Contact& source, std::string_view maker, Audience* audience);
  Audience Resolve(const Destinations& named, std::string_view dest_group, const Contact& source);
  std::optional<Decision> RefuseMessage(int64_t length_bytes, bool is_forwarded, Contact* source,
                                        int64_t utime);
  void DecideAll(const Transmission& message, const std::optional<Decision>& refusal,
                 const Audience& audience, Contact* source, int64_t utime,
                 std::vector<Decision>* decisions, std::vector<std::string>* unknown_names);

  const RoutingRules& rules_;
  uint64_t seed_;
  ContactBook& contacts_;
  FateLedger& ledger_;
  std::vector<Contact*> gateways_;
};

}  // namespace shoal

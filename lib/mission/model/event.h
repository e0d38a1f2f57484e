// [[event]] and [[order]] as data.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lib/comms/routing/control.h"

namespace shoal {

/// `[[event]]`: a message that is published at a given time.
struct CommandEvent {
  std::string vehicle;  ///< A name, or "all".
  std::string command;  ///< A helm command: see helm_command_t.
  std::string argument;
  std::vector<double> values;

  bool operator==(const CommandEvent&) const = default;
};
struct SimCommandEvent {
  std::string vehicle;
  std::string command;  ///< See sim_command_t.
  std::vector<double> values;

  bool operator==(const SimCommandEvent&) const = default;
};
struct RuleEvent {
  std::string rule;     ///< One of ControlTable(): "comms_range", "stealth", ...
  std::string vehicle;  ///< Where the rule is of one vehicle; otherwise empty.
  ControlValue value;   ///< A request has none.

  bool operator==(const RuleEvent&) const = default;
};
struct MessageEvent {  ///< A vehicle sends a node message: see node_message_t.
  std::string src_node;
  std::string dest_node;   ///< Names joined by ':', or all.
  std::string dest_group;  ///< A group, or all.
  std::string var_name;
  std::string string_val;
  std::optional<double> double_val;  ///< Present: the value, and string_val is empty.
  bool ack = false;                  ///< Repeated until it is acknowledged.

  bool operator==(const MessageEvent&) const = default;
};
struct Event {
  double at_s = 0;  ///< Mission seconds since the start.
  std::variant<CommandEvent, SimCommandEvent, RuleEvent, MessageEvent> what;

  bool operator==(const Event&) const = default;
};

/// `[[order]]`: a command that `shoal send NAME` gives; orders of one name are given together, in
/// the order of the file.
struct NamedOrder {
  std::string name;
  CommandEvent command;

  bool operator==(const NamedOrder&) const = default;
};

}  // namespace shoal

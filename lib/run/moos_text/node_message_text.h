// Node messages as MOOS apps write them.
//
//   Result<MoosNodeMessage> message = ParseNodeMessage(
//       "src_node=alpha,dest_node=bravo,var_name=SPEED_UPDATE,string_val=\"speed=2, now\"");
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {

struct MoosNodeMessage {
  std::string src_node;
  std::string src_app;
  std::string dest_node;   ///< Names joined by ':', or all.
  std::string dest_group;  ///< A group, or all.
  std::string var_name;
  std::string string_val;
  std::optional<double> double_val;  ///< Absent: the value is string_val.
  std::string color;                 ///< Of its pulse.
  bool ack = false;
  std::string ack_id;
  std::vector<MoosField> extra;  ///< Other keys, such as src_bhv, in order.

  bool operator==(const MoosNodeMessage&) const = default;
};

/// Keys count without regard to case; dest_name is another name of dest_node. Required: src_node,
/// var_name, and dest_node or dest_group. A message has string_val or double_val; without either
/// string_val is empty. The error names the key and states what to write.
[[nodiscard]] Result<MoosNodeMessage> ParseNodeMessage(std::string_view text);

}  // namespace shoal

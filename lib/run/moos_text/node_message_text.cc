#include "lib/run/moos_text/node_message_text.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

constexpr std::array<std::pair<std::string_view, std::string MoosNodeMessage::*>, 9> kTextKeys = {{
    {"src_node", &MoosNodeMessage::src_node},
    {"src_app", &MoosNodeMessage::src_app},
    {"dest_node", &MoosNodeMessage::dest_node},
    {"dest_name", &MoosNodeMessage::dest_node},
    {"dest_group", &MoosNodeMessage::dest_group},
    {"var_name", &MoosNodeMessage::var_name},
    {"string_val", &MoosNodeMessage::string_val},
    {"color", &MoosNodeMessage::color},
    {"ack_id", &MoosNodeMessage::ack_id},
}};

/// Takes one field. Returns what is wrong with it; empty: nothing.
std::string Take(MoosField field, const std::string& key, MoosNodeMessage* message) {
  for (const auto& [name, member] : kTextKeys) {
    if (name == key) {
      message->*member = std::move(field.value);
      return "";
    }
  }
  if (key == "double_val") {
    message->double_val = NumberIn(field.value);
    if (!message->double_val) {
      return fmt::format("double_val = {} is not a finite number; write string_val=... for text",
                         Quoted(field.value));
    }
  } else if (key == "ack") {
    const std::string word = LowerCase(field.value.substr(0, 8));
    if (word != "true" && word != "false") {
      return fmt::format("ack = {} is neither true nor false", Quoted(field.value));
    }
    message->ack = word == "true";
  } else {
    message->extra.push_back(std::move(field));
  }
  return "";
}

bool IsKnown(const std::string& key) {
  for (const auto& [name, member] : kTextKeys) {
    if (name == key) return true;
  }
  return key == "double_val" || key == "ack";
}

}  // namespace

Result<MoosNodeMessage> ParseNodeMessage(std::string_view text) {
  Result<std::vector<MoosField>> fields = ParseFields(text);
  if (!fields.ok()) return Error{fields.error()};
  MoosNodeMessage message;
  std::set<std::string> seen;
  for (MoosField& field : *fields) {
    constexpr size_t kLongestKey = 16;
    const std::string key = field.key.size() > kLongestKey ? "" : LowerCase(field.key);
    const std::string name = key == "dest_name" ? "dest_node" : key;
    if (IsKnown(key) && !seen.insert(name).second) {
      return Error{fmt::format("{} is given twice; leave one of the two", name)};
    }
    if (std::string problem = Take(std::move(field), key, &message); !problem.empty()) {
      return Error{std::move(problem)};
    }
  }
  if (message.src_node.empty()) return Error{"src_node is missing; write src_node=<vehicle>"};
  if (message.dest_node.empty() && message.dest_group.empty()) {
    return Error{"dest_node and dest_group are missing; write dest_node=<vehicle> or all"};
  }
  if (message.var_name.empty()) return Error{"var_name is missing; write var_name=<variable>"};
  if (message.double_val && !message.string_val.empty()) {
    return Error{"string_val and double_val are both given; leave one of the two"};
  }
  return message;
}

}  // namespace shoal

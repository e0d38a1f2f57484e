#include "lib/tools/moos/contact_templates.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/tools/moos/bhv_keys.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

/// Replaces $[CONTACT] by a name: in conditions it is in upper case, else as it is.
std::string WithContact(std::string text, const std::string& contact, bool is_condition) {
  for (const auto& [macro, value] : {std::pair<std::string_view, std::string>(
                                         "$[CONTACT]", is_condition ? UpperCase(contact) : contact),
                                     {"$[contact]", LowerCase(contact)},
                                     {"$[Contact]", contact}}) {
    for (size_t at = text.find(macro); at != text.npos; at = text.find(macro, at + value.size())) {
      text.replace(at, macro.size(), value);
    }
  }
  return text;
}

}  // namespace

bool AsksForAlerts(const BhvBlock& block) {
  const std::string_view kind = KindOfBhv(block.type);
  if (!IsContactKind(kind)) return false;
  bool is_template = false;
  bool has_updates = false;
  // CutRange asks for alerts by default.
  bool needs = kind == "cut_range";
  for (const MoosLine& line : block.lines) {
    const std::string key = LowerCase(line.key.substr(0, 64));
    const std::string word = LowerCase(WithoutQuotes(line.value).substr(0, 16));
    if (key == "templating") is_template = word == "spawn";
    const bool has_alerts = kind == "avoid_collision" || kind == "colregs";
    if (key == "updates") has_updates = true;
    if (key == "no_alert_request" && !has_alerts) needs = word == "false";
  }
  return is_template && needs && has_updates;
}

bool NeedsOneForEach(const BhvBlock& block) {
  return KindOfBhv(block.type) != "cut_range" && AsksForAlerts(block);
}

std::vector<BhvBlock> OneForEach(const BhvBlock& block, const std::vector<std::string>& contacts) {
  std::vector<BhvBlock> blocks;
  for (const std::string& contact : contacts) {
    BhvBlock one = block;
    one.lines.clear();
    bool has_contact = false;
    for (MoosLine line : block.lines) {
      const std::string key = LowerCase(line.key.substr(0, 64));
      if (key == "max_spawnings") continue;
      if (key == "templating") line.value = "disallowed";
      const bool is_contact = key == "contact" || key == "them";
      has_contact = has_contact || is_contact;
      if (key == "name" || key == "descriptor") line.value += contact;
      line.value = is_contact ? contact : WithContact(line.value, contact, key == "condition");
      line.text = line.key;
      line.text.append(" = ").append(line.value);
      one.lines.push_back(std::move(line));
    }
    for (const auto& [key, value] :
         {std::pair<std::string, std::string>("contact", contact), {"on_no_contact_ok", "true"}}) {
      if (key == "contact" && has_contact) continue;
      std::string text = key;
      text.append(" = ").append(value);
      one.lines.push_back({.number = 0,
                           .origin = block.origin,
                           .text = std::move(text),
                           .key = key,
                           .value = value});
    }
    blocks.push_back(std::move(one));
  }
  return blocks;
}

void CollectVariablesOfContacts(const BhvBlock& block, const std::vector<std::string>& contacts,
                                std::set<std::string, std::less<>>* variables) {
  for (const MoosLine& line : block.lines) {
    const bool has_contact = LowerCase(line.value).find("$[contact]") != line.value.npos;
    if (LowerCase(line.key) != "condition" || !has_contact) continue;
    for (const std::string& contact : contacts) {
      CollectVariables(WithContact(ConditionText(line.value), contact, true), variables);
    }
  }
}

}  // namespace shoal

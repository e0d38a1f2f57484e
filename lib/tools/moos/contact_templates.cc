#include "lib/tools/moos/contact_templates.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/tools/moos/bhv_keys.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

/// Replaces $[CONTACT] by a name.
std::string WithContact(std::string text, const std::string& contact) {
  constexpr std::string_view kMacro = "$[CONTACT]";
  for (size_t at = text.find(kMacro); at != text.npos; at = text.find(kMacro, at)) {
    text.replace(at, kMacro.size(), contact);
    at += contact.size();
  }
  return text;
}

}  // namespace

bool NeedsOneForEach(const BhvBlock& block) {
  const std::string_view kind = KindOfBhv(block.type);
  if (!IsContactKind(kind)) return false;
  bool is_template = false;
  bool needs = false;
  for (const MoosLine& line : block.lines) {
    const std::string key = LowerCase(line.key.substr(0, 64));
    const std::string word = LowerCase(WithoutQuotes(line.value).substr(0, 16));
    if (key == "templating") is_template = word == "spawn";
    const bool has_alerts = kind == "avoid_collision" || kind == "colregs";
    if (key == "no_alert_request" && word == "false" && !has_alerts) needs = true;
  }
  return is_template && needs;
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
      line.value = is_contact ? contact : WithContact(line.value, contact);
      line.text = line.key + " = " + line.value;
      one.lines.push_back(std::move(line));
    }
    for (const auto& [key, value] :
         {std::pair<std::string, std::string>("contact", contact), {"on_no_contact_ok", "true"}}) {
      if (key == "contact" && has_contact) continue;
      one.lines.push_back({.number = 0,
                           .origin = block.origin,
                           .text = key + " = " + value,
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
    if (LowerCase(line.key) != "condition" || line.value.find("$[CONTACT]") == line.value.npos) {
      continue;
    }
    for (const std::string& contact : contacts) {
      CollectVariables(WithContact(ConditionText(line.value), contact), variables);
    }
  }
}

}  // namespace shoal

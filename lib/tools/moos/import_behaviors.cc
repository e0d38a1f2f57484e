#include "lib/tools/moos/import_behaviors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_text.h"
#include "lib/tools/moos/contact_templates.h"
#include "lib/tools/moos/import_block.h"

namespace shoal {
namespace {

constexpr size_t kMax = 200;

/// A key of a TOML table, in quotes where it needs them.
std::string TomlKey(std::string_view name) {
  const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return IsNameCharacter(c) || c == '-';
  });
  return is_bare ? std::string(name) : TomlString(name);
}

void ImportMode(const BhvMode& mode, BhvImport* import) {
  BhvTable table{.header = "[[vehicle.mode]]", .lines = {}};
  const auto set = [&](std::string key, std::string value, std::string origin, std::string text) {
    table.lines.push_back({.key = std::move(key),
                           .value = std::move(value),
                           .origin = std::move(origin),
                           .text = std::move(text),
                           .reason = "",
                           .is_essential = true});
  };
  const std::string declared = mode.variable + " = " + mode.value;
  set("set", TomlString(declared), mode.origin, "set " + declared);
  std::vector<std::string> conditions;
  std::string origins;
  std::string texts;
  for (const MoosLine& line : mode.conditions) {
    conditions.push_back(ConditionText(line.text));
    CollectVariables(conditions.back(), &import->variables);
    CollectVariables(conditions.back(), &import->condition_variables);
    origins += (origins.empty() ? "" : ", ") + line.origin;
    texts += (texts.empty() ? "" : ", ") + line.text;
  }
  if (!conditions.empty()) set("condition", TomlTexts(conditions), origins, texts);
  if (!mode.otherwise.empty()) {
    set("else", TomlString(mode.otherwise), mode.origin, "} " + mode.otherwise);
  }
  import->tables.push_back(std::move(table));
}

/// Orders set these where they are variables: those of conditions that no line initializes are
/// made so.
void AddOrderVariables(const BhvImport& import, BhvTable* table) {
  for (const char* name : {"DEPLOY", "RETURN", "STATION_KEEP"}) {
    const bool is_there = std::any_of(table->lines.begin(), table->lines.end(),
                                      [&](const DraftLine& line) { return line.key == name; });
    if (is_there || !import.condition_variables.contains(name)) continue;
    table->lines.push_back({.key = name,
                            .value = TomlString("false"),
                            .origin = "",
                            .text = "",
                            .reason = "Assumed: conditions name it, an order sets it."});
  }
}

/// No name of a behavior may be the beginning of another's in shoal: "leg" beside "leg2" becomes
/// "leg_1".
void SetNamesApart(std::vector<BhvTable>* tables) {
  std::vector<DraftLine*> names;
  for (BhvTable& table : *tables) {
    for (DraftLine& line : table.lines) {
      if (table.header == "[[vehicle.behavior]]" && line.key == "name") names.push_back(&line);
    }
  }
  // In quotes: without the last one.
  const auto begins = [](const std::string& other, std::string_view name) {
    return other.size() > name.size() && other.starts_with(name.substr(0, name.size() - 1));
  };
  for (DraftLine* line : names) {
    const std::string plain = line->value.substr(0, line->value.size() - 1);
    std::string wanted = line->value;
    const auto is_beginning = [&](const DraftLine* other) {
      return other != line && begins(other->value, wanted);
    };
    const auto is_same = [&](const DraftLine* other) {
      return other != line && other->value == wanted;
    };
    for (size_t i = 1; std::any_of(names.begin(), names.end(), is_beginning) ||
                       (i > 1 && std::any_of(names.begin(), names.end(), is_same));
         ++i) {
      wanted = fmt::format("{}_{}\"", plain, i);
    }
    if (wanted == line->value) continue;
    line->value = wanted;
    line->reason = "Assumed: another behavior's name begins with it.";
  }
}

BhvTable ImportVariables(const BhvFile& file, BhvImport* import) {
  BhvTable table{.header = "[vehicle.variables]", .lines = {}};
  std::map<std::string, size_t> places;
  for (const MoosLine& line : file.initials) {
    import->variables.insert(line.key);
    const auto number = NumberIn(line.value);
    const bool is_text = !number || line.value.starts_with('"');
    DraftLine setting{
        .key = TomlKey(line.key),
        .value = is_text ? TomlString(WithoutQuotes(line.value)) : TomlNumber(*number),
        .origin = line.origin,
        .text = "initialize " + line.text,
        .reason = ""};
    const auto [at, is_new] = places.emplace(setting.key, table.lines.size());
    if (!is_new) {
      DraftLine& earlier = table.lines[at->second];
      earlier.key.clear();
      earlier.reason = "replaced by " + line.origin;
      at->second = table.lines.size();
    }
    table.lines.push_back(std::move(setting));
  }
  return table;
}

/// Returns the first kMax of a list; names what is left out.
template <class Item>
std::vector<Item> Bounded(std::vector<Item> items, std::string_view what, BhvImport* import) {
  if (items.size() <= kMax) return items;
  import->warnings.push_back(fmt::format("{}: {} are left out from here on: {} are the most",
                                         items[kMax].origin, what, kMax));
  items.resize(kMax);
  return items;
}

/// Collects the words of all lines of a file.
void CollectWords(const BhvFile& file, std::set<std::string, std::less<>>* words) {
  for (const MoosLine& line : file.initials) CollectVariables(line.text, words);
  for (const BhvMode& mode : file.modes) {
    CollectVariables(mode.variable, words);
    for (const MoosLine& line : mode.conditions) CollectVariables(line.text, words);
  }
  for (const BhvBlock& block : file.behaviors) {
    for (const MoosLine& line : block.lines) CollectVariables(line.text, words);
  }
}

}  // namespace

BhvImport ImportBhv(const BhvFile& whole, const std::vector<std::string>& contacts) {
  BhvImport import;
  BhvFile file = whole;
  file.initials = Bounded(std::move(file.initials), "variables", &import);
  file.modes = Bounded(std::move(file.modes), "modes", &import);
  file.behaviors = Bounded(std::move(file.behaviors), "behaviors", &import);
  CollectWords(file, &import.words);
  BhvTable variables = ImportVariables(file, &import);
  for (const BhvMode& mode : file.modes) ImportMode(mode, &import);
  for (const BhvBlock& block : file.behaviors) {
    CollectVariablesOfContacts(block, contacts, &import.variables);
    if (!NeedsOneForEach(block)) {
      ImportBhvBlock(block, &import);
      continue;
    }
    for (const BhvBlock& one : OneForEach(block, contacts)) ImportBhvBlock(one, &import);
    if (!contacts.empty()) continue;
    import.warnings.push_back(
        fmt::format("{}: Behavior = {}: is left out: it is about contacts, and the mission has no "
                    "other vehicle",
                    block.origin, block.type));
    import.lost.push_back(import.warnings.back());
  }
  for (const UnpostedVariable& each : import.unposted) {
    if (!import.condition_variables.contains(each.variable)) continue;
    import.warnings.push_back(
        fmt::format("{}: is not posted here, and a condition reads it", each.line));
  }
  SetNamesApart(&import.tables);
  AddOrderVariables(import, &variables);
  if (!variables.lines.empty()) import.tables.insert(import.tables.begin(), std::move(variables));
  BhvTable odd{.header = "# What else is in " + file.name + ".", .lines = {}};
  for (const MoosOddLine& line : file.odd_lines) {
    odd.lines.push_back(
        {.key = "", .value = "", .origin = line.origin, .text = line.text, .reason = line.reason});
    if (line.is_loss) {
      import.warnings.push_back(
          fmt::format("{}: {} {}", line.origin, Quoted(line.text), line.reason));
      import.lost.push_back(import.warnings.back());
    }
  }
  if (!odd.lines.empty()) import.tables.push_back(std::move(odd));
  return import;
}

}  // namespace shoal

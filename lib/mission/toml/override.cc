#include "lib/mission/toml/override.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMaxParts = 16;
/// Missing tables are made, but for these: an override changes one of a list, it adds none.
constexpr std::array<std::string_view, 7> kLists = {"vehicle", "fleet",  "event", "participant",
                                                    "host",    "expect", "task"};

bool IsKeyCharacter(char c) { return IsNameCharacter(c) || c == '-'; }

bool IsBareWord(std::string_view text) {
  return !text.empty() && (IsLetter(text[0]) || text[0] == '_') &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return IsKeyCharacter(c) || std::string_view(".:/").find(c) != std::string_view::npos;
         });
}

/// Splits the path before '='; a part may be in double quotes. Returns the path and where '='
/// is; an empty path where the text has not this form.
std::pair<std::vector<std::string>, size_t> SplitPath(std::string_view text) {
  std::vector<std::string> path;
  for (size_t at = 0; at < text.size() && path.size() < kMaxParts;) {
    size_t end = at;
    if (text[at] == '"') {
      end = text.find('"', at + 1);
      if (end == std::string_view::npos) break;
      path.emplace_back(text.substr(at + 1, end - at - 1));
      ++end;
    } else {
      while (end < text.size() && IsKeyCharacter(text[end])) ++end;
      if (end == at) break;
      path.emplace_back(text.substr(at, end - at));
    }
    if (end < text.size() && text[end] == '=') return {path, end};
    if (end >= text.size() || text[end] != '.') break;
    at = end + 1;
  }
  return {};
}

/// Returns the element that `part` names: by its name without regard to case, or by its number.
Value* FindElement(Array& array, const std::string& part, std::string_view parent) {
  for (Value& element : array) {
    const std::string* name = NameOfElement(element, parent);
    if (name != nullptr && LowerCase(*name) == LowerCase(part)) return &element;
  }
  const size_t number = ReadNumber<size_t>(part).value_or(0);
  return number >= 1 && number <= array.size() ? &array[number - 1] : nullptr;
}

std::string NoSuchElement(const Array& array, const std::string& part, std::string_view parent) {
  std::vector<std::string_view> names;
  for (const Value& element : array) {
    if (const std::string* name = NameOfElement(element, parent)) names.push_back(*name);
  }
  std::string hint = DidYouMean(part, names);
  if (hint.empty()) {
    hint = fmt::format("; the file has {} of them, numbered from 1", array.size());
  }
  return fmt::format("no {} {}{}", parent, Quoted(part), hint);
}

std::string NoSuchTemplate(const Table& templates, const std::string& name) {
  std::vector<std::string_view> names;
  for (const Entry& entry : templates) names.push_back(entry.key);
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) {
    hint = names.empty() ? "; the file has no [template.NAME]" : "; the file has " + Joined(names);
  }
  return "no template " + Quoted(name) + hint;
}

}  // namespace

const std::string* NameOfElement(const Value& element, std::string_view parent) {
  const std::string* name = FindText(element, "name");
  const bool has_kind = parent == "task" || parent == "behavior";
  return name == nullptr && has_kind ? FindText(element, "kind") : name;
}

std::optional<Override> ParseOverride(std::string_view text, int64_t number, Problems& problems) {
  const Place place = {.override_number = number};
  auto [path, equals] = SplitPath(text);
  if (path.empty()) {
    problems.Add(
        place, "not of the form key.path=value, such as mission.seed=7 or vehicle.alpha.helm=hand");
    return std::nullopt;
  }
  const std::string_view value_text = text.substr(equals + 1);
  std::optional<Value> value = ParseTomlValue(value_text, place);
  if (!value && IsBareWord(value_text)) value = Value{place, std::string(value_text)};
  if (!value) {
    problems.Add(place, fmt::format("{} is not a TOML value; a text with other characters than "
                                    "letters, digits and _-.:/ needs quotes: '{}=\"...\"'",
                                    Quoted(value_text), path.back()));
    return std::nullopt;
  }
  return Override{std::move(path), std::move(*value), place};
}

void Apply(const Override& override_, Value& root, Problems& problems) {
  Value* here = &root;
  std::string_view parent = "mission file";
  for (size_t i = 0; i < override_.path.size(); ++i) {
    const std::string& part = override_.path[i];
    const bool last = i + 1 == override_.path.size();
    if (auto* array = std::get_if<Array>(&here->data)) {
      here = FindElement(*array, part, parent);
      if (here == nullptr) {
        problems.Add(override_.place, NoSuchElement(*array, part, parent));
        return;
      }
      if (last) *here = override_.value;
    } else if (auto* table = std::get_if<Table>(&here->data)) {
      if (last) {
        Set(*table, part, override_.place, override_.value);
        return;
      }
      if (Find(*table, part) == nullptr) {
        if (std::find(kLists.begin(), kLists.end(), part) != kLists.end()) {
          problems.Add(override_.place, fmt::format("there is no [[{}]] to change", part));
          return;
        }
        if (i == 1 && parent == "template") {
          problems.Add(override_.place, NoSuchTemplate(*table, part));
          return;
        }
        Set(*table, part, override_.place, Value{override_.place, Table()});
      }
      here = Find(*table, part);
    } else {
      problems.Add(override_.place,
                   fmt::format("'{}' is {}; nothing lies below it", parent, WhatIs(*here)));
      return;
    }
    parent = part;
  }
}

}  // namespace shoal

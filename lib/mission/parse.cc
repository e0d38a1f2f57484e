#include "lib/mission/parse.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace shoal {
namespace {

// toml++ limits the depth of brackets but not the parts of a dotted key, and recurses on both: a
// key of 100,000 parts would overflow the stack. No key of a mission file has more than five.
constexpr int kMostKeyParts = 16;
constexpr int kDeepestValue = 32;

/// Walks over TOML just far enough to count the dots of each key.
class DotCounter {
 public:
  explicit DotCounter(std::string_view text) : text_(text) {}

  /// Returns the place of the first key with too many parts.
  std::optional<Place> FindTooLongKey() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        SkipString(c);
        continue;
      }
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      if (c == '.' && ++dots_ >= kMostKeyParts) return HerePlace();
      if (std::string_view("[]{}=,\n").find(c) != std::string_view::npos) dots_ = 0;
      ++at_;
    }
    return std::nullopt;
  }

 private:
  void SkipString(char quote) {
    const std::string three(3, quote);
    const bool many_lines = text_.substr(at_, 3) == three;
    at_ += many_lines ? 3 : 1;
    while (at_ < text_.size()) {
      if (quote == '"' && text_[at_] == '\\') {
        at_ += 2;
      } else if (many_lines ? text_.substr(at_, 3) == three : text_[at_] == quote) {
        at_ += many_lines ? 3 : 1;
        return;
      } else if (!many_lines && text_[at_] == '\n') {
        return;  // An error that the parser describes better.
      } else {
        ++at_;
      }
    }
  }

  Place HerePlace() const {
    const std::string_view before = text_.substr(0, at_);
    const size_t line_break = before.rfind('\n');
    const size_t line_start = line_break == std::string_view::npos ? 0 : line_break + 1;
    return {.line = 1 + std::count(before.begin(), before.end(), '\n'),
            .column = static_cast<int64_t>(at_ - line_start) + 1};
  }

  std::string_view text_;
  size_t at_ = 0;
  int dots_ = 0;
};

Place PlaceOf(const toml::source_region& source) {
  return {.line = source.begin.line, .column = source.begin.column};
}

/// Converts the tree of toml++, which sorts by key, to ours, in the order of the file. Sets
/// `too_deep` where it gives up.
Value Convert(const toml::node& node, int depth, std::optional<Place>& too_deep) {
  Value value;
  value.place = PlaceOf(node.source());
  if (depth > kDeepestValue) {
    too_deep = value.place;
  } else if (const auto* table = node.as_table()) {
    Table entries;
    for (const auto& [key, child] : *table) {
      entries.push_back(
          {std::string(key.str()), PlaceOf(key.source()), Convert(child, depth + 1, too_deep)});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return std::pair(a.key_place, a.key) < std::pair(b.key_place, b.key);
    });
    value.data = std::move(entries);
  } else if (const auto* array = node.as_array()) {
    Array elements;
    for (const toml::node& child : *array) {
      elements.push_back(Convert(child, depth + 1, too_deep));
    }
    value.data = std::move(elements);
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    value.data = flag->get();
  } else {
    value.data = DateOrTime();
  }
  return value;
}

void Replace(Value& value, const Place& place) {
  value.place = place;
  if (auto* array = std::get_if<Array>(&value.data)) {
    for (Value& element : *array) Replace(element, place);
  } else if (auto* table = std::get_if<Table>(&value.data)) {
    for (Entry& entry : *table) {
      entry.key_place = place;
      Replace(entry.value, place);
    }
  }
}

}  // namespace

std::optional<Value> ParseToml(std::string_view text, Problems& problems) {
  if (const auto place = DotCounter(text).FindTooLongKey()) {
    problems.Add(*place, fmt::format("a key has more than {} parts; no key of a mission file does",
                                     kMostKeyParts));
    return std::nullopt;
  }
  try {
    const toml::table parsed = toml::parse(text, std::string_view("mission"));
    std::optional<Place> too_deep;
    Value root = Convert(parsed, 0, too_deep);
    if (!too_deep) return root;
    problems.Add(
        *too_deep,
        fmt::format("nested deeper than {} levels; no part of a mission file is", kDeepestValue));
  } catch (const toml::parse_error& error) {
    problems.Add(PlaceOf(error.source()), "not TOML: " + std::string(error.description()));
  }
  return std::nullopt;
}

std::optional<Value> ParseTomlValue(std::string_view text, const Place& place) {
  Problems ignored("", {});
  std::optional<Value> root = ParseToml("value = " + std::string(text), ignored);
  if (!root) return std::nullopt;
  Table& table = std::get<Table>(root->data);
  if (table.size() != 1 || table.front().key != "value") return std::nullopt;
  Value value = std::move(table.front().value);
  Replace(value, place);
  return value;
}

}  // namespace shoal

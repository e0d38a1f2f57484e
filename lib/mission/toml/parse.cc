#include "lib/mission/toml/parse.h"

#include <fmt/format.h>
#include <pthread.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <system_error>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"

namespace shoal {
namespace {

constexpr int kDeepestValue = 32;  ///< The deepest key of a mission file has seven levels.
constexpr size_t kLongestText_bytes = size_t{4} << 20;

// toml++ recurses once for each part of a dotted key, and knows no limit of these. The deepest text
// of a length is one such key, two bytes per part. toml++ 3.3 needs 32 bytes of stack per byte of
// text for it as released, 224 without optimization, 304 with the address sanitizer.
constexpr size_t kStackPerByte = 512;
constexpr size_t kLeastStack_bytes = size_t{8} << 20;
/// Any stack suffices for this; a recording may have 100,000 overrides, and each thread takes time.
constexpr size_t kShortText_bytes = 1024;

/// Runs `work` to its end on a thread with this stack. Returns 0, or the errno of a thread that
/// cannot be made. Memory is used only for the part of the stack that is touched.
int RunOnStack(size_t size_bytes, const std::function<void()>& work) {
  pthread_attr_t attributes;
  pthread_t thread{};
  pthread_attr_init(&attributes);
  int error = pthread_attr_setstacksize(&attributes, size_bytes);
  if (error == 0) {
    error = pthread_create(
        &thread, &attributes,
        [](void* what) -> void* {
          (*static_cast<const std::function<void()>*>(what))();
          return nullptr;
        },
        const_cast<std::function<void()>*>(&work));
  }
  pthread_attr_destroy(&attributes);
  if (error == 0) pthread_join(thread, nullptr);
  return error;
}

Place PlaceOf(const toml::source_region& source) {
  return {.line = source.begin.line, .column = source.begin.column};
}

/// Converts the tree of toml++, which sorts by key, to ours, in the order of the file. Sets
/// `too_deep` to the first place where it gives up.
Value Convert(const toml::node& node, int depth, std::optional<Place>& too_deep) {
  Value value;
  value.place = PlaceOf(node.source());
  if (depth > kDeepestValue) {
    if (!too_deep) too_deep = value.place;
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

std::string_view LineOf(std::string_view text, int64_t line) {
  for (int64_t i = 1; i < line && !text.empty(); ++i) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// Returns what toml++ states, in the words of mission files where it is what beginners write.
std::string WhyNotToml(std::string_view description, std::string_view line, int64_t column) {
  constexpr std::string_view kRedefined = "cannot redefine existing table '";
  if (const size_t at = description.find(kRedefined);
      at != std::string_view::npos && description.ends_with("as array-of-tables")) {
    const std::string_view rest = description.substr(at + kRedefined.size());
    const std::string_view name = rest.substr(0, rest.find('\''));
    return fmt::format(
        "a table of {0}, such as [{0}.x] or [[{0}.x]], comes before the first [[{0}]]: write "
        "[[{0}]] first, and what belongs to it after it",
        name);
  }
  // toml++ takes the end of the line for a control character; a true one is on the line.
  const auto num_characters =
      std::ranges::count_if(line, [](char c) { return (static_cast<uint8_t>(c) & 0xC0) != 0x80; });
  if (column > num_characters && description.find("string: ") != std::string_view::npos &&
      description.find("control characters") != std::string_view::npos) {
    return "the text has no closing quote on its line";
  }
  if (description.ends_with("expected '=', saw ','") && line.find('{') != std::string_view::npos) {
    return "values in braces have keys: {key = value, key = value}";
  }
  const size_t equals = line.find('=');
  if (equals != std::string_view::npos && description.ends_with("could not determine value type")) {
    const std::string_view key = Trimmed(line.substr(0, equals));
    const std::string_view value = Trimmed(line.substr(equals + 1, line.find('#') - equals - 1));
    const bool is_word = !value.empty() && std::ranges::all_of(value, IsNameCharacter);
    if (is_word) return fmt::format("a text needs quotes: write {} = \"{}\"", key, value);
    constexpr std::array<std::string_view, 4> kTypographic = {"\u201c", "\u201e", "\u00ab",
                                                              "\u2018"};
    const bool is_typographic = std::ranges::any_of(
        kTypographic, [&](std::string_view quote) { return value.starts_with(quote); });
    if (is_typographic) return "quotes around a text are straight ones: \" or '";
  }
  return TerminalLine(description);  // It may quote what the file has there.
}

/// Parses on the stack of the calling thread.
std::optional<Value> ParseHere(std::string_view text, Problems& problems) {
  try {
    const toml::table parsed = toml::parse(text, std::string_view("mission"));
    std::optional<Place> too_deep;
    Value root = Convert(parsed, 0, too_deep);
    if (!too_deep) return root;
    problems.Add(
        *too_deep,
        fmt::format("nested deeper than {} levels; no part of a mission file is", kDeepestValue));
  } catch (const toml::parse_error& error) {
    const Place place = PlaceOf(error.source());
    problems.Add(place, "not TOML: " + WhyNotToml(error.description(), LineOf(text, place.line),
                                                  place.column));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Value> ParseToml(std::string_view text, Problems& problems) {
  if (text.size() > kLongestText_bytes) {
    problems.Add({}, fmt::format("is {} bytes long; a mission file has at most {}", text.size(),
                                 kLongestText_bytes));
    return std::nullopt;
  }
  if (text.size() <= kShortText_bytes) return ParseHere(text, problems);
  std::optional<Value> root;
  const size_t stack_bytes = kLeastStack_bytes + kStackPerByte * text.size();
  const int error = RunOnStack(stack_bytes, [&] { root = ParseHere(text, problems); });
  if (error != 0) {
    problems.Add({}, fmt::format("cannot be parsed: no thread with a stack of {} MiB can be made "
                                 "({}); `ulimit -v` and `ulimit -u` may forbid it",
                                 stack_bytes >> 20, std::generic_category().message(error)));
  }
  return root;
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

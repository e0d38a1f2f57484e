#include "lib/mission/toml/update_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "lib/base/geometry/convex_polygon.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/polygon_text.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// Returns the value that `text` writes in a file, or the text itself.
Value ValueOf(const std::string& text) {
  auto value = ParseTomlValue(text, {});
  if (value) return std::move(*value);
  if (const auto number = NumberIn(text)) return {{}, *number};
  return {{}, text};
}

Value ArrayOf(const std::vector<Eigen::Vector2d>& points) {
  Array array;
  for (const Eigen::Vector2d& point : points) {
    array.push_back({{}, Array{{{}, point.x()}, {{}, point.y()}}});
  }
  return {{}, std::move(array)};
}

/// Returns the text without the quotes around it.
std::string Unquoted(const std::string& text) {
  const VariableValue value = ValueIn(text);
  const auto* inner = std::get_if<std::string>(&value);
  return inner != nullptr ? *inner : text;
}

std::string LowerCaseInside(const std::string& text) { return LowerCase(Unquoted(text)); }

}  // namespace

UpdateReader::UpdateReader(std::span<const UpdateItem> items, Problems& problems)
    : items_(items), problems_(problems) {}

UpdateReader::~UpdateReader() {
  const std::vector<std::string_view> known(known_.begin(), known_.end());
  for (const UpdateItem& item : items_) {
    if (std::find(known.begin(), known.end(), item.key) != known.end()) continue;
    const auto given = hints_.find(item.key);
    std::string hint =
        given == hints_.end() ? DidYouMean(item.key, known) : " (" + given->second + ")";
    if (hint.empty()) hint = "; known here: " + Joined(known);
    problems_.Add({}, "unknown key " + Quoted(item.key) + hint);
  }
}

const std::string* UpdateReader::Take(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  const std::string* value = nullptr;
  for (const UpdateItem& item : items_) {
    if (item.key == key) value = &item.value;  // The last one counts.
  }
  return value;
}

template <class Read>
void UpdateReader::AsInTheFile(std::string_view key, Value value, const Read& read) {
  const Value table = {{}, Table{{std::string(key), {}, std::move(value)}}};
  TableReader reader(table, "the update", problems_);
  read(reader);
}

template <class Read>
void UpdateReader::Parsed(std::string_view key, const Read& read) {
  const std::string* text = Take(key);
  if (text != nullptr) AsInTheFile(key, ValueOf(*text), read);
}

void UpdateReader::Number(std::string_view key, double& value, NumberLimits range) {
  Parsed(key, [&](TableReader& reader) { reader.Number(key, value, range); });
}

void UpdateReader::NumberOrWord(std::string_view key, double& value, double max,
                                std::string_view word, double meaning) {
  Parsed(key, [&](TableReader& reader) { reader.NumberOrWord(key, value, max, word, meaning); });
}

void UpdateReader::Scalar(std::string_view key, std::string& word) {
  Parsed(key, [&](TableReader& reader) { reader.Scalar(key, word); });
}

void UpdateReader::Integer(std::string_view key, int64_t& value, int64_t min, int64_t max) {
  Parsed(key, [&](TableReader& reader) { reader.Integer(key, value, min, max); });
}

void UpdateReader::Flag(std::string_view key, bool& value) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  const std::string word = LowerCaseInside(*text);
  if (word == "toggle") {
    value = !value;
    return;
  }
  const Value given = word == "true"    ? Value{{}, true}
                      : word == "false" ? Value{{}, false}
                                        : ValueOf(*text);
  AsInTheFile(key, given, [&](TableReader& reader) { reader.Flag(key, value); });
}

void UpdateReader::Text(std::string_view key, std::string& value, TextRule rule) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  AsInTheFile(key, {{}, Unquoted(*text)},
              [&](TableReader& reader) { reader.Text(key, value, rule); });
}

void UpdateReader::Word(std::string_view key, std::string& value,
                        std::span<const std::string_view> words) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  AsInTheFile(key, {{}, Unquoted(*text)},
              [&](TableReader& reader) { reader.Word(key, value, words); });
}

void UpdateReader::Numbers(std::string_view key, std::vector<double>& values, size_t max_count) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  Value given = ValueOf(*text);
  if (!std::holds_alternative<Array>(given.data)) given = ValueOf("[" + *text + "]");
  AsInTheFile(key, std::move(given),
              [&](TableReader& reader) { reader.Numbers(key, values, max_count); });
}

void UpdateReader::Pair(std::string_view key, Eigen::Vector2d& pair, NumberLimits range) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  Value given = ValueOf(*text);
  const auto points = ParsePoints(*text);
  if (points.ok() && points->size() == 1) {
    given = std::move(std::get<Array>(ArrayOf(*points).data).front());
  }
  AsInTheFile(key, std::move(given), [&](TableReader& reader) { reader.Pair(key, pair, range); });
}

void UpdateReader::Pairs(std::string_view key, std::vector<Eigen::Vector2d>& pairs,
                         NumberLimits range, size_t max_count) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  Value given = ValueOf(*text);
  if (!std::holds_alternative<Array>(given.data)) {
    const auto points = ParsePolygon(*text);
    if (!points.ok()) return Refuse(key, fmt::format("{}: {}", key, points.error()));
    given = ArrayOf(*points);
  }
  AsInTheFile(key, std::move(given),
              [&](TableReader& reader) { reader.Pairs(key, pairs, range, max_count); });
}

void UpdateReader::Triple(std::string_view key, Eigen::Vector3d& triple, NumberLimits range) {
  Parsed(key, [&](TableReader& reader) { reader.Triple(key, triple, range); });
}

void UpdateReader::Triples(std::string_view key, std::vector<Eigen::Vector3d>& triples,
                           NumberLimits range, size_t max_count) {
  Parsed(key, [&](TableReader& reader) { reader.Triples(key, triples, range, max_count); });
}

void UpdateReader::Texts(std::string_view key, std::vector<std::string>& texts, size_t max_count) {
  Parsed(key, [&](TableReader& reader) { reader.Texts(key, texts, max_count); });
}

void UpdateReader::TextMap(std::string_view key, std::map<std::string, std::string>& texts,
                           size_t max_count) {
  Parsed(key, [&](TableReader& reader) { reader.TextMap(key, texts, max_count); });
}

void UpdateReader::Scalars(std::string_view key,
                           std::map<std::string, std::variant<std::string, double>>& values,
                           size_t max_count) {
  Parsed(key, [&](TableReader& reader) { reader.Scalars(key, values, max_count); });
}

void UpdateReader::Below(std::string_view, const DescribeTable&) {}
void UpdateReader::Inline(std::string_view, const DescribeTable&) {}
void UpdateReader::EachBelow(std::string_view, size_t, const std::function<void(size_t)>&,
                             const std::function<void(Fields&, size_t)>&) {}

bool UpdateReader::Has(std::string_view key, bool present) {
  return Take(key) != nullptr || present;
}

/// Texts that write points or an array are read as these.
bool UpdateReader::HoldsText(std::string_view key) {
  const std::string* text = Take(key);
  return text != nullptr && !std::holds_alternative<Array>(ValueOf(*text).data);
}

void UpdateReader::NoKey(std::string_view name, std::string hint) {
  hints_.emplace(name, std::move(hint));
}

void UpdateReader::Skip(std::string_view key) { Take(key); }

void UpdateReader::Refuse(std::string_view, std::string text) {
  problems_.Add({}, std::move(text));
}

}  // namespace shoal

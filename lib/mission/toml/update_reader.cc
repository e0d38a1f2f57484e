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

namespace {

/// The value of a field as the file would write it, from the text of an update.
class ValueMaker {
 public:
  explicit ValueMaker(const std::string& text) : text_(text) {}

  Result<Value> For(const TextField&) const { return Value{{}, Unquoted(text_)}; }
  Result<Value> For(const WordField&) const { return Value{{}, Unquoted(text_)}; }
  Result<Value> For(const FlagField& field) const {
    const std::string word = LowerCaseInside(text_);
    if (word == "toggle") return Value{{}, !field.value};
    if (word == "true" || word == "false") return Value{{}, word == "true"};
    return ValueOf(text_);
  }
  Result<Value> For(const NumbersField&) const {
    Value value = ValueOf(text_);
    return std::holds_alternative<Array>(value.data) ? value : ValueOf("[" + text_ + "]");
  }
  Result<Value> For(const PairField&) const {
    const auto points = ParsePoints(text_);
    const bool is_point = points.ok() && points->size() == 1;
    return is_point ? std::get<Array>(ArrayOf(*points).data).front() : ValueOf(text_);
  }
  Result<Value> For(const PairsField&) const {
    Value value = ValueOf(text_);
    if (std::holds_alternative<Array>(value.data)) return value;
    const auto points = ParsePolygon(text_);
    if (!points.ok()) return Error{points.error()};
    return ArrayOf(*points);
  }
  /// All others are written as in the file.
  template <class AnyField>
  Result<Value> For(const AnyField&) const {
    return ValueOf(text_);
  }

 private:
  const std::string& text_;
};

}  // namespace

void UpdateReader::Key(std::string_view key, const Field& field) {
  const std::string* text = Take(key);
  if (text == nullptr) return;
  const ValueMaker maker(*text);
  Result<Value> value = std::visit([&](const auto& each) { return maker.For(each); }, field);
  if (!value.ok()) return Refuse(key, fmt::format("{}: {}", key, value.error()));
  const Value table = {{}, Table{{std::string(key), {}, std::move(*value)}}};
  TableReader reader(table, "the update", problems_);
  reader.Key(key, field);
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

void UpdateReader::NoKey(std::string_view name, const std::string& hint) {
  hints_.emplace(name, hint);
}

void UpdateReader::Skip(std::string_view key) { Take(key); }

void UpdateReader::Refuse(std::string_view, const std::string& text) { problems_.Add({}, text); }

}  // namespace shoal

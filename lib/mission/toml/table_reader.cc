#include "lib/mission/toml/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr double kLargestNumber = 1e9;   // Of the values of commands, which have no range here.
constexpr double kMaxExactWhole = 1e15;  ///< Whole numbers up to it are what their digits read.

std::string Allowed(NumberLimits range) {
  return range.excludes_min ? fmt::format("greater than {}, at most {}", range.min, range.max)
                            : fmt::format("{} to {}", range.min, range.max);
}

bool Contains(NumberLimits range, double number) {
  if (!std::isfinite(number) || number > range.max) return false;
  return range.excludes_min ? number > range.min : number >= range.min;
}

std::optional<double> NumberOf(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  if (const auto* integer = std::get_if<int64_t>(&value.data)) {
    return static_cast<double>(*integer);
  }
  return std::nullopt;
}

bool HasControlCharacter(std::string_view text, bool many_lines) {
  return std::any_of(text.begin(), text.end(), [&](char c) {
    if (many_lines && (c == '\n' || c == '\t' || c == '\r')) return false;
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  });
}

/// Returns "start = {x_m = ..., y_m = ...}", with the first keys that a table has.
std::string ExampleOf(std::string_view key, const Fields::DescribeTable& describe) {
  constexpr size_t kMaxKeys = 2;
  const Value empty = {.place = {}, .data = Table()};
  Problems ignored("", {});
  TableReader reader(empty, std::string(key), ignored);
  describe(reader);
  std::string example;
  for (const std::string& each :
       std::span(reader.known()).first(std::min(kMaxKeys, reader.known().size()))) {
    example += fmt::format("{}{} = ...", example.empty() ? "" : ", ", each);
  }
  return fmt::format("{} = {{{}}}", key, example);
}

std::string Element(std::string_view key, size_t index) {
  return fmt::format("element {} of {}", index + 1, key);
}

/// Returns the path by which an override names a table: "vehicle.NAME.task.NAME" for
/// [[vehicle.task]].
std::string PathOfHome(std::string_view home) {
  const bool is_list = home.starts_with("[[");
  const size_t num_brackets = is_list ? 2 : 1;
  home = home.substr(num_brackets, home.size() - 2 * num_brackets);
  std::string path;
  while (!home.empty()) {
    const size_t end = std::min(home.find('.'), home.size());
    const std::string_view part = home.substr(0, end);
    home.remove_prefix(std::min(end + 1, home.size()));
    if (!path.empty()) path += '.';
    path += part;
    if (part == "vehicle" || (home.empty() && is_list)) path += ".NAME";
  }
  return path;
}

}  // namespace

TableReader::TableReader(const Value& table, std::string title, Problems& problems)
    : source_(table),
      table_(std::get_if<Table>(&table.data)),
      title_(std::move(title)),
      problems_(problems),
      num_problems_before_(problems.size()) {
  if (table_ == nullptr) {
    problems_.Add(table.place, fmt::format("{} must be a table, not {}", title_, WhatIs(table)));
  }
}

TableReader::~TableReader() {
  if (!IsSound()) problems_.MarkUnsound(source_);
  if (table_ == nullptr || skips_rest_) return;
  const std::vector<std::string_view> known(known_.begin(), known_.end());
  for (const Entry& entry : *table_) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    const auto given = hints_.find(entry.key);
    std::string hint = given == hints_.end() ? std::string() : " (" + given->second + ")";
    // Whoever writes an override sees no tables: that its path lacks one is the likelier mistake.
    const bool home_first = entry.key_place.override_number > 0;
    if (hint.empty() && home_first) hint = HintOfHome(entry);
    if (hint.empty()) hint = DidYouMean(entry.key, known);
    if (hint.empty()) hint = HintOfHome(entry);
    if (hint.empty()) hint = "; known here: " + Joined(known);
    problems_.Add(entry.key_place, "unknown key " + Quoted(entry.key) + hint);
  }
}

std::string TableReader::HintOfHome(const Entry& entry) const {
  const std::string home = problems_.HomeOf(entry.key);
  if (home.empty()) return {};
  std::string hint = "; it is a key of " + home;
  if (entry.key_place.override_number > 0) {
    hint += fmt::format(": write {}.{}=...", PathOfHome(home), entry.key);
  }
  return hint;
}

const Value* TableReader::Take(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return table_ == nullptr ? nullptr : Find(*table_, key);
}

const Array* TableReader::TakeArray(std::string_view key, size_t max_count, std::string_view what) {
  const Value* value = Take(key);
  if (value == nullptr) return nullptr;
  const auto* array = std::get_if<Array>(&value->data);
  if (array == nullptr) {
    problems_.Add(value->place, fmt::format("{} must be {}, not {}", key, what, WhatIs(*value)));
  } else if (array->size() > max_count) {
    problems_.Add(value->place, fmt::format("{} has {} elements; allowed: at most {}", key,
                                            array->size(), max_count));
    array = nullptr;
  }
  return array;
}

std::optional<double> TableReader::AsNumber(const Value& value, const std::string& name,
                                            NumberLimits range) {
  const std::optional<double> number = NumberOf(value);
  if (!number) {
    problems_.Add(value.place, fmt::format("{} must be a number, not {}", name, WhatIs(value)));
  } else if (!Contains(range, *number)) {
    problems_.Add(value.place, fmt::format("{} = {} is out of range; allowed: {}", name, *number,
                                           Allowed(range)));
  } else {
    return number;
  }
  return std::nullopt;
}

std::optional<std::string> TableReader::AsText(const Value& value, const std::string& name,
                                               TextRule rule) {
  const auto* text = std::get_if<std::string>(&value.data);
  std::string problem;
  if (text == nullptr) {
    problem = fmt::format("must be a string in quotes, not {}", WhatIs(value));
  } else if (text->size() < rule.min_length) {
    problem = "must not be empty";
  } else if (text->size() > rule.max_length) {
    problem = fmt::format("is {} bytes long; allowed: at most {}", text->size(), rule.max_length);
  } else if (HasControlCharacter(*text, rule.many_lines)) {
    problem = "must not hold control characters";
  } else {
    return *text;
  }
  problems_.Add(value.place, name + " " + problem);
  return std::nullopt;
}

std::optional<Eigen::VectorXd> TableReader::AsVector(const Value& value, const std::string& name,
                                                     NumberLimits range, Eigen::Index size,
                                                     std::string_view example) {
  const auto* array = std::get_if<Array>(&value.data);
  if (array == nullptr || static_cast<Eigen::Index>(array->size()) != size) {
    const std::string found =
        array == nullptr ? WhatIs(value) : fmt::format("an array of {}", array->size());
    problems_.Add(value.place, fmt::format("{} must be {}, not {}", name, example, found));
    return std::nullopt;
  }
  constexpr std::array<std::string_view, 3> kPlaces = {"first", "second", "third"};
  Eigen::VectorXd vector(size);
  bool is_sound = true;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto place = static_cast<size_t>(i);
    const auto number = AsNumber(
        (*array)[place], fmt::format("the {} number of {}", kPlaces.at(place), name), range);
    vector[i] = number.value_or(0);
    is_sound = is_sound && number.has_value();
  }
  if (!is_sound) return std::nullopt;
  return vector;
}

std::optional<Eigen::Vector2d> TableReader::AsPair(const Value& value, const std::string& name,
                                                   NumberLimits range) {
  const auto vector = AsVector(value, name, range, 2, "two numbers like [10, 20]");
  if (!vector) return std::nullopt;
  return Eigen::Vector2d(*vector);
}

void TableReader::Read(std::string_view key, const NumberField& field) {
  const auto& [value, range] = field;
  const Value* found = Take(key);
  if (found != nullptr) value = AsNumber(*found, std::string(key), range).value_or(value);
}

void TableReader::Read(std::string_view key, const NumberOrWordField& field) {
  const auto& [value, max, word, meaning] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* text = std::get_if<std::string>(&found->data);
  const std::optional<double> number = NumberOf(*found);
  if ((text != nullptr && *text == word) || (number && std::isfinite(*number) && *number < 0)) {
    value = meaning;
  } else if (number && Contains(Between(0, max), *number)) {
    value = *number;
  } else {
    const std::string what = number ? fmt::format("{}", *number) : WhatIs(*found);
    problems_.Add(found->place,
                  fmt::format("{} must be 0 to {} or \"{}\", not {}", key, max, word, what));
  }
}

void TableReader::Read(std::string_view key, const ScalarField& field) {
  const auto& [word] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  if (const auto* text = std::get_if<std::string>(&found->data)) {
    word = *text;
  } else if (const auto* flag = std::get_if<bool>(&found->data)) {
    word = *flag ? "true" : "false";
  } else if (const std::optional<double> number = NumberOf(*found)) {
    word = fmt::format("{}", *number);
  } else {
    problems_.Add(found->place,
                  fmt::format("{} must be a number, true or false, or a string, not {}", key,
                              WhatIs(*found)));
  }
}

void TableReader::Read(std::string_view key, const IntegerField& field) {
  const auto& [value, min, max] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* integer = std::get_if<int64_t>(&found->data);
  if (integer == nullptr) {
    const auto* number = std::get_if<double>(&found->data);
    problems_.Add(
        found->place,
        number == nullptr ? fmt::format("{} must be a whole number, not {}", key, WhatIs(*found))
        : std::rint(*number) == *number && std::abs(*number) < kMaxExactWhole
            ? fmt::format("{0} must be a whole number without a point: write {0} = {1:.0f}", key,
                          *number)
            : fmt::format("{} must be a whole number, not {}", key, *number));
  } else if (*integer < min || *integer > max) {
    problems_.Add(found->place, fmt::format("{} = {} is out of range; allowed: {} to {}", key,
                                            *integer, min, max));
  } else {
    value = *integer;
  }
}

void TableReader::Read(std::string_view key, const FlagField& field) {
  const auto& [value] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  if (const auto* flag = std::get_if<bool>(&found->data)) {
    value = *flag;
  } else {
    problems_.Add(found->place,
                  fmt::format("{} must be true or false, not {}", key, WhatIs(*found)));
  }
}

void TableReader::Read(std::string_view key, const TextField& field) {
  const auto& [value, rule] = field;
  const Value* found = Take(key);
  if (found != nullptr) value = AsText(*found, std::string(key), rule).value_or(value);
}

void TableReader::Read(std::string_view key, const WordField& field) {
  const auto& [value, words] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* text = std::get_if<std::string>(&found->data);
  if (text != nullptr && std::find(words.begin(), words.end(), *text) != words.end()) {
    value = *text;
    return;
  }
  if (text == nullptr) {
    problems_.Add(found->place, fmt::format("{} must be a string in quotes, not {}; one of: {}",
                                            key, WhatIs(*found), Joined(words)));
    return;
  }
  std::string hint = DidYouMean(*text, words);
  if (hint.empty()) hint = "; one of: " + Joined(words);
  problems_.Add(found->place, fmt::format("unknown {} {}{}", key, Quoted(*text), hint));
}

void TableReader::Read(std::string_view key, const NumbersField& field) {
  const auto& [values, max_count] = field;
  const Array* array = TakeArray(key, max_count, "an array of numbers");
  if (array == nullptr) return;
  values.clear();
  for (size_t i = 0; i < array->size(); ++i) {
    const auto number =
        AsNumber((*array)[i], Element(key, i), Between(-kLargestNumber, kLargestNumber));
    values.push_back(number.value_or(0));
  }
}

void TableReader::Read(std::string_view key, const PairField& field) {
  const auto& [pair, range] = field;
  const Value* found = Take(key);
  if (found != nullptr) pair = AsPair(*found, std::string(key), range).value_or(pair);
}

void TableReader::Read(std::string_view key, const PairsField& field) {
  const auto& [pairs, range, max_count] = field;
  const Array* array = TakeArray(key, max_count, "an array of pairs like [[0, 0], [10, 20]]");
  if (array == nullptr) return;
  pairs.clear();
  for (size_t i = 0; i < array->size(); ++i) {
    const auto pair = AsPair((*array)[i], Element(key, i), range);
    pairs.push_back(pair.value_or(Eigen::Vector2d::Zero()));
  }
}

void TableReader::Read(std::string_view key, const TripleField& field) {
  const auto& [triple, range] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto numbers =
      AsVector(*found, std::string(key), range, 3, "three numbers like [10, 20, 5]");
  if (numbers) triple = *numbers;
}

void TableReader::Read(std::string_view key, const TriplesField& field) {
  const auto& [triples, range, max_count] = field;
  const Array* array =
      TakeArray(key, max_count, "an array of points like [[0, 0, 10], [50, 0, 20]]");
  if (array == nullptr) return;
  triples.clear();
  for (size_t i = 0; i < array->size(); ++i) {
    const auto triple =
        AsVector((*array)[i], Element(key, i), range, 3, "three numbers like [10, 20, 5]");
    triples.push_back(triple ? Eigen::Vector3d(*triple) : Eigen::Vector3d::Zero());
  }
}

void TableReader::Read(std::string_view key, const TextsField& field) {
  const auto& [texts, max_count] = field;
  const Array* array = TakeArray(key, max_count, "an array of strings");
  if (array == nullptr) return;
  texts.clear();
  for (size_t i = 0; i < array->size(); ++i) {
    const auto text = AsText((*array)[i], Element(key, i), {.max_length = 4096});
    texts.push_back(text.value_or(""));
  }
}

void TableReader::Read(std::string_view key, const TextMapField& field) {
  const auto& [texts, max_count] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* table = std::get_if<Table>(&found->data);
  if (table == nullptr || table->size() > max_count) {
    problems_.Add(found->place,
                  fmt::format("{} must be a table of at most {} strings like {{KEY = \"value\"}}",
                              key, max_count));
    return;
  }
  texts.clear();
  for (const Entry& entry : *table) {
    if (entry.key.empty() || entry.key.size() > 64 || HasControlCharacter(entry.key, false)) {
      problems_.Add(entry.key_place, "a key of " + std::string(key) +
                                         " must have 1 to 64 bytes and no control characters");
    }
    const auto text = AsText(entry.value, Quoted(entry.key), {.max_length = 1024});
    texts[entry.key] = text.value_or("");
  }
}

void TableReader::Read(std::string_view key, const ScalarsField& field) {
  const auto& [values, max_count] = field;
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* table = std::get_if<Table>(&found->data);
  if (table == nullptr || table->size() > max_count) {
    problems_.Add(found->place,
                  fmt::format("{} must be a table of at most {} numbers and strings like {{KEY = "
                              "2.5}}",
                              key, max_count));
    return;
  }
  values.clear();
  for (const Entry& entry : *table) {
    const auto* flag = std::get_if<bool>(&entry.value.data);
    const std::optional<double> number = NumberOf(entry.value);
    if (flag != nullptr) {
      values[entry.key] = *flag ? "true" : "false";
    } else if (number) {
      values[entry.key] =
          AsNumber(entry.value, Quoted(entry.key), Between(-kLargestNumber, kLargestNumber))
              .value_or(0);
    } else {
      values[entry.key] = AsText(entry.value, Quoted(entry.key), {.max_length = 4096}).value_or("");
    }
  }
}

void TableReader::Key(std::string_view key, const Field& field) {
  std::visit([&](const auto& each) { Read(key, each); }, field);
}

void TableReader::Below(std::string_view key, const DescribeTable& describe) {
  const Value* found = Take(key);
  if (found == nullptr) return;
  if (const auto* array = std::get_if<Array>(&found->data)) {
    const bool are_tables = std::ranges::any_of(
        *array, [](const Value& each) { return std::holds_alternative<Table>(each.data); });
    problems_.Add(found->place,
                  are_tables
                      ? fmt::format("there is one table {0}, not several: write [{0}] in single "
                                    "brackets",
                                    key)
                      : fmt::format("{} is a table: write {} in braces, not an array", key,
                                    ExampleOf(key, describe)));
    return;
  }
  TableReader reader(*found, std::string(key), problems_);
  describe(reader);
}

void TableReader::Inline(std::string_view key, const DescribeTable& describe) {
  Below(key, describe);
}

void TableReader::EachBelow(std::string_view key, size_t, const std::function<void(size_t)>& resize,
                            const std::function<void(Fields&, size_t)>& describe_one) {
  const Value* found = Take(key);
  if (found == nullptr) return;
  const auto* array = std::get_if<Array>(&found->data);
  if (array == nullptr) {
    // [[vehicle.task]] alone makes vehicle a table, too.
    const auto* table = std::get_if<Table>(&found->data);
    const bool only_below =
        table != nullptr && !table->empty() && std::ranges::all_of(*table, [](const Entry& entry) {
          const auto* below = std::get_if<Array>(&entry.value.data);
          return below != nullptr && !below->empty() &&
                 std::holds_alternative<Table>(below->front().data);
        });
    problems_.Add(
        found->place,
        only_below
            ? fmt::format("[[{0}.{1}]] belongs to a [[{0}]], and none is above it: write [[{0}]] "
                          "with its keys first",
                          key, table->front().key)
            : fmt::format("there may be several tables {0}: write [[{0}]] in double brackets",
                          key));
    return;
  }
  resize(array->size());
  for (size_t i = 0; i < array->size(); ++i) {
    TableReader reader((*array)[i], std::string(key), problems_);
    describe_one(reader, i);
  }
}

bool TableReader::Has(std::string_view key, bool) { return Take(key) != nullptr; }

bool TableReader::HoldsText(std::string_view key) {
  const Value* found = Take(key);
  return found != nullptr && std::holds_alternative<std::string>(found->data);
}

bool TableReader::HoldsArray(std::string_view key) {
  const Value* found = Take(key);
  return found != nullptr && std::holds_alternative<Array>(found->data);
}

bool TableReader::IsSound() const { return problems_.size() == num_problems_before_; }

void TableReader::Require(std::string_view key, std::string_view example) {
  if (table_ == nullptr || Take(key) != nullptr) return;
  problems_.Add(source_.place, fmt::format("{} lacks '{}'; for example: {}", title_, key, example));
}

void TableReader::NoKey(std::string_view name, const std::string& hint) {
  hints_.emplace(name, hint);
}

void TableReader::Skip(std::string_view key) { Take(key); }

void TableReader::SkipRest() { skips_rest_ = true; }

const Place& TableReader::PlaceOf(std::string_view key) const {
  const Value* found = table_ == nullptr ? nullptr : Find(*table_, key);
  return found == nullptr ? source_.place : found->place;
}

void TableReader::Refuse(std::string_view key, const std::string& text) {
  problems_.Add(PlaceOf(key), text);
}

void TableReader::Warn(std::string_view key, const std::string& text) {
  problems_.Warn(PlaceOf(key), text);
}

std::string TableReader::Where() const { return problems_.LineOf(source_.place); }

}  // namespace shoal

// The keys of one table of a mission file, described once for both directions: TableReader fills
// a struct from a file, TableWriter writes the struct as a file with every default.
//
//   void Describe(Fields& fields, CaptureRule& rule) {
//     fields.Number("capture_radius_m", rule.capture_radius_m, Above(0, 1000));
//     fields.Flag("capture_line", rule.capture_line);
//   }
//
// A key that is absent leaves its variable as it is: the struct's default is the file's default.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/mission/toml/field.h"

namespace shoal {

class Fields {
 public:
  using DescribeTable = std::function<void(Fields&)>;

  virtual ~Fields() = default;

  /// Reads or writes the variable of `key`.
  virtual void Key(std::string_view key, const Field& field) = 0;

  /// [key], a table below this one.
  virtual void Below(std::string_view key, const DescribeTable& describe) = 0;
  /// key = {...}, a small table in one line. (A file may write either form for either.)
  virtual void Inline(std::string_view key, const DescribeTable& describe) = 0;
  /// [[key]], any number of tables. `describe_one` is called with the index of each; `resize`
  /// first, when reading, with their number.
  virtual void EachBelow(std::string_view key, size_t count,
                         const std::function<void(size_t)>& resize,
                         const std::function<void(Fields&, size_t)>& describe_one) = 0;

  /// True where variables are filled, false where they are written.
  virtual bool reading() const = 0;
  /// When reading, true where the table has `key`; when writing, `present`; when changing, either.
  virtual bool Has(std::string_view key, bool present) = 0;

  // What follows is about files that are read. A writer has nothing to do in it.

  /// True where Require has an effect: a table of the file, not a change of what exists.
  virtual bool demands_keys() const { return true; }
  /// True where the table has a string under `key`.
  virtual bool HoldsText(std::string_view /*key*/) { return false; }
  /// Likewise, of a list or [[key]].
  virtual bool HoldsArray(std::string_view /*key*/) { return false; }
  /// True where nothing of this table, or below it, has been refused so far.
  virtual bool IsSound() const { return true; }
  /// Demands `key`; `example` is the line that the message proposes.
  virtual void Require(std::string_view /*key*/, std::string_view /*example*/) {}
  /// `name` is not a key here, but a user may expect it; the error for it gives this hint.
  virtual void NoKey(std::string_view /*name*/, const std::string& /*hint*/) {}
  /// Declares that `key` is known, although it is not read here.
  virtual void Skip(std::string_view /*key*/) {}
  /// Declares all keys known: for a table that is wrong in a way that leaves them without meaning.
  virtual void SkipRest() {}
  /// Refuses the value of `key` (or, where it is absent, the table): states why and what to do.
  virtual void Refuse(std::string_view /*key*/, const std::string& /*text*/) {}
  /// Warns of the value of `key` (or, where it is absent, of the table): legal but suspicious.
  virtual void Warn(std::string_view /*key*/, const std::string& /*text*/) {}
  /// Returns the "file:line" where this table begins; empty when writing.
  virtual std::string Where() const { return {}; }

  /// When writing, a line of comment.
  virtual void Note(std::string_view /*text*/) {}

  // A key of each sort (field.h).

  void Number(std::string_view key, double& value, NumberLimits range) {
    Key(key, NumberField{value, range});
  }
  void NumberOrWord(std::string_view key, double& value, double max, std::string_view word,
                    double meaning) {
    Key(key, NumberOrWordField{value, max, word, meaning});
  }
  void Scalar(std::string_view key, std::string& word) { Key(key, ScalarField{word}); }
  void Integer(std::string_view key, int64_t& value, int64_t min, int64_t max) {
    Key(key, IntegerField{value, min, max});
  }
  void Flag(std::string_view key, bool& value) { Key(key, FlagField{value}); }
  void Text(std::string_view key, std::string& value, TextRule rule) {
    Key(key, TextField{value, rule});
  }
  void Word(std::string_view key, std::string& value, std::span<const std::string_view> words) {
    Key(key, WordField{value, words});
  }
  void Numbers(std::string_view key, std::vector<double>& values, size_t max_count) {
    Key(key, NumbersField{values, max_count});
  }
  void Pair(std::string_view key, Eigen::Vector2d& pair, NumberLimits range) {
    Key(key, PairField{pair, range});
  }
  void Pairs(std::string_view key, std::vector<Eigen::Vector2d>& pairs, NumberLimits range,
             size_t max_count) {
    Key(key, PairsField{pairs, range, max_count});
  }
  void Triple(std::string_view key, Eigen::Vector3d& triple, NumberLimits range) {
    Key(key, TripleField{triple, range});
  }
  void Triples(std::string_view key, std::vector<Eigen::Vector3d>& triples, NumberLimits range,
               size_t max_count) {
    Key(key, TriplesField{triples, range, max_count});
  }
  void Texts(std::string_view key, std::vector<std::string>& texts, size_t max_count) {
    Key(key, TextsField{texts, max_count});
  }
  void TextMap(std::string_view key, std::map<std::string, std::string>& texts, size_t max_count) {
    Key(key, TextMapField{texts, max_count});
  }
  void Scalars(std::string_view key,
               std::map<std::string, std::variant<std::string, double>>& values, size_t max_count) {
    Key(key, ScalarsField{values, max_count});
  }

  /// `name` is what another program calls `key`.
  void CalledElsewhere(std::string_view key, std::string_view name) {
    NoKey(name, "here it is '" + std::string(key) + "'");
  }

  /// All tables [[key]] as `items`.
  template <class T, class DescribeItem>
  void List(std::string_view key, std::vector<T>& items, const DescribeItem& describe) {
    EachBelow(
        key, items.size(), [&](size_t count) { items.resize(count); },
        [&](Fields& fields, size_t i) { describe(fields, items[i]); });
  }

  /// An enumeration, by its words: one for each enumerator.
  template <class E, size_t N>
  void Choice(std::string_view key, E& value,
              const std::array<std::pair<std::string_view, E>, N>& choices) {
    static_assert(N == kNumEnumerators<E>, "a Choice has a word for each enumerator");
    ChoiceAmong(key, value, choices);
  }

  /// The same for some of the enumerators, or another type.
  template <class E, size_t N>
  void ChoiceAmong(std::string_view key, E& value,
                   const std::array<std::pair<std::string_view, E>, N>& choices) {
    std::vector<std::string_view> words;
    std::string word;
    for (const auto& [choice, meaning] : choices) {
      words.push_back(choice);
      if (meaning == value) word = choice;
    }
    Word(key, word, words);
    for (const auto& [choice, meaning] : choices) {
      if (choice == word) value = meaning;
    }
  }

  /// An int, for structs that have one.
  void SmallInteger(std::string_view key, int& value, int min, int max) {
    int64_t wide = value;
    Integer(key, wide, min, max);
    value = static_cast<int>(wide);
  }
};

}  // namespace shoal

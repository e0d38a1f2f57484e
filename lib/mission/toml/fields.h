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

#include <Eigen/Core>
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

namespace shoal {

/// Allowed numbers; never NaN, never infinite.
struct NumberLimits {
  double min = 0;
  double max = 0;
  bool excludes_min = false;
};
constexpr NumberLimits Between(double min, double max) { return {min, max, false}; }
constexpr NumberLimits Above(double min, double max) { return {min, max, true}; }

/// Allowed texts. Control characters never are, but line breaks and tabs in a text of many lines.
struct TextRule {
  size_t min_length = 0;  ///< In bytes.
  size_t max_length = 64;
  bool many_lines = false;
};

class Fields {
 public:
  using DescribeTable = std::function<void(Fields&)>;

  virtual ~Fields() = default;

  virtual void Number(std::string_view key, double& value, NumberLimits range) = 0;
  /// A number, or `word`, which stands for `meaning`. Any negative number means the same.
  virtual void NumberOrWord(std::string_view key, double& value, double max, std::string_view word,
                            double meaning) = 0;
  /// A number, a yes or no, or a text, as a file writes it but without quotes: "2.5", "true".
  virtual void Scalar(std::string_view key, std::string& word) = 0;
  virtual void Integer(std::string_view key, int64_t& value, int64_t min, int64_t max) = 0;
  virtual void Flag(std::string_view key, bool& value) = 0;
  virtual void Text(std::string_view key, std::string& value, TextRule rule) = 0;
  /// One of `words`.
  virtual void Word(std::string_view key, std::string& value,
                    std::span<const std::string_view> words) = 0;
  virtual void Numbers(std::string_view key, std::vector<double>& values, size_t max_count) = 0;
  /// [x, y].
  virtual void Pair(std::string_view key, Eigen::Vector2d& pair, NumberLimits range) = 0;
  /// [[x, y], ...].
  virtual void Pairs(std::string_view key, std::vector<Eigen::Vector2d>& pairs, NumberLimits range,
                     size_t max_count) = 0;
  /// [x, y, z].
  virtual void Triple(std::string_view key, Eigen::Vector3d& triple, NumberLimits range) = 0;
  /// [[x, y, z], ...].
  virtual void Triples(std::string_view key, std::vector<Eigen::Vector3d>& triples,
                       NumberLimits range, size_t max_count) = 0;
  virtual void Texts(std::string_view key, std::vector<std::string>& texts, size_t max_count) = 0;
  /// {key = "text", ...}.
  virtual void TextMap(std::string_view key, std::map<std::string, std::string>& texts,
                       size_t max_count) = 0;

  /// {key = "text", other = 2.5, third = true, ...}; true and false count as text.
  virtual void Scalars(std::string_view key,
                       std::map<std::string, std::variant<std::string, double>>& values,
                       size_t max_count) = 0;

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
  /// True where Require has an effect: a table of the file, not a change of what exists.
  virtual bool demands_keys() const { return true; }
  /// When reading, true where the table has `key`; when writing, `present`; when changing, either.
  virtual bool Has(std::string_view key, bool present) = 0;
  /// When reading, true where the table has a string under `key`; when writing, false.
  virtual bool HoldsText(std::string_view key) = 0;
  /// Likewise, of a list or [[key]].
  virtual bool HoldsArray(std::string_view key) = 0;
  /// True where nothing of this table, or below it, has been refused so far.
  virtual bool IsSound() const = 0;
  /// Demands `key`; `example` is the line that the message proposes.
  virtual void Require(std::string_view key, std::string_view example) = 0;
  /// `name` is no key here, but a user may expect it; the error for it gives this hint.
  virtual void NoKey(std::string_view name, std::string hint) = 0;
  /// Declares `key` a known one that is not read here.
  virtual void Skip(std::string_view key) = 0;
  /// Declares all keys known: for a table that is wrong in a way that leaves them without meaning.
  virtual void SkipRest() = 0;
  /// Refuses the value of `key` (or, where it is absent, the table): states why and what to do.
  virtual void Refuse(std::string_view key, std::string text) = 0;
  /// Warns of the value of `key` (or, where it is absent, of the table): legal but suspicious.
  virtual void Warn(std::string_view key, std::string text) = 0;
  /// When writing, a line of comment.
  virtual void Note(std::string_view /*text*/) {}
  /// Returns the "file:line" where this table begins; empty when writing.
  virtual std::string Where() const = 0;

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

  /// An enumeration, by its words.
  template <class E, size_t N>
  void Choice(std::string_view key, E& value,
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

// The variable behind one key of a table, by the sort of value that a file has for it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
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

struct NumberField {
  double& value;
  NumberLimits range;
};
/// A number, or `word`, which stands for `meaning`. Any negative number means the same.
struct NumberOrWordField {
  double& value;
  double max;
  std::string_view word;
  double meaning;
};
/// A number, a yes or no, or a text, as a file writes it but without quotes: "2.5", "true".
struct ScalarField {
  std::string& word;
};
struct IntegerField {
  int64_t& value;
  int64_t min;
  int64_t max;
};
struct FlagField {
  bool& value;
};
struct TextField {
  std::string& value;
  TextRule rule;
};
/// One of `words`.
struct WordField {
  std::string& value;
  std::span<const std::string_view> words;
};
struct NumbersField {
  std::vector<double>& values;
  size_t max_count;
};
/// [x, y].
struct PairField {
  Eigen::Vector2d& pair;
  NumberLimits range;
};
/// [[x, y], ...].
struct PairsField {
  std::vector<Eigen::Vector2d>& pairs;
  NumberLimits range;
  size_t max_count;
};
/// [x, y, z].
struct TripleField {
  Eigen::Vector3d& triple;
  NumberLimits range;
};
/// [[x, y, z], ...].
struct TriplesField {
  std::vector<Eigen::Vector3d>& triples;
  NumberLimits range;
  size_t max_count;
};
struct TextsField {
  std::vector<std::string>& texts;
  size_t max_count;
};
/// {key = "text", ...}.
struct TextMapField {
  std::map<std::string, std::string>& texts;
  size_t max_count;
};
/// {key = "text", other = 2.5, third = true, ...}; true and false count as text.
struct ScalarsField {
  std::map<std::string, std::variant<std::string, double>>& values;
  size_t max_count;
};

using Field = std::variant<NumberField, NumberOrWordField, ScalarField, IntegerField, FlagField,
                           TextField, WordField, NumbersField, PairField, PairsField, TripleField,
                           TriplesField, TextsField, TextMapField, ScalarsField>;

}  // namespace shoal

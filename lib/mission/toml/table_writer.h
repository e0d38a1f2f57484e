// Writes structs as TOML, every key with its value.
#pragma once

#include <string>
#include <string_view>

#include "lib/mission/toml/fields.h"

namespace shoal {

class TableWriter final : public Fields {
 public:
  /// `path` is the table's own, such as "vehicle.task"; empty for the root.
  explicit TableWriter(std::string path = "") : path_(std::move(path)) {}

  /// Returns all that has been described: first the table's own keys, then the tables below.
  std::string TakeText() { return std::move(lines_) + std::move(tables_); }

  void Number(std::string_view key, double& value, NumberLimits range) override;
  void NumberOrWord(std::string_view key, double& value, double max, std::string_view word,
                    double meaning) override;
  void Scalar(std::string_view key, std::string& word) override;
  void Integer(std::string_view key, int64_t& value, int64_t min, int64_t max) override;
  void Flag(std::string_view key, bool& value) override;
  void Text(std::string_view key, std::string& value, TextRule rule) override;
  void Word(std::string_view key, std::string& value,
            std::span<const std::string_view> words) override;
  void Numbers(std::string_view key, std::vector<double>& values, size_t max_count) override;
  void Pair(std::string_view key, Eigen::Vector2d& pair, NumberLimits range) override;
  void Triple(std::string_view key, Eigen::Vector3d& triple, NumberLimits range) override;
  void Triples(std::string_view key, std::vector<Eigen::Vector3d>& triples, NumberLimits range,
               size_t max_count) override;
  void Pairs(std::string_view key, std::vector<Eigen::Vector2d>& pairs, NumberLimits range,
             size_t max_count) override;
  void Texts(std::string_view key, std::vector<std::string>& texts, size_t max_count) override;
  void TextMap(std::string_view key, std::map<std::string, std::string>& texts,
               size_t max_count) override;
  void Scalars(std::string_view key,
               std::map<std::string, std::variant<std::string, double>>& values,
               size_t max_count) override;
  void Below(std::string_view key, const DescribeTable& describe) override;
  void Inline(std::string_view key, const DescribeTable& describe) override;
  void EachBelow(std::string_view key, size_t count, const std::function<void(size_t)>& resize,
                 const std::function<void(Fields&, size_t)>& describe_one) override;
  bool reading() const override { return false; }
  bool Has(std::string_view, bool present) override { return present; }
  bool HoldsText(std::string_view) override { return false; }
  bool HoldsArray(std::string_view) override { return false; }
  bool IsSound() const override { return true; }
  void Require(std::string_view, std::string_view) override {}
  void NoKey(std::string_view, std::string) override {}
  void Skip(std::string_view) override {}
  void SkipRest() override {}
  void Refuse(std::string_view, std::string) override {}
  void Warn(std::string_view, std::string) override {}
  void Note(std::string_view text) override { lines_ += "# " + std::string(text) + "\n"; }
  std::string Where() const override { return ""; }

 private:
  void Line(std::string_view key, std::string_view value);
  std::string PathOf(std::string_view key) const;

  std::string path_;
  std::string lines_;
  std::string tables_;
};

/// Returns the shortest TOML number that reads back as exactly this.
std::string TomlNumber(double number);

/// Returns `text` as a TOML string of one line, in double quotes.
std::string TomlString(std::string_view text);

}  // namespace shoal

// Fills structs from a table of a mission file and notices everything that is wrong with it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/toml/fields.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

/// Reads one table. Its destructor reports each key that was not asked for as unknown, with the
/// nearest of those asked for. A wrong value leaves its variable as it is.
class TableReader final : public Fields {
 public:
  /// `title` names the table in messages: "[comms]". `table` and `problems` outlive the reader.
  TableReader(const Value& table, std::string title, Problems& problems);
  ~TableReader() override;
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

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
  bool reading() const override { return true; }
  bool Has(std::string_view key, bool present) override;
  bool HoldsText(std::string_view key) override;
  bool HoldsArray(std::string_view key) override;
  bool IsSound() const override;
  void Require(std::string_view key, std::string_view example) override;
  void NoKey(std::string_view name, std::string hint) override;
  void Skip(std::string_view key) override;
  void SkipRest() override;
  void Refuse(std::string_view key, std::string text) override;
  void Warn(std::string_view key, std::string text) override;
  std::string Where() const override;

 private:
  /// Returns the value of `key`, which is known from now on, or nullptr.
  const Value* Take(std::string_view key);
  /// Returns the array under `key` where it has at most `max_count` elements, or nullptr.
  const Array* TakeArray(std::string_view key, size_t max_count, std::string_view what);
  /// Returns where the value of `key` stands; where there is none, the table.
  const Place& PlaceOf(std::string_view key) const;
  // These return the value where it is right, and report what is wrong otherwise. `name` is the
  // key, or the key and the number of the element.
  std::optional<double> AsNumber(const Value& value, const std::string& name, NumberLimits range);
  std::optional<std::string> AsText(const Value& value, const std::string& name, TextRule rule);
  /// An array of numbers, as many as in `example`.
  std::optional<Eigen::VectorXd> AsVector(const Value& value, const std::string& name,
                                          NumberLimits range, Eigen::Index size,
                                          std::string_view example);
  std::optional<Eigen::Vector2d> AsPair(const Value& value, const std::string& name,
                                        NumberLimits range);

  const Value& source_;
  const Table* table_;  ///< Null where the source is no table, which was reported.
  bool skips_rest_ = false;
  std::string title_;
  Problems& problems_;
  size_t num_problems_before_;
  std::vector<std::string> known_;  ///< In the order in which they were asked for.
  std::map<std::string, std::string, std::less<>> hints_;  ///< Of NoKey(), by name.
};

}  // namespace shoal

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

  void Key(std::string_view key, const Field& field) override;
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
  void NoKey(std::string_view name, const std::string& hint) override;
  void Skip(std::string_view key) override;
  void SkipRest() override;
  void Refuse(std::string_view key, const std::string& text) override;
  void Warn(std::string_view key, const std::string& text) override;
  std::string Where() const override;
  /// The keys that were asked for so far.
  const std::vector<std::string>& known() const { return known_; }

 private:
  // One for each sort of field.
  void Read(std::string_view key, const NumberField& field);
  void Read(std::string_view key, const NumberOrWordField& field);
  void Read(std::string_view key, const ScalarField& field);
  void Read(std::string_view key, const IntegerField& field);
  void Read(std::string_view key, const FlagField& field);
  void Read(std::string_view key, const TextField& field);
  void Read(std::string_view key, const WordField& field);
  void Read(std::string_view key, const NumbersField& field);
  void Read(std::string_view key, const PairField& field);
  void Read(std::string_view key, const PairsField& field);
  void Read(std::string_view key, const TripleField& field);
  void Read(std::string_view key, const TriplesField& field);
  void Read(std::string_view key, const TextsField& field);
  void Read(std::string_view key, const TextMapField& field);
  void Read(std::string_view key, const ScalarsField& field);

  /// Returns in which table an unknown key belongs, or nothing.
  std::string HintOfHome(const Entry& entry) const;
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
  const Table* table_;  ///< Null where the source is not a table, which was reported.
  bool skips_rest_ = false;
  std::string title_;
  Problems& problems_;
  size_t num_problems_before_;
  std::vector<std::string> known_;  ///< In the order in which they were asked for.
  std::map<std::string, std::string, std::less<>> hints_;  ///< Of NoKey(), by name.
};

}  // namespace shoal

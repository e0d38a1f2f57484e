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

  void Key(std::string_view key, const Field& field) override;
  void Below(std::string_view key, const DescribeTable& describe) override;
  void Inline(std::string_view key, const DescribeTable& describe) override;
  void EachBelow(std::string_view key, size_t count, const std::function<void(size_t)>& resize,
                 const std::function<void(Fields&, size_t)>& describe_one) override;
  bool reading() const override { return false; }
  bool Has(std::string_view, bool present) override { return present; }
  void Note(std::string_view text) override { lines_ += "# " + std::string(text) + "\n"; }

 private:
  // One for each sort of field.
  void Write(std::string_view key, const NumberField& field);
  void Write(std::string_view key, const NumberOrWordField& field);
  void Write(std::string_view key, const ScalarField& field);
  void Write(std::string_view key, const IntegerField& field);
  void Write(std::string_view key, const FlagField& field);
  void Write(std::string_view key, const TextField& field);
  void Write(std::string_view key, const WordField& field);
  void Write(std::string_view key, const NumbersField& field);
  void Write(std::string_view key, const PairField& field);
  void Write(std::string_view key, const PairsField& field);
  void Write(std::string_view key, const TripleField& field);
  void Write(std::string_view key, const TriplesField& field);
  void Write(std::string_view key, const TextsField& field);
  void Write(std::string_view key, const TextMapField& field);
  void Write(std::string_view key, const ScalarsField& field);

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

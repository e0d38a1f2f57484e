// A table of a file that has been read: where it and its keys stand, for checks that span tables.
//
//   const TablePlace file(root, problems);
//   const TablePlace vehicle = file.Below("vehicle", 2);
//   vehicle.Refuse("start", "only a vehicle of model = \"remus100\" can start under water");
//
// The places are those that the parser recorded with the values: nothing is read again.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

class TablePlace {
 public:
  /// The whole file. `root` and `problems` outlive this and all places below it.
  TablePlace(const Value& root, Problems& problems);

  /// Returns the table [key], or the one of that number among [[key]], from 0. Where the file has
  /// none, that is a table without keys which stands where this one does.
  TablePlace Below(std::string_view key) const;
  TablePlace Below(std::string_view key, size_t number) const;

  bool Has(std::string_view key) const;
  /// True where nothing of this table, or below it, has been refused so far, be it while it was
  /// read (TableReader) or through a TablePlace.
  bool IsSound() const;
  /// Refuses the value of `key` (or, where it is absent, the table): states why and what to do.
  void Refuse(std::string_view key, std::string text) const;
  /// Warns of the value of `key` (or, where it is absent, of the table): legal but suspicious.
  void Warn(std::string_view key, std::string text) const;
  /// The same where it makes the mission fail, whatever happens in it: `shoal check` refuses it.
  void WarnOfFailure(std::string_view key, std::string text) const;

 private:
  explicit TablePlace(Problems& problems) : problems_(&problems) {}
  TablePlace At(const Value* value) const;
  const Value* Find(std::string_view key) const;
  const Place& PlaceOf(std::string_view key) const;

  Problems* problems_;
  std::vector<const Value*> way_;  ///< From the root to the last table that the file has.
  bool exists_ = true;             ///< The file has this table, and it is the last of the way.
};

}  // namespace shoal

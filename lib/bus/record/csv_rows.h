// One message as rows of a table.
//
// Columns: time_s (the event's time), one for each number and text of the message, then `index` and
// the members of arrays of structs. A message with such arrays makes one row for each index, with
// the other columns repeated; where an array is shorter than another, its columns stay empty; where
// all are empty, there is one row without index. Arrays of structs within these structs likewise:
// an element of the outer array makes one row for each element of the inner one, with the same
// index and in their order, and one row with the inner columns empty where there is none. The inner
// array has no index column: its length is a column, as every member is.
//
// Where the message has a member `index` or `time_s`, the table's own column is `row_index` or
// `row_time_s`: no name is in a header twice.
//
// Small arrays of fixed size have a column for each element, all other arrays of values one cell:
// [1 2 3]. So have arrays within arrays whose structs would hold themselves: [{y=3} {y=4}]. Members
// named utime or ending in _utime are seconds, in columns named ..._s.
//
// The user's own fields (`extra` of node reports, a list of key_value_t) are rows with extra.key
// and extra.value as all arrays of structs are; each key that the layout is given has a column at
// the end, extra[key], with its value in every row of the message, empty where the message has no
// such key. Of a key that stands twice the first value counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/schema/schema.h"
#include "lib/base/schema/walk.h"

namespace shoal {

/// The columns that an array of structs has in a table.
struct CsvTable {
  size_t num_columns = 0;        ///< With those of arrays within.
  std::vector<CsvTable> tables;  ///< Arrays of structs within its structs; their columns come last.
};

enum class CsvValue { kText, kInteger, kReal };

struct CsvColumn {
  std::string name;
  CsvValue value = CsvValue::kText;  ///< Times in seconds are kReal, true and false kInteger.
};

/// How the messages of one type become rows. Lines end in a line feed alone.
class CsvLayout {
 public:
  /// `extra_keys`: the keys of the user's own fields that get a column.
  /// @pre type is one of schema.types(), and both outlive this.
  CsvLayout(const Schema& schema, const StructType& type, std::vector<std::string> extra_keys = {});

  /// The names of the columns, as a line.
  const std::string& header() const { return header_; }
  /// The columns with the kind of value that each holds. No name is there twice.
  const std::vector<CsvColumn>& columns() const { return columns_; }

  /// Appends the rows of the message that `bytes` are.
  /// @pre FindWireFault() finds none.
  void AppendRows(int64_t event_utime, std::span<const uint8_t> bytes, std::string* out) const;

 private:
  const Schema& schema_;
  const StructType& type_;
  std::vector<std::string> extra_keys_;
  std::vector<CsvColumn> columns_;
  std::string header_;
  std::vector<CsvTable> tables_;
};

/// Takes the next row from `rows`, which AppendRows has made; false: no row is left.
[[nodiscard]] bool TakeCsvRow(std::string_view* rows, std::vector<std::string>* cells);

/// Appends one cell as UTF-8, in quotes where RFC 4180 asks for them.
void AppendCsvCell(std::string_view any_text, std::string* out);

}  // namespace shoal

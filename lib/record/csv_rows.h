// One message as rows of a table.
//
// Columns: time_s (the event's time), one for each number and text of the message, then `index` and
// the members of arrays of structs. A message with such arrays makes one row for each index, with
// the other columns repeated; where an array is shorter than another, its columns stay empty; where
// all are empty, there is one row without index. Small arrays of fixed size have a column for each
// element, all other arrays and what is in an array's structs one cell: [1 2 3]. Members named
// utime or ending in _utime are seconds, in columns named ..._s.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/schema/schema.h"
#include "lib/schema/walk.h"

namespace shoal {

/// How the messages of one type become rows. Lines end in a line feed alone.
class CsvLayout {
 public:
  /// @pre type is one of schema.types(), and both outlive this.
  CsvLayout(const Schema& schema, const StructType& type);

  /// The names of the columns, as a line.
  const std::string& header() const { return header_; }

  /// Appends the rows of one message.
  /// @pre FindWireFault() finds none.
  void AppendRows(int64_t event_utime, std::span<const uint8_t> message, std::string* out) const;

 private:
  const Schema& schema_;
  const StructType& type_;
  std::string header_;
  std::vector<std::string> empty_rows_;  ///< The commas of each table where it has no more rows.
};

/// Appends one cell, in quotes where RFC 4180 asks for them.
void AppendCsvCell(std::string_view text, std::string* out);

}  // namespace shoal

#include "lib/bus/record/csv_rows.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "lib/base/schema/text.h"
#include "lib/bus/record/extra_fields.h"
#include "lib/bus/record/valid_utf8.h"

namespace shoal {

namespace {

/// Fixed arrays of at most this many elements have a column for each.
constexpr int64_t kMaxExpandedElements = 64;

enum class Shape {
  kCell,      ///< One value, one column.
  kExpanded,  ///< An array with a column for each element.
  kText,      ///< An array in one column.
  kNested,    ///< A struct, whose members are columns.
  kTable,     ///< An array of structs: rows.
};

/// The structs around a member, outermost first.
using OpenTypes = std::vector<const StructType*>;

/// Returns whether an array within an array may be rows: columns of structs that hold themselves
/// would have no end. Messages are nested at most kMaxStructDepth deep; columns need no more.
bool MayNest(const StructType& type, const OpenTypes& open) {
  return open.size() <= kMaxStructDepth && std::find(open.begin(), open.end(), &type) == open.end();
}

Shape ShapeOf(const Schema& schema, const Member& member, const OpenTypes& open, bool is_in_table) {
  if (member.dimensions.empty()) return member.primitive ? Shape::kCell : Shape::kNested;
  if (!member.primitive) {
    if (!is_in_table) return Shape::kTable;
    return MayNest(schema.types()[member.struct_index], open) ? Shape::kTable : Shape::kText;
  }
  int64_t num_elements = 1;
  for (const Dimension& dimension : member.dimensions) {
    if (dimension.is_variable() || dimension.fixed_size > kMaxExpandedElements) return Shape::kText;
    num_elements *= dimension.fixed_size;
    if (num_elements > kMaxExpandedElements) return Shape::kText;
  }
  return Shape::kExpanded;
}

bool IsUtime(const Member& member) {
  return member.primitive == Primitive::kInt64 &&
         (member.name == "utime" || member.name.ends_with("_utime"));
}

/// The names of the columns of a struct, in the order of a walk.
struct Columns {
  std::vector<CsvColumn> cells;  ///< Outside of its arrays of structs.
  std::vector<Columns> tables;   ///< One for each of these arrays.
};

/// @pre member.primitive
CsvValue ValueOf(const Member& member) {
  if (*member.primitive == Primitive::kString) return CsvValue::kText;
  const bool is_real = IsUtime(member) || *member.primitive == Primitive::kFloat ||
                       *member.primitive == Primitive::kDouble;
  return is_real ? CsvValue::kReal : CsvValue::kInteger;
}

CsvColumn ColumnOf(const Member& member, const std::string& name) {
  return {.name = name + (IsUtime(member) ? "_s" : ""), .value = ValueOf(member)};
}

void AddExpanded(const Member& member, const std::string& name, size_t d,
                 std::vector<CsvColumn>* columns) {
  if (d == member.dimensions.size()) {
    columns->push_back(ColumnOf(member, name));
    return;
  }
  for (int64_t i = 0; i < member.dimensions[d].fixed_size; ++i) {
    std::string element = name;
    element.append("[").append(std::to_string(i)).append("]");
    AddExpanded(member, element, d + 1, columns);
  }
}

/// Finds the columns of a type.
class ColumnFinder {
 public:
  explicit ColumnFinder(const Schema& schema) : schema_(schema) {}

  /// Adds those of `type` to `columns`, which are those of an array's structs where `is_in_table`.
  void Add(const StructType& type, const std::string& prefix, bool is_in_table, Columns* columns) {
    open_.push_back(&type);
    for (const Member& member : type.members) {
      const std::string name = prefix + member.name;
      switch (ShapeOf(schema_, member, open_, is_in_table)) {
        case Shape::kCell:
          columns->cells.push_back(ColumnOf(member, name));
          break;
        case Shape::kExpanded:
          AddExpanded(member, name, 0, &columns->cells);
          break;
        case Shape::kText:
          columns->cells.push_back({.name = name});
          break;
        case Shape::kNested:
          Add(schema_.types()[member.struct_index], name + ".", is_in_table, columns);
          break;
        case Shape::kTable:
          Add(schema_.types()[member.struct_index], name + ".", true,
              &columns->tables.emplace_back());
          break;
      }
    }
    open_.pop_back();
  }

 private:
  const Schema& schema_;
  OpenTypes open_;
};

/// A message, or a struct in an array of structs.
struct Element {
  std::string cells;  ///< Outside of its arrays of structs; each with a comma before it.
  std::vector<std::vector<Element>> tables;  ///< The elements of each of these arrays.
  std::vector<size_t> row_ends;  ///< For each index into them: rows of this one and all before.

  size_t num_rows() const { return row_ends.empty() ? 1 : row_ends.back(); }

  /// Fills row_ends.
  /// @pre row_ends of the inner elements are filled.
  void CountRows() {
    for (size_t i = 0;; ++i) {
      size_t num_rows_of_index = 0;
      for (const auto& table : tables) {
        if (i < table.size()) num_rows_of_index = std::max(num_rows_of_index, table[i].num_rows());
      }
      if (num_rows_of_index == 0) return;
      row_ends.push_back((i == 0 ? 0 : row_ends.back()) + num_rows_of_index);
    }
  }
};

/// Sorts the values of a message into cells.
class RowCollector : public Visitor {
 public:
  explicit RowCollector(const Schema& schema) : schema_(schema) {}
  RowCollector(const RowCollector&) = delete;  // rows_ points into this

  /// Complete after the walk.
  const Element& message() const { return message_; }

  void MemberBegin(const Member& member) override {
    if (text_) return text_->MemberBegin(member);
    shape_ = ShapeOf(schema_, member, open_types_, rows_.size() > 1);
    is_utime_ = IsUtime(member);
    if (shape_ == Shape::kTable) rows_.back()->tables.emplace_back();
    if (shape_ == Shape::kText) {
      cell_.clear();
      text_.emplace(&cell_, false);
    }
  }

  void StructBegin(const StructType& type) override {
    if (text_) text_->StructBegin(type);
    open_types_.push_back(&type);
    const bool is_row = !open_.empty() && open_.back() == Part::kTable;
    if (is_row) rows_.push_back(&rows_.back()->tables.back().emplace_back());
    open_.push_back(is_row ? Part::kRow : PartThatBegins());
  }
  void StructEnd() override {
    if (text_) text_->StructEnd();
    open_types_.pop_back();
    Leave();
    if (open_.empty()) message_.CountRows();
  }
  void ArrayBegin(int64_t size) override {
    if (text_) text_->ArrayBegin(size);
    open_.push_back(PartThatBegins());
  }
  void ArrayEnd() override {
    if (text_) text_->ArrayEnd();
    Leave();
  }

  void Value(const Scalar& value) override {
    if (text_) return text_->Value(value);
    cell_.clear();
    if (is_utime_) {
      AppendSeconds(std::get<int64_t>(value), &cell_);
    } else {
      AppendScalar(value, &cell_);
    }
    AddCell();
  }

 private:
  /// The role of an open struct or array in the table.
  enum class Part { kCells, kText, kTable, kRow };

  Part PartThatBegins() const {
    if (text_) return Part::kText;
    return shape_ == Shape::kTable ? Part::kTable : Part::kCells;
  }

  void Leave() {
    const Part part = open_.back();
    open_.pop_back();
    if (part == Part::kRow) {
      rows_.back()->CountRows();
      rows_.pop_back();
      shape_ = Shape::kTable;
    }
    if (part == Part::kText && open_.back() != Part::kText) {
      text_.reset();
      AddCell();
    }
  }

  void AddCell() {
    std::string& cells = rows_.back()->cells;
    cells += ',';
    AppendCsvCell(cell_, &cells);
  }

  const Schema& schema_;
  Element message_;
  std::vector<Element*> rows_ = {&message_};  ///< The elements being filled, outermost first.
  OpenTypes open_types_;
  std::vector<Part> open_;        ///< Outermost first.
  Shape shape_ = Shape::kNested;  ///< Of the member that began last.
  bool is_utime_ = false;         ///< That member is a time.
  std::string cell_;
  std::optional<TextWriter> text_;  ///< Present: inside a member that becomes one cell.
};

/// Returns the name of a column that the table has beside those of the message: `name`, or with
/// "row_" before it where the message has a member of that name.
std::string NameOfOwnColumn(std::string name, const Columns& columns) {
  while (std::ranges::find(columns.cells, name, &CsvColumn::name) != columns.cells.end()) {
    name.insert(0, "row_");
  }
  return name;
}

/// Appends the columns in the order of a row, and returns their layout.
CsvTable AddInOrder(const Columns& columns, std::vector<CsvColumn>* all) {
  CsvTable table{.num_columns = columns.cells.size(), .tables = {}};
  all->insert(all->end(), columns.cells.begin(), columns.cells.end());
  for (const Columns& inner : columns.tables) {
    table.num_columns += table.tables.emplace_back(AddInOrder(inner, all)).num_columns;
  }
  return table;
}

/// The place of one row of an element in the arrays within that element.
struct Place {
  size_t index = 0;  ///< Into the arrays; their greatest length where the row is behind all.
  size_t row = 0;    ///< Among the rows of that index.
};

Place FindPlace(const Element& element, size_t row) {
  const auto& ends = element.row_ends;
  const auto end = std::upper_bound(ends.begin(), ends.end(), row);
  return {.index = static_cast<size_t>(end - ends.begin()),
          .row = row - (end == ends.begin() ? 0 : *std::prev(end))};
}

/// Appends the cells of the arrays within `element` at that place.
void AppendTables(const std::vector<CsvTable>& layout, const Element& element, Place place,
                  std::string* out) {
  for (size_t t = 0; t < layout.size(); ++t) {
    const std::vector<Element>& table = element.tables[t];
    if (place.index >= table.size()) {
      out->append(layout[t].num_columns, ',');
      continue;
    }
    const Element& inner = table[place.index];
    *out += inner.cells;
    AppendTables(layout[t].tables, inner, FindPlace(inner, place.row), out);
  }
}

}  // namespace

void AppendCsvCell(std::string_view any_text, std::string* out) {
  const std::string text = ValidUtf8(any_text);
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    *out += text;
    return;
  }
  *out += '"';
  for (const char c : text) {
    if (c == '"') *out += '"';
    *out += c;
  }
  *out += '"';
}

bool TakeCsvRow(std::string_view* rows, std::vector<std::string>* cells) {
  cells->clear();
  if (rows->empty()) return false;
  cells->emplace_back();
  bool is_quoted = false;
  size_t i = 0;
  for (; i < rows->size(); ++i) {
    const char c = (*rows)[i];
    if (c == '"') {
      // Two quotes inside of quotes are one: the first closes, the second opens again.
      if (!is_quoted && i > 0 && (*rows)[i - 1] == '"') cells->back() += c;
      is_quoted = !is_quoted;
    } else if (!is_quoted && c == '\n') {
      break;
    } else if (!is_quoted && c == ',') {
      cells->emplace_back();
    } else {
      cells->back() += c;
    }
  }
  rows->remove_prefix(std::min(i + 1, rows->size()));
  return true;
}

CsvLayout::CsvLayout(const Schema& schema, const StructType& type,
                     std::vector<std::string> extra_keys)
    : schema_(schema), type_(type), extra_keys_(std::move(extra_keys)) {
  Columns columns;
  ColumnFinder(schema).Add(type, "", false, &columns);
  columns_.push_back({.name = NameOfOwnColumn("time_s", columns), .value = CsvValue::kReal});
  if (!columns.tables.empty()) {
    columns.cells.push_back(
        {.name = NameOfOwnColumn("index", columns), .value = CsvValue::kInteger});
  }
  tables_ = AddInOrder(columns, &columns_).tables;
  const Member* extra = ExtraMember(schema, type);
  if (extra == nullptr) extra_keys_.clear();
  for (const std::string& key : extra_keys_) {
    columns_.push_back({.name = extra->name + "[" + key + "]"});
  }
  for (const CsvColumn& column : columns_) {
    if (!header_.empty()) header_ += ',';
    AppendCsvCell(column.name, &header_);
  }
  header_ += '\n';
}

void CsvLayout::AppendRows(int64_t event_utime, std::span<const uint8_t> bytes,
                           std::string* out) const {
  RowCollector collector(schema_);
  const auto fault = Walk(schema_, type_, bytes, &collector);
  SHOAL_CHECK(!fault, "a message of which rows are made decodes (FindWireFault() finds none)");
  std::string extra;
  if (!extra_keys_.empty()) {
    const ExtraFields fields = ExtraFieldsOf(schema_, type_, bytes);
    for (const std::string& key : extra_keys_) {
      extra += ',';
      const auto has_key = [&](const auto& field) { return ValidUtf8(field.first) == key; };
      const auto it = std::ranges::find_if(fields, has_key);
      if (it != fields.end()) AppendCsvCell(it->second, &extra);
    }
  }
  const Element& message = collector.message();
  for (size_t row = 0; row < message.num_rows(); ++row) {
    const Place place = FindPlace(message, row);
    AppendSeconds(event_utime, out);
    *out += message.cells;
    if (!tables_.empty()) *out += ',';
    if (!message.row_ends.empty()) *out += std::to_string(place.index);
    AppendTables(tables_, message, place, out);
    *out += extra;
    *out += '\n';
  }
}

}  // namespace shoal

#include "lib/record/csv_rows.h"

#include <algorithm>
#include <optional>

#include "lib/schema/text.h"

namespace shoal {

namespace {

/// Fixed arrays of up to so many elements have a column for each.
constexpr int64_t kMaxExpandedElements = 64;

enum class Shape {
  kCell,      ///< One value, one column.
  kExpanded,  ///< An array with a column for each element.
  kText,      ///< An array in one column.
  kNested,    ///< A struct, whose members are columns.
  kTable,     ///< An array of structs: rows.
};

Shape ShapeOf(const Member& member, bool is_in_table) {
  if (member.dimensions.empty()) return member.primitive ? Shape::kCell : Shape::kNested;
  if (!member.primitive) return is_in_table ? Shape::kText : Shape::kTable;
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

/// The columns of a type, in the order in which a walk comes to them.
struct Columns {
  std::vector<std::string> names;                ///< Outside of tables.
  std::vector<std::vector<std::string>> tables;  ///< One list for each array of structs.
};

void AddExpanded(const Member& member, const std::string& name, size_t d,
                 std::vector<std::string>* names) {
  if (d == member.dimensions.size()) {
    names->push_back(name + (IsUtime(member) ? "_s" : ""));
    return;
  }
  for (int64_t i = 0; i < member.dimensions[d].fixed_size; ++i) {
    std::string element = name;
    element.append("[").append(std::to_string(i)).append("]");
    AddExpanded(member, element, d + 1, names);
  }
}

/// Adds to `names`; arrays of structs to columns->tables, unless inside one (columns == nullptr).
void AddColumns(const Schema& schema, const StructType& type, const std::string& prefix,
                std::vector<std::string>* names, Columns* columns) {
  for (const Member& member : type.members) {
    const std::string name = prefix + member.name;
    switch (ShapeOf(member, columns == nullptr)) {
      case Shape::kCell:
        names->push_back(name + (IsUtime(member) ? "_s" : ""));
        break;
      case Shape::kExpanded:
        AddExpanded(member, name, 0, names);
        break;
      case Shape::kText:
        names->push_back(name);
        break;
      case Shape::kNested:
        AddColumns(schema, schema.types()[member.struct_index], name + ".", names, columns);
        break;
      case Shape::kTable:
        AddColumns(schema, schema.types()[member.struct_index], name + ".",
                   &columns->tables.emplace_back(), nullptr);
        break;
    }
  }
}

/// Sorts the values of a message into cells. A row is its cells, each with a comma before it.
class RowCollector : public Visitor {
 public:
  std::string outside;                           ///< The row's cells outside of tables.
  std::vector<std::vector<std::string>> tables;  ///< Rows of each array of structs.

  void MemberBegin(const Member& member) override {
    if (text_) return text_->MemberBegin(member);
    shape_ = ShapeOf(member, is_in_row_);
    is_utime_ = IsUtime(member);
    if (shape_ == Shape::kTable) tables.emplace_back();
    if (shape_ == Shape::kText) {
      cell_.clear();
      text_.emplace(&cell_, false);
    }
  }

  void StructBegin(const StructType& type) override {
    if (text_) text_->StructBegin(type);
    const bool is_row = !open_.empty() && open_.back() == Part::kTable;
    if (is_row) tables.back().emplace_back();
    is_in_row_ |= is_row;
    open_.push_back(is_row ? Part::kRow : PartThatBegins());
  }
  void StructEnd() override {
    if (text_) text_->StructEnd();
    Leave();
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
  /// What an open struct or array is to the table.
  enum class Part { kCells, kText, kTable, kRow };

  Part PartThatBegins() const {
    if (text_) return Part::kText;
    return shape_ == Shape::kTable ? Part::kTable : Part::kCells;
  }

  void Leave() {
    const Part part = open_.back();
    open_.pop_back();
    if (part == Part::kRow) {
      is_in_row_ = false;
      shape_ = Shape::kTable;
    }
    if (part == Part::kText && open_.back() != Part::kText) {
      text_.reset();
      AddCell();
    }
  }

  void AddCell() {
    std::string& row = is_in_row_ ? tables.back().back() : outside;
    row += ',';
    AppendCsvCell(cell_, &row);
  }

  std::vector<Part> open_;        ///< Outermost first.
  Shape shape_ = Shape::kNested;  ///< Of the member that began last.
  bool is_utime_ = false;         ///< That member is a time.
  bool is_in_row_ = false;
  std::string cell_;
  std::optional<TextWriter> text_;  ///< Present: inside a member that becomes one cell.
};

}  // namespace

void AppendCsvCell(std::string_view text, std::string* out) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
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

CsvLayout::CsvLayout(const Schema& schema, const StructType& type) : schema_(schema), type_(type) {
  Columns columns;
  AddColumns(schema, type, "", &columns.names, &columns);
  header_ = "time_s";
  const auto add = [&](const std::string& name) {
    header_ += ',';
    AppendCsvCell(name, &header_);
  };
  for (const std::string& name : columns.names) add(name);
  if (!columns.tables.empty()) add("index");
  for (const auto& table : columns.tables) {
    for (const std::string& name : table) add(name);
    empty_rows_.emplace_back(table.size(), ',');
  }
  header_ += '\n';
}

void CsvLayout::AppendRows(int64_t event_utime, std::span<const uint8_t> message,
                           std::string* out) const {
  RowCollector collector;
  const auto fault = Walk(schema_, type_, message, &collector);
  SHOAL_CHECK(!fault, "rows of a message that nobody checked");
  size_t num_rows = 0;
  for (const auto& table : collector.tables) num_rows = std::max(num_rows, table.size());
  for (size_t i = 0; i < std::max<size_t>(1, num_rows); ++i) {
    AppendSeconds(event_utime, out);
    *out += collector.outside;
    if (!empty_rows_.empty()) *out += ',';
    if (i < num_rows) *out += std::to_string(i);
    for (size_t t = 0; t < collector.tables.size(); ++t) {
      *out += i < collector.tables[t].size() ? collector.tables[t][i] : empty_rows_[t];
    }
    *out += '\n';
  }
}

}  // namespace shoal

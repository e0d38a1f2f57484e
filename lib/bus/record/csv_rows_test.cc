#include "lib/bus/record/csv_rows.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <sstream>
#include <utility>

namespace shoal::csv_rows_test {

/// Writes members of a message as LCM does.
class Wire {
 public:
  explicit Wire(const StructType& type) { Int64(type.fingerprint); }
  Wire& Int64(int64_t value) { return Put(static_cast<uint64_t>(value), 8); }
  Wire& Int32(int32_t value) { return Put(static_cast<uint32_t>(value), 4); }
  Wire& Int8(int8_t value) { return Put(static_cast<uint8_t>(value), 1); }
  Wire& Double(double value) { return Put(std::bit_cast<uint64_t>(value), 8); }
  Wire& Text(std::string_view value) {
    Int32(static_cast<int32_t>(value.size()) + 1);
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    return Int8(0);
  }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  Wire& Put(uint64_t value, int num_bytes) {
    for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
      bytes_.push_back(static_cast<uint8_t>(value >> shift));
    }
    return *this;
  }
  std::vector<uint8_t> bytes_;
};

struct Table {
  explicit Table(const std::string& text)
      : schema(*Schema::Build({{"a.lcm", text}})), type(*schema.FindByName("t")) {}
  std::string Rows(const Wire& wire) const {
    std::string rows;
    CsvLayout(schema, type).AppendRows(1'000'000, wire.bytes(), &rows);
    return rows;
  }
  std::string Header() const { return CsvLayout(schema, type).header(); }

  Schema schema;
  const StructType& type;
};

TEST(CsvLayout, GivesSmallFixedArraysAndNestedStructsColumnsOfTheirOwn) {
  const Table table(
      "struct t { int64_t utime; p_t at; int8_t grid[2][2]; int8_t many[65]; }"
      "struct p_t { double x_m; int64_t fix_utime; }");
  EXPECT_EQ(table.Header(),
            "time_s,utime_s,at.x_m,at.fix_utime_s,grid[0][0],grid[0][1],grid[1][0],grid[1][1],"
            "many\n");
  Wire wire(table.type);
  wire.Int64(500'000).Double(1.5).Int64(-1).Int8(1).Int8(2).Int8(3).Int8(4);
  std::string many = "[";
  for (int8_t i = 0; i < 65; ++i) {
    wire.Int8(i);
    many += std::to_string(i);
    many += i == 64 ? "]" : " ";
  }
  EXPECT_EQ(table.Rows(wire), "1.000,0.500,1.5,-0.000001,1,2,3,4," + many + "\n");
}

TEST(CsvLayout, PutsVariableArraysOfValuesIntoOneCell) {
  const Table table("struct t { int8_t n; string names[n]; double m[n][n]; int8_t last; }");
  EXPECT_EQ(table.Header(), "time_s,n,names,m,last\n");
  Wire wire(table.type);
  wire.Int8(2).Text("a b").Text("c").Double(1).Double(2).Double(3).Double(4).Int8(9);
  EXPECT_EQ(table.Rows(wire), "1.000,2,\"[\"\"a b\"\" c]\",[[1 2] [3 4]],9\n");
}

TEST(CsvLayout, RunsThroughSeveralArraysOfStructsAtOnce) {
  const Table table(
      "struct t { int8_t n; int8_t m; p_t a[n]; int8_t mid; q_t b[m][2]; int8_t last; }"
      "struct p_t { int8_t x; int8_t k; int8_t list[k]; q_t one; }"
      "struct q_t { int8_t y; }");
  EXPECT_EQ(table.Header(), "time_s,n,m,mid,last,index,a.x,a.k,a.list,a.one.y,b.y\n");
  Wire wire(table.type);
  wire.Int8(1).Int8(1);
  wire.Int8(7).Int8(2).Int8(1).Int8(2).Int8(5);  // a[0]
  wire.Int8(6);
  wire.Int8(10).Int8(11);  // b[0][0], b[0][1]
  wire.Int8(8);
  EXPECT_EQ(table.Rows(wire),
            "1.000,1,1,6,8,0,7,2,[1 2],5,10\n"
            "1.000,1,1,6,8,1,,,,,11\n");
}

TEST(CsvLayout, LeavesAMemberItsNameWhereTheTableHasAColumnOfThatName) {
  const Table table(
      "struct t { int8_t index; double time_s; int8_t row_index; int8_t n; p_t extra[n]; }"
      "struct p_t { int8_t index; }");
  EXPECT_EQ(table.Header(), "row_time_s,index,time_s,row_index,n,row_row_index,extra.index\n");
  Wire wire(table.type);
  wire.Int8(7).Double(2.5).Int8(6).Int8(1).Int8(9);
  EXPECT_EQ(table.Rows(wire), "1.000,7,2.5,6,1,0,9\n");
}

TEST(CsvLayout, GivesEachStructOfAnArrayInAnArrayARowWithTheOthersRepeated) {
  const Table table(
      "struct t { int8_t n; p_t a[n]; }"
      "struct p_t { int8_t x; int8_t k; q_t inner[k]; q_t one; }"
      "struct q_t { int64_t sent_utime; int8_t m; string names[m]; }");
  EXPECT_EQ(table.Header(),
            "time_s,n,index,a.x,a.k,a.one.sent_utime_s,a.one.m,a.one.names,"
            "a.inner.sent_utime_s,a.inner.m,a.inner.names\n");
  Wire wire(table.type);
  wire.Int8(3);
  wire.Int8(7).Int8(2);                                            // a[0]
  wire.Int64(250'000).Int8(2).Text("alpha 12").Text("b");          // a[0].inner[0]
  wire.Int64(-1).Int8(0).Int64(3'000'000).Int8(0);                 // a[0].inner[1], a[0].one
  wire.Int8(8).Int8(0).Int64(4'000'000).Int8(0);                   // a[1]
  wire.Int8(9).Int8(1).Int64(5'000'000).Int8(0).Int64(0).Int8(0);  // a[2]
  EXPECT_EQ(table.Rows(wire),
            "1.000,3,0,7,2,3.000,0,[],0.250,2,\"[\"\"alpha 12\"\" b]\"\n"
            "1.000,3,0,7,2,3.000,0,[],-0.000001,0,[]\n"
            "1.000,3,1,8,0,4.000,0,[],,,\n"
            "1.000,3,2,9,1,0.000,0,[],5.000,0,[]\n");
  EXPECT_EQ(table.Rows(Wire(table.type).Int8(0)), "1.000,0,,,,,,,,,\n");
}

TEST(CsvLayout, RunsThroughSeveralArraysWithinSeveralArraysAtOnce) {
  const Table table(
      "struct t { p_t a[2]; p_t b[1]; q_t c[3]; }"
      "struct p_t { int8_t n; q_t v[n]; int8_t m; w_t w; } struct w_t { q_t deep[1][2]; }"
      "struct q_t { int8_t y; }");
  EXPECT_EQ(table.Header(), "time_s,index,a.n,a.m,a.v.y,a.w.deep.y,b.n,b.m,b.v.y,b.w.deep.y,c.y\n");
  Wire wire(table.type);
  wire.Int8(3).Int8(1).Int8(2).Int8(3).Int8(40).Int8(5).Int8(6);  // a[0]
  wire.Int8(0).Int8(41).Int8(7).Int8(8);                          // a[1]
  wire.Int8(1).Int8(9).Int8(42).Int8(10).Int8(11);                // b[0]
  wire.Int8(12).Int8(13).Int8(14);                                // c
  EXPECT_EQ(table.Rows(wire),
            "1.000,0,3,40,1,5,1,42,9,10,12\n"
            "1.000,0,3,40,2,6,1,42,,11,12\n"
            "1.000,0,3,40,3,,1,42,,,12\n"
            "1.000,1,0,41,,7,,,,,13\n"
            "1.000,1,0,41,,8,,,,,13\n"
            "1.000,2,,,,,,,,,14\n");
}

TEST(CsvLayout, GoesAsDeepAsArraysDo) {
  const Table table(
      "struct t { a_t a[2]; } struct a_t { int8_t x; b_t b[2]; } struct b_t { int8_t n; c_t c[n]; }"
      "struct c_t { int8_t z; }");
  EXPECT_EQ(table.Header(), "time_s,index,a.x,a.b.n,a.b.c.z\n");
  Wire wire(table.type);
  wire.Int8(1).Int8(2).Int8(3).Int8(4).Int8(0);          // a[0]
  wire.Int8(5).Int8(1).Int8(6).Int8(2).Int8(7).Int8(8);  // a[1]
  EXPECT_EQ(table.Rows(wire),
            "1.000,0,1,2,3\n"
            "1.000,0,1,2,4\n"
            "1.000,0,1,0,\n"
            "1.000,1,5,1,6\n"
            "1.000,1,5,2,7\n"
            "1.000,1,5,2,8\n");
}

TEST(CsvLayout, PutsStructsThatHoldThemselvesIntoOneCell) {
  const Table tree("struct t { int8_t n; t sons[n]; }");
  EXPECT_EQ(tree.Header(), "time_s,n,index,sons.n,sons.sons\n");
  Wire wire(tree.type);
  wire.Int8(2).Int8(1).Int8(0).Int8(0);
  EXPECT_EQ(tree.Rows(wire), "1.000,2,0,1,[{sons=[]}]\n1.000,2,1,0,[]\n");

  const Table by_another("struct t { int8_t n; u_t list[n]; } struct u_t { t inner; }");
  EXPECT_EQ(by_another.Header(), "time_s,n,index,list.inner.n,list.inner.list\n");
}

/// The cells of a line without quotes and line feed.
size_t NumCells(std::string_view line) {
  return static_cast<size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

RC_GTEST_PROP(CsvLayoutProperty, GivesEachInnerStructOneRowAndEachRowAllColumns, ()) {
  const Table table(
      "struct t { int8_t n; p_t a[n]; } struct p_t { int8_t k; q_t v[k]; int8_t l; q_t w[l]; }"
      "struct q_t { int8_t y; }");
  const auto elements = *rc::gen::container<std::vector<std::pair<int8_t, int8_t>>>(
      rc::gen::pair(rc::gen::inRange<int8_t>(0, 5), rc::gen::inRange<int8_t>(0, 5)));
  RC_PRE(elements.size() <= 100u);
  Wire wire(table.type);
  wire.Int8(static_cast<int8_t>(elements.size()));
  std::vector<size_t> expected;  // index of each row
  for (size_t i = 0; i < elements.size(); ++i) {
    const auto [k, l] = elements[i];
    wire.Int8(k);
    for (int8_t j = 0; j < k; ++j) wire.Int8(j);
    wire.Int8(l);
    for (int8_t j = 0; j < l; ++j) wire.Int8(j);
    expected.insert(expected.end(), static_cast<size_t>(std::max<int8_t>({1, k, l})), i);
  }
  std::istringstream rows(table.Rows(wire));
  std::vector<size_t> indices;
  for (std::string row; std::getline(rows, row);) {
    RC_ASSERT(NumCells(row) == NumCells(table.Header()));
    if (elements.empty()) continue;
    const size_t at = row.find(',', row.find(',') + 1) + 1;
    indices.push_back(std::stoul(row.substr(at)));
  }
  RC_ASSERT(indices == expected);
}

TEST(AppendCsvCell, QuotesAsRfc4180Asks) {
  const auto cell = [](std::string_view text) {
    std::string out;
    AppendCsvCell(text, &out);
    return out;
  };
  EXPECT_EQ(cell("plain text"), "plain text");
  EXPECT_EQ(cell(""), "");
  EXPECT_EQ(cell("a,b"), "\"a,b\"");
  EXPECT_EQ(cell("the \"x\""), "\"the \"\"x\"\"\"");
  EXPECT_EQ(cell("two\nlines"), "\"two\nlines\"");
}

RC_GTEST_PROP(TakeCsvRow, ReadsWhatAppendCsvCellWrote, ()) {
  const auto rows = *rc::gen::container<std::vector<std::vector<std::string>>>(
      rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(
          rc::gen::container<std::string>(rc::gen::element('a', '"', ',', '\n', '\r')))));
  std::string text;
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      AppendCsvCell(row[i], &text);
    }
    text += '\n';
  }
  std::string_view rest = text;
  std::vector<std::string> cells;
  for (const auto& row : rows) {
    RC_ASSERT(TakeCsvRow(&rest, &cells));
    RC_ASSERT(cells == row);
  }
  RC_ASSERT(!TakeCsvRow(&rest, &cells));
}

}  // namespace shoal::csv_rows_test

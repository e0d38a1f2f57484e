#include "lib/record/csv_rows.h"

#include <gtest/gtest.h>

#include <bit>

namespace shoal {
namespace {

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
      "struct p_t { int8_t x; int8_t k; int8_t list[k]; q_t inner[k]; q_t one; }"
      "struct q_t { int8_t y; }");
  EXPECT_EQ(table.Header(), "time_s,n,m,mid,last,index,a.x,a.k,a.list,a.inner,a.one.y,b.y\n");
  Wire wire(table.type);
  wire.Int8(1).Int8(1);
  wire.Int8(7).Int8(2).Int8(1).Int8(2).Int8(3).Int8(4).Int8(5);  // a[0]
  wire.Int8(6);
  wire.Int8(10).Int8(11);  // b[0][0], b[0][1]
  wire.Int8(8);
  EXPECT_EQ(table.Rows(wire),
            "1.000,1,1,6,8,0,7,2,[1 2],[{y=3} {y=4}],5,10\n"
            "1.000,1,1,6,8,1,,,,,,11\n");
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
  EXPECT_EQ(cell("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(cell("two\nlines"), "\"two\nlines\"");
}

}  // namespace
}  // namespace shoal

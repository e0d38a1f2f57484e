#include "lib/tools/rebroker/link_table.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::link_table_test {

fate_t Fate(const std::string& kind, const std::string& destination, const std::string& cause,
            int32_t count = 1) {
  fate_t fate{};
  fate.kind = kind;
  fate.source = "alpha";
  fate.destination = destination;
  fate.cause = cause;
  fate.count = count;
  return fate;
}

TEST(LinkTable, CountsByKindLinkAndCause) {
  LinkTable table;
  table.AddRecorded(Fate("report", "bravo", "delivered"));
  table.AddNow(Fate("report", "bravo", "out_of_range"));
  table.AddNow(Fate("report", "*", "out_of_range", 12));
  table.AddNow(Fate("message", "bravo", "delivered"));
  EXPECT_EQ(table.Of("report", "alpha", "bravo", "delivered"), (LinkTable::Change{1, 0}));
  EXPECT_EQ(table.Of("report", "alpha", "bravo", "out_of_range"), (LinkTable::Change{0, 1}));
  EXPECT_EQ(table.Of("report", "alpha", "*", "out_of_range"), (LinkTable::Change{0, 12}));
  EXPECT_EQ(table.Of("message", "alpha", "bravo", "delivered"), (LinkTable::Change{0, 1}));
  EXPECT_EQ(table.Of("ack", "alpha", "bravo", "delivered"), (LinkTable::Change{0, 0}));
}

TEST(LinkTable, CountsNothingForCountsThatAreNone) {
  LinkTable table;
  table.AddRecorded(Fate("report", "*", "out_of_range", -5));
  table.AddRecorded(Fate("report", "*", "out_of_range", 0));
  EXPECT_EQ(table.Text(LinkTable::kAllLinks), "");
}

TEST(LinkTable, MarksWhatDiffers) {
  LinkTable table;
  for (int i = 0; i < 3; ++i) table.AddRecorded(Fate("report", "bravo", "delivered"));
  table.AddNow(Fate("report", "bravo", "delivered"));
  table.AddRecorded(Fate("report", "bravo", "dropped"));
  table.AddNow(Fate("report", "bravo", "dropped"));
  EXPECT_EQ(table.Text(LinkTable::kAllLinks),
            "Node reports                                        recorded        now\n"
            "* all links                  delivered                     3          1         -2\n"
            "                             dropped                       1          1\n"
            "* alpha -> bravo             delivered                     3          1         -2\n"
            "                             dropped                       1          1\n"
            "\n");
}

TEST(LinkTable, LeavesLinksWithoutADifferenceOutWhereThereAreMany) {
  LinkTable table;
  for (const char* name : {"bravo", "charlie", "delta"}) {
    table.AddRecorded(Fate("report", name, "delivered"));
    table.AddNow(Fate("report", name, name == std::string("delta") ? "dropped" : "delivered"));
  }
  const std::string text = table.Text(2);
  EXPECT_EQ(text.find("bravo"), std::string::npos) << text;
  EXPECT_NE(text.find("* alpha -> delta"), std::string::npos) << text;
  EXPECT_NE(text.find("2 links without a difference not shown"), std::string::npos) << text;
  EXPECT_NE(table.Text(3).find("bravo"), std::string::npos);
}

TEST(LinkTable, EscapesUnprintableText) {
  LinkTable table;
  table.AddRecorded(Fate("made up\n", "\x1b[2J", ""));
  const std::string text = table.Text(LinkTable::kAllLinks);
  EXPECT_NE(text.find("Of other kinds"), std::string::npos) << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

}  // namespace shoal::link_table_test

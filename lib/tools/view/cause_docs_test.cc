// docs/reference/fates.md and docs/communication/acoustic_network.md against the table of causes
// and the rules' order.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "lib/comms/routing/cause.h"
#include "lib/comms/routing/decide.h"
#include "lib/tools/view/fate_text.h"

namespace shoal::cause_docs_test {

std::string PageText(const std::string& path) {
  std::ifstream in(std::string(SHOAL_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// One table: the rows that begin with a name in backticks, by that name.
using PageTable = std::map<std::string, std::string>;

/// Returns the tables of a page whose first column has this head.
std::vector<PageTable> TablesOf(const std::string& page, const std::string& head) {
  std::vector<PageTable> tables;
  bool is_in_table = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| " + head + " |")) {
      is_in_table = true;
      tables.emplace_back();
    } else if (!line.starts_with("|")) {
      is_in_table = false;
    } else if (is_in_table && line.starts_with("| `")) {
      const size_t end = line.find('`', 3);
      tables.back()[line.substr(3, end - 3)] += line.substr(end);
    }
  }
  return tables;
}

std::vector<std::string> KeysOf(const PageTable& table) {
  std::vector<std::string> keys;
  for (const auto& [key, row] : table) keys.push_back(key);
  return keys;
}

/// The keys of causes that `belongs` picks, in the order of texts.
template <class Belongs>
std::vector<std::string> KeysWhere(const Belongs& belongs) {
  std::vector<std::string> keys;
  for (const CauseRow& row : kCauseTable) {
    if (belongs(row)) keys.emplace_back(row.key);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

TEST(FatesPage, HasARowForEachCauseOfTheRulesAndOfTheNetworkAndNoOthers) {
  const std::vector<PageTable> tables = TablesOf(PageText("docs/reference/fates.md"), "cause");
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(KeysOf(tables[0]),
            KeysWhere([](const CauseRow& row) { return !row.of_rules.empty(); }));
  EXPECT_EQ(KeysOf(tables[1]),
            KeysWhere([](const CauseRow& row) { return !row.of_network.empty(); }));
}

TEST(FatesPage, NamesTheNumbersThatATextOfACauseShows) {
  const std::vector<PageTable> tables = TablesOf(PageText("docs/reference/fates.md"), "cause");
  ASSERT_EQ(tables.size(), 2U);
  for (const CauseRow& row : kCauseTable) {
    if (row.outcome == CauseOutcome::kPending) continue;
    std::string rows;
    for (const PageTable& table : tables) {
      const auto found = table.find(std::string(row.key));
      if (found != table.end()) rows += found->second;
    }
    for (const FateNumber& number : FateNumbers()) {
      if (row.text.find("{" + std::string(number.name) + "}") == row.text.npos) continue;
      std::istringstream members{std::string(number.members)};
      for (std::string member; members >> member;) {
        EXPECT_NE(rows.find("`" + member), rows.npos) << row.key << " shows " << member;
      }
    }
  }
}

TEST(FatesPage, ListsTheRulesOfEachKindInTheirOrder) {
  const std::string page = PageText("docs/reference/fates.md");
  for (const Kind kind : {Kind::kReport, Kind::kMessage, Kind::kPacket}) {
    size_t place = page.find("- A " + std::string(KindText(kind)) + ": ");
    ASSERT_NE(place, page.npos) << KindText(kind);
    place = page.find("at each destination", place);
    const size_t end = page.find("\n- ", place);
    for (const Cause cause : OrderOfCauses(kind)) {
      if (cause == Cause::kDelivered) continue;
      place = page.find("`" + std::string(CauseText(cause)) + "`", place);
      EXPECT_LT(place, end) << KindText(kind) << " asks for " << CauseText(cause);
    }
  }
}

TEST(AcousticNetworkPage, CallsCausesAsTheWireDoes) {
  const std::vector<PageTable> tables =
      TablesOf(PageText("docs/communication/acoustic_network.md"), "cause");
  ASSERT_EQ(tables.size(), 1U);
  // What never enters the network is described in the text below the table.
  EXPECT_EQ(KeysOf(tables[0]), KeysWhere([](const CauseRow& row) {
              // Those that it alone can give stand behind kNoChannel.
              return row.cause == Cause::kDelivered || row.cause > Cause::kNoChannel;
            }));
}

}  // namespace shoal::cause_docs_test

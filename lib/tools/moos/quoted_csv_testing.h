// Tables of tests/golden/moos_import, whose cells may be in double quotes.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/golden/read_golden.h"

namespace shoal {

/// Returns the rows by the columns' titles; a doubled quote within a quoted cell is one.
inline std::vector<GoldenRow> ReadQuotedCsv(const std::string& name) {
  std::ifstream in(GoldenPath(name));
  EXPECT_TRUE(in) << GoldenPath(name);
  std::vector<std::string> titles;
  std::vector<GoldenRow> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells = {""};
    bool is_quoted = false;
    for (size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && is_quoted && line.substr(i + 1, 1) == "\"") {
        cells.back() += line[++i];
      } else if (line[i] == '"') {
        is_quoted = !is_quoted;
      } else if (line[i] == ',' && !is_quoted) {
        cells.emplace_back();
      } else if (line[i] != '\r') {
        cells.back() += line[i];
      }
    }
    if (titles.empty()) {
      titles = cells;
      continue;
    }
    GoldenRow row;
    for (size_t i = 0; i < titles.size() && i < cells.size(); ++i) row[titles[i]] = cells[i];
    rows.push_back(row);
  }
  EXPECT_GT(rows.size(), 1U) << name;
  return rows;
}

}  // namespace shoal

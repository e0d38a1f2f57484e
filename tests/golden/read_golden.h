// Reads the tables of tests/golden: numbers that another program or a book gives for our formulas.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace shoal {

/// Returns the path of a file of tests/golden, "munet/flip_bits.csv".
inline std::string GoldenPath(const std::string& name) {
  return std::string(SHOAL_SOURCE_DIR) + "/tests/golden/" + name;
}

/// Returns the text of a file, or nothing where there is none.
inline std::optional<std::string> ReadGoldenText(const std::string& name) {
  std::ifstream in(GoldenPath(name));
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline nlohmann::json ReadGoldenJson(const std::string& name) {
  std::ifstream in(GoldenPath(name));
  EXPECT_TRUE(in) << GoldenPath(name);
  return nlohmann::json::parse(in);
}

/// A line of a table, by the columns' titles.
using GoldenRow = std::map<std::string, std::string>;

inline std::vector<GoldenRow> ReadGoldenCsv(const std::string& name) {
  std::ifstream in(GoldenPath(name));
  EXPECT_TRUE(in) << GoldenPath(name);
  std::vector<std::string> titles;
  std::vector<GoldenRow> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    GoldenRow row;
    size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      if (rows.empty() && titles.size() == column) {
        titles.push_back(cell);
      }
      row[titles.at(column)] = cell;
    }
    rows.push_back(row);
  }
  EXPECT_GT(rows.size(), 1U) << name;
  if (!rows.empty()) rows.erase(rows.begin());  // The titles.
  return rows;
}

inline double Number(const GoldenRow& row, const std::string& title) {
  return std::strtod(row.at(title).c_str(), nullptr);
}

inline std::vector<uint8_t> FromHex(const std::string& hex) {
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

}  // namespace shoal

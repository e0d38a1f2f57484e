// The functions of tests/golden/helm/functions.csv, and how shoal's are held against them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/decision/decide.h"
#include "tests/golden/read_golden.h"

namespace shoal {

struct GoldenEncounter {
  VesselMotion own = {};
  VesselMotion contact = {};
};

/// States by their number.
inline std::map<std::string, GoldenEncounter> ReadEncounters() {
  std::map<std::string, GoldenEncounter> encounters;
  for (const GoldenRow& row : ReadGoldenCsv("helm/states.csv")) {
    const auto vessel = [&](const std::string& which) {
      return VesselMotion{.position_m = {Number(row, which + "x"), Number(row, which + "y")},
                          .heading_deg = Number(row, which + "h"),
                          .speed_mps = Number(row, which + "v")};
    };
    encounters[row.at("state")] = {.own = vessel("os"), .contact = vessel("cn")};
  }
  return encounters;
}

/// The rows of one behavior.
inline std::vector<GoldenRow> ReadFunctions(const std::string& behavior) {
  std::vector<GoldenRow> rows;
  for (const GoldenRow& row : ReadGoldenCsv("helm/functions.csv")) {
    if (row.at("behavior") == behavior) rows.push_back(row);
  }
  return rows;
}

/// Compares at every 10 degrees and 0.5 m/s. Returns the greatest difference.
inline double GreatestDifference(const Objective& objective, const GoldenRow& row) {
  std::istringstream values(row.at("values"));
  double worst = 0;
  int num_values = 0;
  for (int course = 0; course < 360; course += 10) {
    for (int speed = 0; speed <= 40; speed += 5) {
      double golden = 0;
      if (values >> golden) ++num_values;
      worst = std::max(worst, std::abs(ValueOf(objective, course, speed, 0) - golden));
    }
  }
  EXPECT_EQ(num_values, 324);
  return worst;
}

}  // namespace shoal

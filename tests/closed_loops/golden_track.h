// The tracks of tests/golden, and how shoal's are held against them.
//
//   const GoldenTracks golden = ReadTracks("munet/sim_direct_cb.csv");
//   for (const GoldenRow& row : golden.at(step)) ExpectState(auv.state, row, 1e-8);
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "tests/golden/read_golden.h"

namespace shoal {

inline constexpr std::array kEtaTitles = {"x", "y", "z", "phi", "theta", "psi"};
inline constexpr std::array kNuTitles = {"u", "v", "w", "p", "q", "r"};

/// Rows by their step, one for every vehicle of a swarm.
using GoldenTracks = std::map<int64_t, std::vector<GoldenRow>>;

inline GoldenTracks ReadTracks(const std::string& file) {
  GoldenTracks tracks;
  for (const GoldenRow& row : ReadGoldenCsv(file)) {
    tracks[static_cast<int64_t>(Number(row, "i"))].push_back(row);
  }
  return tracks;
}

inline Eigen::Vector3d PositionIn(const GoldenRow& row) {
  return {Number(row, "x"), Number(row, "y"), Number(row, "z")};
}

inline Remus100State StateIn(const GoldenRow& row) {
  Remus100State state;
  for (int i = 0; i < 6; ++i) {
    state.eta[i] = Number(row, kEtaTitles.at(static_cast<size_t>(i)));
    state.nu[i] = Number(row, kNuTitles.at(static_cast<size_t>(i)));
  }
  state.actuators = {Number(row, "rud_act"), Number(row, "stern_act"), Number(row, "rpm_act")};
  return state;
}

/// Compares with `tolerance`, relative for values above 1.
inline void ExpectState(const Remus100State& state, const GoldenRow& row, double tolerance,
                        const std::string& where) {
  const Remus100State golden = StateIn(row);
  const auto allowed = [&](double value) { return tolerance * std::max(1.0, std::abs(value)); };
  for (int i = 0; i < 6; ++i) {
    const double away = state.eta[i] - golden.eta[i];
    EXPECT_NEAR(i < 3 ? away : WrapPi(away), 0, allowed(golden.eta[i]))
        << where << " " << kEtaTitles.at(static_cast<size_t>(i));
    EXPECT_NEAR(state.nu[i], golden.nu[i], allowed(golden.nu[i]))
        << where << " " << kNuTitles.at(static_cast<size_t>(i));
  }
  EXPECT_NEAR(state.actuators.rudder_rad, golden.actuators.rudder_rad, tolerance) << where;
  EXPECT_NEAR(state.actuators.stern_plane_rad, golden.actuators.stern_plane_rad, tolerance)
      << where;
  EXPECT_NEAR(state.actuators.propeller_rpm, golden.actuators.propeller_rpm,
              allowed(golden.actuators.propeller_rpm))
      << where;
}

}  // namespace shoal

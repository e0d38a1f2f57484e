// What the status page of a helm shows, but for what its arbiter and its log add.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "apps/helm/helm_order.h"
#include "apps/helm/helm_states.h"
#include "lib/mission/model/vehicle.h"
#include "shoal/actuators_t.hpp"
#include "shoal/desired_t.hpp"
#include "shoal/guidance_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/nav_t.hpp"

namespace shoal {

/// Another vehicle, as its last report has it.
struct ReportedVehicle {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  int64_t reported_utime = 0;
};
using ReportedVehicles = std::map<std::string, ReportedVehicle, std::less<>>;

/// How many messages a helm has received.
struct HelmCounters {
  int64_t num_navs = 0;
  int64_t num_bad_navs = 0;
  std::array<int64_t, kNumOrderKinds> num_executed{};
  int64_t num_refused = 0;  ///< Orders.
  int64_t num_reports = 0;
  int64_t num_undecodable = 0;
};

/// Everything outlives the call.
struct HelmPageFacts {
  const Vehicle& vehicle;
  std::string gains;
  const HelmStates& states;
  const helm_state_t& state;   ///< As published last.
  const guidance_t* guidance;  ///< The same; nullptr: it never was.
  const nav_t& nav;
  const desired_t& desired;
  const actuators_t& actuators;
  HelmCounters counters;
  const ReportedVehicles& contacts;
  int64_t utime = 0;
};

[[nodiscard]] std::string HelmPageText(const HelmPageFacts& facts);

}  // namespace shoal

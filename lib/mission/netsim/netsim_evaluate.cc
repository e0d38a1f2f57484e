#include "lib/mission/netsim/netsim_evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shoal {

namespace {

struct NavVerdict {
  NetsimStatus status = NetsimStatus::kAccepted;
  std::string problem = {};
};

struct NavValue {
  const char* name;
  double NetsimNav::*value;
};

constexpr NavValue kValues[] = {
    {"time", &NetsimNav::time_s},     {"lat", &NetsimNav::lat_deg},
    {"lon", &NetsimNav::lon_deg},     {"depth", &NetsimNav::depth_m},
    {"speed", &NetsimNav::speed_mps}, {"heading", &NetsimNav::heading_deg},
};

struct NavBound {
  const char* name;
  double NetsimNav::*value;
  double NetsimEnvironment::*min;
  double NetsimEnvironment::*max;
};

constexpr NavBound kBounds[] = {
    {"lat", &NetsimNav::lat_deg, &NetsimEnvironment::lat_min_deg, &NetsimEnvironment::lat_max_deg},
    {"lon", &NetsimNav::lon_deg, &NetsimEnvironment::lon_min_deg, &NetsimEnvironment::lon_max_deg},
    {"depth", &NetsimNav::depth_m, &NetsimEnvironment::depth_min_m,
     &NetsimEnvironment::depth_max_m},
};

const NetsimVehicle* FindVehicle(const NetsimOptions& options, int modem_tcp_port) {
  const auto vehicle = std::find_if(
      options.vehicles.begin(), options.vehicles.end(),
      [&](const NetsimVehicle& each) { return each.modem_tcp_port == modem_tcp_port; });
  return vehicle == options.vehicles.end() ? nullptr : &*vehicle;
}

const NetsimEnvironment* FindEnvironment(const NetsimOptions& options, const std::string& name) {
  const auto environment =
      std::find_if(options.environments.begin(), options.environments.end(),
                   [&](const NetsimEnvironment& each) { return each.name == name; });
  return environment == options.environments.end() ? nullptr : &*environment;
}

NavVerdict OutOfRegion(std::string problem) {
  return {NetsimStatus::kOutOfDefinedRegion, std::move(problem)};
}

NavVerdict JudgePlace(const NetsimNav& nav, const NetsimVehicle& vehicle,
                      const NetsimOptions& options) {
  for (const NavValue& each : kValues) {
    if (std::isfinite(nav.*each.value)) continue;
    return OutOfRegion(fmt::format("{}: {} is missing or not finite", vehicle.name, each.name));
  }
  const NetsimEnvironment* environment = FindEnvironment(options, vehicle.environment);
  if (environment == nullptr) {
    return OutOfRegion(fmt::format("{}: no environment '{}'", vehicle.name, vehicle.environment));
  }
  for (const NavBound& bound : kBounds) {
    const double value = nav.*bound.value;
    if (value >= environment->*bound.min && value <= environment->*bound.max) continue;
    return OutOfRegion(fmt::format("{}: {} {} is not from {} to {} (environment '{}')",
                                   vehicle.name, bound.name, value, environment->*bound.min,
                                   environment->*bound.max, environment->name));
  }
  return {};
}

NavVerdict Judge(const NetsimNav& nav, const NetsimVehicle* vehicle, std::string_view peer_address,
                 const NetsimOptions& options) {
  if (vehicle == nullptr) {
    return {NetsimStatus::kInvalidModemTcpPort,
            fmt::format("modem_tcp_port {} belongs to no [[netsim.vehicle]]", nav.modem_tcp_port)};
  }
  if (vehicle->address != "any" && vehicle->address != peer_address) {
    return {NetsimStatus::kInvalidSourceAddress,
            fmt::format("{}: positions come from {} only, not from {}", vehicle->name,
                        vehicle->address, peer_address)};
  }
  return JudgePlace(nav, *vehicle, options);
}

}  // namespace

NetsimVerdict EvaluateRequest(const NetsimRequest& request, std::string_view peer_address,
                              const NetsimOptions& options) {
  NetsimVerdict verdict{
      .status = NetsimStatus::kAccepted, .positions = {}, .stats = request.stats, .problem = {}};
  for (const NetsimNav& nav : request.navs) {
    const NetsimVehicle* vehicle = FindVehicle(options, nav.modem_tcp_port);
    NavVerdict judged = Judge(nav, vehicle, peer_address, options);
    if (judged.status != NetsimStatus::kAccepted) {
      verdict.status = judged.status;
      verdict.problem = std::move(judged.problem);
      break;
    }
    verdict.positions.push_back({vehicle->name, nav});
  }
  if (request.is_whole) return verdict;

  verdict.positions.clear();
  verdict.stats.clear();
  if (verdict.status != NetsimStatus::kAccepted) return verdict;
  // All that was checked is right, and yet nothing is applied: there is no status for this.
  verdict.status.reset();
  verdict.problem = "a required field of stats is missing";
  return verdict;
}

}  // namespace shoal

#include "lib/mission/netsim/netsim_options.h"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace shoal {

namespace {

using Problems = std::vector<NetsimProblem>;

constexpr int kMinLineBytes = 1024;
constexpr int kMaxLineBytes = 64 << 20;
constexpr int kMaxConnections = 10'000;
constexpr double kMaxTimeout_s = 1e9;

std::string WhereEnvironment(const NetsimEnvironment& environment) {
  return fmt::format("netsim.environment '{}'", environment.name);
}

std::string WhereVehicle(const NetsimVehicle& vehicle) {
  return fmt::format("netsim.vehicle '{}'", vehicle.name);
}

/// False for NaN.
template <class T>
bool IsFrom(T low, T high, T value) {
  return value >= low && value <= high;
}

template <class T>
void CheckNumber(const std::string& where, const std::string& key, T low, T high, T value,
                 Problems* problems) {
  if (IsFrom(low, high, value)) return;
  problems->push_back({where, key, fmt::format("must be from {} to {}, not {}", low, high, value)});
}

void CheckBounds(const std::string& where, const std::string& quantity, double min, double max,
                 double limit, Problems* problems) {
  const auto separator = quantity.rfind('_');
  const auto key = [&](const char* end) {
    return quantity.substr(0, separator) + end + quantity.substr(separator);
  };
  const size_t num_before = problems->size();
  CheckNumber(where, key("_min"), -limit, limit, min, problems);
  CheckNumber(where, key("_max"), -limit, limit, max, problems);
  if (problems->size() > num_before || min <= max) return;
  problems->push_back(
      {where, key("_max"), fmt::format("must not be less than {}, {}", key("_min"), min)});
}

void CheckEnvironment(const NetsimEnvironment& environment, Problems* problems) {
  const std::string where = WhereEnvironment(environment);
  CheckBounds(where, "lat_deg", environment.lat_min_deg, environment.lat_max_deg, 90, problems);
  CheckBounds(where, "lon_deg", environment.lon_min_deg, environment.lon_max_deg, 360, problems);
  CheckBounds(where, "depth_m", environment.depth_min_m, environment.depth_max_m, 12'000, problems);
}

/// Ports of this machine, and their owners.
class Ports {
 public:
  explicit Ports(Problems* problems) : problems_(problems) {}

  void Take(const std::string& where, const std::string& key, int port) {
    CheckNumber(where, key, 1, 65535, port, problems_);
    const std::string owner = fmt::format("{} of {}", key, where);
    const auto [entry, is_new] = owners_.emplace(port, owner);
    if (is_new) return;
    problems_->push_back(
        {where, key, fmt::format("{} is taken by {}: each port has one use", port, entry->second)});
  }

 private:
  Problems* problems_;
  std::map<int, std::string> owners_;
};

bool HasEnvironment(const NetsimOptions& options, const std::string& name) {
  return std::any_of(options.environments.begin(), options.environments.end(),
                     [&](const NetsimEnvironment& each) { return each.name == name; });
}

void CheckVehicle(const NetsimVehicle& vehicle, const NetsimOptions& options, Ports* ports,
                  Problems* problems) {
  const std::string where = WhereVehicle(vehicle);
  ports->Take(where, "modem_tcp_port", vehicle.modem_tcp_port);
  if (vehicle.gps.tcp_port != 0) ports->Take(where, "gps_tcp_port", vehicle.gps.tcp_port);
  if (vehicle.address != "any" && !IsIpv4Address(vehicle.address)) {
    problems->push_back({where, "address",
                         fmt::format("must be an IPv4 address, as \"127.0.0.1\", or \"any\", not "
                                     "\"{}\": names are not looked up",
                                     vehicle.address)});
  }
  if (!HasEnvironment(options, vehicle.environment)) {
    problems->push_back(
        {where, "environment",
         fmt::format("no [[netsim.environment]] has the name '{}'", vehicle.environment)});
  }
}

template <class Entries, class Where>
void CheckNames(const Entries& entries, Where where, Problems* problems) {
  std::set<std::string> names;
  for (const auto& entry : entries) {
    if (entry.name.empty()) problems->push_back({where(entry), "name", "must not be empty"});
    if (!names.insert(entry.name).second) {
      problems->push_back({where(entry), "name", "is there twice"});
    }
  }
}

}  // namespace

bool IsIpv4Address(const std::string& text) {
  in_addr address{};
  return text.find('\0') == text.npos && inet_pton(AF_INET, text.c_str(), &address) == 1;
}

std::vector<NetsimProblem> FindNetsimProblems(const NetsimOptions& options) {
  Problems problems;
  Ports ports(&problems);
  ports.Take("netsim", "port", options.port);
  if (!IsIpv4Address(options.address)) {
    problems.push_back({"netsim", "address",
                        fmt::format("must be an IPv4 address of this machine, as \"127.0.0.1\", or "
                                    "\"0.0.0.0\" for all of them, not \"{}\"",
                                    options.address)});
  }
  CheckNumber("netsim", "max_connections", 1, kMaxConnections, options.max_connections, &problems);
  CheckNumber("netsim", "max_line_bytes", kMinLineBytes, kMaxLineBytes, options.max_line_bytes,
              &problems);
  CheckNumber("netsim", "idle_timeout_s", 0.0, kMaxTimeout_s, options.idle_timeout_s, &problems);
  CheckNames(options.environments, WhereEnvironment, &problems);
  CheckNames(options.vehicles, WhereVehicle, &problems);
  for (const NetsimEnvironment& each : options.environments) CheckEnvironment(each, &problems);
  for (const NetsimVehicle& each : options.vehicles) {
    CheckVehicle(each, options, &ports, &problems);
  }
  return problems;
}

}  // namespace shoal

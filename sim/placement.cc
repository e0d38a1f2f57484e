#include "sim/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string_view>

#include "lib/base/check/check.h"
#include "lib/base/text/numbers.h"
#include "lib/comms/routing/reach_grid.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/broker/report_blocks.h"

namespace shoal {

namespace {

// Rough costs of a step, in microseconds of one core. Their ratios alone count, and a wrong one
// only makes a mission slower.
constexpr double kVessel_us = 0.9;     ///< Simulation, helm and node_reporter.
constexpr double kModelStep_us = 0.6;  ///< Of a model that integrates in steps of its own.
constexpr double kMember_us = 1;       ///< Its acomms, and the positions of the others.
constexpr double kBehavior_us = 4;     ///< A decision, shared out over the steps between two.
constexpr double kDirectorPerVehicle_us = 0.12;
constexpr double kBrokerPerVehicle_us = 0.14;
constexpr double kBrokerPerLink_us = 0.09;  ///< For each other vehicle with fates of its own.

double CostOf(const Mission& mission, const Vehicle& vehicle) {
  double cost_us = 0;
  if (vehicle.sim == Provider::kShoal) cost_us += kVessel_us / 3;
  if (vehicle.helm == Provider::kShoal) cost_us += kVessel_us / 3;
  if (vehicle.reporter == Provider::kShoal) cost_us += kVessel_us / 3;
  if (const auto* model = std::get_if<Remus100Options>(&vehicle.model)) {
    cost_us += kModelStep_us * static_cast<double>(mission.tick_us) / 1e6 / model->model_step_s;
  }
  if (mission.SwarmOf(vehicle) != nullptr) cost_us += kMember_us;
  return cost_us + kBehavior_us * static_cast<double>(vehicle.behaviors.size());
}

/// Returns how many pairs of vehicles the broker decides about one by one, each in both directions,
/// as far as the start shows it.
double NumLinks(const Mission& mission) {
  const auto num_vehicles = static_cast<double>(mission.vehicles.size());
  const double range_m = mission.comms.comms_range_m;
  if (num_vehicles <= static_cast<double>(mission.comms.each_fate_up_to) || !(range_m > 0)) {
    return range_m == 0 ? 0 : num_vehicles * (num_vehicles - 1);
  }
  ReachGrid grid;
  grid.Reset(range_m);
  const auto start_of = [&](size_t i) {
    return Eigen::Vector3d(mission.vehicles[i].start.x_m, mission.vehicles[i].start.y_m, 0);
  };
  for (size_t i = 0; i < mission.vehicles.size(); ++i)
    grid.Put(static_cast<int32_t>(i), start_of(i));
  double num_links = 0;
  std::vector<int32_t> near;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    near.clear();
    grid.AppendNear(start_of(i), range_m, &near);
    num_links += static_cast<double>(
        std::ranges::count_if(near,
                              [&](int32_t other) {
                                return (start_of(static_cast<size_t>(other)) - start_of(i)).norm() <
                                       range_m;
                              }) -
        1);
  }
  return num_links;
}

constexpr size_t kNowhere = static_cast<size_t>(-1);

/// What a word of --place may have beside vehicles.
constexpr std::string_view kBroker = "shore_broker";

/// Places what one word of --place names: vehicles, the broker. Returns what is wrong with it, if
/// anything.
std::optional<Error> PlaceByHand(const Mission& mission, const std::string& word,
                                 Placement* placement) {
  const auto wrong = [&](const std::string& why) {
    return Error{
        fmt::format("--place {}: {}; write PART=VEHICLE[,VEHICLE...], with a part from 0 to {}",
                    Quoted(word), why, placement->num_parts - 1)};
  };
  const size_t equals = word.find('=');
  if (equals == std::string::npos) return wrong("no '='");
  const std::optional<size_t> number = ReadNumber<size_t>(word.substr(0, equals));
  if (!number) return wrong("the part is not a number");
  const size_t part = *number;
  if (part >= placement->num_parts) return wrong(fmt::format("there is no part {}", part));
  std::string_view rest = std::string_view(word).substr(equals + 1);
  while (true) {
    const size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view name = rest.substr(0, comma);
    const std::vector<const Vehicle*> named = mission.VehiclesNamed(name);
    if (name == kBroker) {
      placement->broker_part = part;
    } else if (named.empty()) {
      return wrong(fmt::format("there is no vehicle {}", Quoted(name)));
    }
    for (const Vehicle* vehicle : named) {
      size_t& place =
          placement->part_of_vehicle[static_cast<size_t>(vehicle - mission.vehicles.data())];
      if (place != kNowhere && place != part) {
        return wrong(fmt::format("{} is placed on {} already", vehicle->name, place));
      }
      place = part;
    }
    if (comma == rest.size()) return std::nullopt;
    rest.remove_prefix(comma + 1);
  }
}

/// Returns the load up to which `loads_us` are to be filled so that they take `more_us` together.
double LevelOf(std::vector<double> loads_us, double more_us) {
  std::sort(loads_us.begin(), loads_us.end());
  double sum_us = more_us;
  double level_us = 0;
  for (size_t i = 0; i < loads_us.size(); ++i) {
    if (i > 0 && loads_us[i] >= level_us) break;
    sum_us += loads_us[i];
    level_us = sum_us / static_cast<double>(i + 1);
  }
  return level_us;
}

/// What there is to do beside the vehicles, in one step.
struct CommonCosts {
  double director_us = 0;
  double broker_us = 0;
};

CommonCosts CommonCostsOf(const Mission& mission) {
  const auto num_vehicles = static_cast<double>(mission.vehicles.size());
  return {.director_us = kDirectorPerVehicle_us * num_vehicles,
          .broker_us = kBrokerPerVehicle_us * num_vehicles + kBrokerPerLink_us * NumLinks(mission)};
}

/// Chooses the part in which the busiest has less to do, unless the user has placed the broker, and
/// returns what each part has to do before any vehicle is placed.
std::vector<double> PlaceWholeBroker(const CommonCosts& common, double vehicles_us,
                                     Placement* placement) {
  const auto with_broker_on = [&](size_t part) {
    std::vector<double> loads_us(placement->num_parts, 0);
    loads_us[0] += common.director_us;
    loads_us[part] += common.broker_us;
    return loads_us;
  };
  if (placement->broker_part == kNowhere) {
    const auto busiest_us = [&](const std::vector<double>& loads_us) {
      return std::max(*std::ranges::max_element(loads_us), LevelOf(loads_us, vehicles_us));
    };
    constexpr double kWorthIt = 0.99;  // What is alike but for rounding stays beside.
    const bool is_better_apart =
        placement->num_parts > 1 &&
        busiest_us(with_broker_on(1)) < kWorthIt * busiest_us(with_broker_on(0));
    placement->broker_part = is_better_apart ? 1 : 0;
  }
  return with_broker_on(placement->broker_part);
}

/// Gives each vehicle its share of the broker: its reports are routed where most vehicles of its
/// block are. Returns what each part has to do before any vehicle is placed.
std::vector<double> ShareBroker(const CommonCosts& common, size_t num_parts,
                                std::vector<double>* costs_us) {
  for (double& cost_us : *costs_us) {
    cost_us += common.broker_us / static_cast<double>(costs_us->size());
  }
  std::vector<double> loads_us(num_parts, 0);
  loads_us[0] = common.director_us;
  return loads_us;
}

/// Gives each block to the part that has most of its vehicles.
void PlaceBlocks(const ReportBlocks& blocks, Placement* placement) {
  std::vector<std::vector<size_t>> counts(blocks.num_blocks(),
                                          std::vector<size_t>(placement->num_parts, 0));
  for (size_t i = 0; i < placement->part_of_vehicle.size(); ++i) {
    ++counts[blocks.BlockOf(static_cast<int32_t>(i))][placement->part_of_vehicle[i]];
  }
  for (const std::vector<size_t>& count : counts) {
    placement->part_of_block.push_back(
        static_cast<size_t>(std::ranges::max_element(count) - count.begin()));
  }
}

}  // namespace

Placement OnePart(const Mission& mission) {
  Placement placement;
  placement.part_of_vehicle.assign(mission.vehicles.size(), 0);
  return placement;
}

Result<Placement> MakePlacement(const Mission& mission, size_t num_parts,
                                std::span<const std::string> by_hand) {
  SHOAL_CHECK(num_parts > 0, "a mission has at least one part");
  Placement placement = {.num_parts = num_parts, .broker_part = kNowhere};
  placement.part_of_vehicle.assign(mission.vehicles.size(), kNowhere);
  for (const std::string& word : by_hand) {
    if (const auto error = PlaceByHand(mission, word, &placement)) return *error;
  }
  std::vector<double> costs_us;
  for (const Vehicle& vehicle : mission.vehicles) costs_us.push_back(CostOf(mission, vehicle));
  const CommonCosts common = CommonCostsOf(mission);
  const ReportBlocks blocks(SetupOf(mission));
  const bool is_shared =
      num_parts > 1 && blocks.num_blocks() > 1 && placement.broker_part == kNowhere;
  if (is_shared) placement.broker_part = 0;
  std::vector<double> loads_us =
      is_shared ? ShareBroker(common, num_parts, &costs_us)
                : PlaceWholeBroker(common, std::accumulate(costs_us.begin(), costs_us.end(), 0.0),
                                   &placement);
  double rest_us = 0;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const size_t part = placement.part_of_vehicle[i];
    (part == kNowhere ? rest_us : loads_us[part]) += costs_us[i];
  }
  const double level_us = LevelOf(loads_us, rest_us);
  // In the mission's order, each vehicle goes to the part in whose room its middle lies.
  size_t part = 0;
  double room_end_us = std::max(0.0, level_us - loads_us[0]);
  double placed_us = 0;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    if (placement.part_of_vehicle[i] != kNowhere) continue;
    while (part + 1 < num_parts && placed_us + costs_us[i] / 2 > room_end_us) {
      room_end_us += std::max(0.0, level_us - loads_us[++part]);
    }
    placement.part_of_vehicle[i] = part;
    placed_us += costs_us[i];
  }
  if (is_shared) PlaceBlocks(blocks, &placement);
  return placement;
}

}  // namespace shoal

#include "lib/run/broker/report_blocks.h"

#include <algorithm>
#include <numeric>

#include "lib/bus/bus/bus.h"

namespace shoal {

namespace {

/// Places of a step: what comes before the reports, the blocks, what comes after them.
constexpr size_t kMaxBlocks = kNumPlaces - 2;

bool IsDirect(const BrokerSetup& setup) {
  return setup.rules.reports_over.is_direct() &&
         std::ranges::none_of(setup.media.of_vehicles,
                              [](const VehicleMedia& media) { return media.gateway.exists; });
}

}  // namespace

ReportBlocks::ReportBlocks(const BrokerSetup& setup) : blocks_(setup.vehicles.size(), 0) {
  const size_t num_vehicles = setup.vehicles.size();
  if (num_vehicles == 0 || !IsDirect(setup)) return;
  const size_t per_block = std::max(kVehiclesPerBlock, num_vehicles / kMaxBlocks + 1);
  num_blocks_ = (num_vehicles - 1) / per_block + 1;
  std::vector<size_t> places(num_vehicles);
  std::iota(places.begin(), places.end(), size_t{0});
  std::ranges::sort(places, {},
                    [&](size_t place) { return std::string_view(setup.vehicles[place]); });
  for (size_t i = 0; i < num_vehicles; ++i) blocks_[places[i]] = i / per_block;
}

}  // namespace shoal

#include "lib/mission/model/vehicle.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace shoal {
namespace {

template <size_t... kPlaces>
std::vector<AnyModel> ModelsAt(std::index_sequence<kPlaces...> /*places*/) {
  return {AnyModel(std::in_place_index<kPlaces>)...};
}

}  // namespace

Vehicle::Vehicle() = default;
Vehicle::~Vehicle() = default;
Vehicle::Vehicle(const Vehicle&) = default;
Vehicle::Vehicle(Vehicle&&) noexcept = default;
Vehicle& Vehicle::operator=(const Vehicle&) = default;
Vehicle& Vehicle::operator=(Vehicle&&) noexcept = default;
bool Vehicle::operator==(const Vehicle&) const = default;

bool Vehicle::HasMedium(std::string_view medium) const {
  return media.names.empty() || std::ranges::find(media.names, medium) != media.names.end();
}

double DraughtOf(const Vehicle& vehicle) {
  const bool is_moored = std::holds_alternative<BuoyParams>(vehicle.model);
  return is_moored || FactsOfModel(vehicle.model).is_underwater ? 0 : vehicle.draught_m;
}

ModelFacts FactsOfModel(const AnyModel& model) {
  return std::visit([](const auto& parameters) { return FactsOf(parameters); }, model);
}

std::vector<AnyModel> EachModel() {
  return ModelsAt(std::make_index_sequence<std::variant_size_v<AnyModel>>());
}

}  // namespace shoal

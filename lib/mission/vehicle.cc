#include "lib/mission/vehicle.h"

#include <cstddef>
#include <utility>

namespace shoal {
namespace {

template <size_t... kPlaces>
std::vector<AnyModel> ModelsAt(std::index_sequence<kPlaces...> /*places*/) {
  return {AnyModel(std::in_place_index<kPlaces>)...};
}

}  // namespace

ModelFacts FactsOfModel(const AnyModel& model) {
  return std::visit([](const auto& parameters) { return FactsOf(parameters); }, model);
}

std::vector<AnyModel> EachModel() {
  return ModelsAt(std::make_index_sequence<std::variant_size_v<AnyModel>>());
}

}  // namespace shoal

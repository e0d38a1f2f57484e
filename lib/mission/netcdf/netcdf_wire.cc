#include "lib/mission/netcdf/netcdf_wire.h"

#include <utility>

namespace shoal {

namespace {

void AddVariable(const NetcdfVariable& variable, NetcdfReplyWriter* writer) {
  writer->AddText(variable.name);
  writer->Add(static_cast<uint8_t>(variable.type));
  writer->Add(static_cast<uint32_t>(variable.dimensions.size()));
  for (const uint32_t dimension : variable.dimensions) writer->Add(dimension);
  writer->Add(static_cast<uint32_t>(variable.attributes.size()));
  for (const NetcdfAttribute& attribute : variable.attributes) {
    writer->AddText(attribute.name);
    writer->AddText(attribute.text);
    writer->Add(static_cast<uint8_t>(attribute.type));
    writer->AddNumbers(attribute.numbers.data(), attribute.numbers.size());
  }
}

/// Returns how many parts follow; nothing where there are too many.
std::optional<uint32_t> TakeCount(NetcdfReply* reply) {
  const auto count = reply->Take<uint32_t>();
  if (!reply->ok() || count > kMaxNetcdfNames) return std::nullopt;
  return count;
}

std::optional<NetcdfType> TakeType(NetcdfReply* reply) {
  const auto type = reply->Take<uint8_t>();
  if (!reply->ok() || type > static_cast<uint8_t>(NetcdfType::kDouble)) return std::nullopt;
  return static_cast<NetcdfType>(type);
}

std::optional<NetcdfVariable> TakeVariable(size_t num_dimensions, NetcdfReply* reply) {
  NetcdfVariable variable{.name = reply->TakeText()};
  const std::optional<NetcdfType> type = TakeType(reply);
  if (!type) return std::nullopt;
  variable.type = *type;
  const auto rank = TakeCount(reply);
  if (!rank) return std::nullopt;
  for (uint32_t i = 0; i < *rank; ++i) {
    variable.dimensions.push_back(reply->Take<uint32_t>());
    if (!reply->ok() || variable.dimensions.back() >= num_dimensions) return std::nullopt;
  }
  const auto num_attributes = TakeCount(reply);
  if (!num_attributes) return std::nullopt;
  for (uint32_t i = 0; i < *num_attributes && reply->ok(); ++i) {
    NetcdfAttribute attribute{.name = reply->TakeText()};
    attribute.text = reply->TakeText();
    const std::optional<NetcdfType> attribute_type = TakeType(reply);
    if (!attribute_type) return std::nullopt;
    attribute.type = *attribute_type;
    attribute.numbers = reply->TakeNumbers();
    variable.attributes.push_back(std::move(attribute));
  }
  return variable;
}

}  // namespace

bool IsCoordinate(const NetcdfHeader& header, const NetcdfVariable& variable) {
  constexpr uint64_t kMaxCoordinates = 100'000;
  return variable.type != NetcdfType::kOther && variable.dimensions.size() == 1 &&
         header.dimensions[variable.dimensions[0]].name == variable.name &&
         header.NumValues(variable) <= kMaxCoordinates;
}

void AddHeader(const NetcdfHeader& header, NetcdfReplyWriter* writer) {
  writer->Add(static_cast<uint32_t>(header.dimensions.size()));
  for (const NetcdfDimension& dimension : header.dimensions) {
    writer->AddText(dimension.name);
    writer->Add(dimension.length);
  }
  writer->Add(static_cast<uint32_t>(header.variables.size()));
  for (const NetcdfVariable& variable : header.variables) AddVariable(variable, writer);
}

std::optional<NetcdfHeader> TakeHeader(NetcdfReply* reply) {
  NetcdfHeader header;
  const auto num_dimensions = TakeCount(reply);
  if (!num_dimensions) return std::nullopt;
  for (uint32_t i = 0; i < *num_dimensions && reply->ok(); ++i) {
    std::string name = reply->TakeText();
    header.dimensions.push_back({.name = std::move(name), .length = reply->Take<uint64_t>()});
  }
  const auto num_variables = TakeCount(reply);
  if (!num_variables) return std::nullopt;
  for (uint32_t i = 0; i < *num_variables; ++i) {
    std::optional<NetcdfVariable> variable = TakeVariable(header.dimensions.size(), reply);
    if (!variable || !reply->ok()) return std::nullopt;
    header.variables.push_back(std::move(*variable));
  }
  return header;
}

}  // namespace shoal

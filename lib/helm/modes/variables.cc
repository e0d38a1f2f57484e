#include "lib/helm/modes/variables.h"

#include <cmath>

namespace shoal {

std::string Variables::WhyNot(std::string_view variable, const VariableValue& value) const {
  if (variable.empty()) return "it has no name";
  const auto* number = std::get_if<double>(&value);
  if (number != nullptr && !std::isfinite(*number)) return "the number is not finite";
  const Entry* entry = Find(variable);
  if (entry == nullptr) {
    return entries_.size() < kMax ? "" : "there are " + std::to_string(kMax) + " variables";
  }
  if (entry->value.index() == value.index()) return {};
  return number == nullptr ? "the variable is a number" : "the variable is text";
}

bool Variables::Set(std::string_view variable, const VariableValue& value, double time_s) {
  if (!WhyNot(variable, value).empty()) return false;
  auto found = entries_.find(variable);
  if (found == entries_.end()) found = entries_.emplace(variable, Entry{value}).first;
  Entry& entry = found->second;
  entry.value = value;
  entry.set_s = time_s;
  ++entry.num_set;
  if (entry.fresh.size() >= kMaxFresh) entry.fresh.erase(entry.fresh.begin());
  entry.fresh.push_back(value);
  return true;
}

const Variables::Entry* Variables::Find(std::string_view variable) const {
  const auto found = entries_.find(variable);
  return found == entries_.end() ? nullptr : &found->second;
}

void Variables::ForgetFresh() {
  for (auto& [name, entry] : entries_) entry.fresh.clear();
}

}  // namespace shoal

#include "lib/modes/variables.h"

#include <cmath>

namespace shoal {

bool Variables::Set(std::string_view variable, const VariableValue& value, double time_s) {
  if (variable.empty()) return false;
  const auto* number = std::get_if<double>(&value);
  if (number != nullptr && !std::isfinite(*number)) return false;
  auto found = entries_.find(variable);
  if (found == entries_.end()) {
    if (entries_.size() >= kMost) return false;
    found = entries_.emplace(variable, Entry{value}).first;
  } else if (found->second.value.index() != value.index()) {
    return false;
  }
  Entry& entry = found->second;
  entry.value = value;
  entry.set_s = time_s;
  ++entry.num_set;
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

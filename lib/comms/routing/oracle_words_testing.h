// For tests: a fate as the oracle (oracle_testing.h) returns it, and the oracle's own reading of
// names.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <ostream>
#include <string>

#include "lib/comms/routing/fate.h"

namespace shoal::oracle {

struct Fate {
  std::string source;
  std::string destination;
  Decision numbers;  ///< Everything but source and destination.

  bool operator==(const Fate&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const Fate& fate) {
  const Decision& d = fate.numbers;
  return out << KindText(d.kind) << " " << d.number << " " << fate.source << " > "
             << fate.destination << ": " << CauseText(d.cause) << OverrideText(d.override_rule)
             << " range " << d.range_m << " < " << d.limit_m << " age " << d.age_s << " < "
             << d.age_limit_s << " wait " << d.wait_s << " loss " << d.loss_pct << " length "
             << d.length_bytes << " <= " << d.length_limit_bytes;
}

inline std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return text;
}

inline bool IsName(const std::string& name) {
  const std::string lower = Lower(name);
  return !name.empty() && name.size() <= 32 && lower != "all" && lower != "unc" &&
         lower != "local" &&
         lower.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

inline bool IsFinite(const Eigen::Vector3d& position_m) {
  return std::isfinite(position_m.x()) && std::isfinite(position_m.y()) &&
         std::isfinite(position_m.z());
}

inline std::string Trimmed(std::string text) {
  while (text.starts_with(' ')) text.erase(0, 1);
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

}  // namespace shoal::oracle

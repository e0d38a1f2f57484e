// Which variables of the shore uFldShoreBroker takes to vehicles.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/moos_file.h"

namespace shoal {

/// Which variable of the shore reaches which vehicle: `bridge = src=UP_$N, alias=UP` of
/// uFldShoreBroker, where $N is the vehicle's number, $V its name.
class MoosBridges {
 public:
  /// Returns false where the line is no such rule.
  bool Add(const MoosLine& line);

  /// Returns "UP_ABE" or "UP_ALL" for what the shore posts; empty where no rule names it.
  std::string Find(std::string_view posted, std::span<const std::string> vehicles) const;

 private:
  struct Bridge {
    std::string source;
    std::string alias;
  };
  std::vector<Bridge> bridges_;
};

}  // namespace shoal

#include "lib/vehicle/guidance/route_rounds.h"

namespace shoal {

bool RouteRounds::Pass(int most_rounds) {
  const bool ends = IsEnd(most_rounds);
  ++num_reached_;
  if (IsLast()) ++num_rounds_;
  if (!ends) index_ = IsLast() ? 0 : index_ + 1;
  return !ends;
}

}  // namespace shoal

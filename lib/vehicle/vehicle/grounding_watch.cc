#include "lib/vehicle/vehicle/grounding_watch.h"

namespace shoal {

bool GroundingWatch::Look(size_t vehicle, double clearance_m) {
  if (clearance_m > kFreed_m) is_aground_[vehicle] = false;
  if (clearance_m > 0 || is_aground_[vehicle]) return false;
  is_aground_[vehicle] = true;
  return true;
}

}  // namespace shoal

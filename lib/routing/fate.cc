#include "lib/routing/fate.h"

namespace shoal {

std::string_view CauseText(Cause cause) {
  switch (cause) {
    case Cause::kDelivered:
      return "delivered";
    case Cause::kInvalid:
      return "invalid";
    case Cause::kTooManyVehicles:
      return "too_many_vehicles";
    case Cause::kStaleReceiver:
      return "stale_receiver";
    case Cause::kOutOfRange:
      return "out_of_range";
  }
  return "unknown";
}

}  // namespace shoal

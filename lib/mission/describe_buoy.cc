// The table [vehicle.buoy].
#include "lib/mission/buoy_model.h"
#include "lib/mission/fields.h"

namespace shoal {

void Describe(Fields& fields, BuoyParams& params) {
  fields.Number("watch_radius_m", params.watch_radius_m, Between(0, 10'000));
}

}  // namespace shoal

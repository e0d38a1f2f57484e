// The table [vehicle.buoy].
#include "lib/mission/model/buoy_model.h"
#include "lib/mission/toml/fields.h"

namespace shoal {

void Describe(Fields& fields, BuoyParams& params) {
  fields.Number("watch_radius_m", params.watch_radius_m, Between(0, 10'000));
}

}  // namespace shoal

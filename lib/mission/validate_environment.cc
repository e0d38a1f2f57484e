// Whether the sea of [environment] can be made.
#include "lib/mission/ocean_of.h"
#include "lib/mission/validate.h"

namespace shoal {

void ValidateEnvironment(const Mission& mission, const TablePlace& file) {
  const TablePlace environment = file.Below("environment");
  if (!file.Has("environment") || !environment.IsSound()) return;
  if (const Result<Ocean> ocean = OceanOf(mission); !ocean.ok()) {
    environment.Refuse("floor", ocean.error());
  }
}

}  // namespace shoal

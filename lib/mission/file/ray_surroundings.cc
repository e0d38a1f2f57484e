#include "lib/mission/file/ray_surroundings.h"

#include "lib/mission/file/ocean_of.h"
#include "lib/mission/file/water_files.h"

namespace shoal {

Result<RaySurroundings> SurroundingsOf(const Mission& mission, const RayChannelOptions& rays) {
  RaySurroundings surroundings;
  if (!rays.arrivals_file.empty()) {
    const auto table = ReadArrivals(PathBeside(mission.file, rays.arrivals_file));
    if (!table.ok()) return Error{table.error()};
    surroundings.arrivals = *table;
  }
  if (rays.follows_floor) {
    const Result<Ocean> ocean = OceanOf(mission);
    if (!ocean.ok()) return Error{ocean.error()};
    if (!ocean->floor) return Error{"the mission has no sea floor"};
    surroundings.floor = ocean->floor;
  }
  return surroundings;
}

std::shared_ptr<RayChannel> MakeRayChannel(const Mission& mission) {
  const AcousticOptions& options = mission.acoustics.options;
  if (!options.rays) return nullptr;
  const Result<RaySurroundings> surroundings = SurroundingsOf(mission, *options.rays);
  if (!surroundings.ok()) return nullptr;
  RayBand band;
  if (options.modem) {
    band = {.hz = 500 * (options.modem->low_khz + options.modem->high_khz),
            .absorption_dbpkm = LinkModel(*options.modem, options.sea).absorption_dbpkm()};
  }
  return std::make_shared<RayChannel>(*options.rays, *surroundings, band);
}

}  // namespace shoal

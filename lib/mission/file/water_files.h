// Reads the files about sound that [acoustics.channel] names.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/acoustics/ray_channel_options.h"
#include "lib/sea/rays/bellhop_arrivals.h"
#include "lib/sea/rays/bellhop_case.h"
#include "lib/sea/rays/sound_profile.h"

namespace shoal {

/// Returns the sound speed profile of a file, by its ending: .csv, a cast (cast_text.h); .nc, a
/// NetCDF file with temperature and salinity, or the speed, along one depth axis; .env, of Bellhop.
/// An error names the file, what is wrong with it, and the remedy.
[[nodiscard]] Result<SoundProfile> ReadProfileFile(const std::string& path);

/// Returns the rows of a packet error table in CSV.
[[nodiscard]] Result<std::vector<PacketErrorPoint>> ReadPacketErrors(const std::string& path);

/// Returns the arrivals of a file .arr.
[[nodiscard]] Result<std::shared_ptr<const ArrivalTable>> ReadArrivals(const std::string& path);

/// Returns the case of a .env and of the files beside it.
[[nodiscard]] Result<BellhopCase> ReadBellhopFile(const std::string& path);

/// Returns the path of a file that a mission file names: it counts from that file's folder.
[[nodiscard]] std::string PathBeside(const std::string& mission_file, const std::string& file);

}  // namespace shoal

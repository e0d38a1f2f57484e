#include "lib/mission/file/data_files.h"

#include <algorithm>
#include <variant>

#include "lib/mission/file/grid_files.h"

namespace shoal {

std::vector<std::string> DataFilesOf(const Mission& mission) {
  std::vector<std::string> files;
  const auto add = [&files](const std::string& file) {
    if (!file.empty() && std::ranges::find(files, file) == files.end()) files.push_back(file);
  };
  for (const std::string& file : GridFilesOf(mission.environment)) add(file);
  for (const Vehicle& vehicle : mission.vehicles) {
    if (const auto* track = std::get_if<TrackOptions>(&vehicle.model)) add(track->file);
  }
  const auto add_sound = [&add](const Acoustics& acoustics) {
    if (!acoustics.options.rays) return;
    add(acoustics.options.rays->profile_file);
    add(acoustics.options.rays->packet_errors_file);
    add(acoustics.options.rays->arrivals_file);
  };
  add_sound(mission.acoustics);
  for (const MediumOptions& medium : mission.media) add_sound(medium.acoustics);
  return files;
}

}  // namespace shoal

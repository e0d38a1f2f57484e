#include "lib/mission/file/track_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/text/letters.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/track/csv_track.h"
#include "lib/mission/track/gpx_track.h"

namespace shoal {

namespace {

constexpr double kMicroseconds = 1e6;

Result<ReplayTrack> ReadTrack(const Mission& mission, const TrackOptions& options,
                              std::vector<std::string>* warnings) {
  if (options.file.empty()) {
    return Error{"model = \"track\" needs a file: write track = {file = \"ferry.csv\"}, or .gpx"};
  }
  const std::filesystem::path path =
      std::filesystem::path(mission.file).parent_path() / options.file;
  const std::string ending = LowerCase(path.extension().string());
  if (ending != ".csv" && ending != ".gpx") {
    return Error{path.string() + ": a track is a table of text, .csv, or GPX, .gpx: convert it"};
  }
  const FileText file = ReadRegularFile(path.string());
  if (!file.problem.empty()) {
    return Error{path.string() + ": " + file.problem +
                 "; a track's path counts from the mission file's folder"};
  }
  const LocalFrame frame({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg});
  const TrackSource source = {.name = path.string(),
                              .frame = &frame,
                              .underwater = options.underwater,
                              .depth_positive = options.depth_positive,
                              .vessel = options.name,
                              .number = options.number};
  return ending == ".gpx" ? ParseGpxTrack(file.text, source, warnings)
                          : ParseCsvTrack(file.text, source, warnings);
}

/// Fills in one vehicle's start, and warns of a track that does not last as long as the mission.
void FillInTrack(Mission& mission, Vehicle& vehicle, const TablePlace& place) {
  const auto* options = std::get_if<TrackOptions>(&vehicle.model);
  if (options == nullptr) return;
  const TablePlace table = place.Below("track");
  const Result<MissionTrack> track = TrackOf(mission, *options);
  if (!track.ok()) return table.Refuse("file", track.error());
  const StartPose written = vehicle.start;
  vehicle.start = StartOf(*track);
  vehicle.return_task.point_m = {vehicle.start.x_m, vehicle.start.y_m};
  if (place.Has("start") && written != vehicle.start) {
    place.Warn("start",
               "start has no effect: the track begins where its file has it; leave it out");
  }
  for (const std::string& warning : track->warnings) table.Warn("file", warning);
  const bool has_one_time = track->track.fixes().size() == 1;  // Which is a warning by now.
  const double first_s =
      static_cast<double>(track->track.first_us() - track->offset_us) / kMicroseconds;
  const double last_s =
      static_cast<double>(track->track.last_us() - track->offset_us) / kMicroseconds;
  if (has_one_time) return;
  if (last_s <= 0 || first_s >= mission.duration_s) {
    table.Warn("file", fmt::format("the track is from {:.1f} to {:.1f} s of the mission, so that "
                                   "{} never moves: see time and delay_s, and start_utime of "
                                   "[mission]",
                                   first_s, last_s, vehicle.name));
  } else if (last_s < mission.duration_s) {
    table.Warn("file", fmt::format("the track ends at {:.1f} s, before the mission at {:g} s: {} "
                                   "lies there from then on",
                                   last_s, mission.duration_s, vehicle.name));
  }
}

}  // namespace

ReplayState MissionTrack::At(double mission_s) const {
  return track.At(offset_us + std::llround(mission_s * kMicroseconds));
}

Result<MissionTrack> TrackOf(const Mission& mission, const TrackOptions& options) {
  std::vector<std::string> warnings;
  Result<ReplayTrack> track = ReadTrack(mission, options, &warnings);
  if (!track.ok()) return Error{track.error()};
  const int64_t start_us =
      options.time == TrackTime::kFirst ? track->first_us() : mission.start_utime;
  const int64_t delay_us = std::llround(options.delay_s * kMicroseconds);
  return MissionTrack{.track = std::move(*track),
                      .offset_us = start_us - delay_us,
                      .warnings = std::move(warnings)};
}

StartPose StartOf(const MissionTrack& track) {
  const ReplayState state = track.At(0);
  return {.x_m = state.position_m.x(),
          .y_m = state.position_m.y(),
          .heading_deg = RadToDeg(state.heading_rad),
          .speed_mps = state.speed_mps,
          .depth_m = std::max(0.0, state.position_m.z())};
}

void FillInTracks(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    FillInTrack(mission, mission.vehicles[i], file.Below("vehicle", i));
  }
}

}  // namespace shoal

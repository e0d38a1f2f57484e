// A recorded track in mission files: model = "track" and its table [vehicle.track].
#pragma once

#include <cstdint>
#include <string>

#include "lib/mission/model/model_facts.h"
#include "lib/mission/track/depth_positive.h"

namespace shoal {

class Fields;

/// What of a track counts as the mission's start.
enum class TrackTime {
  kFirst,     ///< Its first point.
  kAbsolute,  ///< Its times are the mission's: microseconds since 1970, as start_utime.
};

/// `[vehicle.track]`: a vehicle that goes where a file has it.
struct TrackOptions {
  std::string file = {};  ///< CSV or GPX; counts from the mission file's folder.
  TrackTime time = TrackTime::kFirst;
  double delay_s = 0;       ///< All of it comes later by this.
  bool underwater = false;  ///< It dives: depths of the file count.
  DepthPositive depth_positive = DepthPositive::kByForm;
  std::string name = {};  ///< Of the vessel, in a file with several; empty: none is chosen by it.
  int64_t number = 0;     ///< Of the track, in GPX with several, from 1; 0: likewise.

  bool operator==(const TrackOptions&) const = default;
};

constexpr ModelFacts FactsOf(const TrackOptions& model) {
  return {.name = "track", .is_underwater = model.underwater, .passive = "replayed"};
}

/// [vehicle.track].
void Describe(Fields& fields, TrackOptions& options);

}  // namespace shoal

#include "lib/mission/track/track_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "lib/base/time/seconds.h"

namespace shoal {

std::string QuotedWord(std::string_view word) {
  constexpr size_t kMax = 32;
  std::string quoted(word.substr(0, kMax));
  for (char& c : quoted) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + quoted + (word.size() > kMax ? "...'" : "'");
}

std::string TrackBuilder::Add(const ReplayFix& fix) {
  if (fixes_.size() >= kMaxFixes) {
    return fmt::format("more than {} points; leave some out, or divide the track", kMaxFixes);
  }
  if (fix.position_m.head<2>().cwiseAbs().maxCoeff() > kFarthestFix_m) {
    return fmt::format(
        "this point is {:.0f} km from the mission's origin, and a mission reaches {:.0f} km: set "
        "origin in [mission] to a place nearby",
        fix.position_m.head<2>().norm() / 1000, kFarthestFix_m / 1000);
  }
  if (fix.position_m.z() < -100 || fix.position_m.z() > kDeepestFix_m) {
    return fmt::format(
        "a depth of {:g} m is impossible: depths are metres, positive below the "
        "surface, and at most {:g}",
        fix.position_m.z(), kDeepestFix_m);
  }
  if (!fixes_.empty()) {
    const ReplayFix& last = fixes_.back();
    if (fix.time_us <= last.time_us) {
      return fmt::format(
          "the time is not after that of the point before ({} s): sort the points "
          "by time, and leave out those of equal time",
          Seconds(fix.time_us - last.time_us));
    }
    const double speed_mps =
        (fix.position_m - last.position_m).norm() / (Seconds(fix.time_us - last.time_us));
    if (speed_mps > kFastestFix_mps) {
      return fmt::format(
          "from the point before to this one it would go at {:.4g} m/s, and {:g} "
          "is the most: correct the time or the place, or leave the point out",
          speed_mps, kFastestFix_mps);
    }
  }
  fixes_.push_back(fix);
  return "";
}

std::string TrackBuilder::Add(ReplayFix fix, const GeoPoint& place) {
  if (std::abs(place.lat_deg) > 90 || std::abs(place.lon_deg) > 180) {
    return fmt::format(
        "latitude {:g}, longitude {:g} is no place: latitudes are from -90 to 90, "
        "longitudes from -180 to 180 degrees",
        place.lat_deg, place.lon_deg);
  }
  const std::optional<Eigen::Vector2d> position_m = source_.frame->ToLocal(place);
  if (!position_m) {
    return fmt::format(
        "latitude {:g}, longitude {:g} is out of reach of the mission's origin: set "
        "origin in [mission] to a place nearby",
        place.lat_deg, place.lon_deg);
  }
  fix.position_m.head<2>() = *position_m;
  return Add(fix);
}

Result<ReplayTrack> TrackBuilder::Finish(const ReplayColumns& columns) {
  if (fixes_.empty()) {
    return Error{source_.name + ": no point of a track in it; is the file complete?"};
  }
  if (source_.underwater && !columns.depth) {
    return Error{source_.name +
                 ": it has no depths, and underwater = true needs them: add a column depth_m (of "
                 "GPX: ele below 0), or leave underwater out"};
  }
  return ReplayTrack(std::move(fixes_), columns);
}

}  // namespace shoal

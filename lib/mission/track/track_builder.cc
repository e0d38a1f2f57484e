#include "lib/mission/track/track_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"

namespace shoal {

namespace {

/// A vessel that is not seen for longer may have been anywhere.
constexpr int64_t kLongestGap_us = 3600 * kSecond_us;
/// A track that is no higher than this above the surface lies on it, whatever else it does.
constexpr double kSurfaceNoise_m = 0.5;

/// Slower than this over ground, a vessel's heading and speed are those of waves and receivers.
constexpr double kUnderWay_mps = 0.5;
/// Points farther apart in time may leave out a bend of the way.
constexpr double kDense_s = 30;
/// A knot is 0.51 m/s, and a current rarely makes as large a difference.
constexpr double kOtherUnit = 1.6;

std::string SpeedProblem(const ReplayFix& from, const ReplayFix& to) {
  const double speed_mps =
      (to.position_m - from.position_m).norm() / (Seconds(to.time_us - from.time_us));
  if (speed_mps <= kFastestFix_mps) return "";
  return fmt::format(
      "from the point before to this one it would go at {:.4g} m/s, and {:g} "
      "is the most: correct the time or the place, or leave the point out",
      speed_mps, kFastestFix_mps);
}

}  // namespace

std::string QuotedWord(std::string_view word) {
  constexpr size_t kMax = 32;
  std::string quoted(word.substr(0, kMax));
  for (char& c : quoted) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + quoted + (word.size() > kMax ? "...'" : "'");
}

void TrackBuilder::NoteDepth(double z_m, uint64_t line) {
  deepest_m_ = std::max(deepest_m_, z_m);
  if (z_m >= 0) return;
  above_.Note(line);
  if (-z_m <= highest_m_) return;
  highest_m_ = -z_m;
  highest_line_ = line;
}

std::string TrackBuilder::AddToTime(const ReplayFix& fix, uint64_t line) {
  const double apart_m = (fix.position_m - first_of_time_m_).norm();
  if (apart_m > kFarthestOfOneTime_m) {
    return fmt::format(
        "this point has the time of the point before, and is {:.4g} m from it: if both are of one "
        "vessel, correct the time or the place, else leave one vessel in the file",
        apart_m);
  }
  if (fixes_.size() > 1) {
    if (std::string problem = SpeedProblem(fixes_[fixes_.size() - 2], fix); !problem.empty()) {
      return problem;
    }
  }
  equal_times_.Note(line);
  fixes_.back() = fix;
  return "";
}

std::string TrackBuilder::Add(ReplayFix fix, uint64_t line) {
  if (source_.underwater && positive_ == DepthPositive::kUp) fix.position_m.z() *= -1;
  if (fix.position_m.head<2>().cwiseAbs().maxCoeff() > kFarthestFix_m) {
    return fmt::format(
        "this point is {:.0f} km from the mission's origin, and a mission reaches {:.0f} km: set "
        "origin in [mission] to a place nearby",
        fix.position_m.head<2>().norm() / 1000, kFarthestFix_m / 1000);
  }
  if (std::abs(fix.position_m.z()) > kDeepestFix_m) {
    return fmt::format(
        "a depth of {:g} m is impossible: depths are metres, positive below the surface (or above "
        "it, with depth_positive = \"up\"), and at most {:g}",
        fix.position_m.z(), kDeepestFix_m);
  }
  if (!fixes_.empty()) {
    const ReplayFix& last = fixes_.back();
    if (fix.time_us < last.time_us) {
      return fmt::format(
          "the time is not after that of the point before ({} s): sort the points "
          "by time if all are of one vessel, else leave one vessel in the file",
          Seconds(fix.time_us - last.time_us));
    }
    if (fix.time_us == last.time_us) {
      NoteDepth(fix.position_m.z(), line);
      return AddToTime(fix, line);
    }
    if (std::string problem = SpeedProblem(last, fix); !problem.empty()) return problem;
    if (fix.time_us - last.time_us > longest_gap_us_) {
      longest_gap_us_ = fix.time_us - last.time_us;
      longest_gap_line_ = line;
    }
  }
  if (fixes_.size() >= kMaxFixes) {
    return fmt::format("more than {} points; leave some out, or divide the track", kMaxFixes);
  }
  NoteDepth(fix.position_m.z(), line);
  first_of_time_m_ = fix.position_m;
  fixes_.push_back(fix);
  return "";
}

/// Why a place may lie beyond a mission's reach, as a remedy.
std::string TrackBuilder::WhyFar(const GeoPoint& place) const {
  if (place.lat_deg == 0 && place.lon_deg == 0) {
    return "receivers write latitude 0, longitude 0 without a fix: leave the point out";
  }
  if (std::abs(place.lon_deg) <= 90) {
    const std::optional<Eigen::Vector2d> swapped_m =
        source_.frame->ToLocal({.lat_deg = place.lon_deg, .lon_deg = place.lat_deg});
    if (swapped_m && swapped_m->cwiseAbs().maxCoeff() <= kFarthestFix_m) {
      return "with latitude and longitude swapped it would be within: name them the other way "
             "round";
    }
  }
  return "set origin in [mission] to a place nearby";
}

std::string TrackBuilder::Add(ReplayFix fix, GeoPoint place, uint64_t line) {
  if (std::abs(place.lat_deg) > 90 || place.lon_deg < -180 || place.lon_deg > 360) {
    return fmt::format(
        "latitude {:g}, longitude {:g} is not a place: latitudes are from -90 to 90, "
        "longitudes from -180 to 360 degrees{}",
        place.lat_deg, place.lon_deg,
        std::abs(place.lat_deg) > 90 && std::abs(place.lon_deg) <= 90
            ? "; are the two swapped, or in degrees and minutes?"
            : "");
  }
  if (place.lon_deg > 180) place.lon_deg -= 360;
  const std::optional<Eigen::Vector2d> position_m = source_.frame->ToLocal(place);
  if (!position_m) {
    return fmt::format("latitude {:g}, longitude {:g} is out of reach of the mission's origin: {}",
                       place.lat_deg, place.lon_deg, WhyFar(place));
  }
  if (position_m->cwiseAbs().maxCoeff() > kFarthestFix_m) {
    return fmt::format(
        "latitude {:g}, longitude {:g} is {:.0f} km from the mission's origin, and a mission "
        "reaches {:.0f} km: {}",
        place.lat_deg, place.lon_deg, position_m->norm() / 1000, kFarthestFix_m / 1000,
        WhyFar(place));
  }
  if (place.lat_deg == 0 && place.lon_deg == 0) null_places_.Note(line);
  fix.position_m.head<2>() = *position_m;
  return Add(fix, line);
}

/// Why the depths cannot be right; empty: they can.
std::string TrackBuilder::WhyAboveSurface() const {
  const bool is_turned = highest_m_ > kSurfaceNoise_m && highest_m_ > deepest_m_;
  if (!is_turned && highest_m_ <= kHighestFix_m) return "";
  const std::string place = fmt::format("{}:{}: this point is {:g} m above the surface",
                                        source_.name, highest_line_, highest_m_);
  if (is_turned) {
    return fmt::format(
        "{}, and none is more than {:g} m below it: the file counts the other way, so write "
        "depth_positive = \"{}\" beside underwater = true; or leave both out",
        place, deepest_m_, positive_ == DepthPositive::kUp ? "down" : "up");
  }
  return fmt::format(
      "{}, and others are up to {:g} m below it; up to {:g} m counts as noise: correct the depth, "
      "or "
      "leave the point out",
      place, deepest_m_, kHighestFix_m);
}

/// Points that noise has put above the surface lie on it.
void TrackBuilder::TakeSurface(std::vector<std::string>* warnings) {
  if (deepest_m_ <= 0) {
    warnings->push_back(
        fmt::format("{}: no point is below the surface: it never dives", source_.name));
  }
  if (above_.count == 0) return;
  for (ReplayFix& fix : fixes_) fix.position_m.z() = std::max(0.0, fix.position_m.z());
  warnings->push_back(
      fmt::format("{}:{}: {} of its points are above the surface, by up to {:g} m: they count as "
                  "on it",
                  source_.name, above_.line, above_.count, highest_m_));
}

void TrackBuilder::WarnOfRest(std::vector<std::string>* warnings) const {
  if (equal_times_.count > 0) {
    warnings->push_back(fmt::format(
        "{}:{}: {} of its points have the time of the point before: the last of each time counts",
        source_.name, equal_times_.line, equal_times_.count));
  }
  if (null_places_.count > 0) {
    warnings->push_back(fmt::format(
        "{}:{}: {} of its points are at latitude 0, longitude 0, which receivers write without a "
        "fix",
        source_.name, null_places_.line, null_places_.count));
  }
  if (fixes_.size() == 1) {
    warnings->push_back(
        fmt::format("{}: its points have one time in all: it lies still", source_.name));
  } else if (std::ranges::all_of(fixes_, [&](const ReplayFix& fix) {
               return fix.position_m == fixes_.front().position_m;
             })) {
    warnings->push_back(fmt::format("{}: its {} points are all at one place: it never moves",
                                    source_.name, fixes_.size()));
  }
  if (longest_gap_us_ > kLongestGap_us) {
    warnings->push_back(fmt::format(
        "{}:{}: this point is {:.4g} h after the one before: it goes there straight and steadily",
        source_.name, longest_gap_line_, Seconds(longest_gap_us_) / 3600));
  }
}

/// Recorded speeds that are in another unit, or times that are.
void TrackBuilder::WarnOfSpeeds(std::vector<std::string>* warnings) const {
  double recorded_m = 0;
  double way_m = 0;
  double time_s = 0;
  size_t count = 0;
  for (size_t i = 1; i < fixes_.size(); ++i) {
    const ReplayFix& from = fixes_[i - 1];
    const ReplayFix& to = fixes_[i];
    if (!std::isfinite(from.speed_mps) || !std::isfinite(to.speed_mps)) continue;
    const double length_s = Seconds(to.time_us - from.time_us);
    recorded_m += (from.speed_mps + to.speed_mps) / 2 * length_s;
    way_m += (to.position_m - from.position_m).head<2>().norm();
    time_s += length_s;
    ++count;
  }
  if (count == 0 || time_s > kDense_s * static_cast<double>(count)) return;
  if (std::max(recorded_m, way_m) < kUnderWay_mps * time_s) return;
  if (recorded_m <= kOtherUnit * way_m && way_m <= kOtherUnit * recorded_m) return;
  warnings->push_back(
      fmt::format("{}: its speeds are {:.3g} m/s on average, and from point to point it goes at "
                  "{:.3g} m/s: are speeds in m/s, and times in the unit of their column?",
                  source_.name, recorded_m / time_s, way_m / time_s));
}

/// Recorded headings in another unit or from another direction, or zeros in place of unknown ones.
void TrackBuilder::WarnOfHeadings(std::vector<std::string>* warnings) const {
  double along_m = 0;
  double way_m = 0;
  for (size_t i = 1; i < fixes_.size(); ++i) {
    const ReplayFix& from = fixes_[i - 1];
    const Eigen::Vector2d way = (fixes_[i].position_m - from.position_m).head<2>();
    const double length_m = way.norm();
    const double speed_mps = length_m / Seconds(fixes_[i].time_us - from.time_us);
    if (!std::isfinite(from.heading_rad) || speed_mps < kUnderWay_mps) continue;
    along_m += length_m * Cos(from.heading_rad - HeadingOf(way));
    way_m += length_m;
  }
  // 60 degrees on average: no vessel crabs as far all the time.
  if (way_m == 0 || along_m >= way_m / 2) return;
  warnings->push_back(
      fmt::format("{}: its headings and its way from point to point are {:.0f} degrees apart: are "
                  "headings in degrees, true, clockwise from North, and empty where unknown?",
                  source_.name, RadToDeg(Acos(std::max(-1.0, along_m / way_m)))));
}

Result<ReplayTrack> TrackBuilder::Finish(const ReplayColumns& columns,
                                         std::vector<std::string>* warnings) {
  if (fixes_.empty()) {
    return Error{source_.name + ": no point of a track in it; is the file complete?"};
  }
  if (source_.underwater && !columns.depth) {
    return Error{source_.name +
                 ": it has no depths, and underwater = true needs them: add a column depth_m (of "
                 "GPX: ele below 0), or leave underwater out"};
  }
  if (source_.underwater) {
    if (std::string problem = WhyAboveSurface(); !problem.empty()) return Error{problem};
  }
  std::vector<std::string> unread;
  if (warnings == nullptr) warnings = &unread;
  if (source_.underwater) TakeSurface(warnings);
  WarnOfRest(warnings);
  if (columns.speed) WarnOfSpeeds(warnings);
  if (columns.heading) WarnOfHeadings(warnings);
  return ReplayTrack(std::move(fixes_), columns);
}

}  // namespace shoal

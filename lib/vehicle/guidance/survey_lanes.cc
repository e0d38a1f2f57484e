#include "lib/vehicle/guidance/survey_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/dubins.h"

namespace shoal {

namespace {

/// Closer than this is the same place.
constexpr double kSamePlace_m = 1e-6;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Leg EdgeOf(std::span<const Eigen::Vector2d> polygon_m, size_t i) {
  return {.from_m = polygon_m[i], .to_m = polygon_m[(i + 1) % polygon_m.size()]};
}

/// Returns on which side of the line through `leg` a point lies, 0 on it.
int SideOf(const Leg& leg, const Eigen::Vector2d& point_m) {
  const double cross = Cross(leg.to_m - leg.from_m, point_m - leg.from_m);
  return (cross > 0) - (cross < 0);
}

/// @pre the point lies on the line through `leg`
bool IsWithin(const Leg& leg, const Eigen::Vector2d& point_m) {
  return (point_m - leg.from_m).dot(point_m - leg.to_m) <= 0;
}

bool Meet(const Leg& a, const Leg& b) {
  const int a_from = SideOf(b, a.from_m);
  const int a_to = SideOf(b, a.to_m);
  const int b_from = SideOf(a, b.from_m);
  const int b_to = SideOf(a, b.to_m);
  if (a_from * a_to < 0 && b_from * b_to < 0) return true;
  return (a_from == 0 && IsWithin(b, a.from_m)) || (a_to == 0 && IsWithin(b, a.to_m)) ||
         (b_from == 0 && IsWithin(a, b.from_m)) || (b_to == 0 && IsWithin(a, b.to_m));
}

/// A corner in the frame of the lanes: along them, and to starboard of the polygon's first corner.
struct Corner {
  double along_m;
  double across_m;
};

struct Interval {
  double begin_m;
  double end_m;
};

/// The polygon as the lanes see it.
class LaneFrame {
 public:
  explicit LaneFrame(const SurveyArea& area)
      : origin_m_(area.polygon_m.front()), heading_rad_(HeadingOfLanes(area)) {
    for (const Eigen::Vector2d& corner_m : area.polygon_m) {
      const Eigen::Vector2d from_origin_m = corner_m - origin_m_;
      corners_.push_back(
          {.along_m = from_origin_m.dot(along_), .across_m = from_origin_m.dot(across_)});
    }
    const auto [first, last] = std::minmax_element(
        corners_.begin(), corners_.end(),
        [](const Corner& a, const Corner& b) { return a.across_m < b.across_m; });
    first_m_ = first->across_m;
    width_m_ = last->across_m - first_m_;
  }

  double first_m() const { return first_m_; }
  double width_m() const { return width_m_; }

  Leg LegOf(const Interval& interval, double across_m) const {
    const auto place = [&](double along_m) -> Eigen::Vector2d {
      return origin_m_ + along_m * along_ + across_m * across_;
    };
    return {.from_m = place(interval.begin_m), .to_m = place(interval.end_m)};
  }

  /// Returns where the line at `across_m` lies in the polygon; exactly at a corner, where a line
  /// a little to starboard of it does, or with `to_port` a little to port.
  std::vector<Interval> SectionAt(double across_m, bool to_port = false) const {
    std::vector<double> cuts_m;
    for (size_t i = 0; i < corners_.size(); ++i) {
      const Corner& a = corners_[i];
      const Corner& b = corners_[(i + 1) % corners_.size()];
      const bool a_before = to_port ? a.across_m < across_m : a.across_m <= across_m;
      const bool b_before = to_port ? b.across_m < across_m : b.across_m <= across_m;
      if (a_before != b_before) cuts_m.push_back(AlongAt(a, b, across_m));
    }
    std::sort(cuts_m.begin(), cuts_m.end());
    std::vector<Interval> section;
    for (size_t i = 0; i + 1 < cuts_m.size(); i += 2) {
      section.push_back({.begin_m = cuts_m[i], .end_m = cuts_m[i + 1]});
    }
    return section;
  }

  /// Returns what the polygon covers of the lanes' direction between two lines. The strip's pieces
  /// are bounded by parts of edges and of the two lines: together these cover what the pieces do.
  std::vector<Interval> ShadowOf(double begin_m, double end_m) const {
    std::vector<Interval> shadow = SectionAt(begin_m);
    const std::vector<Interval> far_side = SectionAt(end_m, true);
    shadow.insert(shadow.end(), far_side.begin(), far_side.end());
    for (size_t i = 0; i < corners_.size(); ++i) {
      const Corner& a = corners_[i];
      const Corner& b = corners_[(i + 1) % corners_.size()];
      const auto [low, high] = std::minmax(a.across_m, b.across_m);
      // What only touches the strip lies beside it.
      if (high <= begin_m || low >= end_m) continue;
      const double from_m = AlongAt(a, b, std::clamp(a.across_m, begin_m, end_m));
      const double to_m = AlongAt(a, b, std::clamp(b.across_m, begin_m, end_m));
      shadow.push_back({.begin_m = std::min(from_m, to_m), .end_m = std::max(from_m, to_m)});
      // An edge along the lanes has no width to be cut by.
      if (low == high)
        shadow.back() = {std::min(a.along_m, b.along_m), std::max(a.along_m, b.along_m)};
    }
    return Merged(std::move(shadow));
  }

 private:
  static double HeadingOfLanes(const SurveyArea& area) {
    if (area.lane_angle_deg) return DegToRad(*area.lane_angle_deg);
    constexpr double kLonger = 1 + 1e-9;  // Of two equally long edges the first.
    Leg longest = EdgeOf(area.polygon_m, 0);
    for (size_t i = 1; i < area.polygon_m.size(); ++i) {
      const Leg edge = EdgeOf(area.polygon_m, i);
      if (Length(edge) > kLonger * Length(longest)) longest = edge;
    }
    const double course_rad = Course(longest);
    return course_rad >= kPi ? course_rad - kPi : course_rad;
  }

  static double AlongAt(const Corner& a, const Corner& b, double across_m) {
    if (across_m == a.across_m || a.across_m == b.across_m) return a.along_m;
    const double part = (across_m - a.across_m) / (b.across_m - a.across_m);
    return a.along_m + part * (b.along_m - a.along_m);
  }

  static std::vector<Interval> Merged(std::vector<Interval> intervals) {
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.begin_m < b.begin_m; });
    std::vector<Interval> merged;
    for (const Interval& each : intervals) {
      if (merged.empty() || each.begin_m > merged.back().end_m + kSamePlace_m) {
        merged.push_back(each);
      } else {
        merged.back().end_m = std::max(merged.back().end_m, each.end_m);
      }
    }
    return merged;
  }

  Eigen::Vector2d origin_m_;
  double heading_rad_;
  Eigen::Vector2d along_ = UnitVector(heading_rad_);
  Eigen::Vector2d across_ = UnitVector(heading_rad_ + kPi / 2);
  std::vector<Corner> corners_;
  double first_m_ = 0;
  double width_m_ = 0;
};

double CountLanes(const LaneFrame& frame, double spacing_m) {
  constexpr double kRounding = 1e-9;  // A width of exactly n spacings takes n lanes.
  return std::max(1.0, std::ceil(frame.width_m() / spacing_m - kRounding));
}

/// From its first part to its last, what lies between them included: a vehicle passes it all.
double LengthOf(const SurveyLane& lane) {
  return (lane.parts.back().to_m - lane.parts.front().from_m).norm();
}

Leg Reversed(const Leg& leg) { return {.from_m = leg.to_m, .to_m = leg.from_m}; }

/// Returns the parts in the order in which they are passed, longer by the overrun at both ends.
std::vector<Leg> PartsOf(const SurveyLane& lane, bool backward, double overrun_m) {
  std::vector<Leg> parts = lane.parts;
  if (backward) {
    std::reverse(parts.begin(), parts.end());
    for (Leg& part : parts) part = Reversed(part);
  }
  const Eigen::Vector2d farther_m =
      overrun_m * UnitVector(HeadingOf(parts.back().to_m - parts.front().from_m));
  parts.front().from_m -= farther_m;
  parts.back().to_m += farther_m;
  return parts;
}

/// An end of the first or last lane of a share.
struct Way {
  bool from_last = false;  ///< The last lane comes first.
  bool backward = false;   ///< The first lane that is passed is passed backward.
};

Way ChooseWay(std::span<const SurveyLane> lanes, const SurveyRoute& route) {
  constexpr std::array<Way, 4> kWays = {
      {{false, false}, {false, true}, {true, false}, {true, true}}};
  const auto cost = [&](const Way& way) {
    const SurveyLane& lane = way.from_last ? lanes.back() : lanes.front();
    const Eigen::Vector2d entry_m =
        way.backward ? lane.parts.back().to_m : lane.parts.front().from_m;
    switch (route.entry) {
      case SurveyEntry::kNearest:
        return (entry_m - route.start_m).norm();
      case SurveyEntry::kNorthWest:
        return entry_m.x() - entry_m.y();
      case SurveyEntry::kNorthEast:
        return -entry_m.x() - entry_m.y();
      case SurveyEntry::kSouthEast:
        return -entry_m.x() + entry_m.y();
      case SurveyEntry::kSouthWest:
        return entry_m.x() + entry_m.y();
    }
    return 0.0;
  };
  Way best = kWays[0];
  for (const Way& way : kWays) {
    if (cost(way) < cost(best) - kSamePlace_m) best = way;
  }
  return best;
}

void Append(const Eigen::Vector2d& point_m, std::vector<Eigen::Vector2d>* points_m) {
  if (!points_m->empty() && (points_m->back() - point_m).norm() < kSamePlace_m) return;
  points_m->push_back(point_m);
}

}  // namespace

std::string PolygonProblem(std::span<const Eigen::Vector2d> polygon_m) {
  const size_t size = polygon_m.size();
  const auto number = [](size_t i) { return std::to_string(i + 1); };
  if (size < 3) return "a polygon needs three corners or more, like [[0, 0], [200, 0], [200, 100]]";
  for (size_t i = 0; i < size; ++i) {
    if (Length(EdgeOf(polygon_m, i)) >= kSamePlace_m) continue;
    return i + 1 == size ? "the last corner is the first again: leave it out, a polygon is closed"
                         : "corners " + number(i) + " and " + number(i + 1) + " are the same place";
  }
  for (size_t i = 0; i < size; ++i) {
    const Leg edge = EdgeOf(polygon_m, i);
    const Leg next = EdgeOf(polygon_m, (i + 1) % size);
    if (SideOf(edge, next.to_m) == 0 &&
        (edge.to_m - edge.from_m).dot(next.to_m - next.from_m) < 0) {
      return "at corner " + number((i + 1) % size) + " the edge goes back where it came from";
    }
    for (size_t j = i + 2; j < size; ++j) {
      if (i == 0 && j + 1 == size) continue;  // Neighbours.
      if (!Meet(edge, EdgeOf(polygon_m, j))) continue;
      return "the edges after corners " + number(i) + " and " + number(j) +
             " cross or touch: list the corners in the order in which they follow one another";
    }
  }
  if (AreaOf_m2(polygon_m) < kSamePlace_m) return "the polygon has no area";
  return {};
}

double AreaOf_m2(std::span<const Eigen::Vector2d> polygon_m) {
  double twice_m2 = 0;
  for (size_t i = 1; i + 1 < polygon_m.size(); ++i) {
    twice_m2 += Cross(polygon_m[i] - polygon_m[0], polygon_m[i + 1] - polygon_m[0]);
  }
  return std::abs(twice_m2) / 2;
}

bool IsInside(std::span<const Eigen::Vector2d> polygon_m, const Eigen::Vector2d& point_m) {
  bool inside = false;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Leg edge = EdgeOf(polygon_m, i);
    if ((edge.from_m.y() > point_m.y()) == (edge.to_m.y() > point_m.y())) continue;
    const bool rises = edge.to_m.y() > edge.from_m.y();
    if ((SideOf(edge, point_m) > 0) == rises) inside = !inside;
  }
  return inside;
}

double CountLanes(const SurveyArea& area) {
  return CountLanes(LaneFrame(area), area.lane_spacing_m);
}

std::vector<SurveyLane> LanesOver(const SurveyArea& area) {
  if (area.polygon_m.empty()) return {};
  const LaneFrame frame(area);
  const int count = static_cast<int>(CountLanes(frame, area.lane_spacing_m));
  const double spacing_m = frame.width_m() / count;
  std::vector<SurveyLane> lanes;
  lanes.reserve(static_cast<size_t>(count));
  // What a polygon has exactly where two strips meet, such as the bottom of a notch, is of neither.
  const double rim_m = std::min(kSamePlace_m, spacing_m / 1000);
  for (int k = 0; k < count; ++k) {
    const double begin_m = frame.first_m() + k * spacing_m + (k > 0 ? rim_m : 0);
    const double end_m = frame.first_m() + (k + 1) * spacing_m - (k + 1 < count ? rim_m : 0);
    const double across_m = frame.first_m() + (k + 0.5) * spacing_m;
    const std::vector<Interval> intervals = area.lane_ends == LaneEnds::kInside
                                                ? frame.SectionAt(across_m)
                                                : frame.ShadowOf(begin_m, end_m);
    SurveyLane lane;
    for (const Interval& interval : intervals)
      lane.parts.push_back(frame.LegOf(interval, across_m));
    if (!lane.parts.empty()) lanes.push_back(std::move(lane));
  }
  return lanes;
}

std::span<const SurveyLane> ShareOf(std::span<const SurveyLane> lanes, const SurveyShare& share) {
  double total_m = 0;
  for (const SurveyLane& lane : lanes) total_m += LengthOf(lane);
  const auto size = static_cast<int64_t>(lanes.size());
  const auto members = static_cast<int64_t>(share.members);
  // A lane is of the member in whose part of the whole length its middle lies.
  int64_t begin = 0;
  int64_t end = 0;
  int64_t next = 0;
  double before_m = 0;
  for (int64_t i = 0; i <= static_cast<int64_t>(share.place); ++i) {
    begin = end;
    const double limit_m = total_m * static_cast<double>(i + 1) / static_cast<double>(members);
    while (next < size && before_m + LengthOf(lanes[static_cast<size_t>(next)]) / 2 < limit_m) {
      before_m += LengthOf(lanes[static_cast<size_t>(next++)]);
    }
    end = i + 1 == members ? size : std::max(next, begin + 1);
    end = std::max(begin, std::min(end, size - (members - i - 1)));
  }
  return lanes.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin));
}

std::vector<Eigen::Vector2d> PathAlong(std::span<const SurveyLane> lanes,
                                       const SurveyRoute& route) {
  std::vector<Eigen::Vector2d> points_m;
  if (lanes.empty()) return points_m;
  Way way = ChooseWay(lanes, route);
  double heading_rad = 0;
  for (size_t i = 0; i < lanes.size(); ++i, way.backward = !way.backward) {
    const SurveyLane& lane = lanes[way.from_last ? lanes.size() - 1 - i : i];
    const std::vector<Leg> parts = PartsOf(lane, way.backward, route.overrun_m);
    const double next_rad = HeadingOf(parts.back().to_m - parts.front().from_m);
    if (route.turn_radius_m > 0 && !points_m.empty()) {
      const DubinsWay turn = ShortestWay({points_m.back(), heading_rad},
                                         {parts.front().from_m, next_rad}, route.turn_radius_m);
      for (const Eigen::Vector2d& point_m : PointsAlong(turn)) Append(point_m, &points_m);
    }
    for (const Leg& part : parts) {
      Append(part.from_m, &points_m);
      Append(part.to_m, &points_m);
    }
    heading_rad = next_rad;
  }
  return points_m;
}

}  // namespace shoal

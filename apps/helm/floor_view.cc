#include "apps/helm/floor_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/helm/sonar_echoes.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// How far the slope of what has passed below is taken to go on.
constexpr double kLineLength_m = 20;
/// How far ahead a chart is read: enough to climb 30 m at 2 m/s.
constexpr double kChartLength_m = 120;
constexpr double kNear_m = 40;
constexpr double kNearStep_m = 2;
constexpr double kFarStep_m = 4;
/// Echoes farther to the side are not on the way.
constexpr double kHalfWay_m = 5;
/// Slower than this a course over ground means nothing.
constexpr double kLeastSpeed_mps = 0.3;
/// What the highest beam sees is taken to be higher by this: its top is not in the fan.
constexpr double kUnseenHeight_m = 30;
constexpr double kSameBeam_deg = 0.01;
/// What was seen stays for as long as the vehicle takes to come down by it at this slope: near an
/// edge it is out of the fan.
constexpr double kReturnSlope = 0.1;
constexpr double kFastestOverGround_mps = 50;
constexpr double kDeepestFloor_m = 1e5;
constexpr double kLeastSlope = 0.02;

DepthBound Least(const DepthBound& a, const DepthBound& b) {
  return {.now_m = std::min(a.now_m, b.now_m),
          .soon_m = std::min(a.soon_m, b.soon_m),
          .later_m = std::min(a.later_m, b.later_m)};
}

}  // namespace

FloorView::FloorView(const Remus100Options& options, const SonarOptions& sonar,
                     std::optional<SeaFloor> chart)
    : source_(options.floor_from == "chart"   ? Source::kChart
              : options.floor_from == "sonar" ? Source::kSonar
                                              : Source::kAltimeter),
      clearance_m_(options.seabed_clearance_m),
      sonar_step_m_(sonar.max_range_m / sonar.range_steps),
      chart_(std::move(chart)) {}

void FloorView::Forget() {
  line_.Lose();
  held_m_ = std::numeric_limits<double>::infinity();
}

// The top of what a beam sees may be as high as the next beam looks.
void FloorView::OnSonar(const sonar_t& ping) {
  ping_ = ping;
  highest_beams_ = ping;
  ping_.beams.clear();
  highest_beams_.beams.clear();
  for (const sonar_beam_t& beam : ping.beams) {
    sonar_beam_t raised = beam;
    raised.elevation_deg = 91;
    for (const sonar_beam_t& other : ping.beams) {
      if (other.elevation_deg > beam.elevation_deg + kSameBeam_deg) {
        raised.elevation_deg = std::min(raised.elevation_deg, other.elevation_deg);
      }
    }
    if (raised.elevation_deg <= 90) {
      ping_.beams.push_back(raised);
    } else {
      highest_beams_.beams.push_back(beam);
    }
  }
}

DepthBound FloorView::Look(const nav_t& nav, double turn_rad, double dt_s, double climb_mps) {
  const bool has_course = std::isfinite(nav.speed_over_ground_mps) &&
                          std::isfinite(nav.course_over_ground_deg) &&
                          nav.speed_over_ground_mps >= kLeastSpeed_mps;
  const double speed_mps =
      has_course ? std::min(nav.speed_over_ground_mps, kFastestOverGround_mps) : 0;
  const double course_rad = DegToRad(has_course ? nav.course_over_ground_deg : nav.heading_deg);
  const double ground_mps = std::max(speed_mps, kLeastSpeed_mps);
  const Clearance clearance = {.clearance_m = clearance_m_,
                               .max_slope = std::max(kLeastSlope, climb_mps / ground_mps),
                               .speed_mps = speed_mps};
  if (source_ == Source::kChart && chart_) {
    return BoundOver(ChartAhead(nav, course_rad, turn_rad, speed_mps), clearance);
  }
  if (nav.altitude_m >= 0) {
    line_.Update(std::min(nav.z_m + nav.altitude_m, kDeepestFloor_m), dt_s);
  } else {
    line_.Lose();
  }
  const DepthBound below = BoundOver(line_.Ahead(kLineLength_m, speed_mps), clearance);
  if (source_ != Source::kSonar) return below;
  return Least(below, SonarBound(nav, course_rad, dt_s, clearance));
}

// Along the arc on which the vehicle turns, and straight on from its end.
std::vector<FloorPoint> FloorView::ChartAhead(const nav_t& nav, double course_rad, double turn_rad,
                                              double speed_mps) const {
  std::vector<FloorPoint> points;
  Eigen::Vector2d place_m(nav.x_m, nav.y_m);
  const double turned_per_m =
      speed_mps > 0 ? std::abs(DegToRad(nav.yaw_rate_degps)) / speed_mps : 0;
  for (double ahead_m = 0;;) {
    points.push_back({.ahead_m = ahead_m, .z_m = chart_->DepthAt(place_m)});
    if (speed_mps <= 0 || ahead_m >= kChartLength_m) return points;
    const double step_m = ahead_m < kNear_m ? kNearStep_m : kFarStep_m;
    ahead_m += step_m;
    const double turned_rad = std::min(turned_per_m * ahead_m, std::abs(turn_rad));
    place_m += step_m * UnitVector(course_rad + std::copysign(turned_rad, turn_rad));
  }
}

DepthBound FloorView::SonarBound(const nav_t& nav, double course_rad, double dt_s,
                                 const Clearance& clearance) {
  DepthBound seen = BoundOver(EchoesAhead(ping_, nav, course_rad, 0), clearance);
  held_m_ = std::min(held_m_ + kReturnSlope * clearance.speed_mps * dt_s, seen.now_m);
  seen = Least(seen, DepthBound::Level(held_m_));
  return Least(seen,
               BoundOver(EchoesAhead(highest_beams_, nav, course_rad, kUnseenHeight_m), clearance));
}

std::vector<FloorPoint> FloorView::EchoesAhead(const sonar_t& ping, const nav_t& nav,
                                               double course_rad, double higher_m) const {
  const Eigen::Vector2d along = UnitVector(course_rad);
  const Eigen::Vector2d abeam(-along.y(), along.x());
  std::vector<FloorPoint> seen;
  for (const SonarEcho& echo : EchoesOf(ping, nav)) {
    // Where it may be at the nearest, for the range is rounded up.
    const Eigen::Vector3d offset_m = std::max(0.0, echo.range_m - sonar_step_m_) * echo.direction;
    const double ahead_m = along.dot(offset_m.head<2>());
    if (ahead_m <= 0 || std::abs(abeam.dot(offset_m.head<2>())) > kHalfWay_m) continue;
    seen.push_back({.ahead_m = ahead_m, .z_m = nav.z_m + offset_m.z() - higher_m});
  }
  std::sort(seen.begin(), seen.end(),
            [](const FloorPoint& a, const FloorPoint& b) { return a.ahead_m < b.ahead_m; });
  return seen;
}

}  // namespace shoal

#include "lib/helm/behaviors/convoy.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

namespace {

constexpr size_t kMaxMarks = 1000;  // Of a contact that is lost sight of; the oldest is dropped.

}  // namespace

void ConvoyBehavior::Leave(const Eigen::Vector2d& position_m) {
  if (!marks_m_.empty() && (position_m - marks_m_.back()).norm() < options_.mark_spacing) return;
  if (marks_m_.empty()) closest_m_ = -1;
  marks_m_.push_back(position_m);
  if (marks_m_.size() > kMaxMarks) {
    marks_m_.pop_front();
    closest_m_ = -1;
  }
}

void ConvoyBehavior::Reach(const Eigen::Vector2d& own_m) {
  // The last mark stays: the contact itself is beyond it.
  while (marks_m_.size() > 1) {
    const double distance_m = (marks_m_.front() - own_m).norm();
    const bool slipped =
        closest_m_ >= 0 && closest_m_ <= options_.nm_radius && distance_m > closest_m_;
    if (distance_m >= options_.radius && !slipped) {
      closest_m_ = closest_m_ < 0 ? distance_m : std::min(closest_m_, distance_m);
      return;
    }
    marks_m_.pop_front();
    closest_m_ = -1;
  }
}

BehaviorAnswer ConvoyBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  const VesselMotion& own = inputs.own.motion;
  const VesselMotion& theirs = contact->now;
  const RelativeGeometry geometry = GeometryOf(own, theirs);
  Leave(contact->reported.position_m);
  Reach(own.position_m);
  double along_m = (theirs.position_m - marks_m_.back()).norm();
  const Eigen::Vector2d* before_m = &own.position_m;
  for (const Eigen::Vector2d& mark_m : marks_m_) {
    along_m += (mark_m - *before_m).norm();
    before_m = &mark_m;
  }
  const bool is_last = marks_m_.size() == 1;
  const Eigen::Vector2d ahead_m = is_last ? theirs.position_m : marks_m_.front();
  const double top_mps = options_.spd_max < 0 ? inputs.domain->speed_mps.Last() : options_.spd_max;
  const double speed_mps =
      std::clamp(theirs.speed_mps + options_.spd_gain * (along_m - options_.range), 0.0, top_mps);
  answer = PreferBoth(inputs, PeakOverCourse(BearingDeg(own.position_m, ahead_m), 0, 180),
                      TransitSpeed(inputs, InDomain(inputs, speed_mps), 70), 50);
  Post(answer, "CONVOY_RANGE", along_m);
  Post(answer, "CONVOY_MARKS", static_cast<double>(marks_m_.size()));
  DescribeContact(options_.contact, *contact, geometry, "convoy", "", answer);
  answer.view.points_m.assign(marks_m_.begin(), marks_m_.end());
  answer.view.steers_for_m = ahead_m;
  return answer;
}

BehaviorAnswer ConvoyBehavior::Idle(const BehaviorInputs&) {
  marks_m_.clear();
  closest_m_ = -1;
  return {};
}

}  // namespace shoal

// Keys that several kinds of [[vehicle.task]] have in common.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string_view>

#include "lib/mission/file/describe.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

constexpr size_t kMaxTaskPoints = 10'000;
constexpr NumberLimits kTaskPlace = Between(-kFarthest_m, kFarthest_m);

/// Describes `points_frame`. Returns what is to be added to the points of the table: nothing, or
/// the vehicle's start.
Eigen::Vector2d DescribeFrame(Fields& fields, const StartPose& start);

/// Moves `point_m` by `offset_m`, which must not take it out of the world.
void Move(Fields& fields, std::string_view key, Eigen::Vector2d& point_m,
          const Eigen::Vector2d& offset_m);

/// `points` or `path` of a path_follow task, and the keys about how it is flown.
void DescribePath(Fields& fields, PathFollowTask& task, const StartPose& start);

/// `polygon`, whose corners do not yet count from the origin.
void DescribePolygon(Fields& fields, SurveyArea& area);
/// The other keys of an area. One that is refused, here or at its polygon, is left without corners:
/// nothing can be planned over it.
void DescribeLanes(Fields& fields, SurveyArea& area);
void DescribeRoute(Fields& fields, SurveyRoute& route);

void Describe(Fields& fields, CaptureRule& rule);
void DescribeSpeed(Fields& fields, double& speed_mps);

template <class LineFollowing>
void DescribeLineFollowing(Fields& fields, LineFollowing& task) {
  fields.Number("lookahead_m", task.lookahead_m, Above(0, 10'000));
  fields.Number("crab_gain", task.crab_gain, Between(0, 1));
}

}  // namespace shoal

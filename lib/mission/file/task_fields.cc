#include "lib/mission/file/task_fields.h"

#include <array>
#include <string>

namespace shoal {

Eigen::Vector2d DescribeFrame(Fields& fields, const StartPose& start) {
  constexpr std::array<std::string_view, 2> kFrames = {"mission", "start"};
  std::string frame = "mission";
  fields.Word("points_frame", frame, kFrames);
  return frame == "start" ? Eigen::Vector2d(start.x_m, start.y_m) : Eigen::Vector2d(0, 0);
}

void Move(Fields& fields, std::string_view key, Eigen::Vector2d& point_m,
          const Eigen::Vector2d& offset_m) {
  point_m += offset_m;
  if (point_m.cwiseAbs().maxCoeff() <= kFarthest_m) return;
  fields.Refuse(key, "a point of " + std::string(key) +
                         ", counted from the start, is more than 1000 km from the origin");
  point_m.setZero();
}

void Describe(Fields& fields, CaptureRule& rule) {
  fields.Number("capture_radius_m", rule.capture_radius_m, Above(0, 1000));
  fields.Number("slip_radius_m", rule.slip_radius_m, Between(0, 1000));
  fields.Flag("capture_line", rule.capture_line);
}

void DescribeSpeed(Fields& fields, double& speed_mps) {
  fields.Number("speed_mps", speed_mps, Above(0, kFastest_mps));
}

}  // namespace shoal

// No NaN and no infinity leaves lib/vehicle/guidance for any finite input. PathFollower,
// TargetTracker, the tasks of underwater vehicles, paths and predictions have such tests beside
// them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/alos.h"
#include "lib/vehicle/guidance/line_of_sight.h"
#include "lib/vehicle/guidance/path_progress.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::finite_guidance_test {

RC_GTEST_PROP(FiniteGuidance, AlosIsFiniteForAnyErrorAndAnyTime, ()) {
  const AlosParams params{.lookahead_m = DrawBetween(0.1, 1000), .crab_gain = DrawBetween(0, 1)};
  const AlosStep step =
      StepAlos(params, AnyFinite(), AnyFinite(), AnyFinite(), std::abs(AnyFinite()));
  RC_ASSERT(std::isfinite(step.heading_rad) && std::isfinite(step.crab_rad));
  Alos alos(params);
  for (int i = 0; i < 5; ++i) {
    RC_ASSERT(std::abs(alos.Update(AnyFinite(), AnyFinite(), std::abs(AnyFinite()))) <= kPi);
    alos.TurnBy(AnyFinite());
    RC_ASSERT(std::abs(alos.crab_rad()) <= Alos::kMaxCrab_rad);
  }
}

RC_GTEST_PROP(FiniteGuidance, SightsAndTrackErrorsAreFiniteBetweenAnyTwoPlaces, ()) {
  const TargetScene scene = AnyFiniteTargetScene();
  const LineOfSight sight = SightFrom(scene.target, scene.own);
  RC_ASSERT(std::isfinite(sight.range_m) && std::abs(sight.away.norm() - 1) < 1e-9);
  const WaypointPath path{{AnyFiniteVector(), AnyFiniteVector()}};
  const PathEnd end = *rc::gen::element(PathEnd::kGoOn, PathEnd::kReturnToFirst);
  const PathProgress progress{.previous = end == PathEnd::kGoOn ? 1U : 0U,
                              .ended = end == PathEnd::kGoOn};
  const PathLeg leg = CurrentLeg(path, end, progress, scene.own.position_m);
  RC_ASSERT(leg.to_m.allFinite() && std::isfinite(leg.psi_rad) && std::isfinite(leg.length_m));
  const TrackErrors errors = ErrorsOn(leg, scene.own.position_m);
  RC_ASSERT(std::isfinite(errors.x_e_m) && std::isfinite(errors.y_e_m));
}

SurveyTask SurveyAt(const Eigen::Vector2d& corner_m) {
  SurveyTask task;
  task.area.polygon_m = {corner_m, corner_m + Eigen::Vector2d(90, 0),
                         corner_m + Eigen::Vector2d(20, 70)};
  task.route = {.start_m = {0, 0}, .turn_radius_m = 15};
  return task;
}

RC_GTEST_PROP(FiniteGuidance, TasksOfSurfaceCraftAskForFiniteThingsWhereverTheyAre, ()) {
  const Eigen::Vector2d here_m = VectorWithin(1e6).head<2>();
  const TaskRunner::What what = *rc::gen::element<TaskRunner::What>(
      WaypointsTask{.points_m = {here_m, {0, 0}, here_m}}, LoiterTask{.center_m = here_m},
      StationKeepTask{.point_m = here_m, .here = false}, StationKeepTask{},
      ReturnTask{.point_m = here_m}, SurveyAt(here_m));
  Fix fix{.position_m = AnyFiniteVector().head<2>(), .heading_rad = AnyFinite()};
  TaskRunner runner(what, fix);
  for (int i = 0; i < 10; ++i) {
    if (*rc::gen::arbitrary<bool>()) fix.position_m = AnyFiniteVector().head<2>();
    fix.heading_rad = AnyFinite();
    fix.time_s += DrawBetween(0, 10);
    if (i == 5) runner.Rejoin(fix);
    const Guidance guidance = runner.Update(fix);
    RC_ASSERT(std::isfinite(guidance.heading_rad) && std::isfinite(guidance.speed_mps));
    RC_ASSERT(std::isfinite(guidance.distance_m) && std::isfinite(guidance.cross_track_error_m));
    RC_ASSERT(guidance.waypoint_m.allFinite());
  }
}

}  // namespace shoal::finite_guidance_test

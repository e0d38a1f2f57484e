// A mission before it runs, as the viewer's page shows it: its plan, and its vehicles where they
// start. There is one moment, 0 s.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/mission/model/mission.h"
#include "lib/tools/view/scene.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

class PlannedView : public ViewSource {
 public:
  /// `boot` names this start of the viewer.
  PlannedView(const Mission& mission, const std::string& boot);

  std::string SetupJson(bool commands) override;
  BackgroundFolder Backgrounds() override { return BackgroundsOf(mission_); }
  std::string FrameJson(double t_s) override;
  std::string TrailsJson() override;
  std::string LinksJson(double t_s) override;
  Result<std::string> MediumLinksJson(std::string_view medium, double t_s) override;
  std::string FatesJson(const FateQuery& query, double t_s) override;
  std::string EventsJson() override;
  std::string VerdictJson() override;
  Result<std::string> LinkJson(std::string_view from, std::string_view to, double t_s) override;
  Result<std::string> VehicleJson(std::string_view name, double t_s, double window_s) override;

 private:
  const Mission mission_;
  Scene scene_;
  std::string setup_json_;
};

}  // namespace shoal

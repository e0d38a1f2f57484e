// The interface of the viewer's web server to a running or a recorded mission. Answers are
// JSON as docs/extending/viewer_protocol.md has it.
//
// All functions may be called from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/mission/file/background_files.h"

namespace shoal {

/// Which fates are asked for; empty texts: all.
struct FateQuery {
  std::string vehicle;  ///< Source or destination, without regard to case.
  std::string kind;
  std::string cause;
  bool only_blocked = false;
  int64_t after = -1;  ///< Only those with a greater id.
  int limit = 200;
};

class ViewSource {
 public:
  virtual ~ViewSource() = default;

  /// `commands`: the client may send commands.
  virtual std::string SetupJson(bool commands) = 0;
  /// Returns where the files are that the mission names as backgrounds.
  virtual BackgroundFolder Backgrounds() { return {}; }
  // `t_s` is mission time since the start; ignored for a running mission, which has only the
  // current time.
  virtual std::string FrameJson(double t_s) = 0;
  virtual std::string TrailsJson() = 0;
  virtual std::string LinksJson(double t_s) = 0;
  /// The same of one medium; the error names one that the mission does not have.
  virtual Result<std::string> MediumLinksJson(std::string_view medium, double t_s) = 0;
  virtual std::string FatesJson(const FateQuery& query, double t_s) = 0;
  virtual std::string EventsJson() = 0;
  /// What became of the mission's expectations; null while it runs, and where it is not known.
  virtual std::string VerdictJson() = 0;
  /// The error names a vehicle that is not in the mission.
  virtual Result<std::string> LinkJson(std::string_view from, std::string_view to, double t_s) = 0;
  virtual Result<std::string> VehicleJson(std::string_view name, double t_s, double window_s) = 0;
};

}  // namespace shoal

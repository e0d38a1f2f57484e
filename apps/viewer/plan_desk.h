// Edits of the mission file on the page: what the text means, and with --allow-commands a file of
// the edited text beside the mission file, and its run.
//
//   PlanDesk desk(may_write, [] { return PlanFile{"missions/berta.toml"}; });
//   desk.Look(R"({"text": "...", "edit": {"do": "move", ...}})");   // from any thread
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "apps/viewer/web_request.h"

namespace shoal {

class PlanRuns;

/// The mission that is shown.
struct PlanFile {
  std::string file = {};                    ///< Empty: there is none.
  std::vector<std::string> overrides = {};  ///< `--set` of its run.
};

class PlanDesk {
 public:
  /// A text that is longer, and its file, are for an editor. A request has 64 KiB.
  static constexpr size_t kMaxText_bytes = 48'000;

  PlanDesk(bool may_write, std::function<PlanFile()> file);
  /// Ends the missions that it has started.
  ~PlanDesk();
  PlanDesk(const PlanDesk&) = delete;
  PlanDesk& operator=(const PlanDesk&) = delete;

  /// Answers POST /api/plan.
  WebAnswer Look(std::string_view body);
  /// Answers POST /api/plan/write: {"file": "missions/berta_plan1.toml"}.
  WebAnswer Write(std::string_view body);
  /// Answers POST /api/plan/run: the same, and "url" of the viewer of the mission that runs.
  WebAnswer Run(std::string_view body);

 private:
  /// A new file; its path, or the answer that states why there is none.
  std::string WriteNew(std::string_view body, WebAnswer* refusal);

  const bool may_write_;
  const std::function<PlanFile()> file_;
  const std::unique_ptr<PlanRuns> runs_;  ///< Absent where nothing may be written.
};

}  // namespace shoal

// A mission file that is being edited on the map, as the viewer's page has it: /api/plan of
// docs/extending/viewer_protocol.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/plan/plan_edit.h"

namespace shoal {

/// A text that is edited, and what is to be done with it.
struct PlanQuestion {
  std::optional<std::string> text = {};  ///< Absent: that of the file.
  std::optional<PlanEdit> edit = {};
};

/// Reads the body of a request; any bytes are allowed.
[[nodiscard]] Result<PlanQuestion> ParsePlanQuestion(std::string_view body);

/// What the answer states beside the text.
struct PlanFacts {
  std::string file = {};                    ///< As errors name it.
  std::vector<std::string> overrides = {};  ///< `--set` of the run.
  bool may_write = false;
};

/// Returns the answer about a text: its errors and warnings in the words of `shoal check`, its
/// places, and what a map draws of it.
[[nodiscard]] std::string PlanJson(const std::string& text, const PlanFacts& facts);

}  // namespace shoal

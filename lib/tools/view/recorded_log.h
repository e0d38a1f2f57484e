// A log with its mission, and notes for the user about both.
#pragma once

#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_reader.h"
#include "lib/mission/model/mission.h"
#include "lib/tools/view/log_index.h"
#include "lib/tools/view/recorded_survey.h"

namespace shoal {

struct RecordedLog {
  LogReader reader;
  LogSurvey survey;
  Mission mission;             ///< Without a mission file, as the messages show it.
  bool knows_mission = false;  ///< It came from a file.
  std::vector<std::string> notes = {};
};

/// Opens `path`, a log or the folder of a recording, with `mission_file`, or with the mission
/// beside the log where that is empty. Errors state what to try.
[[nodiscard]] Result<RecordedLog> OpenRecordedLog(const std::string& path,
                                                  const std::string& mission_file,
                                                  const std::vector<std::string>& overrides);

/// Appends to `notes` what is wrong with a log that `reader` has read to its end.
void NoteTroubles(const LogReader& reader, const LogSurvey& survey, const LogIndex& index,
                  std::vector<std::string>* notes);

}  // namespace shoal

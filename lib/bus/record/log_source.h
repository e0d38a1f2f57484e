// What all `shoal log` commands share: opening a log, choosing events, reporting damage.
#pragma once

#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_reader.h"

namespace shoal {

/// Opens `path`; on failure writes why to `err` and returns nothing.
std::optional<LogReader> OpenLog(const std::string& path, OnDamage on_damage, std::ostream& err);

/// Returns true, and writes the error, if `out_path` is the log that is read.
[[nodiscard]] bool IsLogItself(const std::string& path, const std::string& out_path,
                               std::ostream& err);

/// Writes the damages that `reader` skipped, or its error. Returns true where it read to the end.
bool ReportDamage(const LogReader& reader, std::ostream& err);

[[nodiscard]] bool IsSelected(const LogSelection& selection, const LogEvent& event);

/// Writes which globs of `choice` match no channel of the log, which has `channels`. Returns false
/// if `choice.only` has globs and none of them matches.
bool ReportUnmatched(const std::string& path, const ChannelChoice& choice,
                     const std::set<std::string, std::less<>>& channels, std::ostream& err);
/// The same for a selection.
bool ReportUnmatched(const LogReader& reader, const LogSelection& selection,
                     const std::set<std::string, std::less<>>& channels, std::ostream& err);

}  // namespace shoal

// `shoal log sqlite`: a log as a database. Exit codes as those of lib/bus/record/log_commands.h.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "lib/bus/record/log_commands.h"

namespace shoal {

struct LogSqliteOptions {
  std::string path;
  std::string out_path;  ///< A file of this name is replaced.
  LogSelection selection = {};
  bool skip_damage = false;
  std::vector<std::string> types = {};
};

/// Writes an SQLite database: for every channel (and further type on it) a table of its name with
/// the columns of LogCsv, but of the user's own fields only those that every message has; tables
/// `channels` (channel, type, table_name, messages, rows) and `mission` (name, text: mission.toml,
/// run.txt and summary.txt where they lie beside the log, and verdict, PASS or FAIL); views `fates`
/// and <CHANNEL>.extra (time_s, name, key, value).
int LogSqlite(const LogSqliteOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal

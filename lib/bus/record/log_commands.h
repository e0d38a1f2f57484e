// What `shoal log info|cat|copy|diff|csv` do. Each reads files, writes text to `out`, warnings and
// errors to `err`, and returns the process's exit code: 0, or kExitEnvironment for a file that
// cannot be read (or is damaged, without skip_damage), kExitUsage for types that are not valid and
// for channels of which the log has none.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/record/index_file.h"

namespace shoal {

/// Chooses events of a log.
struct LogSelection {
  std::vector<std::string> channels = {};       ///< Globs with * ? [a-z]; empty: all.
  std::vector<std::string> without = {};        ///< The same; they win over `channels`.
  std::optional<double> from_s = std::nullopt;  ///< Event time, seconds, included.
  std::optional<double> to_s = std::nullopt;    ///< Event time, seconds, included.
};

/// Returns whether `from_s` is not after `to_s`; prints the error to `err` where it is.
[[nodiscard]] bool IsSelectionSound(const LogSelection& selection, std::ostream& err);

struct LogInfoOptions {
  std::string path;
  std::vector<std::string> types = {};              ///< .lcm files of types that are not shoal's.
  std::function<void(double share)> progress = {};  ///< Called now and then while it reads.
  /// The counts of a log with at least as many bytes are kept beside it (index_file.h), and used.
  uint64_t least_indexed_bytes = kLeastIndexedLog_bytes;
};

/// Prints time span, events, bytes; per channel: type, count, rate in Hz of log time, first and
/// last time; and what is wrong: unknown types, messages that do not decode, damaged parts. Reads
/// what can be read of a damaged log, and returns kExitEnvironment then.
int LogInfo(const LogInfoOptions& options, std::ostream& out, std::ostream& err);

struct LogCatOptions {
  std::string path;
  LogSelection selection = {};
  std::optional<int64_t> limit = std::nullopt;  ///< Lines at most.
  bool skip_damage = false;                     ///< Print what can be read of a damaged log.
  std::vector<std::string> types = {};
};

/// Prints one line per message: `12.300 NAV_ALPHA nav_t x_m=1.5 ...`. The member utime is left out
/// where it equals the event's time.
int LogCat(const LogCatOptions& options, std::ostream& out, std::ostream& err);

struct LogCopyOptions {
  std::string path;
  std::string out_path;  ///< Compressed where it ends in ".zst". A file of this name is replaced.
  LogSelection selection = {};
  bool skip_damage = false;  ///< Copy what can be read of a damaged log.
};

/// Copies the events of a log, as they are, into another: a part of them, or all, compressed or
/// not. They keep their numbers and times. Prints how many.
int LogCopy(const LogCopyOptions& options, std::ostream& out, std::ostream& err);

struct LogDiffOptions {
  std::string path_a;
  std::string path_b;
  std::vector<std::string> types = {};
  std::vector<std::string> without = {};  ///< Globs of channels that are not compared.
};

inline constexpr int kLogsDiffer = 1;

/// Compares times, channels and messages in order (not event numbers, not seals). Prints the first
/// difference with step (index of distinct times, from 0), time, channel, field and both values,
/// and which channels have different numbers of events. Returns 0 for equal logs, else kLogsDiffer.
int LogDiff(const LogDiffOptions& options, std::ostream& out, std::ostream& err);

/// Messages of one type as lines of text, in a form that lib/bus/record does not define.
struct LogLines {
  std::string type;       ///< Such as "node_report_t".
  std::string extension;  ///< Of the files: ".alog".
  std::string header;     ///< The first lines of each file.
  /// Appends the lines of one message, which decodes.
  std::function<void(int64_t event_utime, std::string_view channel,
                     std::span<const uint8_t> message, std::string* out)>
      append;
};

struct LogCsvOptions {
  std::string path;
  std::string out_dir;  ///< Made where it does not exist; files and links in it are replaced.
  LogSelection selection = {};
  bool skip_damage = false;
  std::vector<std::string> types = {};
  std::optional<LogLines> lines = std::nullopt;  ///< Written beside the tables.
};

/// Writes <CHANNEL>.csv for every channel (lib/bus/record/csv_rows.h describes the columns), and
/// <CHANNEL>.<type>.csv for further types on one channel; with `lines`, beside each table of that
/// type a file of the same name with their extension. Names the files in `out`.
int LogCsv(const LogCsvOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal

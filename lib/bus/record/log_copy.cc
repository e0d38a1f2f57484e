#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <system_error>

#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/log_writer.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// A plain log is written whenever as much of it is in memory.
constexpr int64_t kCopyPiece_bytes = 4 << 20;

}  // namespace

int LogCopy(const LogCopyOptions& options, std::ostream& out, std::ostream& err) {
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  if (IsLogItself(reader->path(), options.out_path, err)) return kExitUsage;
  // Beside the copy's place, under a name that ends as it does: what is there stays till the end.
  const fs::path place(options.out_path);
  std::error_code error_code;
  const fs::file_type type = fs::status(place, error_code).type();
  const bool is_file = type == fs::file_type::regular || type == fs::file_type::not_found;
  const fs::path target = fs::is_symlink(place, error_code) ? fs::weakly_canonical(place) : place;
  const fs::path part =
      is_file ? target.parent_path() / (".part-" + target.filename().string()) : place;
  Result<LogWriter> writer = LogWriter::Create(part.string());
  if (!writer.ok()) {
    err << writer.error() << '\n';
    return kExitEnvironment;
  }
  const auto give_up = [&](int code) {
    if (is_file) fs::remove(part, error_code);
    return code;
  };
  std::set<std::string, std::less<>> channels;
  int64_t num_events = 0;
  int64_t flushed_bytes = 0;
  while (const auto event = reader->Next()) {
    ++num_events;
    if (!channels.contains(event->channel)) channels.emplace(event->channel);
    if (!IsSelected(options.selection, *event)) continue;
    writer->AppendAs(*event);
    if (writer->counters().bytes - flushed_bytes < kCopyPiece_bytes) continue;
    flushed_bytes = writer->counters().bytes;
    if (const auto error = writer->Flush()) {
      err << error->message << '\n';
      return give_up(kExitEnvironment);
    }
  }
  if (const auto error = writer->Close()) {
    err << error->message << '\n';
    return give_up(kExitEnvironment);
  }
  const int64_t num_copied = writer->counters().events;
  const bool has_matches = ReportUnmatched(*reader, options.selection, channels, err);
  const bool is_whole = ReportDamage(*reader, err);
  if (!has_matches) return give_up(kExitUsage);
  if (num_copied == 0 && (num_events > 0 || !is_whole)) {
    if (num_events > 0) {
      err << fmt::format(
          "shoal: none of the {} events of {} is chosen by --from, --to, --channels and --without; "
          "`shoal log info` shows times and channels\n",
          num_events, reader->path());
    }
    return give_up(is_whole ? kExitUsage : kExitEnvironment);
  }
  if (is_file) fs::rename(part, target, error_code);
  if (error_code) {
    err << fmt::format("{}: cannot become the copy: {}\n", part.string(), error_code.message());
    return kExitEnvironment;
  }
  out << fmt::format("{}: {} of {} events, {} bytes of the log\n", options.out_path, num_copied,
                     num_events, writer->counters().bytes);
  return is_whole ? kExitOk : kExitEnvironment;
}

}  // namespace shoal

#include <fmt/format.h>

#include <ostream>
#include <set>

#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/log_writer.h"

namespace shoal {

namespace {

/// A plain log is written whenever as much of it is in memory.
constexpr int64_t kCopyPiece_bytes = 4 << 20;

}  // namespace

int LogCopy(const LogCopyOptions& options, std::ostream& out, std::ostream& err) {
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  if (IsLogItself(reader->path(), options.out_path, err)) return kExitUsage;
  Result<LogWriter> writer = LogWriter::Create(options.out_path);
  if (!writer.ok()) {
    err << writer.error() << '\n';
    return kExitEnvironment;
  }
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
      return kExitEnvironment;
    }
  }
  if (const auto error = writer->Close()) {
    err << error->message << '\n';
    return kExitEnvironment;
  }
  out << fmt::format("{}: {} of {} events, {} bytes of the log\n", options.out_path,
                     writer->counters().events, num_events, writer->counters().bytes);
  const bool has_matches = ReportUnmatched(*reader, options.selection, channels, err);
  if (!ReportDamage(*reader, err)) return kExitEnvironment;
  return has_matches ? kExitOk : kExitUsage;
}

}  // namespace shoal

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/log_writer.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// A plain copy is written to the file whenever this much of it is in memory.
constexpr int64_t kCopyPiece_bytes = 4 << 20;

/// A copy is written to `part`, which replaces `target` when it is whole. Both are the same path if
/// `target` cannot be replaced by a file, as a device.
struct CopyPlace {
  fs::path target;
  fs::path part;

  bool is_apart() const { return part != target; }
};

CopyPlace PlaceOf(const std::string& out_path) {
  std::error_code ignored;
  const fs::path place(out_path);
  const fs::file_type type = fs::status(place, ignored).type();
  const bool is_link = fs::is_symlink(place, ignored);
  const bool is_file = type == fs::file_type::regular;
  if (!is_file && (type != fs::file_type::not_found || is_link)) return {place, place};
  const fs::path target = is_link ? fs::canonical(place, ignored) : place;
  // The ending of the name decides whether the copy is compressed. The name has the process's
  // number, since two copies may be made in one folder at a time.
  const std::string_view suffix =
      out_path.ends_with(kCompressedSuffix) ? kCompressedSuffix : ".lcm";
  return {target, target.parent_path() / fmt::format(".part-{}{}", getpid(), suffix)};
}

/// Opens the copy: beside its target, or, where no file can be made there, at the target itself.
Result<LogWriter> BeginCopy(CopyPlace* place) {
  if (!place->is_apart()) return LogWriter::Create(place->part.string());
  std::error_code ignored;
  fs::remove(place->part, ignored);  // What a killed process left, or a link laid out to be hit.
  Result<LogWriter> writer = LogWriter::Create(place->part.string());
  if (!writer.ok()) {
    place->part = place->target;
    return LogWriter::Create(place->part.string());
  }
  if (const fs::file_status there = fs::status(place->target, ignored); fs::exists(there)) {
    fs::permissions(place->part, there.permissions(), ignored);
  }
  return writer;
}

}  // namespace

int LogCopy(const LogCopyOptions& options, std::ostream& out, std::ostream& err) {
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  if (IsLogItself(reader->path(), options.out_path, err)) return kExitUsage;
  CopyPlace place = PlaceOf(options.out_path);
  Result<LogWriter> writer = BeginCopy(&place);
  if (!writer.ok()) {
    err << writer.error() << '\n';
    return kExitEnvironment;
  }
  std::error_code error_code;
  const auto give_up = [&](int code) {
    if (place.is_apart()) fs::remove(place.part, error_code);
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
  if (place.is_apart()) fs::rename(place.part, place.target, error_code);
  if (error_code) {
    err << fmt::format("{}: cannot become the copy: {}\n", place.part.string(),
                       error_code.message());
    return kExitEnvironment;
  }
  out << fmt::format("{}: {} of {} events, {} bytes of the log\n", options.out_path, num_copied,
                     num_events, writer->counters().bytes);
  return is_whole ? kExitOk : kExitEnvironment;
}

}  // namespace shoal

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <utility>

#include "lib/base/schema/text.h"
#include "lib/base/text/letters.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/text_file.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/bus/record/extra_fields.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"

namespace shoal {

namespace {

/// The output for the messages of one type on one channel: a table, and lines if requested.
class ChannelFiles {
 public:
  ChannelFiles(const std::string& stem, CsvLayout layout, const LogLines* lines)
      : layout_(std::move(layout)), table_(stem + ".csv", layout_.header()), line_writer_(lines) {
    if (lines != nullptr) lines_.emplace(stem + lines->extension, lines->header);
  }

  /// Returns the file that cannot be written (errno holds the reason), nullptr where all went well.
  const TextFile* Append(const LogEvent& event, std::span<const uint8_t> message) {
    ++num_messages_;
    const auto row = [&](std::string* out) { layout_.AppendRows(event.utime, message, out); };
    if (!table_.Append(row)) return &table_;
    const auto line = [&](std::string* out) {
      line_writer_->append(event.utime, event.channel, message, out);
    };
    return lines_ && !lines_->Append(line) ? &*lines_ : nullptr;
  }

  /// Likewise.
  const TextFile* Flush() {
    if (!table_.Flush()) return &table_;
    return lines_ && !lines_->Flush() ? &*lines_ : nullptr;
  }

  /// Names the files in `out`.
  void Report(std::ostream& out) const {
    out << fmt::format("{}: {} messages\n", table_.path(), num_messages_);
    if (lines_) out << fmt::format("{}: {} lines\n", lines_->path(), num_messages_);
  }

  const std::string& path() const { return table_.path(); }

 private:
  CsvLayout layout_;
  TextFile table_;
  const LogLines* line_writer_;
  std::optional<TextFile> lines_;
  int64_t num_messages_ = 0;
};

/// The files of a directory, one for each channel and type.
class CsvDirectory {
 public:
  /// `lines` may be nullptr; what it points to must outlive this, as must schema and keys.
  CsvDirectory(std::string path, const Schema& schema, const ExtraKeyTable& extra_keys,
               const LogLines* lines)
      : path_(std::move(path)), schema_(schema), extra_keys_(extra_keys), lines_(lines) {}

  ChannelFiles& FilesOf(std::string_view channel, const StructType& type) {
    auto& files = files_[{std::string(channel), &type}];
    if (!files) {
      const bool has_lines = lines_ != nullptr && DisplayName(type) == lines_->type;
      files = std::make_unique<ChannelFiles>(
          NewStem(channel, type), CsvLayout(schema_, type, extra_keys_.Of(channel, type).keys),
          has_lines ? lines_ : nullptr);
    }
    return *files;
  }

  /// Calls `f(ChannelFiles&)` in order of the files' names until it returns false.
  template <class F>
  bool ForEach(F f) {
    std::map<std::string, ChannelFiles*> by_path;
    for (auto& [key, files] : files_) by_path.emplace(files->path(), files.get());
    for (auto& [path, files] : by_path) {
      if (!f(*files)) return false;
    }
    return true;
  }

 private:
  /// Channel names come from an untrusted file: no path made of one leaves the directory.
  static std::string SafeName(std::string_view channel) {
    constexpr size_t kMaxLength = 100;
    std::string name(channel.substr(0, kMaxLength));
    for (char& c : name) {
      const bool is_safe = IsNameCharacter(c) || c == '-';
      if (!is_safe) c = '_';
    }
    return name;
  }

  std::string NewStem(std::string_view channel, const StructType& type) {
    std::string name = SafeName(channel);
    if (names_.contains(name)) name = fmt::format("{}.{}", name, SafeName(DisplayName(type)));
    const std::string stem = name;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}.{}", stem, i);
    return path_ + "/" + name;
  }

  std::string path_;
  const Schema& schema_;
  const ExtraKeyTable& extra_keys_;
  const LogLines* lines_;
  std::map<std::pair<std::string, const StructType*>, std::unique_ptr<ChannelFiles>> files_;
  std::set<std::string> names_;
};

}  // namespace

int LogCsv(const LogCsvOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  auto event = reader->Next();
  if (!event && (!reader->error().empty() || reader->num_damages() > 0)) {
    return ReportDamage(*reader, err) ? kExitOk : kExitEnvironment;
  }
  std::error_code error;
  std::filesystem::create_directories(options.out_dir, error);
  if (error) {
    err << fmt::format("cannot make {}: {}\n", options.out_dir, error.message());
    return kExitEnvironment;
  }

  // Their columns are in the headers: the log is read twice.
  const ExtraKeyTable extra_keys(*schema, options.selection, reader->Another());
  CsvDirectory directory(options.out_dir, *schema, extra_keys,
                         options.lines ? &*options.lines : nullptr);
  std::map<std::string, int64_t> left_out;
  const auto fail = [&](const TextFile& file) {
    err << fmt::format("cannot write {}: {}\n", file.path(), ErrnoText(errno));
    return kExitEnvironment;
  };
  std::set<std::string, std::less<>> channels;
  Bytes storage;
  for (; event; event = reader->Next()) {
    if (!channels.contains(event->channel)) channels.emplace(event->channel);
    if (!IsSelected(options.selection, *event)) continue;
    const RecognisedMessage message = RecogniseAsList(*schema, event->data, &storage);
    if (!message.IsDecodable()) {
      ++left_out[std::string(event->channel)];
      continue;
    }
    ChannelFiles& files = directory.FilesOf(event->channel, *message.type);
    if (const TextFile* failed = files.Append(*event, message.data)) return fail(*failed);
  }
  const TextFile* failed = nullptr;
  directory.ForEach([&](ChannelFiles& files) {
    failed = files.Flush();
    if (failed == nullptr) files.Report(out);
    return failed == nullptr;
  });
  if (failed != nullptr) return fail(*failed);
  for (const auto& [channel, count] : left_out) {
    std::string shown;
    AppendQuoted(channel, &shown);
    err << fmt::format("{}: {} messages left out: unknown type, or bytes that do not decode\n",
                       shown, count);
  }
  if (!ReportDamage(*reader, err)) return kExitEnvironment;
  return ReportUnmatched(*reader, options.selection, channels, err) ? kExitOk : kExitUsage;
}

}  // namespace shoal

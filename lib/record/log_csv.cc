#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <utility>

#include "lib/record/csv_rows.h"
#include "lib/record/file_descriptor.h"
#include "lib/record/log_commands.h"
#include "lib/record/log_source.h"
#include "lib/record/message_types.h"
#include "lib/schema/text.h"

namespace shoal {

namespace {

/// Gathers text and appends it to a file in large pieces. Open only while it writes: a log may have
/// more channels than a process may have files.
class CsvFile {
 public:
  CsvFile(std::string path, const Schema& schema, const StructType& type)
      : path_(std::move(path)), layout_(schema, type), pending_(layout_.header()) {}

  [[nodiscard]] bool Append(int64_t event_utime, std::span<const uint8_t> message) {
    constexpr size_t kPieceSize = 256 << 10;
    layout_.AppendRows(event_utime, message, &pending_);
    ++num_messages_;
    return pending_.size() < kPieceSize || Flush();
  }

  /// Returns false where the file cannot be written; errno tells why.
  [[nodiscard]] bool Flush() {
    const int mode = std::exchange(is_new_, false) ? O_TRUNC : O_APPEND;
    FileDescriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | mode, 0644));
    if (!file.is_open()) return false;
    size_t written = 0;
    while (written < pending_.size()) {
      const ssize_t result =
          ::write(file.get(), pending_.data() + written, pending_.size() - written);
      if (result < 0 && errno == EINTR) continue;
      if (result < 0) return false;
      written += static_cast<size_t>(result);
    }
    pending_.clear();
    return file.Close();
  }

  const std::string& path() const { return path_; }
  int64_t num_messages() const { return num_messages_; }

 private:
  std::string path_;
  CsvLayout layout_;
  std::string pending_;
  int64_t num_messages_ = 0;
  bool is_new_ = true;
};

/// The files of a directory, one for each channel and type.
class CsvDirectory {
 public:
  CsvDirectory(std::string path, const Schema& schema) : path_(std::move(path)), schema_(schema) {}

  CsvFile& FileOf(std::string_view channel, const StructType& type) {
    auto& file = files_[{std::string(channel), &type}];
    if (!file) file = std::make_unique<CsvFile>(NewPath(channel, type), schema_, type);
    return *file;
  }

  /// Calls `f(CsvFile&)` in order of the files' names until it returns false.
  template <class F>
  bool ForEach(F f) {
    std::map<std::string, CsvFile*> by_path;
    for (auto& [key, file] : files_) by_path.emplace(file->path(), file.get());
    for (auto& [path, file] : by_path) {
      if (!f(*file)) return false;
    }
    return true;
  }

 private:
  /// Channels come from a file that anybody may have made: nothing in them leaves the directory.
  static std::string SafeName(std::string_view channel) {
    constexpr size_t kMaxLength = 100;
    std::string name(channel.substr(0, kMaxLength));
    for (char& c : name) {
      const bool is_safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '_' || c == '-';
      if (!is_safe) c = '_';
    }
    return name;
  }

  std::string NewPath(std::string_view channel, const StructType& type) {
    std::string name = SafeName(channel);
    if (names_.contains(name)) name = fmt::format("{}.{}", name, SafeName(DisplayName(type)));
    const std::string stem = name;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}.{}", stem, i);
    return path_ + "/" + name + ".csv";
  }

  std::string path_;
  const Schema& schema_;
  std::map<std::pair<std::string, const StructType*>, std::unique_ptr<CsvFile>> files_;
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

  CsvDirectory directory(options.out_dir, *schema);
  std::map<std::string, int64_t> left_out;
  const auto fail = [&](const CsvFile& file) {
    err << fmt::format("cannot write {}: {}\n", file.path(), ErrnoText(errno));
    return kExitEnvironment;
  };
  std::set<std::string, std::less<>> channels;
  for (; event; event = reader->Next()) {
    if (!channels.contains(event->channel)) channels.emplace(event->channel);
    if (!IsSelected(options.selection, *event)) continue;
    const RecognisedMessage message = Recognise(*schema, event->data);
    if (!message.IsDecodable()) {
      ++left_out[std::string(event->channel)];
      continue;
    }
    CsvFile& file = directory.FileOf(event->channel, *message.type);
    if (!file.Append(event->utime, message.data)) return fail(file);
  }
  const CsvFile* failed = nullptr;
  directory.ForEach([&](CsvFile& file) {
    if (!file.Flush()) failed = &file;
    if (failed == nullptr)
      out << fmt::format("{}: {} messages\n", file.path(), file.num_messages());
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
  ReportUnmatched(*reader, options.selection, channels, err);
  return kExitOk;
}

}  // namespace shoal

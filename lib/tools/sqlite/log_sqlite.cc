#include "lib/tools/sqlite/log_sqlite.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <utility>

#include "lib/base/schema/text.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/bus/record/extra_fields.h"
#include "lib/bus/record/file_window.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"
#include "lib/bus/record/valid_utf8.h"
#include "lib/tools/sqlite/sqlite_file.h"

namespace shoal {

namespace {

/// Returns the text of a file beside the log; nothing where there is none that can be read whole.
std::optional<std::string> TextBeside(const std::filesystem::path& log, const char* name) {
  constexpr uint64_t kMaxTextSize = 4 << 20;
  Result<FileWindow> file = FileWindow::Open((log.parent_path() / name).string());
  if (!file.ok() || file->size() > kMaxTextSize) return std::nullopt;
  const auto bytes = file->At(0, static_cast<size_t>(file->size()));
  if (!file->error().empty()) return std::nullopt;
  return ValidUtf8({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Returns the last line that is PASS or FAIL, as a summary ends; empty: there is none.
std::string_view VerdictOf(std::string_view summary) {
  std::string_view verdict;
  while (!summary.empty()) {
    const std::string_view line = summary.substr(0, summary.find('\n'));
    if (line == "PASS" || line == "FAIL") verdict = line;
    summary.remove_prefix(std::min(line.size() + 1, summary.size()));
  }
  return verdict;
}

const char* TypeName(CsvValue value) {
  switch (value) {
    case CsvValue::kInteger:
      return "INTEGER";
    case CsvValue::kReal:
      return "REAL";
    case CsvValue::kText:
      break;
  }
  return "TEXT";
}

/// The table of the messages of one type on one channel.
class ChannelTableWriter {
 public:
  static constexpr size_t kMaxColumns = 2000;  ///< SQLite's own limit.

  ChannelTableWriter(SqliteFile* file, std::string name, const CsvLayout& layout)
      : layout_(layout), name_(std::move(name)), insert_(Make(file)) {}

  void Add(int64_t utime, std::span<const uint8_t> message) {
    rows_.clear();
    layout_.AppendRows(utime, message, &rows_);
    std::string_view rest = rows_;
    while (TakeCsvRow(&rest, &cells_)) {
      for (size_t i = 0; i < cells_.size(); ++i) Bind(layout_.columns()[i], cells_[i]);
      insert_.EndRow();
      ++num_rows_;
    }
    ++num_messages_;
  }

  const std::string& name() const { return name_; }
  const std::string& time_column() const { return layout_.columns()[0].name; }
  int64_t num_messages() const { return num_messages_; }
  int64_t num_rows() const { return num_rows_; }

 private:
  SqliteInsert Make(SqliteFile* file) {
    SqliteNames names;
    std::string columns;
    for (const CsvColumn& column : layout_.columns()) {
      // Of this affinity SQLite makes 3.0 of a 3 in a column of reals: 3 / 2 would be 1.
      columns += fmt::format("{}{} {}", columns.empty() ? "" : ", ",
                             SqliteName(names.Take(column.name)), TypeName(column.value));
    }
    file->Execute(fmt::format("CREATE TABLE {} ({})", SqliteName(name_), columns));
    return {file, name_, layout_.columns().size()};
  }

  void Bind(const CsvColumn& column, const std::string& cell) {
    if (column.value == CsvValue::kText) return insert_.Bind(std::string_view(cell));
    if (cell == "true" || cell == "false") return insert_.Bind(int64_t{cell == "true"});
    const char* end = cell.data() + cell.size();
    int64_t whole = 0;
    if (std::from_chars(cell.data(), end, whole).ptr == end && !cell.empty()) {
      return insert_.Bind(whole);
    }
    double number = 0;  // "" (no such row), nan: NULL
    const auto read = std::from_chars(cell.data(), end, number);
    if (cell.empty() || read.ec != std::errc() || read.ptr != end) return insert_.BindNull();
    insert_.Bind(number);
  }

  CsvLayout layout_;
  std::string name_;
  SqliteInsert insert_;
  int64_t num_messages_ = 0;
  int64_t num_rows_ = 0;
  std::string rows_;
  std::vector<std::string> cells_;
};

/// The database of one log.
class LogDatabase {
 public:
  LogDatabase(const Schema& schema, const ExtraKeyTable& extra_keys, SqliteFile* file)
      : schema_(schema), extra_keys_(extra_keys), file_(*file) {
    for (const char* name : {"channels", "mission", "fates"}) names_.Take(name);
  }

  /// Returns false where the message's type cannot be a table.
  bool Add(const LogEvent& event, const RecognisedMessage& message) {
    auto& table = tables_[{std::string(event.channel), message.type}];
    if (!table) table = MakeTable(event.channel, *message.type);
    if (!table) return false;
    table->Add(event.utime, message.data);
    return true;
  }

  void Finish(const std::string& log) {
    WriteChannels();
    WriteMission(log);
    for (const auto& [key, table] : tables_) {
      if (DisplayName(*key.second) == "comms_fates_t") WriteFates(*table);
      if (const Member* extra = ExtraMember(schema_, *key.second))
        WriteExtra(*table, *key.second, *extra);
    }
    tables_.clear();
  }

  size_t num_tables() const { return num_tables_; }

 private:
  std::unique_ptr<ChannelTableWriter> MakeTable(std::string_view channel, const StructType& type) {
    const CsvLayout layout(schema_, type, extra_keys_.Of(channel, type).Common());
    if (layout.columns().size() > ChannelTableWriter::kMaxColumns) return nullptr;
    std::string name = ValidUtf8(channel);
    if (!channels_.insert(std::string(channel)).second) name += "." + DisplayName(type);
    if (name.starts_with("sqlite_")) name.insert(0, "_");  // SQLite keeps these for itself
    ++num_tables_;
    return std::make_unique<ChannelTableWriter>(&file_, names_.Take(name), layout);
  }

  void WriteChannels() {
    file_.Execute("CREATE TABLE channels (channel, type, table_name, messages, rows)");
    SqliteInsert insert(&file_, "channels", 5);
    for (const auto& [key, table] : tables_) {
      insert.Bind(std::string_view(ValidUtf8(key.first)));
      insert.Bind(std::string_view(DisplayName(*key.second)));
      insert.Bind(std::string_view(table->name()));
      insert.Bind(table->num_messages());
      insert.Bind(table->num_rows());
      insert.EndRow();
    }
  }

  void WriteMission(const std::string& log) {
    file_.Execute("CREATE TABLE mission (name, text)");
    SqliteInsert insert(&file_, "mission", 2);
    const auto add = [&](std::string_view name, std::string_view text) {
      insert.Bind(name);
      insert.Bind(text);
      insert.EndRow();
    };
    for (const char* name : {"mission.toml", "run.txt", "summary.txt"}) {
      const auto text = TextBeside(log, name);
      if (!text) continue;
      add(name, *text);
      const std::string_view verdict = VerdictOf(*text);
      if (name == std::string_view("summary.txt") && !verdict.empty()) add("verdict", verdict);
    }
  }

  /// Adds the view `fates`: COMMS_FATES with plain names of columns, `range_m` and `path_snr_db`.
  void WriteFates(const ChannelTableWriter& table) {
    if (has_fates_) return;
    has_fates_ = true;
    const StructType& type = *schema_.FindByName("shoal.fate_t");
    std::string columns = "time_s";
    const auto add = [&](const std::string& column, const std::string& name) {
      columns += fmt::format(", {} AS {}", SqliteName("fates." + column), SqliteName(name));
    };
    for (const Member& member : type.members) {
      if (member.primitive) add(member.name, member.name);
    }
    for (const Member& member : schema_.FindByName("shoal.acoustic_path_t")->members) {
      const std::string column = member.name + (member.name == "sent_utime" ? "_s" : "");
      add("path." + column, "path_" + column);
    }
    file_.Execute(fmt::format("CREATE VIEW fates AS SELECT {} FROM {} WHERE \"index\" IS NOT NULL",
                              columns, SqliteName(table.name())));
  }

  /// Adds the view <table>.extra: the user's own fields, one row for each key of each message.
  void WriteExtra(const ChannelTableWriter& table, const StructType& type, const Member& extra) {
    std::string columns = SqliteName(table.time_column()) + " AS time_s, ";
    const auto has_name = [](const Member& member) { return member.name == "name"; };
    if (std::ranges::any_of(type.members, has_name)) columns += "name, ";
    const std::string key = SqliteName(extra.name + ".key");
    file_.Execute(
        fmt::format("CREATE VIEW {} AS SELECT {}{} AS key, {} AS value FROM {} WHERE {} "
                    "<> ''",
                    SqliteName(names_.Take(table.name() + "." + extra.name)), columns, key,
                    SqliteName(extra.name + ".value"), SqliteName(table.name()), key));
  }

  const Schema& schema_;
  const ExtraKeyTable& extra_keys_;
  SqliteFile& file_;
  SqliteNames names_;
  std::set<std::string> channels_;
  size_t num_tables_ = 0;
  bool has_fates_ = false;
  std::map<std::pair<std::string, const StructType*>, std::unique_ptr<ChannelTableWriter>> tables_;
};

}  // namespace

int LogSqlite(const LogSqliteOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  if (IsLogItself(options.path, options.out_path, err)) return kExitUsage;
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  const ExtraKeyTable extra_keys(*schema, options.selection, reader->Another());
  auto event = reader->Next();
  if (!event && !ReportDamage(*reader, err)) return kExitEnvironment;

  SqliteFile file(options.out_path);
  LogDatabase database(*schema, extra_keys, &file);
  std::map<std::string, int64_t> left_out;
  std::set<std::string, std::less<>> channels;
  Bytes storage;
  for (; event && file.problem().empty(); event = reader->Next()) {
    if (!channels.contains(event->channel)) channels.emplace(event->channel);
    if (!IsSelected(options.selection, *event)) continue;
    const RecognisedMessage message = RecogniseAsList(*schema, event->data, &storage);
    if (!message.IsDecodable() || !database.Add(*event, message)) {
      ++left_out[std::string(event->channel)];
    }
  }
  database.Finish(options.path);
  if (const std::string problem = file.Close(); !problem.empty()) {
    err << fmt::format("cannot write {}: {}\n", options.out_path, problem);
    return kExitEnvironment;
  }
  out << fmt::format("{}: {} tables of channels\n", options.out_path, database.num_tables());
  for (const auto& [channel, count] : left_out) {
    std::string shown;
    AppendQuoted(channel, &shown);
    err << fmt::format(
        "{}: {} messages left out: unknown type, bytes that do not decode, or more "
        "than {} columns\n",
        shown, count, ChannelTableWriter::kMaxColumns);
  }
  if (!ReportDamage(*reader, err)) return kExitEnvironment;
  return ReportUnmatched(*reader, options.selection, channels, err) ? kExitOk : kExitUsage;
}

}  // namespace shoal

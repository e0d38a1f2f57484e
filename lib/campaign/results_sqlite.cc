#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "lib/campaign/reduce.h"

namespace shoal {

namespace {

/// A name of a column or table in quotes.
std::string QuotedName(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    text += c;
    if (c == '"') text += c;
  }
  return text + "\"";
}

/// Names of columns, each once: SQLite knows no case, keys of missions do.
class ColumnNames {
 public:
  void Add(const std::string& name) {
    std::string unique = name;
    for (int i = 2; !taken_.insert(LowerOf(unique)).second; ++i) {
      unique = fmt::format("{}_{}", name, i);
    }
    text_ += (text_.empty() ? "" : ", ") + QuotedName(unique);
    ++size_;
  }
  const std::string& text() const { return text_; }
  size_t size() const { return size_; }

 private:
  static std::string LowerOf(std::string text) {
    for (char& c : text) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
  }

  std::set<std::string> taken_;
  std::string text_;
  size_t size_ = 0;
};

/// One database that is being written; the first error is kept, and nothing is done after it.
class SqliteWriter {
 public:
  explicit SqliteWriter(const std::string& path) {
    sqlite3* database = nullptr;
    Check(sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE,
                          nullptr));
    database_.reset(database);
    // What is written is thrown away where it does not become whole.
    Execute("PRAGMA journal_mode = OFF");
    Execute("PRAGMA synchronous = OFF");
    Execute("BEGIN");
  }

  void Execute(const std::string& sql) {
    if (problem_.empty())
      Check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr));
  }

  void Prepare(const std::string& table, size_t num_columns) {
    std::string marks = "?";
    for (size_t i = 1; i < num_columns; ++i) marks += ", ?";
    sqlite3_stmt* statement = nullptr;
    const std::string sql = fmt::format("INSERT INTO {} VALUES ({})", table, marks);
    if (problem_.empty()) {
      Check(sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr));
    }
    statement_.reset(statement);
    next_ = 1;
  }

  void Bind(std::string_view text) {
    if (!problem_.empty()) return;
    Check(sqlite3_bind_text(statement_.get(), next_++, text.data(), static_cast<int>(text.size()),
                            SQLITE_TRANSIENT));
  }
  void Bind(int64_t number) {
    if (problem_.empty()) Check(sqlite3_bind_int64(statement_.get(), next_++, number));
  }
  /// NaN becomes NULL.
  void Bind(double number) {
    if (problem_.empty()) Check(sqlite3_bind_double(statement_.get(), next_++, number));
  }
  /// A number where the text is one, else the text.
  void BindToml(const std::string& toml) {
    char* end = nullptr;
    const double number = std::strtod(toml.c_str(), &end);
    const bool is_number = !toml.empty() && *end == '\0' && std::isfinite(number);
    if (is_number && toml.find_first_not_of("-0123456789") == std::string::npos) {
      Bind(static_cast<int64_t>(std::strtoll(toml.c_str(), nullptr, 10)));
    } else if (is_number) {
      Bind(number);
    } else if (toml.size() >= 2 && toml.front() == '"' && toml.find('\\') == std::string::npos) {
      Bind(std::string_view(toml).substr(1, toml.size() - 2));
    } else {
      Bind(std::string_view(toml));
    }
  }

  void EndRow() {
    if (!problem_.empty()) return;
    if (sqlite3_step(statement_.get()) != SQLITE_DONE) Check(sqlite3_errcode(database_.get()));
    sqlite3_reset(statement_.get());
    next_ = 1;
  }

  [[nodiscard]] std::string Close() {
    statement_.reset();
    Execute("COMMIT");
    const int code = sqlite3_close(database_.release());
    if (problem_.empty() && code != SQLITE_OK) problem_ = sqlite3_errstr(code);
    return problem_;
  }

 private:
  void Check(int code) {
    if (code != SQLITE_OK && problem_.empty()) problem_ = sqlite3_errstr(code);
  }

  struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  std::string problem_;
  std::unique_ptr<sqlite3, CloseDatabase> database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_ = 1;
};

void WriteCases(const CampaignResults& results, SqliteWriter* writer) {
  ColumnNames columns;
  columns.Add("case");
  columns.Add("policy");
  for (const std::string& key : results.sweep_keys) columns.Add(key);
  writer->Execute(fmt::format("CREATE TABLE cases ({})", columns.text()));
  writer->Prepare("cases", columns.size());
  for (const CampaignCase& each : results.cases) {
    writer->Bind(std::string_view(each.id));
    writer->Bind(std::string_view(each.policy));
    for (const std::string& value : each.values) writer->BindToml(value);
    writer->EndRow();
  }
}

void WriteMetrics(const CampaignResults& results, SqliteWriter* writer) {
  writer->Execute("CREATE TABLE metrics (name, unit, text)");
  writer->Prepare("metrics", 3);
  for (const MetricName& metric : results.metrics) {
    writer->Bind(std::string_view(metric.name));
    writer->Bind(std::string_view(metric.unit));
    writer->Bind(std::string_view(metric.text));
    writer->EndRow();
  }
}

void WriteTrials(const CampaignResults& results, SqliteWriter* writer) {
  ColumnNames columns;
  columns.Add("case");
  for (const std::string& key : results.sweep_keys) columns.Add(key);
  for (const char* name : {"policy", "repetition", "seed"}) columns.Add(name);
  for (const std::string& key : results.sampled_keys) columns.Add(key);
  for (const char* name : {"outcome", "why"}) columns.Add(name);
  for (const MetricName& metric : results.metrics) columns.Add(metric.name);
  writer->Execute(fmt::format("CREATE TABLE trials ({})", columns.text()));
  writer->Prepare("trials", columns.size());
  for (const TrialRow& row : results.rows) {
    const CampaignCase& each = results.cases[row.case_number];
    writer->Bind(std::string_view(each.id));
    for (const std::string& value : each.values) writer->BindToml(value);
    writer->Bind(std::string_view(each.policy));
    writer->Bind(row.repetition);
    writer->Bind(static_cast<int64_t>(row.seed));
    for (const std::string& sample : row.samples) writer->BindToml(sample);
    writer->Bind(kTrialOutcomeNames[static_cast<size_t>(row.result.outcome)]);
    writer->Bind(std::string_view(row.result.why));
    for (const double value : row.result.metrics) writer->Bind(value);
    writer->EndRow();
  }
}

}  // namespace

std::string WriteResultsSqlite(const CampaignResults& results, const std::string& path) {
  const std::string part = PartPath(path);
  std::error_code error;
  std::filesystem::remove(part, error);
  SqliteWriter writer(part);
  WriteCases(results, &writer);
  WriteMetrics(results, &writer);
  WriteTrials(results, &writer);
  std::string problem = writer.Close();
  if (problem.empty()) {
    std::filesystem::rename(part, path, error);
    if (error) problem = error.message();
  }
  if (problem.empty()) return {};
  std::filesystem::remove(part, error);
  return fmt::format("{}: cannot be written: {}", path, problem);
}

}  // namespace shoal

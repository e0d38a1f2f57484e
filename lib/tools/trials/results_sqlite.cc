#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "lib/base/text/numbers.h"
#include "lib/tools/sqlite/sqlite_file.h"
#include "lib/tools/trials/reduce.h"

namespace shoal {

namespace {

/// Names of columns, each once.
class ColumnNames {
 public:
  void Add(const std::string& name) {
    text_ += (text_.empty() ? "" : ", ") + SqliteName(names_.Take(name));
    ++size_;
  }
  const std::string& text() const { return text_; }
  size_t size() const { return size_; }

 private:
  SqliteNames names_;
  std::string text_;
  size_t size_ = 0;
};

/// Makes a table.
SqliteInsert MakeTable(const char* name, const ColumnNames& columns, SqliteFile* file) {
  file->Execute(fmt::format("CREATE TABLE {} ({})", name, columns.text()));
  return {file, name, columns.size()};
}

/// Binds a number where the text is one, else the text.
void BindToml(const std::string& toml, SqliteInsert* insert) {
  const bool is_whole = toml.find_first_not_of("-0123456789") == std::string::npos;
  if (const auto whole = ReadNumber<int64_t>(toml); is_whole && whole) {
    insert->Bind(*whole);
  } else if (const auto number = ReadNumber<double>(toml)) {
    insert->Bind(*number);
  } else if (toml.size() >= 2 && toml.front() == '"' && toml.find('\\') == std::string::npos) {
    insert->Bind(std::string_view(toml).substr(1, toml.size() - 2));
  } else {
    insert->Bind(std::string_view(toml));
  }
}

void WriteCases(const CampaignResults& results, SqliteFile* file) {
  ColumnNames columns;
  columns.Add("case");
  columns.Add("policy");
  for (const std::string& key : results.sweep_keys) columns.Add(key);
  SqliteInsert insert = MakeTable("cases", columns, file);
  for (const CampaignCase& each : results.cases) {
    insert.Bind(std::string_view(each.id));
    insert.Bind(std::string_view(each.policy));
    for (const std::string& value : each.values) BindToml(value, &insert);
    insert.EndRow();
  }
}

void WriteMetrics(const CampaignResults& results, SqliteFile* file) {
  ColumnNames columns;
  for (const char* name : {"name", "unit", "text"}) columns.Add(name);
  SqliteInsert insert = MakeTable("metrics", columns, file);
  for (const MetricName& metric : results.metrics) {
    insert.Bind(std::string_view(metric.name));
    insert.Bind(std::string_view(metric.unit));
    insert.Bind(std::string_view(metric.text));
    insert.EndRow();
  }
}

void WriteTrials(const CampaignResults& results, SqliteFile* file) {
  ColumnNames columns;
  columns.Add("case");
  for (const std::string& key : results.sweep_keys) columns.Add(key);
  for (const char* name : {"policy", "repetition", "seed"}) columns.Add(name);
  for (const std::string& key : results.sampled_keys) columns.Add(key);
  for (const char* name : {"outcome", "why"}) columns.Add(name);
  for (const MetricName& metric : results.metrics) columns.Add(metric.name);
  SqliteInsert insert = MakeTable("trials", columns, file);
  for (const TrialRow& row : results.rows) {
    const CampaignCase& each = results.cases[row.case_number];
    insert.Bind(std::string_view(each.id));
    for (const std::string& value : each.values) BindToml(value, &insert);
    insert.Bind(std::string_view(each.policy));
    insert.Bind(row.repetition);
    insert.Bind(static_cast<int64_t>(row.seed));
    for (const std::string& sample : row.samples) BindToml(sample, &insert);
    insert.Bind(NameOf(row.result.outcome));
    insert.Bind(std::string_view(row.result.why));
    for (const double value : row.result.metrics) insert.Bind(value);
    insert.EndRow();
  }
}

}  // namespace

std::string WriteResultsSqlite(const CampaignResults& results, const std::string& path) {
  SqliteFile file(path);
  WriteCases(results, &file);
  WriteMetrics(results, &file);
  WriteTrials(results, &file);
  const std::string problem = file.Close();
  return problem.empty() ? "" : fmt::format("{}: cannot be written: {}", path, problem);
}

}  // namespace shoal

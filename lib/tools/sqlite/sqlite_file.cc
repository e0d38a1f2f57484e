#include "lib/tools/sqlite/sqlite_file.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>
#include <system_error>

#include "lib/base/text/letters.h"
#include "lib/bus/os/replace_file.h"

namespace shoal {

std::string SqliteName(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '\0') continue;  // it would end the statement
    text += c;
    if (c == '"') text += c;
  }
  return text + "\"";
}

std::string SqliteNames::Take(const std::string& name) {
  std::string unique = name;
  for (int i = 2; !taken_.insert(LowerCase(unique)).second; ++i)
    unique = fmt::format("{}_{}", name, i);
  return unique;
}

void SqliteFile::CloseDatabase::operator()(sqlite3* database) const { sqlite3_close(database); }

void SqliteInsert::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SqliteFile::SqliteFile(std::string path) : path_(std::move(path)), part_(PartPath(path_)) {
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
  sqlite3* database = nullptr;
  Check(sqlite3_open_v2(part_.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE,
                        nullptr));
  database_.reset(database);
  // What is written is thrown away where it does not become whole.
  Execute("PRAGMA journal_mode = OFF");
  Execute("PRAGMA synchronous = OFF");
  Execute("BEGIN");
}

SqliteFile::~SqliteFile() {
  database_.reset();
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

void SqliteFile::Check(int code) {
  if (code == SQLITE_OK || !problem_.empty()) return;
  // "SQL logic error" needs the words of the connection; of a disk that is full there are none.
  problem_ =
      code == SQLITE_ERROR && database_ ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code);
}

void SqliteFile::Execute(const std::string& sql) {
  if (problem_.empty()) {
    Check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr));
  }
}

std::string SqliteFile::Close() {
  Execute("COMMIT");
  const int code = sqlite3_close(database_.release());
  if (problem_.empty() && code != SQLITE_OK) problem_ = sqlite3_errstr(code);
  if (!problem_.empty()) return problem_;
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  if (error) return problem_ = error.message();
  part_.clear();
  return {};
}

SqliteInsert::SqliteInsert(SqliteFile* file, std::string_view table, size_t num_columns)
    : file_(*file) {
  std::string marks = "?";
  for (size_t i = 1; i < num_columns; ++i) marks += ", ?";
  sqlite3_stmt* statement = nullptr;
  const std::string sql = fmt::format("INSERT INTO {} VALUES ({})", SqliteName(table), marks);
  if (file_.problem_.empty()) {
    file_.Check(sqlite3_prepare_v2(file_.database_.get(), sql.c_str(), -1, &statement, nullptr));
  }
  statement_.reset(statement);
}

void SqliteInsert::Bind(std::string_view text) {
  if (!file_.problem_.empty()) return;
  file_.Check(sqlite3_bind_text(statement_.get(), next_++, text.data(),
                                static_cast<int>(text.size()), SQLITE_TRANSIENT));
}

void SqliteInsert::Bind(int64_t number) {
  if (!file_.problem_.empty()) return;
  file_.Check(sqlite3_bind_int64(statement_.get(), next_++, number));
}

void SqliteInsert::Bind(double number) {
  if (!file_.problem_.empty()) return;
  file_.Check(sqlite3_bind_double(statement_.get(), next_++, number));
}

void SqliteInsert::EndRow() {
  next_ = 1;
  if (!file_.problem_.empty()) return;
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_DONE) file_.Check(code);
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

}  // namespace shoal

// Writes an SQLite database: a new file, in one transaction, the same bytes for the same rows.
//
//   SqliteFile file("results.sqlite");
//   file.Execute("CREATE TABLE cases (name, value)");
//   SqliteInsert insert(&file, "cases", 2);
//   insert.Bind("alpha"); insert.Bind(1.5); insert.EndRow();
//   if (const std::string problem = file.Close(); !problem.empty()) Fail(problem);
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace shoal {

/// Returns a name of a column or table in quotes.
[[nodiscard]] std::string SqliteName(std::string_view name);

/// Names of columns or tables, each once: SQLite knows no case, missions and logs do.
class SqliteNames {
 public:
  /// Returns `name`, or it with a number behind it where it was taken, and takes that.
  std::string Take(const std::string& name);

 private:
  std::set<std::string> taken_;  ///< In lower case.
};

/// A database that is being written beside its path; Close() gives it its name. The first error is
/// kept, and nothing is done after it.
class SqliteFile {
 public:
  explicit SqliteFile(std::string path);
  /// Removes what was written where Close() was not called.
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  void Execute(const std::string& sql);

  /// Gives the database its name, in place of a file that has it. Returns what went wrong, or an
  /// empty text.
  /// @pre no SqliteInsert of this file is left.
  [[nodiscard]] std::string Close();

  const std::string& problem() const { return problem_; }
  const std::string& path() const { return path_; }

 private:
  friend class SqliteInsert;
  void Check(int code);

  std::string path_;
  std::string part_;  ///< The path while it is being written; empty: it is no more.
  std::string problem_;
  struct CloseDatabase {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, CloseDatabase> database_;
};

/// Adds rows to one table. Bind() the values of a row from left to right, then EndRow(); columns
/// that were not bound are NULL.
class SqliteInsert {
 public:
  /// @pre the table has `num_columns`, and `file` outlives this.
  SqliteInsert(SqliteFile* file, std::string_view table, size_t num_columns);

  void Bind(std::string_view text);
  void Bind(int64_t number);
  void Bind(double number);  ///< NaN becomes NULL.
  void BindNull() { ++next_; }
  void EndRow();

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };

  SqliteFile& file_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_ = 1;
};

}  // namespace shoal

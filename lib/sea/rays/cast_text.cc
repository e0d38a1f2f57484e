#include "lib/sea/rays/cast_text.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

constexpr size_t kMaxRows = 100'000;

/// A column that is looked for: its name begins with one of these.
struct WantedColumn {
  std::string_view name;
  std::string_view other;
};

using NumberRows = std::vector<std::vector<double>>;

Error At(std::string_view name, int line, const std::string& message) {
  return Error{std::string(name) + ":" + std::to_string(line) + ": " + message};
}

std::string_view TakeLine(std::string_view* text) {
  const size_t end = std::min(text->find('\n'), text->size());
  const std::string_view line = text->substr(0, end);
  text->remove_prefix(std::min(end + 1, text->size()));
  return Trimmed(line.substr(0, line.find('#')));
}

char SeparatorOf(std::string_view line) {
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// Reads a table: its head, then its rows.
class TableText {
 public:
  TableText(std::string_view name, std::string_view text) : name_(name), text_(text) {}

  /// Reads the line with the columns' names.
  std::optional<Error> ReadHead() {
    const std::string_view head = NextLine();
    if (head.empty()) return At(name_, line_, "the file has no line with the columns' names");
    separator_ = SeparatorOf(head);
    for (const std::string_view title : TrimmedParts(head, separator_)) {
      titles_.push_back(LowerCase(title));
    }
    head_line_ = line_;
    return std::nullopt;
  }

  bool Has(const WantedColumn& wanted) const { return Find(wanted).has_value(); }

  /// Reads the rows of these columns.
  Result<NumberRows> Rows(std::span<const WantedColumn> wanted) {
    std::vector<size_t> places;
    for (const WantedColumn& column : wanted) {
      const std::optional<size_t> place = Find(column);
      if (!place) {
        return At(
            name_, head_line_,
            "no column '" + std::string(column.name) + "'; the first line must name the columns");
      }
      places.push_back(*place);
    }
    NumberRows rows;
    for (std::string_view line = NextLine(); !line.empty(); line = NextLine()) {
      const std::vector<std::string_view> cells = TrimmedParts(line, separator_);
      std::vector<double>& row = rows.emplace_back();
      for (size_t i = 0; i < places.size(); ++i) {
        const std::optional<double> number =
            places[i] < cells.size() ? NumberIn(cells[places[i]]) : std::nullopt;
        if (!number) {
          return At(name_, line_,
                    "the column '" + std::string(wanted[i].name) +
                        "' needs a number here; remove rows without data");
        }
        row.push_back(*number);
      }
      lines_.push_back(line_);
      if (rows.size() > kMaxRows) return At(name_, line_, "a table has at most 100000 rows");
    }
    if (rows.empty()) return At(name_, line_, "the table has no rows");
    return rows;
  }

  int LineOf(size_t row) const { return lines_[row]; }
  Error Refuse(const std::string& message) const { return At(name_, head_line_, message); }

 private:
  /// The next line that holds something; empty at the end.
  std::string_view NextLine() {
    while (!text_.empty()) {
      ++line_;
      const std::string_view line = TakeLine(&text_);
      if (!line.empty()) return line;
    }
    return {};
  }

  std::optional<size_t> Find(const WantedColumn& wanted) const {
    for (size_t i = 0; i < titles_.size(); ++i) {
      if (titles_[i].starts_with(wanted.name) || titles_[i].starts_with(wanted.other)) return i;
    }
    return std::nullopt;
  }

  std::string_view name_;
  std::string_view text_;
  char separator_ = ',';
  int line_ = 0;
  int head_line_ = 0;
  std::vector<std::string> titles_;
  std::vector<int> lines_;
};

constexpr WantedColumn kDepth = {"depth", "z_m"};
constexpr WantedColumn kSpeed = {"speed", "sound"};
constexpr WantedColumn kTemperature = {"temperature", "temp"};
constexpr WantedColumn kSalinity = {"salinity", "sal"};

}  // namespace

Result<SoundProfile> ReadCast(std::string_view name, std::string_view text) {
  TableText table(name, text);
  if (const auto error = table.ReadHead()) return *error;
  const bool has_speed = table.Has(kSpeed);
  if (!has_speed && !(table.Has(kTemperature) && table.Has(kSalinity))) {
    return table.Refuse(
        "a cast needs the columns depth and speed, or depth, temperature and salinity");
  }
  const std::vector<WantedColumn> wanted =
      has_speed ? std::vector<WantedColumn>{kDepth, kSpeed}
                : std::vector<WantedColumn>{kDepth, kTemperature, kSalinity};
  const Result<NumberRows> rows = table.Rows(wanted);
  if (!rows.ok()) return Error{rows.error()};
  for (size_t i = 1; i < rows->size(); ++i) {
    if ((*rows)[i][0] > (*rows)[i - 1][0]) continue;
    return At(name, table.LineOf(i),
              "depths must grow from row to row; cut out the way down of the probe, one row for "
              "each depth");
  }
  Result<SoundProfile> profile = Error{""};
  if (has_speed) {
    std::vector<SpeedPoint> points;
    for (const std::vector<double>& row : *rows) points.push_back({row[0], row[1]});
    profile = SoundProfile::Make(std::move(points));
  } else {
    std::vector<CastPoint> cast;
    for (const std::vector<double>& row : *rows) cast.push_back({row[0], row[1], row[2]});
    profile = ProfileOfCast(cast);
  }
  if (!profile.ok()) return Error{std::string(name) + ": " + profile.error()};
  return profile;
}

Result<std::vector<std::pair<double, double>>> ReadErrorTable(std::string_view name,
                                                              std::string_view text) {
  TableText table(name, text);
  if (const auto error = table.ReadHead()) return *error;
  const Result<NumberRows> rows =
      table.Rows(std::vector<WantedColumn>{{"snr", "snr"}, {"loss", "per"}});
  if (!rows.ok()) return Error{rows.error()};
  std::vector<std::pair<double, double>> points;
  for (size_t i = 0; i < rows->size(); ++i) {
    const std::vector<double>& row = (*rows)[i];
    if (i > 0 && !(row[0] > points.back().first)) {
      return At(name, table.LineOf(i), "snr_db must grow from row to row");
    }
    if (!(row[1] >= 0 && row[1] <= 1)) {
      return At(name, table.LineOf(i), "a loss is a probability, between 0 and 1");
    }
    points.emplace_back(row[0], row[1]);
  }
  return points;
}

}  // namespace shoal

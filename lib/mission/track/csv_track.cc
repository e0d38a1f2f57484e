#include "lib/mission/track/csv_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/track/iso_time.h"

namespace shoal {

namespace {

constexpr size_t kMaxColumns = 1000;
/// Microseconds since 1970 until the year 2255, as start_utime of a mission.
constexpr double kLatestTime_us = 9e15;

enum class TimeForm { kMicroseconds, kSeconds, kIsoOrSeconds };

/// A name that a column may have.
struct TimeName {
  std::string_view name;
  TimeForm form;
};
constexpr std::array<TimeName, 8> kTimes = {{{"utime", TimeForm::kMicroseconds},
                                             {"utime_s", TimeForm::kSeconds},
                                             {"time", TimeForm::kIsoOrSeconds},
                                             {"timestamp", TimeForm::kIsoOrSeconds},
                                             {"datetime", TimeForm::kIsoOrSeconds},
                                             {"t_s", TimeForm::kSeconds},
                                             {"time_s", TimeForm::kSeconds},
                                             {"t", TimeForm::kSeconds}}};
using Names = std::span<const std::string_view>;
constexpr std::array<std::string_view, 3> kLatitudes = {"lat_deg", "latitude", "lat"};
constexpr std::array<std::string_view, 4> kLongitudes = {"lon_deg", "longitude", "lon", "lng"};
constexpr std::array<std::string_view, 2> kEasts = {"x_m", "x"};
constexpr std::array<std::string_view, 2> kNorths = {"y_m", "y"};
constexpr std::array<std::string_view, 4> kDepths = {"depth_m", "depth", "z_m", "z"};
constexpr std::array<std::string_view, 3> kHeadings = {"heading_deg", "heading", "hdg"};
constexpr std::array<std::string_view, 3> kSpeeds = {"speed_over_ground_mps", "sog_mps",
                                                     "speed_mps"};

/// Where the columns are, by their place in a line.
struct Columns {
  size_t time = 0;
  TimeForm time_form = TimeForm::kSeconds;
  bool is_geographic = false;
  size_t first = 0;   ///< Latitude, or x.
  size_t second = 0;  ///< Longitude, or y.
  std::optional<size_t> depth;
  std::optional<size_t> heading;
  std::optional<size_t> speed;
};

/// Reads one text. Each step returns what is wrong, empty: nothing.
class CsvTrackReader {
 public:
  CsvTrackReader(std::string_view text, const TrackSource& source)
      : rest_(text), source_(source), builder_(source) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // UTF-8's byte order mark.
  }

  Result<ReplayTrack> Read() {
    std::string problem = ReadHeader();
    while (problem.empty() && NextLine()) problem = ReadFix();
    if (!problem.empty()) {
      return Error{fmt::format("{}:{}: {}", source_.name, line_number_, problem)};
    }
    return builder_.Finish({.depth = columns_.depth && source_.underwater,
                            .heading = columns_.heading.has_value(),
                            .speed = columns_.speed.has_value()});
  }

 private:
  /// Goes to the next line that holds something; false: the text has ended.
  bool NextLine() {
    while (!rest_.empty()) {
      const size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = Trimmed(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_number_;
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }

  std::string ReadHeader() {
    if (!NextLine()) return "the file is empty; its first line names the columns: t_s,x_m,y_m";
    for (const char separator : {',', ';', '\t'}) {
      separator_ = separator;
      if (line_.find(separator) != std::string_view::npos) break;
    }
    if (std::string problem = SplitLine(); !problem.empty()) return problem;
    for (std::string_view cell : cells_) {
      names_.push_back(LowerCase(cell.substr(0, 64)));
    }
    return FindColumns();
  }

  std::optional<size_t> Find(Names names) const {
    for (const std::string_view name : names) {
      const auto found = std::ranges::find(names_, name);
      if (found != names_.end()) return static_cast<size_t>(found - names_.begin());
    }
    return std::nullopt;
  }

  std::string FindColumns() {
    const auto time = std::ranges::find_if(kTimes, [&](const TimeName& each) {
      return Find({&each.name, 1}).has_value();
    });
    if (time == kTimes.end()) {
      return "no column has the time: name one t_s (seconds), utime (microseconds since 1970) or "
             "time (ISO 8601)" +
             ColumnsThatAre();
    }
    columns_.time = *Find({&time->name, 1});
    columns_.time_form = time->form;
    auto first = Find(kLatitudes);
    auto second = Find(kLongitudes);
    columns_.is_geographic = first && second;
    if (!columns_.is_geographic) {
      first = Find(kEasts);
      second = Find(kNorths);
    }
    if (!first || !second) {
      return "no columns have the place: name two lat_deg and lon_deg, or x_m and y_m" +
             ColumnsThatAre();
    }
    columns_.first = *first;
    columns_.second = *second;
    columns_.depth = Find(kDepths);
    columns_.heading = Find(kHeadings);
    columns_.speed = Find(kSpeeds);
    return "";
  }

  /// The header that there is, for messages.
  std::string ColumnsThatAre() const {
    std::string text;
    for (size_t i = 0; i < std::min<size_t>(names_.size(), 8); ++i) {
      text += (i == 0 ? "; there is " : ", ") + QuotedWord(names_[i]);
    }
    return text + (names_.size() > 8 ? ", ..." : "");
  }

  /// Takes one cell off the front of a line; a quote that is not closed makes it end with the line.
  std::string_view TakeCell(std::string_view& line) const {
    size_t from = 0;
    if (line.starts_with('"')) from = std::min(line.find('"', 1), line.size() - 1);
    const size_t end = std::min(line.find(separator_, from), line.size());
    std::string_view cell = Trimmed(line.substr(0, end));
    line.remove_prefix(end);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
      cell = Trimmed(cell.substr(1, cell.size() - 2));
    }
    return cell;
  }

  std::string SplitLine() {
    cells_.clear();
    std::string_view line = line_;
    while (true) {
      cells_.push_back(TakeCell(line));
      if (line.empty()) return "";
      line.remove_prefix(1);
      if (cells_.size() == kMaxColumns) {
        return fmt::format("more than {} columns; is this a table of text?", kMaxColumns);
      }
    }
  }

  std::string ReadFix() {
    if (std::string problem = SplitLine(); !problem.empty()) return problem;
    if (cells_.size() < names_.size()) {
      return fmt::format(
          "this line has {} cells, and the header names {} columns; is the file "
          "complete?",
          cells_.size(), names_.size());
    }
    ReplayFix fix;
    GeoPoint place;
    if (std::string problem = ReadTime(&fix.time_us); !problem.empty()) return problem;
    double* first = columns_.is_geographic ? &place.lat_deg : &fix.position_m.x();
    double* second = columns_.is_geographic ? &place.lon_deg : &fix.position_m.y();
    std::string problem = ReadNumber(columns_.first, first);
    if (problem.empty()) problem = ReadNumber(columns_.second, second);
    if (problem.empty() && columns_.depth && source_.underwater) {
      problem = ReadNumber(*columns_.depth, &fix.position_m.z());
    }
    if (problem.empty() && columns_.heading) problem = ReadHeading(&fix.heading_rad);
    if (problem.empty() && columns_.speed) problem = ReadSpeed(&fix.speed_mps);
    if (!problem.empty()) return problem;
    return columns_.is_geographic ? builder_.Add(fix, place) : builder_.Add(fix);
  }

  std::string ReadNumber(size_t column, double* number) const {
    const std::optional<double> read = NumberIn(cells_[column]);
    if (!read) {
      return fmt::format("{} is {}, and must be a finite number; leave out lines without one",
                         names_[column], QuotedWord(cells_[column]));
    }
    *number = *read;
    return "";
  }

  std::string ReadHeading(double* heading_rad) const {
    double heading_deg = 0;
    std::string problem = ReadNumber(*columns_.heading, &heading_deg);
    if (problem.empty() && std::abs(heading_deg) > 360) {
      problem = fmt::format("{} is {:g}, and must be from -360 to 360 degrees",
                            names_[*columns_.heading], heading_deg);
    }
    *heading_rad = DegToRad(heading_deg);
    return problem;
  }

  std::string ReadSpeed(double* speed_mps) const {
    std::string problem = ReadNumber(*columns_.speed, speed_mps);
    if (problem.empty() && (*speed_mps < 0 || *speed_mps > kFastestFix_mps)) {
      problem = fmt::format("{} is {:g}, and must be from 0 to {:g} m/s", names_[*columns_.speed],
                            *speed_mps, kFastestFix_mps);
    }
    return problem;
  }

  std::string ReadTime(int64_t* time_us) const {
    const std::string_view cell = cells_[columns_.time];
    if (columns_.time_form == TimeForm::kIsoOrSeconds) {
      if (const auto time = ParseLoggedTime(cell)) {
        *time_us = *time;
        return "";
      }
    }
    const std::optional<double> number = NumberIn(cell);
    const double unit = columns_.time_form == TimeForm::kMicroseconds ? 1 : 1e6;
    if (!number || std::abs(*number * unit) > kLatestTime_us) {
      constexpr EnumTable<TimeForm, std::string_view> kForms = {
          "microseconds since 1970", "seconds", "seconds, or ISO 8601: 2026-11-23T09:30:00Z"};
      return fmt::format("{} is {}, and must be a time: {}", names_[columns_.time],
                         QuotedWord(cell), kForms[columns_.time_form]);
    }
    *time_us = std::llround(*number * unit);
    return "";
  }

  std::string_view rest_;
  const TrackSource& source_;
  TrackBuilder builder_;
  std::string_view line_;
  int64_t line_number_ = 0;
  char separator_ = ',';
  std::vector<std::string> names_;       ///< Of the columns, in lower case.
  std::vector<std::string_view> cells_;  ///< Of the line.
  Columns columns_;
};

}  // namespace

Result<ReplayTrack> ParseCsvTrack(std::string_view text, const TrackSource& source) {
  return CsvTrackReader(text, source).Read();
}

}  // namespace shoal

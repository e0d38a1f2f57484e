#include "lib/mission/track/csv_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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
/// Columns that name the vessel of a line.
constexpr std::array<std::string_view, 11> kVessels = {
    "mmsi",      "imo",    "callsign", "vessel_name", "vesselname", "shipname",
    "vessel_id", "vessel", "ship",     "boat",        "vehicle"};
/// What a file has in the place of a number that is not known.
constexpr std::array<std::string_view, 8> kUnknowns = {"",   "nan", "null", "none",
                                                       "na", "n/a", "-",    "--"};
constexpr double kUnknownHeading_deg = 511;  // ITU-R M.1371, table 48: "not available".
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// A surface vessel's column of depths below this is one of a vessel that dives, or of the water.
constexpr double kDives_m = 1;
/// Vessels of one file that are counted; of more, a message lists these.
constexpr size_t kMaxVessels = 1000;

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
  std::vector<size_t> vessels;
};

/// Reads one text. Each step returns what is wrong, empty: nothing.
class CsvTrackReader {
 public:
  CsvTrackReader(std::string_view text, const TrackSource& source)
      : rest_(text), source_(source), builder_(source, DepthPositive::kDown) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // UTF-8's byte order mark.
  }

  Result<ReplayTrack> Read(std::vector<std::string>* warnings) {
    std::string problem = WhyNotText();
    if (problem.empty()) problem = ReadHeader();
    while (problem.empty() && NextLine()) problem = ReadLine();
    if (!problem.empty()) {
      return Error{fmt::format("{}:{}: {}", source_.name, line_number_, problem)};
    }
    if (source_.vessel.empty() && vessels_.size() > 1) {
      return Error{fmt::format(
          "{}: it has lines of several vessels: choose one by name = \"...\" beside file; {}",
          source_.name, VesselsThatAre())};
    }
    if (!source_.vessel.empty() && builder_.size() == 0) {
      return Error{fmt::format("{}: no line is of the vessel {}; {}", source_.name,
                               QuotedWord(source_.vessel), VesselsThatAre())};
    }
    if (std::abs(deepest_unread_m_) > kDives_m && warnings != nullptr) {
      warnings->push_back(
          fmt::format("{}: {} goes to {:g} m, and does not count without underwater = true",
                      source_.name, names_[*columns_.depth], deepest_unread_m_));
    }
    return builder_.Finish({.depth = columns_.depth && source_.underwater,
                            .heading = columns_.heading.has_value(),
                            .speed = columns_.speed.has_value()},
                           warnings);
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

  /// A text in UTF-16 has a mark in front, or zeros between its letters.
  std::string WhyNotText() const {
    const bool is_wide = rest_.starts_with("\xFF\xFE") || rest_.starts_with("\xFE\xFF") ||
                         rest_.substr(0, 100).find('\0') != std::string_view::npos;
    return is_wide ? "this is not a table in UTF-8, but UTF-16 or binary: save it as CSV in UTF-8"
                   : "";
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
    for (const std::string_view name : kVessels) {
      if (const auto column = Find({&name, 1})) columns_.vessels.push_back(*column);
    }
    if (source_.number != 0) {
      return "number = chooses a track of GPX; of a table name = chooses the vessel";
    }
    if (!source_.vessel.empty() && columns_.vessels.empty()) {
      std::string known;
      for (const std::string_view name : kVessels)
        known += (known.empty() ? "" : ", ") + std::string(name);
      return "name = chooses a vessel, and no column has it: name one of " + known +
             ColumnsThatAre();
    }
    return "";
  }

  bool IsOfVessel() const {
    return std::ranges::any_of(columns_.vessels, [&](size_t column) {
      return cells_[column] == std::string_view(source_.vessel);
    });
  }

  /// Counts the line's vessel, by the first column that has one.
  void NoteVessel() {
    if (columns_.vessels.empty()) return;
    const std::string vessel(cells_[columns_.vessels.front()].substr(0, 64));
    if (vessel.empty()) return;
    const auto found = vessels_.find(vessel);
    if (found != vessels_.end()) {
      ++found->second;
    } else if (vessels_.size() < kMaxVessels) {
      vessels_.emplace(vessel, 1);
    }
  }

  /// The vessels that there are, for messages.
  std::string VesselsThatAre() const {
    constexpr size_t kMaxShown = 8;
    std::string text = fmt::format("by {} it has ", names_[columns_.vessels.front()]);
    size_t num_shown = 0;
    for (const auto& [vessel, num_lines] : vessels_) {
      if (num_shown == kMaxShown)
        return text + fmt::format(", {} more", vessels_.size() - kMaxShown);
      text += fmt::format("{}{} ({} lines)", num_shown++ == 0 ? "" : ", ", QuotedWord(vessel),
                          num_lines);
    }
    return text;
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

  std::string ReadLine() {
    if (std::string problem = SplitLine(); !problem.empty()) return problem;
    if (cells_.size() < names_.size()) {
      return fmt::format(
          "this line has {} cells, and the header names {} columns; is the file "
          "complete?",
          cells_.size(), names_.size());
    }
    if (std::any_of(cells_.begin() + static_cast<std::ptrdiff_t>(names_.size()), cells_.end(),
                    [](std::string_view cell) { return !cell.empty(); })) {
      return fmt::format(
          "this line has {} cells, and the header names {} columns: decimals have a point, and a "
          "cell that holds the separator is in double quotes",
          cells_.size(), names_.size());
    }
    const bool is_chosen = source_.vessel.empty() || IsOfVessel();
    if (source_.vessel.empty() || !is_chosen) NoteVessel();
    // Of several vessels the points are never one track: that is refused when all are counted.
    if (!is_chosen || (source_.vessel.empty() && vessels_.size() > 1)) return "";
    return ReadFix();
  }

  std::string ReadFix() {
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
    if (columns_.depth && !source_.underwater) NoteUnreadDepth();
    const auto line = static_cast<uint64_t>(line_number_);
    return columns_.is_geographic ? builder_.Add(fix, place, line) : builder_.Add(fix, line);
  }

  void NoteUnreadDepth() {
    const std::optional<double> depth_m = NumberIn(cells_[*columns_.depth]);
    if (depth_m && std::abs(*depth_m) > std::abs(deepest_unread_m_)) deepest_unread_m_ = *depth_m;
  }

  bool IsUnknown(size_t column) const {
    const std::string_view cell = cells_[column];
    return cell.size() <= 4 && std::ranges::find(kUnknowns, LowerCase(cell)) != kUnknowns.end();
  }

  std::string ReadNumber(size_t column, double* number) const {
    const std::optional<double> read = NumberIn(cells_[column]);
    if (!read) {
      const bool has_comma = cells_[column].find(',') != std::string_view::npos;
      return fmt::format("{} is {}, and must be a finite number{}; leave out lines without one",
                         names_[column], QuotedWord(cells_[column]),
                         has_comma ? " with a decimal point" : "");
    }
    *number = *read;
    return "";
  }

  std::string ReadHeading(double* heading_rad) const {
    *heading_rad = kUnknown;
    if (IsUnknown(*columns_.heading)) return "";
    double heading_deg = 0;
    std::string problem = ReadNumber(*columns_.heading, &heading_deg);
    if (!problem.empty() || heading_deg == kUnknownHeading_deg) return problem;
    if (std::abs(heading_deg) > 360) {
      return fmt::format("{} is {:g}, and must be from -360 to 360 degrees, or empty: unknown",
                         names_[*columns_.heading], heading_deg);
    }
    *heading_rad = DegToRad(heading_deg);
    return "";
  }

  std::string ReadSpeed(double* speed_mps) const {
    *speed_mps = kUnknown;
    if (IsUnknown(*columns_.speed)) return "";
    std::string problem = ReadNumber(*columns_.speed, speed_mps);
    if (problem.empty() && (*speed_mps < 0 || *speed_mps > kFastestFix_mps)) {
      problem = fmt::format("{} is {:g}, and must be from 0 to {:g} m/s, or empty: unknown",
                            names_[*columns_.speed], *speed_mps, kFastestFix_mps);
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
  std::map<std::string, size_t> vessels_;  ///< Lines of each that is not chosen.
  double deepest_unread_m_ = 0;
};

}  // namespace

Result<ReplayTrack> ParseCsvTrack(std::string_view text, const TrackSource& source,
                                  std::vector<std::string>* warnings) {
  return CsvTrackReader(text, source).Read(warnings);
}

}  // namespace shoal

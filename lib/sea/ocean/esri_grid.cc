#include "lib/sea/ocean/esri_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/ocean/current.h"
#include "lib/sea/ocean/gap_marks.h"

namespace shoal {

namespace {

constexpr double kMaxGridDepth_m = 20'000;
constexpr double kMaxCorner_m = 1e9;
constexpr double kMinCell_m = 0.05;  // Maps in degrees have less: 0.03 is two minutes of arc.
constexpr double kMaxCell_m = 1e6;
constexpr double kNoDataDigits = 1e-6;  // As many as a float has, in which maps are mostly kept.
constexpr double kDefaultMark = -9999;
constexpr double kLeastMark = 1e30;  // The largest float and its like.

/// The keys of the header, in lower case, in the order of Header::numbers.
constexpr std::array<std::string_view, 10> kKeys = {
    "ncols",     "nrows",    "xllcorner", "yllcorner", "xllcenter",
    "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};
enum Key {
  kColumns,
  kRows,
  kWest,
  kSouth,
  kWestCenter,
  kSouthCenter,
  kCell,
  kDx,
  kDy,
  kNoDataValue
};

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Takes the next word off the front of a line; empty: there is none.
std::string_view TakeWord(std::string_view& line) {
  const auto start = std::find_if_not(line.begin(), line.end(), IsBlank);
  const auto end = std::find_if(start, line.end(), IsBlank);
  const std::string_view word(start, end);
  line = std::string_view(end, line.end());
  return word;
}

/// Returns whether a word is a NaN, as printf of one system or another writes it.
bool IsNan(std::string_view word) {
  std::string text = LowerCase(word);
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.erase(0, 1);
  return text == "nan" || text.starts_with("nan(") || text.starts_with("1.#qnan") ||
         text.starts_with("1.#ind");
}

/// Returns a number, or NaN; nothing: it is neither.
std::optional<double> ReadNumberOrNan(std::string_view word) {
  return IsNan(word) ? std::nan("") : ReadNumber<double>(word);
}

/// Returns a word as it may stand in a message: short, and printable.
std::string Quote(std::string_view word) {
  std::string quoted(word.substr(0, 24));
  for (char& c : quoted) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + quoted + (word.size() > 24 ? "...'" : "'");
}

/// Reads one text. Each step returns what is wrong, empty: nothing.
class EsriReader {
 public:
  EsriReader(std::string_view text, const EsriGridOptions& options)
      : rest_(text), options_(options) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // UTF-8's byte order mark.
  }

  Result<EsriField> Read() {
    std::string problem = ReadHeader();
    if (problem.empty()) problem = UseHeader();
    if (problem.empty()) problem = ReadRows();
    if (problem.empty()) problem = MakeDepths();
    if (!problem.empty()) {
      return Error{options_.name + ":" + std::to_string(line_number_) + ": " + problem};
    }
    return EsriField{
        .frame = frame_, .values = std::move(values_), .signs = signs_, .gap_marks = gap_marks_};
  }

 private:
  /// Goes to the next line that is not blank; false: the text has ended.
  bool NextLine() {
    while (!rest_.empty()) {
      const size_t end = std::min(rest_.find('\n'), rest_.size());
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_number_;
      if (!std::all_of(line_.begin(), line_.end(), IsBlank)) return true;
    }
    line_ = {};
    return false;
  }

  /// Reads up to the first line that starts with a number, which it leaves in line_.
  std::string ReadHeader() {
    while (NextLine()) {
      std::string_view line = line_;
      const std::string_view word = TakeWord(line);
      if (ReadNumberOrNan(word)) return "";
      const auto key = std::find(kKeys.begin(), kKeys.end(), LowerCase(word));
      if (key == kKeys.end()) {
        return Quote(word) + " is neither a number nor a key of an ESRI ASCII grid; export the " +
               "map in that format (Arc/Info ASCII Grid, .asc)";
      }
      const auto index = static_cast<size_t>(key - kKeys.begin());
      std::optional<double>& number = numbers_[index];
      if (number) return std::string(*key) + " stands here for the second time; remove one";
      const std::string_view value = TakeWord(line);
      number = index == kNoDataValue ? ReadNumberOrNan(value) : ReadNumber<double>(value);
      lines_[index] = line_number_;
      if (!number) return std::string(*key) + " needs a number, not " + Quote(value);
      if (!TakeWord(line).empty()) return std::string(*key) + " takes one number; remove the rest";
    }
    return "the text ends before the first row of numbers; is the file complete?";
  }

  /// Checks one number of the header, which must be there and in the range.
  std::string CheckNumber(Key key, double low, double high) {
    const std::string name(kKeys[key]);
    const std::optional<double>& number = numbers_[key];
    if (!number) return "the header before this line has no " + name + "; add it";
    if (*number >= low && *number <= high) return "";
    line_number_ = lines_[key];
    return name + " must be from " + RoundText(low) + " to " + RoundText(high) +
           (key == kCell || key == kDx || key == kDy
                ? " metres; a map in degrees must be projected to metres first"
                : "");
  }

  static std::string RoundText(double number) {
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
    return {text.data(), end};
  }

  std::string UseHeader() {
    const bool is_square = numbers_[kCell].has_value();
    const Key cell_x = is_square ? kCell : numbers_[kDx] ? kDx : kCell;
    const Key cell_y = is_square ? kCell : numbers_[kDx] ? kDy : kCell;
    const bool west_is_center = numbers_[kWestCenter].has_value();
    const bool south_is_center = numbers_[kSouthCenter].has_value();
    const Key west = west_is_center ? kWestCenter : kWest;
    const Key south = south_is_center ? kSouthCenter : kSouth;
    for (const auto& [key, low, high] :
         {std::tuple(kColumns, 1.0, double{kMaxGridPoints}),
          std::tuple(kRows, 1.0, double{kMaxGridPoints}),
          std::tuple(cell_x, kMinCell_m, kMaxCell_m), std::tuple(cell_y, kMinCell_m, kMaxCell_m),
          std::tuple(west, -kMaxCorner_m, kMaxCorner_m),
          std::tuple(south, -kMaxCorner_m, kMaxCorner_m)}) {
      if (std::string problem = CheckNumber(key, low, high); !problem.empty()) return problem;
    }
    const double columns = *numbers_[kColumns];
    const double rows = *numbers_[kRows];
    if (columns != std::floor(columns) || rows != std::floor(rows)) {
      line_number_ = lines_[columns != std::floor(columns) ? kColumns : kRows];
      return "ncols and nrows must be whole numbers";
    }
    if (columns * rows > kMaxGridPoints) {
      line_number_ = lines_[kRows];
      return "ncols times nrows is more than " + std::to_string(kMaxGridPoints) +
             "; cut out the part that the mission needs, or use larger cells";
    }
    frame_.columns = static_cast<int>(columns);
    frame_.rows = static_cast<int>(rows);
    frame_.cell_m = {*numbers_[cell_x], *numbers_[cell_y]};
    frame_.south_west_m =
        Eigen::Vector2d(*numbers_[west] + (west_is_center ? 0 : frame_.cell_m.x() / 2),
                        *numbers_[south] + (south_is_center ? 0 : frame_.cell_m.y() / 2)) -
        options_.mission_origin_m;
    return "";
  }

  /// Reads the numbers, the first of which are in line_, and turns their rows South to North.
  std::string ReadRows() {
    const size_t num_points =
        static_cast<size_t>(frame_.columns) * static_cast<size_t>(frame_.rows);
    // A number takes two characters at least: no header makes this larger than the text.
    values_.reserve(std::min(num_points, (line_.size() + rest_.size()) / 2 + 1));
    do {
      if (std::string problem = ReadLine(num_points); !problem.empty()) return problem;
    } while (NextLine());
    if (values_.size() < num_points) {
      return CountProblem("the text ends after " + std::to_string(values_.size()) + " of " +
                          std::to_string(num_points) + " numbers; is the file complete?");
    }
    const auto columns = static_cast<ptrdiff_t>(frame_.columns);
    for (ptrdiff_t north = 0, south = frame_.rows - 1; north < south; ++north, --south) {
      std::swap_ranges(values_.begin() + north * columns, values_.begin() + (north + 1) * columns,
                       values_.begin() + south * columns);
    }
    return "";
  }

  std::string ReadLine(size_t num_points) {
    std::string_view line = line_;
    int count = 0;
    for (std::string_view word = TakeWord(line); !word.empty(); word = TakeWord(line), ++count) {
      if (values_.size() == num_points) {
        for (; !word.empty(); word = TakeWord(line)) ++count;
        NoteLine(count);
        return CountProblem("there are more numbers than the " + std::to_string(num_points) +
                            " of ncols and nrows; correct the header");
      }
      const std::optional<double> number = ReadNumberOrNan(word);
      if (!number) return Quote(word) + " is not a number";
      if (std::string problem = AddValue(*number); !problem.empty()) return problem;
    }
    NoteLine(count);
    return "";
  }

  /// A file that has a row on a line, but for one, misses numbers there or has too many.
  void NoteLine(int count) {
    if (count == frame_.columns) {
      has_whole_line_ = true;
    } else if (odd_line_ == 0) {
      odd_line_ = line_number_;
      odd_count_ = count;
    }
  }

  /// Returns that there are too many or too few numbers, at the line where that is seen.
  std::string CountProblem(const std::string& otherwise) {
    if (!has_whole_line_ || odd_line_ == 0) return otherwise;
    line_number_ = odd_line_;
    return "this line has " + std::to_string(odd_count_) + " numbers, and ncols is " +
           std::to_string(frame_.columns) + "; " + otherwise;
  }

  bool IsNoData(double number) const {
    if (std::isnan(number) || std::abs(number) > kLeastMark) return true;
    double mark = numbers_[kNoDataValue].value_or(kDefaultMark);
    if (std::isnan(mark)) mark = kDefaultMark;  // As programs that write nan now did before.
    return std::abs(number - mark) <= kNoDataDigits * std::abs(mark);  // False for NaN.
  }

  std::string AddValue(double number) {
    const bool is_velocity = options_.values == GridValues::kVelocity;
    const auto column_text = [&] {
      return "column " + std::to_string(values_.size() % static_cast<size_t>(frame_.columns) + 1);
    };
    if (IsNoData(number)) {
      if (!is_velocity && !options_.nodata_depth_m) {
        return column_text() +
               " has no data; fill the map's gaps, or state their depth: grid_gap_depth_m";
      }
      values_.push_back(std::nanf(""));
      return "";
    }
    if (std::abs(number) > (is_velocity ? kMaxCurrent_mps : kMaxGridDepth_m)) {
      return column_text() +
             (is_velocity
                  ? " is faster than " + RoundText(kMaxCurrent_mps) + " m/s"
                  : " is further from the surface than " + RoundText(kMaxGridDepth_m) + " m") +
             "; is it the mark for no data? Then set NODATA_value";
    }
    if (!is_velocity) marks_.Count(number);
    values_.push_back(static_cast<float>(number));
    return "";
  }

  /// Makes depths of what was read, where it is no velocity.
  std::string MakeDepths() {
    if (options_.values == GridValues::kVelocity) return "";
    gap_marks_ = marks_.Found();
    for (const float mark : gap_marks_) std::ranges::replace(values_, mark, std::nanf(""));
    if (!gap_marks_.empty() && !options_.nodata_depth_m) {
      return "the map has the number " + RoundText(gap_marks_[0]) +
             ", and none near it: it is taken to mark cells without data; fill these, or state "
             "their depth: grid_gap_depth_m";
    }
    for (float& value : values_) {
      if (std::isnan(value)) {
        value = static_cast<float>(*options_.nodata_depth_m);
        continue;
      }
      signs_.Count(value);
      value = std::max(0.0F, options_.values == GridValues::kElevation ? -value : value);
    }
    return "";
  }

  std::string_view rest_;
  std::string_view line_;
  int line_number_ = 0;
  const EsriGridOptions& options_;
  std::array<std::optional<double>, kKeys.size()> numbers_ = {};
  std::array<int, kKeys.size()> lines_ = {};  ///< Where they stand.
  GridFrame frame_;
  std::vector<float> values_;
  FloorSigns signs_;
  GapMarks marks_;
  std::vector<float> gap_marks_;
  bool has_whole_line_ = false;  ///< Some line has as many numbers as there are columns.
  int odd_line_ = 0;             ///< The first line that has not; 0: there is none.
  int odd_count_ = 0;            ///< How many it has.
};

}  // namespace

Result<DepthGrid> ParseEsriGrid(std::string_view text, const EsriGridOptions& options) {
  Result<EsriField> field = ParseEsriField(text, options);
  if (!field.ok()) return Error{field.error()};
  return DepthGrid(field->frame, std::move(field->values));
}

Result<EsriField> ParseEsriField(std::string_view text, const EsriGridOptions& options) {
  return EsriReader(text, options).Read();
}

}  // namespace shoal

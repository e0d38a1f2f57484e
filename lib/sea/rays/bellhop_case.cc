#include "lib/sea/rays/bellhop_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lib/base/check/bounds.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/rays/list_text.h"

namespace shoal {

namespace {

constexpr double kDecibelsOfNeper = 8.685889638065035;

/// Reads a .env from top to bottom; each step returns an error or "".
class EnvReader {
 public:
  EnvReader(const std::string& name, std::string_view text, const ReadCompanion& read_companion)
      : name_(name), text_(name_, text), read_companion_(read_companion) {}

  Result<BellhopCase> Run() {
    using Step = bool (EnvReader::*)();
    for (const Step step : {&EnvReader::ReadHead, &EnvReader::ReadProfile, &EnvReader::ReadBottom,
                            &EnvReader::ReadPlaces, &EnvReader::ReadRun, &EnvReader::Complete}) {
      if (!(this->*step)()) return Error{error_};
    }
    return std::move(case_);
  }

 private:
  bool Fail(const Error& error) {
    error_ = error.message;
    return false;
  }
  bool Refuse(const std::string& message) { return Fail(text_.Refuse(message)); }

  /// Stores what a reading step returned, or fails with its error.
  template <class T>
  bool Take(Result<T> result, T* value) {
    if (!result.ok()) return Fail(Error{result.error()});
    *value = std::move(*result);
    return true;
  }

  char OptionAt(size_t index) const { return index < options_.size() ? options_[index] : ' '; }

  bool ReadHead() {
    if (!Take(text_.Text("the title in quotes"), &case_.title) ||
        !Take(text_.Number("the frequency in Hz"), &case_.scene.hz)) {
      return false;
    }
    if (!(case_.scene.hz > 0 && case_.scene.hz <= 1e7)) {
      return Refuse("a frequency of " + ShortestText(case_.scene.hz) +
                    " Hz: it must be more than 0 and at most 1e7");
    }
    if (!Take(text_.Number("the number of media"), &value_)) return false;
    if (value_ != 1) {
      return Refuse("the number of media must be 1, as for Bellhop, not " + ShortestText(value_));
    }
    if (!Take(text_.Text("the option string in quotes, as in 'CVW'"), &options_)) return false;
    return CheckOptions() &&
           ReadBoundary(OptionAt(1), "surface", ".trc", &case_.scene.surface_reflector);
  }

  bool CheckOptions() {
    const std::string place = "option string '" + options_ + "': ";
    if (OptionAt(0) != 'C' && OptionAt(0) != 'Q') {
      return Refuse(place + "letter 1 is '" + OptionAt(0) +
                    "'; read are C (speeds linear in depth) and Q (with a .ssp). Resample other "
                    "interpolations to a dense table with C");
    }
    if (std::string_view(" NFMWQL").find(OptionAt(2)) == std::string_view::npos) {
      return Refuse(place + "letter 3, the unit of attenuation, is '" + OptionAt(2) +
                    "'; read are N F M W Q L");
    }
    if (OptionAt(3) != ' ' && OptionAt(3) != 'T') {
      return Refuse(place + "letter 4 is '" + OptionAt(3) +
                    "'; read are a blank (no absorption) and T (Thorp's)");
    }
    if (std::string_view(" ~*-_").find(OptionAt(4)) == std::string_view::npos) {
      return Refuse(place + "letter 5 is '" + OptionAt(4) +
                    "'; read are ~ or * (a .ati) and a blank, - or _ (a flat surface)");
    }
    if (OptionAt(5) != ' ') {
      return Refuse(place + "letter 6 is '" + OptionAt(5) + "'; development options are not read");
    }
    case_.has_thorp_absorption = OptionAt(3) == 'T';
    return true;
  }

  bool ReadBoundary(char kind, const std::string& which, std::string_view table_ending,
                    Reflector* reflector) {
    switch (kind) {
      case 'V':
        *reflector = Vacuum();
        return true;
      case 'R':
        *reflector = RigidWall();
        return true;
      case 'F': {
        ReflectionTable table;
        std::string content;
        const std::string name = CompanionName(table_ending);
        if (!ReadCompanionText(table_ending, &content) ||
            !Take(ReadBellhopReflection(name, content), &table)) {
          return false;
        }
        *reflector = std::move(table);
        return true;
      }
      case 'A':
        return ReadHalfSpace(which, reflector);
      default:
        return Refuse("the kind of the " + which + " is '" + std::string(1, kind) +
                      "'; read are V (vacuum), R (rigid), A (fluid half-space) and F (table)");
    }
  }

  bool ReadHalfSpace(const std::string& which, Reflector* reflector) {
    std::vector<std::optional<double>> items;
    if (!Take(text_.Numbers(6, "depth, speeds, density and attenuations of the " + which),
              &items)) {
      return false;
    }
    HalfSpace below = {.speed_mps = items[1].value_or(speed_mps_),
                       .density = items[3].value_or(density_),
                       .attenuation_db_per_wavelength = 0};
    const double attenuation = items[4].value_or(attenuation_);
    if (items[2].value_or(0) != 0) {
      case_.warnings.push_back(name_ + ": the shear speed of the " + which +
                               " is not used, as in Bellhop's own 2D program");
    }
    below.attenuation_db_per_wavelength = PerWavelength(attenuation, below.speed_mps);
    if (!(IsBetween(below.speed_mps, 1, 20'000) && IsBetween(below.density, 1e-3, 100) &&
          IsBetween(below.attenuation_db_per_wavelength, 0, 100))) {
      return Refuse("the half-space of the " + which +
                    " needs a speed from 1 to 20000 m/s, a density from 0.001 to 100 and an "
                    "attenuation from 0 to 100 dB per wavelength");
    }
    *reflector = below;
    return true;
  }

  double PerWavelength(double attenuation, double speed_mps) const {
    if (attenuation == 0) return 0;
    const double wavelength_m = speed_mps / case_.scene.hz;
    switch (OptionAt(2)) {
      case 'N':
        return attenuation * kDecibelsOfNeper * wavelength_m;
      case 'F':
        return attenuation * case_.scene.hz / 1000 * wavelength_m;
      case 'M':
        return attenuation * wavelength_m;
      case 'Q':
        return kDecibelsOfNeper * std::numbers::pi / attenuation;
      case 'L':
        return attenuation * 2 * std::numbers::pi * kDecibelsOfNeper;
      default:
        return attenuation;
    }
  }

  bool ReadProfile() {
    std::vector<std::optional<double>> items;
    if (!Take(text_.Numbers(3, "points, roughness and depth of the water"), &items)) return false;
    if (!items[2]) return Refuse("the depth of the water is missing: 'points roughness depth'");
    depth_m_ = *items[2];
    while (points_.empty() || std::abs(points_.back().depth_m - depth_m_) > 1e-5) {
      if (!ReadProfileLine()) return false;
    }
    points_.back().depth_m = depth_m_;
    case_.scene.water_density = density_;
    if (OptionAt(0) == 'Q') {
      std::vector<double> depths_m;
      for (const SpeedPoint& point : points_) depths_m.push_back(point.depth_m);
      std::string content;
      return ReadCompanionText(".ssp", &content) &&
             Take(ReadBellhopProfiles(CompanionName(".ssp"), content, depths_m),
                  &case_.scene.water);
    }
    SoundProfile profile;
    if (!Take(SoundProfile::Make(points_), &profile)) return Refuse(error_);
    case_.scene.water = {{0, profile}};
    return true;
  }

  bool ReadProfileLine() {
    std::vector<std::optional<double>> items;
    if (!Take(text_.Numbers(6, "depth and speed of the profile, which goes on to depth " +
                                   ShortestText(depth_m_)),
              &items)) {
      return false;
    }
    if (!items[0]) return Refuse("a point of the profile needs a depth");
    speed_mps_ = items[1].value_or(speed_mps_);
    density_ = items[3].value_or(density_);
    attenuation_ = items[4].value_or(attenuation_);
    if (attenuation_ != 0) {
      return Refuse("attenuation in the water is not read; use letter 4 of the options, T");
    }
    if (!(density_ > 0)) return Refuse("the density of the water must be more than 0");
    points_.push_back({*items[0], speed_mps_});
    if (points_.size() > kMaxBellhopItems) return Refuse("a profile has at most 10000 points");
    if (points_.size() > 1 && !(points_.back().depth_m > points_[points_.size() - 2].depth_m)) {
      return Refuse("depths must grow from point to point");
    }
    if (points_.back().depth_m > depth_m_ + 1e-5) {
      return Refuse("the profile must have a point at the depth of the water, " +
                    ShortestText(depth_m_) + " m");
    }
    return IsBetween(points_.back().depth_m, 0, kMaxProfileDepth_m) &&
                   IsBetween(speed_mps_, kMinRaySpeed_mps, kMaxRaySpeed_mps)
               ? true
               : Refuse("depth " + ShortestText(points_.back().depth_m) + " m, speed " +
                        ShortestText(speed_mps_) + " m/s: a point must be between 0 and " +
                        ShortestText(kMaxProfileDepth_m) + " m and between " +
                        ShortestText(kMinRaySpeed_mps) + " and " + ShortestText(kMaxRaySpeed_mps) +
                        " m/s");
  }

  bool ReadBottom() {
    std::string kind;
    if (!Take(text_.Text("the kind of the bottom in quotes, as in 'A'"), &kind)) return false;
    const char shape = kind.size() > 1 ? kind[1] : ' ';
    if (std::string_view(" ~*-_").find(shape) == std::string_view::npos) {
      return Refuse("the kind of the bottom is '" + kind +
                    "'; letter 2 is ~ or * (a .bty), or a blank, - or _ (flat)");
    }
    case_.scene.surface = {{0, points_.front().depth_m}};
    case_.scene.bottom = {{0, depth_m_}};
    return ReadBoundary(kind.empty() ? ' ' : kind[0], "bottom", ".brc",
                        &case_.scene.bottom_reflector) &&
           (std::string_view("~*").find(shape) == std::string_view::npos ||
            ReadShape(".bty", &case_.scene.bottom)) &&
           (std::string_view("~*").find(OptionAt(4)) == std::string_view::npos ||
            ReadShape(".ati", &case_.scene.surface));
  }

  bool ReadShape(std::string_view ending, std::vector<BoundaryPoint>* boundary) {
    std::string content;
    return ReadCompanionText(ending, &content) &&
           Take(ReadBellhopBoundary(CompanionName(ending), content), boundary);
  }

  /// Reads a count and its values, or the two ends of evenly spaced ones.
  bool ReadVector(std::string_view what, double unit, std::vector<double>* values) {
    int count = 0;
    if (!Take(text_.Count("the number of " + std::string(what), 1, kMaxBellhopItems), &count)) {
      return false;
    }
    std::vector<std::optional<double>> items;
    if (!Take(text_.Numbers(static_cast<size_t>(count), what), &items)) return false;
    const auto last = std::ranges::find_if(
        items, [](const std::optional<double>& item) { return !item.has_value(); });
    const auto num_given = static_cast<size_t>(last - items.begin());
    if (num_given == 0) return Refuse("no " + std::string(what) + " are given");
    if (num_given < items.size() && num_given > 2) {
      return Refuse(std::to_string(items.size()) + " " + std::string(what) +
                    " are announced, and " + std::to_string(num_given) +
                    " given; two stand for the ends of evenly spaced "
                    "ones");
    }
    const double first = *items[0];
    const double end = num_given > 1 ? *items[1] : first;
    for (size_t i = 0; i < items.size(); ++i) {
      const double share =
          items.size() > 1 ? static_cast<double>(i) / static_cast<double>(items.size() - 1) : 0;
      const double value = num_given == items.size() ? *items[i] : first + (end - first) * share;
      values->push_back(value * unit);
    }
    std::ranges::sort(*values);
    return true;
  }

  bool ReadPlaces() {
    return ReadVector("source depths", 1, &case_.source_depths_m) &&
           ReadVector("receiver depths", 1, &case_.receiver_depths_m) &&
           ReadVector("receiver ranges in km", 1000, &case_.receiver_ranges_m);
  }

  bool ReadRun() {
    std::string run;
    if (!Take(text_.Text("the run string in quotes, as in 'A'"), &run)) return false;
    case_.run = run.empty() ? ' ' : run[0];
    if (std::string_view("AaRECIS").find(case_.run) == std::string_view::npos) {
      return Refuse("the run string '" + run + "' must begin with one of A a R E C I S");
    }
    if (run.size() > 3 && run[3] == 'X') {
      return Refuse("run string '" + run + "': line sources (letter 4, X) are not read");
    }
    std::vector<std::optional<double>> items;
    if (!Take(text_.Numbers(1, "the number of beams"), &items)) return false;
    if (!Take(text_.Numbers(2, "the first and the last launch angle in degrees"), &items)) {
      return false;
    }
    const double degree = std::numbers::pi / 180;
    if (!items[0]) return Refuse("the launch angles are missing");
    const double first_deg = *items[0];
    const double last_deg = items[1].value_or(first_deg);
    if (!(first_deg >= -90 && last_deg <= 90 && first_deg <= last_deg)) {
      return Refuse("launch angles must grow and be between -90 and 90 degrees");
    }
    case_.first_launch_rad = first_deg * degree;
    case_.last_launch_rad = last_deg * degree;
    return true;
  }

  bool Complete() {
    const std::string problem = ProblemOf(case_.scene);
    if (!problem.empty()) return Fail(Error{name_ + ": " + problem});
    const double top_m = points_.front().depth_m;
    for (const BoundaryPoint& point : case_.scene.surface) {
      if (point.depth_m >= top_m) continue;
      return Fail(Error{name_ + ": the surface rises above the first depth of the profile, " +
                        ShortestText(top_m) + " m; put the mean surface below it"});
    }
    for (const BoundaryPoint& point : case_.scene.bottom) {
      if (point.depth_m <= depth_m_) continue;
      return Fail(Error{name_ + ": the bottom is at " + ShortestText(point.depth_m) +
                        " m, below the profile, which ends at " + ShortestText(depth_m_) +
                        " m; give the profile a point there"});
    }
    return true;
  }

  std::string CompanionName(std::string_view ending) const {
    const size_t dot = name_.rfind('.');
    return name_.substr(0, dot) + std::string(ending);
  }

  bool ReadCompanionText(std::string_view ending, std::string* content) {
    std::optional<std::string> found = read_companion_(ending);
    if (!found) return Refuse("this line asks for " + CompanionName(ending) + ", which is missing");
    *content = std::move(*found);
    return true;
  }

  const std::string name_;
  ListText text_;
  const ReadCompanion& read_companion_;
  std::string error_;
  BellhopCase case_;
  std::string options_;
  std::vector<SpeedPoint> points_;
  double value_ = 0;
  double depth_m_ = 0;
  double speed_mps_ = 1500;  // Items that a line leaves out are those of the line before.
  double density_ = 1;
  double attenuation_ = 0;
};

}  // namespace

Result<BellhopCase> ReadBellhopCase(const std::string& name, std::string_view text,
                                    const ReadCompanion& read_companion) {
  EnvReader reader(name, text, read_companion);
  return reader.Run();
}

}  // namespace shoal

#include "lib/mission/file/water_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/netcdf/cf_values.h"
#include "lib/mission/netcdf/cf_words.h"
#include "lib/mission/netcdf/netcdf_file.h"
#include "lib/sea/rays/cast_text.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr double kKelvin_degc = 273.15;

Error CannotRead(const std::string& path, const std::string& problem) {
  return Error{path + ": " + problem + "; the path counts from the mission file's folder"};
}

bool HasEnding(const std::string& path, std::string_view ending) {
  return LowerCase(fs::path(path).extension().string()) == ending;
}

/// A quantity of a NetCDF file: what standard_name begins with, or the variable's name.
struct WaterQuantity {
  std::string_view what;
  std::array<std::string_view, 3> standard_names;
  std::array<std::string_view, 6> names;
};
constexpr WaterQuantity kTemperature = {
    "temperature",
    {"sea_water_temperature", "sea_water_potential_temperature",
     "sea_water_conservative_temperature"},
    {"temperature", "temp", "thetao", "water_temp", "t_an", "votemper"}};
constexpr WaterQuantity kSalinity = {
    "salinity",
    {"sea_water_salinity", "sea_water_practical_salinity", "sea_water_absolute_salinity"},
    {"salinity", "so", "psal", "sal", "s_an", "vosaline"}};
constexpr WaterQuantity kSpeed = {"speed of sound",
                                  {"speed_of_sound_in_sea_water", "", ""},
                                  {"sound_speed", "svel", "sound_velocity", "", "", ""}};
constexpr WaterQuantity kDepth = {
    "depth", {"depth", "", ""}, {"depth", "lev", "deptht", "z", "pres_depth", "depthu"}};

bool Contains(std::span<const std::string_view> words, std::string_view word) {
  return !word.empty() && std::ranges::find(words, word) != words.end();
}

const NetcdfVariable* FindQuantity(const NetcdfHeader& header, const WaterQuantity& quantity) {
  for (const NetcdfVariable& variable : header.variables) {
    if (Contains(quantity.standard_names, variable.TextOf("standard_name"))) return &variable;
  }
  for (const NetcdfVariable& variable : header.variables) {
    if (Contains(quantity.names, LowerCase(variable.name))) return &variable;
  }
  return nullptr;
}

/// One profile in a NetCDF file.
class NetcdfCast {
 public:
  NetcdfCast(const NetcdfFile& file, std::string path) : file_(file), path_(std::move(path)) {}

  Result<SoundProfile> Run() {
    const Result<std::vector<double>> depths_m = Column(kDepth, 0);
    if (!depths_m.ok()) return Error{depths_m.error()};
    num_points_ = depths_m->size();
    if (FindQuantity(file_.header(), kSpeed) != nullptr) {
      const Result<std::vector<double>> speeds_mps = Column(kSpeed, num_points_);
      if (!speeds_mps.ok()) return Error{speeds_mps.error()};
      std::vector<SpeedPoint> points;
      for (size_t i = 0; i < num_points_; ++i) {
        if (std::isnan((*speeds_mps)[i])) continue;
        points.push_back({DepthOf((*depths_m)[i]), (*speeds_mps)[i]});
      }
      return Named(SoundProfile::Make(Downward(std::move(points))));
    }
    const Result<std::vector<double>> temperatures = Column(kTemperature, num_points_);
    if (!temperatures.ok()) return Error{temperatures.error()};
    const Result<std::vector<double>> salinities = Column(kSalinity, num_points_);
    if (!salinities.ok()) return Error{salinities.error()};
    const bool is_kelvin =
        LowerCase(FindQuantity(file_.header(), kTemperature)->TextOf("units")).starts_with("k");
    std::vector<CastPoint> cast;
    for (size_t i = 0; i < num_points_; ++i) {
      if (std::isnan((*temperatures)[i]) || std::isnan((*salinities)[i])) continue;
      cast.push_back({DepthOf((*depths_m)[i]), (*temperatures)[i] - (is_kelvin ? kKelvin_degc : 0),
                      (*salinities)[i]});
    }
    return Named(ProfileOfCast(Downward(std::move(cast))));
  }

 private:
  static double DepthOf(double number) { return std::abs(number); }

  template <class Point>
  static std::vector<Point> Downward(std::vector<Point> points) {
    std::ranges::sort(points, {}, &Point::depth_m);
    return points;
  }

  Result<SoundProfile> Named(Result<SoundProfile> profile) const {
    if (!profile.ok()) return Error{path_ + ": " + profile.error()};
    return profile;
  }

  /// Reads a quantity that varies with depth alone. `num_points`: of the depth axis; 0: any.
  Result<std::vector<double>> Column(const WaterQuantity& quantity, uint64_t num_points) const {
    const NetcdfVariable* variable = FindQuantity(file_.header(), quantity);
    if (variable == nullptr) {
      return Error{
          fmt::format("{}: no variable is the {}: none has such a standard_name, nor one "
                      "of the names {}",
                      path_, quantity.what, fmt::join(quantity.names, " "))};
    }
    const uint64_t num_values = file_.header().NumValues(*variable);
    if (num_values == 0 || num_values > kMaxProfilePoints ||
        (num_points > 0 && num_values != num_points)) {
      return Error{fmt::format(
          "{}: variable '{}' has {} values where the depth has {}: it is one of several places or "
          "times; cut out one, as with ncks -d time,0 -d lat,54.1 -d lon,7.9",
          path_, PrintableName(variable->name), num_values,
          num_points > 0 ? num_points : kMaxProfilePoints)};
    }
    Result<std::vector<double>> values = file_.Read(*variable);
    if (!values.ok()) return values;
    return Unpacked(*variable, std::move(*values));
  }

  const NetcdfFile& file_;
  std::string path_;
  size_t num_points_ = 0;
};

Result<SoundProfile> ReadNetcdfCast(const std::string& path) {
  const Result<FileDescriptor> fd = OpenRegularFile(path);
  if (!fd.ok()) return CannotRead(path, fd.error());
  const Result<NetcdfFile> file = NetcdfFile::Open(fd->get(), path);
  if (!file.ok()) return Error{file.error()};
  return NetcdfCast(*file, path).Run();
}

}  // namespace

std::string PathBeside(const std::string& mission_file, const std::string& file) {
  return (fs::path(mission_file).parent_path() / file).string();
}

Result<BellhopCase> ReadBellhopFile(const std::string& path) {
  const FileText text = ReadRegularFile(path);
  if (!text.problem.empty()) return CannotRead(path, text.problem);
  return ReadBellhopCase(path, text.text, [&](std::string_view ending) {
    fs::path beside(path);
    beside.replace_extension(ending);
    FileText found = ReadRegularFile(beside.string());
    if (!found.problem.empty()) return std::optional<std::string>();
    return std::optional(std::move(found.text));
  });
}

Result<SoundProfile> ReadProfileFile(const std::string& path) {
  if (HasEnding(path, ".nc")) return ReadNetcdfCast(path);
  if (HasEnding(path, ".env")) {
    const FileText text = ReadRegularFile(path);
    if (!text.problem.empty()) return CannotRead(path, text.problem);
    bool needs_others = false;
    const Result<BellhopCase> bay =
        ReadBellhopCase(path, text.text, [&](std::string_view /*ending*/) {
          needs_others = true;
          return std::optional<std::string>();
        });
    if (needs_others) {
      return Error{path +
                   ": only the profile is taken, and this .env needs files beside it; give "
                   "surface and bottom the kinds V, R or A without ~, or write the profile "
                   "as a .csv"};
    }
    if (!bay.ok()) return Error{bay.error()};
    if (bay->scene.water.size() == 1) return bay->scene.water.front().profile;
    return Error{path +
                 ": has profiles at several ranges, and a mission has one; name a .env with "
                 "option C"};
  }
  if (!HasEnding(path, ".csv")) {
    return Error{path + ": a profile is a .csv (a cast), a .nc (NetCDF) or a .env (Bellhop)"};
  }
  const FileText text = ReadRegularFile(path);
  if (!text.problem.empty()) return CannotRead(path, text.problem);
  return ReadCast(path, text.text);
}

Result<std::vector<PacketErrorPoint>> ReadPacketErrors(const std::string& path) {
  const FileText text = ReadRegularFile(path);
  if (!text.problem.empty()) return CannotRead(path, text.problem);
  const auto rows = ReadErrorTable(path, text.text);
  if (!rows.ok()) return Error{rows.error()};
  std::vector<PacketErrorPoint> points;
  for (const auto& [snr_db, loss] : *rows) points.push_back({snr_db, loss});
  return points;
}

Result<std::shared_ptr<const ArrivalTable>> ReadArrivals(const std::string& path) {
  const FileText text = ReadRegularFile(path);
  if (!text.problem.empty()) return CannotRead(path, text.problem);
  Result<ArrivalTable> table = ReadBellhopArrivals(path, text.text);
  if (!table.ok()) return Error{table.error()};
  return std::make_shared<const ArrivalTable>(std::move(*table));
}

}  // namespace shoal

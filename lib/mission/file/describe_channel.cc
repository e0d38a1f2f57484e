// The table [acoustics.channel].
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/file/describe.h"
#include "lib/mission/file/water_files.h"

namespace shoal {
namespace {

constexpr TextRule kSoundFileRule = {.min_length = 1, .max_length = 1000};
/// Of tables that a mission file holds.
constexpr size_t kMaxErrorRows = 10'000;

/// Where a key stands for data and another for the file with it: the data, read where the file is
/// named. `read` reads a file into the data, or returns why it cannot.
template <class Read>
void DescribeFile(Fields& fields, std::string_view key, std::string_view data_key,
                  const std::optional<std::string>& folder, std::string& file, const Read& read) {
  if (!fields.Has(key, false)) return;
  if (!folder) {
    fields.Refuse(key, std::string(key) + " opens a file, and here no files are read");
    return;
  }
  fields.Text(key, file, kSoundFileRule);
  if (fields.Has(data_key, false)) {
    fields.Refuse(key, std::string(key) + " and " + std::string(data_key) +
                           " are the same thing: remove one of them");
    return;
  }
  const std::string problem = read(PathBeside(*folder + "/mission", file));
  if (!problem.empty()) fields.Refuse(key, problem);
}

void DescribeProfile(Fields& fields, RayChannelOptions& rays,
                     const std::optional<std::string>& folder) {
  DescribeFile(fields, "profile_file", "profile", folder, rays.profile_file,
               [&](const std::string& path) {
                 const Result<SoundProfile> profile = ReadProfileFile(path);
                 if (!profile.ok()) return profile.error();
                 rays.profile.assign(profile->points().begin(), profile->points().end());
                 return std::string();
               });
  if (fields.reading() && !fields.Has("profile", false)) return;
  std::vector<Eigen::Vector2d> points;
  for (const SpeedPoint& point : rays.profile) points.emplace_back(point.depth_m, point.speed_mps);
  fields.Pairs("profile", points, Between(0, kMaxProfileDepth_m), kMaxProfilePoints);
  rays.profile.clear();
  for (const Eigen::Vector2d& point : points) rays.profile.push_back({point.x(), point.y()});
  const Result<SoundProfile> profile = SoundProfile::Make(rays.profile);
  if (fields.reading() && fields.IsSound() && !profile.ok()) {
    fields.Refuse("profile", profile.error());
  }
  if (!profile.ok()) rays.profile = RayChannelOptions().profile;
}

void DescribePacketErrors(Fields& fields, RayChannelOptions& rays,
                          const std::optional<std::string>& folder) {
  DescribeFile(fields, "packet_errors_file", "packet_errors", folder, rays.packet_errors_file,
               [&](const std::string& path) {
                 auto points = ReadPacketErrors(path);
                 if (!points.ok()) return points.error();
                 rays.packet_errors = *points;
                 return std::string();
               });
  if (!fields.Has("packet_errors", !rays.packet_errors.empty())) return;
  std::vector<Eigen::Vector2d> points;
  for (const PacketErrorPoint& each : rays.packet_errors)
    points.emplace_back(each.snr_db, each.loss);
  fields.Pairs("packet_errors", points, Between(-1000, 1000), kMaxErrorRows);
  rays.packet_errors.clear();
  for (const Eigen::Vector2d& point : points) rays.packet_errors.push_back({point.x(), point.y()});
}

void DescribeBottom(Fields& fields, HalfSpace& bottom) {
  if (fields.HoldsText("bottom")) {
    std::vector<std::string_view> words;
    for (const auto& [word, half_space] : kBottomTypes) words.push_back(word);
    std::string word(words.front());
    fields.Word("bottom", word, words);
    bottom = FindBottomType(word).value_or(bottom);
    return;
  }
  fields.Inline("bottom", [&](Fields& table) {
    table.Number("speed_mps", bottom.speed_mps, Between(100, 10'000));
    table.Number("density", bottom.density, Between(0.1, 10));
    table.Number("attenuation_db_per_wavelength", bottom.attenuation_db_per_wavelength,
                 Between(0, 20));
  });
}

}  // namespace

void Describe(Fields& fields, std::optional<RayChannelOptions>& rays, double wind_mps,
              const std::optional<std::string>& folder) {
  constexpr std::array<std::string_view, 2> kModels = {"straight", "rays"};
  std::string model(kModels[rays ? 1 : 0]);
  fields.Word("model", model, kModels);
  if (model != kModels[1]) {
    rays.reset();
    if (fields.reading()) fields.SkipRest();
    return;
  }
  if (!rays) rays.emplace().wind_mps = wind_mps;
  DescribeProfile(fields, *rays, folder);
  if (fields.Has("arrivals_file", !rays->arrivals_file.empty())) {
    fields.Text("arrivals_file", rays->arrivals_file, kSoundFileRule);
  }
  fields.Number("bottom_depth_m", rays->bottom_depth_m, Between(1, kMaxProfileDepth_m));
  fields.Flag("follows_floor", rays->follows_floor);
  DescribeBottom(fields, rays->bottom);
  fields.Number("wind_mps", rays->wind_mps, Between(0, kMaxWind_mps));
  fields.Number("max_launch_deg", rays->max_launch_deg, Between(1, 89));
  fields.Number("window_s", rays->window_s, Between(0, 60));
  fields.Number("significant_db", rays->significant_db, Between(0.1, 100));
  fields.Number("max_doppler_mps", rays->max_doppler_mps, Above(0, 1000));
  fields.Number("cell_m", rays->cell_m, Between(0.01, 100));
  DescribePacketErrors(fields, *rays, folder);
  if (!fields.reading() || !fields.IsSound()) return;
  const std::string problem = ProblemOf(*rays);
  if (!problem.empty()) fields.Refuse("model", problem);
}

}  // namespace shoal

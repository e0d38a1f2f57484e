// The files beside a .env.
#include "lib/base/check/bounds.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/rays/bellhop_case.h"
#include "lib/sea/rays/list_text.h"

namespace shoal {

Result<std::vector<BoundaryPoint>> ReadBellhopBoundary(std::string_view name,
                                                       std::string_view content) {
  ListText text(name, content);
  const Result<std::string> type = text.Text("the type of the boundary in quotes, as in 'L'");
  if (!type.ok()) return Error{type.error()};
  if (type->empty() || type->front() != 'L') {
    return text.Refuse("boundary type '" + *type +
                       "': straight pieces, 'L', are read, curved ones ('C') and others are not");
  }
  if (type->size() > 1 && (*type)[1] != 'S' && (*type)[1] != ' ') {
    return text.Refuse("boundary type '" + *type +
                       "': points with properties of their own are not read; write 'LS' and leave "
                       "range and depth");
  }
  const Result<int> count = text.Count("the number of points", 1, kMaxBellhopItems);
  if (!count.ok()) return Error{count.error()};
  std::vector<BoundaryPoint> points;
  for (int i = 0; i < *count; ++i) {
    const auto pair = text.Numbers(2, "range in km and depth in m of a point");
    if (!pair.ok()) return Error{pair.error()};
    if (!(*pair)[0] || !(*pair)[1]) return text.Refuse("a point needs range and depth");
    points.push_back({*(*pair)[0] * 1000, *(*pair)[1]});
    if (!IsBetween(points.back().depth_m, -kMaxProfileDepth_m, kMaxProfileDepth_m) ||
        !IsBetween(points.back().range_m, -1e8, 1e8)) {
      return text.Refuse("range " + ShortestText(*(*pair)[0]) + " km and depth " +
                         ShortestText(*(*pair)[1]) + " m are beyond any sea");
    }
    if (i > 0 && !(points[points.size() - 2].range_m < points.back().range_m)) {
      return text.Refuse("ranges must grow from point to point");
    }
  }
  return points;
}

Result<ReflectionTable> ReadBellhopReflection(std::string_view name, std::string_view content) {
  ListText text(name, content);
  const Result<int> count = text.Count("the number of rows", 1, kMaxBellhopItems);
  if (!count.ok()) return Error{count.error()};
  ReflectionTable table;
  for (int i = 0; i < *count; ++i) {
    const auto row = text.Numbers(3, "angle, magnitude and phase of a row");
    if (!row.ok()) return Error{row.error()};
    if (!(*row)[0] || !(*row)[1] || !(*row)[2]) {
      return text.Refuse("a row needs angle, magnitude and phase");
    }
    table.rows.push_back({*(*row)[0], *(*row)[1], *(*row)[2]});
    const std::string problem = ProblemOf(table);
    if (!problem.empty()) return text.Refuse(problem);
  }
  return table;
}

Result<std::vector<ProfileAtRange>> ReadBellhopProfiles(std::string_view name,
                                                        std::string_view content,
                                                        const std::vector<double>& depths_m) {
  ListText text(name, content);
  const Result<int> count = text.Count("the number of profiles", 1, 1000);
  if (!count.ok()) return Error{count.error()};
  const auto num_profiles = static_cast<size_t>(*count);
  const auto ranges_km = text.Items(num_profiles, "the range of a profile in km");
  if (!ranges_km.ok()) return Error{ranges_km.error()};
  std::vector<std::vector<SpeedPoint>> points(num_profiles);
  for (const double depth_m : depths_m) {
    const auto speeds_mps = text.Items(num_profiles, "a speed at depth " + ShortestText(depth_m));
    if (!speeds_mps.ok()) return Error{speeds_mps.error()};
    for (size_t i = 0; i < num_profiles; ++i) points[i].push_back({depth_m, (*speeds_mps)[i]});
    for (const double speed_mps : *speeds_mps) {
      if (!IsBetween(speed_mps, kMinRaySpeed_mps, kMaxRaySpeed_mps)) {
        return text.Refuse("a speed of " + ShortestText(speed_mps) + " m/s: it must be between " +
                           ShortestText(kMinRaySpeed_mps) + " and " +
                           ShortestText(kMaxRaySpeed_mps));
      }
    }
  }
  std::vector<ProfileAtRange> water;
  for (size_t i = 0; i < num_profiles; ++i) {
    Result<SoundProfile> profile = SoundProfile::Make(points[i]);
    if (!profile.ok()) return text.Refuse(profile.error());
    water.push_back({(*ranges_km)[i] * 1000, *profile});
    if (i > 0 && !(water[i].range_m > water[i - 1].range_m)) {
      return text.Refuse("the ranges of the profiles must grow");
    }
  }
  return water;
}

}  // namespace shoal

#include "lib/tools/analysis/age_teeth.h"

#include <algorithm>
#include <utility>

#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

double WholeTime_s(std::span<const AgeTooth> teeth) {
  double whole_s = 0;
  for (const AgeTooth& tooth : teeth) whole_s += Seconds(tooth.length_us);
  return whole_s;
}

}  // namespace

double MeanAge_s(std::span<const AgeTooth> teeth) {
  const double whole_s = WholeTime_s(teeth);
  if (whole_s == 0) return MaxAge_s(teeth);
  double area_s2 = 0;
  for (const AgeTooth& tooth : teeth) {
    const double length_s = Seconds(tooth.length_us);
    area_s2 += length_s * (Seconds(tooth.begin_us) + length_s / 2);
  }
  return area_s2 / whole_s;
}

double MaxAge_s(std::span<const AgeTooth> teeth) {
  double max_s = 0;
  for (const AgeTooth& tooth : teeth) {
    max_s = std::max(max_s, Seconds(tooth.begin_us + tooth.length_us));
  }
  return max_s;
}

/// A tooth has each age between its ends for the same time. So the time below an age is a sum of
/// ramps. This goes along the sum from corner to corner until it is the share of the whole.
double AgePercentile_s(std::span<const AgeTooth> teeth, double share) {
  const double whole_s = WholeTime_s(teeth);
  std::vector<std::pair<int64_t, int>> corners;  // Age, and what becomes of the number of ramps.
  for (const AgeTooth& tooth : teeth) {
    corners.emplace_back(tooth.begin_us, 1);
    corners.emplace_back(tooth.begin_us + tooth.length_us, -1);
  }
  std::sort(corners.begin(), corners.end());
  double below_s = 0;
  int num_ramps = 0;
  for (size_t i = 0; i < corners.size() && whole_s > 0; ++i) {
    if (i > 0) {
      const double more_s = num_ramps * Seconds(corners[i].first - corners[i - 1].first);
      if (below_s + more_s >= share * whole_s) {
        return Seconds(corners[i - 1].first) + (share * whole_s - below_s) / num_ramps;
      }
      below_s += more_s;
    }
    num_ramps += corners[i].second;
  }
  return MaxAge_s(teeth);
}

std::vector<AgeTooth> TeethFrom(std::span<const AgeTooth> teeth, int64_t from_utime) {
  std::vector<AgeTooth> rest;
  for (AgeTooth tooth : teeth) {
    const int64_t cut_us = std::max<int64_t>(0, from_utime - tooth.taken_utime);
    if (cut_us > tooth.length_us) continue;
    tooth.taken_utime += cut_us;
    tooth.begin_us += cut_us;
    tooth.length_us -= cut_us;
    rest.push_back(tooth);
  }
  return rest;
}

}  // namespace shoal

// Arrivals that Bellhop has written as text, a file .arr.
//
//   const Result<ArrivalTable> table = ReadBellhopArrivals("bay.arr", text);
//   for (const RayArrival& arrival : table->Nearest(30, 1000, 60)) ...
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/rays/eigenrays.h"

namespace shoal {

class ArrivalTable {
 public:
  /// Returns the arrivals of the source depth, receiver depth and range of the table that are
  /// nearest to these, each by itself, in order of delay.
  [[nodiscard]] std::span<const RayArrival> Nearest(double source_depth_m, double range_m,
                                                    double receiver_depth_m) const;

  double hz() const { return hz_; }
  /// Whether the amplitudes contain the absorption of the water (rows with an imaginary delay).
  bool has_absorption() const { return has_absorption_; }
  std::span<const double> source_depths_m() const { return source_depths_m_; }
  std::span<const double> receiver_depths_m() const { return receiver_depths_m_; }
  std::span<const double> ranges_m() const { return ranges_m_; }

 private:
  friend class ArrivalReader;

  double hz_ = 0;
  bool has_absorption_ = false;
  std::vector<double> source_depths_m_;
  std::vector<double> receiver_depths_m_;
  std::vector<double> ranges_m_;
  std::vector<std::vector<RayArrival>> links_;  ///< By source depth, receiver depth, range.
};

/// Bounds of a file: links, and arrivals of all of them together.
inline constexpr size_t kMaxTableLinks = 1'000'000;
inline constexpr size_t kMaxTableArrivals = 4'000'000;

/// Returns the arrivals of a file, or an error with file and line. Read by items, as Fortran
/// writes; with '2D' in quotes first, or in the older form with frequency and counts on the first
/// line. Rows of one path, of which Bellhop writes two (equal bounces, delays within 20 us, launch
/// angles within half a degree), are joined: the sum of the amplitudes, means weighted by them.
/// RayArrival::spread_m, reflection and num_caustics are not in such files; length_m is the delay
/// times 1500 m/s.
[[nodiscard]] Result<ArrivalTable> ReadBellhopArrivals(std::string_view name,
                                                       std::string_view text);

}  // namespace shoal

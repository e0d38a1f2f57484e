// A curve of bounded size for a log of any length, drawn without visible loss.
//
//   ThinnedCurve depth;
//   depth.Add(time_s, z_m);
//   depth.Break();                        // the line ends here, and begins again
//   for (const Stroke& stroke : depth.Strokes()) ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

struct CurvePoint {
  double x = 0;
  double y = 0;

  bool operator==(const CurvePoint&) const = default;
};

/// Points that one line goes through.
using Stroke = std::vector<CurvePoint>;

/// Keeps of each run of consecutive points those that are farthest left, right, down and up: no
/// extreme is ever lost, and a curve over time that is no wider in pixels than there are runs is
/// drawn exactly (Jugel et al. 2014, "M4: a visualization-oriented time series data aggregation").
/// The runs become longer as the curve does.
class ThinnedCurve {
 public:
  /// No curve has more than 4 points per run, 5,000 in all.
  static constexpr size_t kMaxRuns = 1250;

  /// Appends a point. Where it is not finite, or larger than any figure shows (1e9), the line
  /// breaks instead, and it returns false.
  bool Add(double x, double y);

  /// Ends the line; the next point begins a new one. A curve with more breaks than half its runs
  /// loses breaks, never extremes.
  void Break() { is_broken_ = true; }

  /// From now on the curve has at most `max_runs` runs. @pre max_runs >= 2
  void LimitTo(size_t max_runs);

  bool empty() const { return runs_.empty(); }
  size_t num_runs() const { return runs_.size(); }

  /// Returns the lines in the order in which their points came.
  std::vector<Stroke> Strokes() const;

 private:
  struct Sample {
    CurvePoint point;
    int64_t number = 0;  ///< Counts the points from 0.
  };
  struct Run {
    Sample left, right, low, high;
    int64_t num_points = 1;
    bool begins_stroke = false;
  };

  static void Extend(const Run& later, Run* run);
  bool MergePairs(bool across_breaks);
  void Shrink();

  std::vector<Run> runs_;
  size_t max_runs_ = kMaxRuns;
  int64_t points_per_run_ = 1;
  int64_t num_points_ = 0;
  bool is_broken_ = true;
};

}  // namespace shoal

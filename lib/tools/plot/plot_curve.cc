#include "lib/tools/plot/plot_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr double kLargest = 1e9;
constexpr int64_t kLongestRun = 1'000'000'000'000;

bool CanBeDrawn(double value) { return std::isfinite(value) && std::abs(value) <= kLargest; }

}  // namespace

bool ThinnedCurve::Add(double x, double y) {
  if (!CanBeDrawn(x) || !CanBeDrawn(y)) {
    Break();
    return false;
  }
  const Sample sample{.point = {x, y}, .number = num_points_++};
  const Run run{
      .left = sample, .right = sample, .low = sample, .high = sample, .begins_stroke = is_broken_};
  is_broken_ = false;
  if (!runs_.empty() && !run.begins_stroke && runs_.back().num_points < points_per_run_) {
    Extend(run, &runs_.back());
    return true;
  }
  if (runs_.size() >= max_runs_) Shrink();
  runs_.push_back(run);
  return true;
}

void ThinnedCurve::LimitTo(size_t max_runs) {
  SHOAL_CHECK(max_runs >= 2, "max_runs is at least 2");
  max_runs_ = max_runs;
  while (runs_.size() > max_runs_) Shrink();
}

void ThinnedCurve::Extend(const Run& later, Run* run) {
  if (later.left.point.x < run->left.point.x) run->left = later.left;
  if (later.right.point.x > run->right.point.x) run->right = later.right;
  if (later.low.point.y < run->low.point.y) run->low = later.low;
  if (later.high.point.y > run->high.point.y) run->high = later.high;
  run->num_points += later.num_points;
}

/// Returns whether that made room enough to go on for long.
bool ThinnedCurve::MergePairs(bool across_breaks) {
  size_t num_kept = 0;
  bool may_extend = false;  // The last that was kept is not a pair yet.
  for (const Run& run : runs_) {
    if (may_extend && (across_breaks || !run.begins_stroke)) {
      Extend(run, &runs_[num_kept - 1]);
      may_extend = false;
    } else {
      runs_[num_kept++] = run;
      may_extend = true;
    }
  }
  runs_.resize(num_kept);
  return 4 * num_kept <= 3 * max_runs_;
}

void ThinnedCurve::Shrink() {
  points_per_run_ = std::min(2 * points_per_run_, kLongestRun);
  if (!MergePairs(false)) MergePairs(true);
}

std::vector<Stroke> ThinnedCurve::Strokes() const {
  std::vector<Stroke> strokes;
  for (const Run& run : runs_) {
    if (run.begins_stroke || strokes.empty()) strokes.emplace_back();
    std::array<Sample, 4> samples = {run.left, run.right, run.low, run.high};
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return a.number < b.number; });
    int64_t last = -1;
    for (const Sample& sample : samples) {
      if (sample.number != last) strokes.back().push_back(sample.point);
      last = sample.number;
    }
  }
  return strokes;
}

}  // namespace shoal

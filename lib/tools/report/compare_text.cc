#include "lib/tools/report/compare_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/tools/plot/plot_script.h"
#include "lib/tools/report/table_text.h"

namespace shoal {

namespace {

constexpr size_t kPointWidth = 26;
constexpr size_t kMaxBrokenNamed = 10;

/// Writes the comparison.
class ComparisonWriter {
 public:
  ComparisonWriter(const CampaignResults& results, const CampaignComparison& comparison)
      : results_(results), comparison_(comparison) {}

  std::string Write() {
    Head();
    Outcomes();
    for (size_t metric = 0; metric < results_.metrics.size(); ++metric) Metric(metric);
    Multiplicity();
    return std::move(text_);
  }

 private:
  void Line(const std::string& line) { text_ += line + '\n'; }

  std::string Label(size_t point) const {
    std::string keys = KeysText(comparison_.points[point].rest);
    if (keys.size() <= kPointWidth) return keys;
    // The full keys are at the head.
    return fmt::format("point {}", point + 1);
  }

  void Head() {
    Line(fmt::format("a: {}    b: {}", ShownText(comparison_.a), ShownText(comparison_.b)));
    Line(fmt::format("Pairs are of equal repetitions; differences are b - a; confidence {:g} %",
                     100 * comparison_.confidence));
    for (size_t i = 0; i < comparison_.points.size(); ++i) {
      const std::string keys = KeysText(comparison_.points[i].rest);
      if (keys.size() > kPointWidth) Line(fmt::format("point {}: {}", i + 1, keys));
    }
    for (const size_t number : comparison_.without_partner) {
      Line(fmt::format("without a partner, not compared: {}",
                       KeysText(KeysOf(results_, results_.cases[number]))));
    }
  }

  void Outcomes() {
    Line(fmt::format("\n{:<{}} {:>8} {:>10} {:>8} {:>8} {:>8} {:>10}", "Outcomes", kPointWidth,
                     "pairs", "both pass", "only a", "only b", "neither", "McNemar p"));
    for (size_t i = 0; i < comparison_.points.size(); ++i) {
      const ComparedPoint& point = comparison_.points[i];
      Line(fmt::format("{:<{}} {:>8} {:>10} {:>8} {:>8} {:>8} {:>10}", Label(i), kPointWidth,
                       point.num_pairs, point.both_pass, point.only_a, point.only_b, point.neither,
                       PText(point.p)));
      Notes(point);
    }
  }

  void Notes(const ComparedPoint& point) {
    if (point.num_alone > 0) {
      Line(fmt::format("    {} without a partner: of another number, missing, or stopped earlier",
                       CountText(point.num_alone, "trial")));
    }
    if (point.num_other_seed > 0) {
      Line(fmt::format("    {} of different seeds: they did not meet the same conditions",
                       CountText(point.num_other_seed, "pair")));
    }
    if (point.broken.empty()) return;
    Line(fmt::format("    {} with an error or a timeout, which counts as not passed:",
                     CountText(static_cast<int64_t>(point.broken.size()), "pair")));
    for (size_t i = 0; i < std::min(point.broken.size(), kMaxBrokenNamed); ++i) {
      const BrokenPair& pair = point.broken[i];
      Line(fmt::format("      {} {}, {} {}", pair.a, NameOf(pair.outcome_a), pair.b,
                       NameOf(pair.outcome_b)));
    }
    if (point.broken.size() > kMaxBrokenNamed) {
      Line(fmt::format("      and {} more: results.csv has all",
                       point.broken.size() - kMaxBrokenNamed));
    }
  }

  void Metric(size_t metric) {
    const MetricName& name = results_.metrics[metric];
    const std::string unit = name.unit.empty() ? "" : " [" + ShownText(name.unit) + "]";
    Line(fmt::format("\n{}{}{}", ShownText(name.name), unit,
                     name.text.empty() ? "" : ": " + ShownText(name.text)));
    Line(fmt::format("{:<{}} {:>8} {:>7} {:>10} {:>10} {:>10}  {}", "", kPointWidth, "pairs",
                     "equal", "mean a", "mean b", "b - a", "interval"));
    for (size_t i = 0; i < comparison_.points.size(); ++i) {
      const MetricComparison& of = comparison_.points[i].metrics[metric];
      const PairedMeans& means = of.means;
      const double equal = static_cast<double>(means.num_equal) /
                           static_cast<double>(std::max<int64_t>(means.num_pairs, 1));
      Line(fmt::format("{:<{}} {:>8} {:>5.1f} % {:>10} {:>10} {:>10}  {}", Label(i), kPointWidth,
                       means.num_pairs, 100 * equal, DigitsText(means.mean_a),
                       DigitsText(means.mean_b), DigitsText(means.difference),
                       IntervalText(means.interval)));
      Line("    " + Gain(means));
      if (of.num_without > 0) {
        Line(fmt::format("    {} left out: a trial has no value",
                         CountText(of.num_without, "pair")));
      }
    }
  }

  static std::string Gain(const PairedMeans& means) {
    if (means.num_pairs > 0 && means.num_equal == means.num_pairs) {
      return "the same in every pair";
    }
    std::string text = "p " + PText(means.p);
    if (std::isfinite(means.narrowing)) {
      text += fmt::format("; without pairs {}: {:.2f} times as wide", IntervalText(means.unpaired),
                          means.narrowing);
    }
    return text;
  }

  void Multiplicity() {
    const size_t num = comparison_.points.size() * (1 + results_.metrics.size());
    if (num < 2) return;
    Line(
        fmt::format("\n{} comparisons: where nothing differs, about {:.2g} of them have p < 0.05 "
                    "by chance.",
                    num, 0.05 * static_cast<double>(num)));
  }

  const CampaignResults& results_;
  const CampaignComparison& comparison_;
  std::string text_;
};

}  // namespace

std::string ComparisonText(const CampaignResults& results, const CampaignComparison& comparison) {
  return ComparisonWriter(results, comparison).Write();
}

}  // namespace shoal

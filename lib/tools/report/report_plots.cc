#include "lib/tools/report/report_plots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/model/vehicle_colors.h"
#include "lib/tools/campaign/case_labels.h"

namespace shoal {

namespace {

constexpr double kLargestDrawn = 1e30;  // gnuplot's axes fail beyond.

bool CanBeDrawn(double value) { return std::isfinite(value) && std::abs(value) <= kLargestDrawn; }

/// A value with an interval, of one case.
struct PlottedPoint {
  double x = 0;
  double y = 0;
  Interval interval;
};

struct PlottedLine {
  std::string title;
  std::vector<PlottedPoint> points = {};
};

/// What is drawn along the x axis: numbers where all values of the first axis are some, else the
/// values in their order, each with its text.
class SweepScale {
 public:
  explicit SweepScale(const CampaignResults& results) {
    for (const CampaignCase& each : results.cases) {
      if (each.values.empty()) continue;
      const std::string& value = each.values.front();
      if (std::find(values_.begin(), values_.end(), value) == values_.end()) {
        values_.push_back(value);
      }
    }
    is_numeric_ = std::all_of(values_.begin(), values_.end(),
                              [](const std::string& value) { return CanBeDrawn(NumberOf(value)); });
  }

  double PlaceOf(const std::string& value) const {
    if (is_numeric_) return NumberOf(value);
    return static_cast<double>(std::find(values_.begin(), values_.end(), value) - values_.begin());
  }

  /// Returns the range of x with a margin, and the marks where the values are texts.
  std::string Settings() const {
    double low = PlaceOf(values_.front());
    double high = low;
    for (const std::string& value : values_) {
      low = std::min(low, PlaceOf(value));
      high = std::max(high, PlaceOf(value));
    }
    const double margin = high > low ? 0.05 * (high - low) : std::max(0.5, 0.1 * std::abs(low));
    std::string text = fmt::format("set xrange [{:.9g}:{:.9g}]\n", low - margin, high + margin);
    if (is_numeric_) return text;
    std::vector<std::string> marks;
    for (size_t i = 0; i < values_.size(); ++i) {
      marks.push_back(fmt::format("{} {}", GnuplotString(values_[i]), i));
    }
    return text + fmt::format("set xtics ({})\n", fmt::join(marks, ", "));
  }

 private:
  std::vector<std::string> values_;
  bool is_numeric_ = true;
};

/// Returns the keys of a case without the first axis: what names its line.
std::string LineTitle(const CampaignResults& results, const CampaignCase& of) {
  CaseKeys keys = KeysOf(results, of);
  if (!of.values.empty()) keys.erase(keys.begin());
  return keys.empty() ? "" : KeysText(keys);
}

/// Returns a name for files: letters, digits and '_' of `name`.
std::string FileNameOf(const std::string& name) {
  std::string file;
  for (const char letter : name) {
    file += IsNameCharacter(letter) ? letter : '_';
  }
  return file;
}

std::vector<std::string> ColorsOf(size_t num) {
  return AssignColors(std::vector<std::string>(num));
}

std::string LeftOutText(size_t num_lines) {
  if (num_lines <= kMaxLines) return "";
  return fmt::format(" ({} of {} lines)", kMaxLines, num_lines);
}

/// Returns the common beginning of a figure with one plot, whose legend is right of it.
std::string PlotHead(const std::string& name, const std::string& title, const std::string& x_label,
                     const std::string& y_label, const std::vector<LegendEntry>& legend, bool png) {
  const Canvas canvas{.png = png};
  const int legend_px = std::min(LegendWidth_px(legend, canvas.height_px), 500);
  return ScriptHead(name, canvas) + LegendPlace(canvas, legend_px, kTop_px) +
         fmt::format(
             "set lmargin at screen 0.1\nset rmargin at screen {:.4f}\n"
             "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
             "set title {}\nset xlabel {}\nset ylabel {} offset 1,0\n",
             1 - static_cast<double>(legend_px) / canvas.width_px,
             1 - static_cast<double>(kTop_px) / canvas.height_px,
             static_cast<double>(kBottom_px) / canvas.height_px, GnuplotString(title),
             GnuplotString(x_label), GnuplotString(y_label));
}

/// Moves each line a little along x, so that intervals at the same place do not hide each other.
void SetApart(std::vector<PlottedLine>* lines) {
  double low = kLargestDrawn;
  double high = -kLargestDrawn;
  for (const PlottedLine& line : *lines) {
    for (const PlottedPoint& point : line.points) {
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
  }
  if (!(high > low)) return;
  const double step = 0.006 * (high - low);
  const double middle = static_cast<double>(std::min(lines->size(), kMaxLines) - 1) / 2;
  for (size_t i = 0; i < lines->size(); ++i) {
    for (PlottedPoint& point : (*lines)[i].points) {
      point.x += (static_cast<double>(i) - middle) * step;
    }
  }
}

/// Draws lines with intervals. The interval of a point without ends is left out, the point stays.
void DrawLines(std::vector<PlottedLine> lines, const std::string& head_settings,
               const std::string& title, const std::string& x_label, const std::string& y_label,
               bool joined, bool png, Figure* figure) {
  if (joined) SetApart(&lines);
  const size_t num = std::min(lines.size(), kMaxLines);
  const std::vector<std::string> colors = ColorsOf(num);
  PlotBlocks blocks;
  std::vector<LegendEntry> legend;
  std::vector<std::string> items;
  for (size_t i = 0; i < num; ++i) {
    std::string text;
    for (const PlottedPoint& point : lines[i].points) {
      const bool has_ends = CanBeDrawn(point.interval.low) && CanBeDrawn(point.interval.high);
      text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", point.x, point.y,
                          has_ends ? point.interval.low : point.y,
                          has_ends ? point.interval.high : point.y);
    }
    if (text.empty()) continue;
    const int block = blocks.AddLines(lines[i].title, text);
    const std::string style = fmt::format("lc rgb '{}' lw 2 pt 7 ps 0.7", colors[i]);
    items.push_back(fmt::format("'{}.dat' index {} using 1:2:3:4 with yerrorbars {} notitle",
                                figure->name, block, style));
    if (joined) {
      items.push_back(fmt::format("'{}.dat' index {} using 1:2 with lines lc rgb '{}' lw 2 notitle",
                                  figure->name, block, colors[i]));
    }
    if (!lines[i].title.empty()) legend.push_back({lines[i].title, "linespoints " + style});
  }
  if (items.empty()) {
    figure->why_left_out = "no trial has a value that a figure can show";
    return;
  }
  figure->data = blocks.text();
  figure->script =
      PlotHead(figure->name, title + LeftOutText(lines.size()), x_label, y_label, legend, png) +
      head_settings + fmt::format("plot {}{}\n", fmt::join(items, ", \\\n  "), LegendItems(legend));
}

/// Writes the figures.
class ReportDrawing {
 public:
  ReportDrawing(const CampaignResults& results, const ReportTables& tables, bool png)
      : results_(results), tables_(tables), png_(png) {}

  std::vector<Figure> Draw() {
    std::vector<Figure> figures = {Share()};
    for (size_t metric = 0; metric < results_.metrics.size(); ++metric) {
      figures.push_back(has_sweep() ? Curve(metric) : Histogram(metric));
    }
    return figures;
  }

 private:
  bool has_sweep() const { return !results_.sweep_keys.empty(); }

  /// Returns the lines of one estimate of each case, by their titles in the order of the cases.
  template <class EstimateOf>
  std::vector<PlottedLine> LinesOf(EstimateOf estimate_of) const {
    const SweepScale scale(results_);
    std::vector<PlottedLine> lines;
    for (size_t i = 0; i < results_.cases.size(); ++i) {
      const CampaignCase& of = results_.cases[i];
      const std::string title = LineTitle(results_, of);
      auto line = std::find_if(lines.begin(), lines.end(),
                               [&](const PlottedLine& each) { return each.title == title; });
      if (line == lines.end()) line = lines.insert(line, {.title = title});
      const Estimate& estimate = estimate_of(tables_.cases[i]);
      if (!CanBeDrawn(estimate.value)) continue;
      line->points.push_back({has_sweep() ? scale.PlaceOf(of.values.front())
                                          : static_cast<double>(line - lines.begin()),
                              estimate.value, estimate.interval});
    }
    for (PlottedLine& line : lines) {
      std::stable_sort(line.points.begin(), line.points.end(),
                       [](const PlottedPoint& a, const PlottedPoint& b) { return a.x < b.x; });
    }
    return lines;
  }

  /// Without a sweep the policies are side by side.
  std::string ScaleSettings(size_t num_lines) const {
    if (has_sweep()) return SweepScale(results_).Settings();
    return fmt::format("set xrange [-0.5:{}]\nunset xtics\n",
                       static_cast<double>(std::min(num_lines, kMaxLines)) - 0.5);
  }

  std::string ConfidenceText() const {
    return fmt::format("intervals at {:g} %", 100 * tables_.confidence);
  }

  std::string XLabel() const { return has_sweep() ? results_.sweep_keys.front() : ""; }

  Figure Share() const {
    Figure figure{.name = "passed"};
    auto lines = LinesOf([](const CaseTable& table) { return table.share_passed; });
    for (PlottedLine& line : lines) {
      for (PlottedPoint& point : line.points) {
        point.y *= 100;
        point.interval = {100 * point.interval.low, 100 * point.interval.high};
      }
    }
    DrawLines(lines, ScaleSettings(lines.size()), "Trials that passed, " + ConfidenceText(),
              XLabel(), "passed [%]", has_sweep(), png_, &figure);
    return figure;
  }

  std::string LabelOf(const MetricName& metric) const {
    return metric.name + (metric.unit.empty() ? "" : " [" + metric.unit + "]");
  }

  Figure FigureOf(const MetricName& metric) const {
    return {.name = "metric_" + FileNameOf(metric.name)};
  }

  Figure Curve(size_t metric) const {
    const MetricName& name = results_.metrics[metric];
    Figure figure = FigureOf(name);
    const auto lines = LinesOf([&](const CaseTable& table) { return table.metrics[metric].mean; });
    DrawLines(lines, ScaleSettings(lines.size()),
              fmt::format("Mean of {}, {}", name.name, ConfidenceText()), XLabel(), LabelOf(name),
              true, png_, &figure);
    return figure;
  }

  /// Returns the values of each case that can be drawn.
  std::vector<std::vector<double>> ValuesOf(size_t metric) const {
    std::vector<std::vector<double>> values(results_.cases.size());
    for (const TrialRow& row : results_.rows) {
      const double value = MetricOf(row.result, metric);
      if (CanBeDrawn(value)) values[row.case_number].push_back(value);
    }
    return values;
  }

  Figure Histogram(size_t metric) const {
    const MetricName& name = results_.metrics[metric];
    Figure figure = FigureOf(name);
    auto values = ValuesOf(metric);
    const size_t num_cases = values.size();
    values.resize(std::min(num_cases, kMaxLines));
    double low = kLargestDrawn;
    double high = -kLargestDrawn;
    size_t most = 0;
    for (const auto& of_case : values) {
      most = std::max(most, of_case.size());
      for (const double value : of_case) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    if (most == 0) {
      figure.why_left_out = "no trial has a value that a figure can show";
      return figure;
    }
    if (!(high > low)) {
      const double margin = std::max(0.5, 0.01 * std::abs(low));
      low -= margin;
      high += margin;
    }
    // As many bins as the square root of the values, within what a figure can show.
    const int num_bins = std::clamp(static_cast<int>(std::sqrt(most)), 5, 60);
    PlotBlocks blocks;
    std::vector<LegendEntry> legend;
    std::vector<std::string> items;
    const auto colors = ColorsOf(values.size());
    for (size_t i = 0; i < values.size(); ++i) {
      if (values[i].empty()) continue;
      const std::string title = LineTitle(results_, results_.cases[i]);
      const int block = blocks.AddLines(title, BinLines(values[i], low, high, num_bins));
      items.push_back(fmt::format(
          "'{0}.dat' index {1} using 1:2 with fillsteps fs transparent solid 0.25 lc rgb '{2}' "
          "notitle, '{0}.dat' index {1} using 1:2 with steps lc rgb '{2}' lw 2 notitle",
          figure.name, block, colors[i]));
      if (!title.empty())
        legend.push_back({title, fmt::format("lines lc rgb '{}' lw 2", colors[i])});
    }
    figure.data = blocks.text();
    figure.script = PlotHead(figure.name, "Values of " + name.name + LeftOutText(num_cases),
                             LabelOf(name), "trials", legend, png_) +
                    fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [0:*]\n", low, high) +
                    fmt::format("plot {}{}\n", fmt::join(items, ", \\\n  "), LegendItems(legend));
    return figure;
  }

  /// Returns the left edge and the count of each bin, and the end.
  static std::string BinLines(const std::vector<double>& values, double low, double high,
                              int num_bins) {
    std::vector<int64_t> counts(static_cast<size_t>(num_bins));
    for (const double value : values) {
      const auto bin = static_cast<int>((value - low) / (high - low) * num_bins);
      ++counts[static_cast<size_t>(std::clamp(bin, 0, num_bins - 1))];
    }
    std::string text;
    for (int i = 0; i <= num_bins; ++i) {
      text += fmt::format("{:.9g} {}\n", low + (high - low) * i / num_bins,
                          counts[static_cast<size_t>(std::min(i, num_bins - 1))]);
    }
    return text;
  }

  const CampaignResults& results_;
  const ReportTables& tables_;
  bool png_;
};

}  // namespace

std::vector<Figure> DrawReport(const CampaignResults& results, const ReportTables& tables,
                               bool png) {
  return ReportDrawing(results, tables, png).Draw();
}

}  // namespace shoal

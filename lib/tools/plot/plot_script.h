// Text for gnuplot: what every figure has in common. Names from a log or a mission are
// escaped: they are only ever shown as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/plot/plot_curve.h"

namespace shoal {

/// Returns `text` as a figure can show it: valid UTF-8 without control characters, 60 characters at
/// most, the last of a longer one an ellipsis.
[[nodiscard]] std::string ShownText(std::string_view text);

/// Returns ShownText(text) as a string of gnuplot in single quotes, in which nothing has a meaning:
/// no backslash, no back quote, no macro.
[[nodiscard]] std::string GnuplotString(std::string_view text);

/// The columns of numbers that a figure draws, as gnuplot reads them: blocks, numbered from 0.
class PlotBlocks {
 public:
  /// Appends a block, headed by `comment`; returns its number. An empty one has a comment alone,
  /// and gnuplot does not count it. @pre some stroke has a point
  int Add(std::string_view comment, const std::vector<Stroke>& strokes);
  /// Appends a block of lines, each of them columns already.
  int AddLines(std::string_view comment, std::string_view lines);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int num_blocks_ = 0;
};

/// Margins above and below the panels.
inline constexpr int kTop_px = 44;
inline constexpr int kBottom_px = 72;

/// A file of a figure, and the script that draws it.
struct Figure {
  std::string name;  ///< "tracks": of tracks.svg, and in its folder of tracks.dat and tracks.gp.
  std::string data = {};          ///< Of <name>.dat.
  std::string script = {};        ///< Of <name>.gp. Paths in it are relative to its folder.
  std::string why_left_out = {};  ///< Why the log has nothing to draw; empty: it has.
};

/// What the figures are drawn on.
struct Canvas {
  bool png = false;  ///< Instead of SVG.
  int width_px = 1000;
  int height_px = 500;
};

/// One line in the legend.
struct LegendEntry {
  std::string title;
  std::string style;  ///< Of gnuplot: "lines lc rgb '#ff0000'".
};

/// Returns how much room the legend takes on the right of a plot `plot_px` high, at least a margin.
[[nodiscard]] int LegendWidth_px(const std::vector<LegendEntry>& legend, int plot_px);

/// Returns the beginning of a script: canvas, file, style of axes.
[[nodiscard]] std::string ScriptHead(const std::string& name, const Canvas& canvas);

/// Returns the lines that place the legend right of the uppermost plot, `plot_px` high, `width_px`
/// wide from its edge.
[[nodiscard]] std::string LegendPlace(const Canvas& canvas, int width_px, int plot_px);

/// Returns the legend as items of a plot command, each with a comma before it.
[[nodiscard]] std::string LegendItems(const std::vector<LegendEntry>& legend);

/// One of the plots over time that are above one another.
struct Panel {
  std::string y_label;
  std::vector<std::string> items;     ///< Of its plot command.
  std::vector<std::string> settings;  ///< Further lines before that.
};

/// Returns a script of plots over time with one axis and one legend. @pre panels are not empty
[[nodiscard]] std::string StackedScript(const std::string& name, const std::string& title,
                                        const std::string& x_label, double first_s, double last_s,
                                        const std::vector<Panel>& panels,
                                        const std::vector<LegendEntry>& legend, bool png);

}  // namespace shoal

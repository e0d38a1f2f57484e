#include "lib/tools/plot/plot_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shoal {

namespace {

constexpr int kLeft_px = 84;
constexpr int kBetween_px = 26;
constexpr int kRight_px = 24;
// Of the legend, more than gnuplot takes: entries that it finds no room for it drops.
constexpr int kLine_px = 27;

/// Returns how many bytes from `begin` on are one character of valid UTF-8; 0: none.
size_t CharacterSize(std::string_view text, size_t begin) {
  const auto byte = [&](size_t i) {
    return begin + i < text.size() ? static_cast<unsigned char>(text[begin + i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  // Too long a form, half of a pair, beyond Unicode; and U+FFFE and its like, which XML forbids.
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
      (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f) ||
      (first == 0xef && second == 0xbf && byte(2) >= 0xbe)) {
    return 0;
  }
  return size;
}

size_t NumCharacters(std::string_view text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xc0) != 0x80;
  }));
}

double Share(int part_px, int whole_px) { return static_cast<double>(part_px) / whole_px; }

int LegendRows(int plot_px) { return std::max(1, plot_px / kLine_px); }

int LongestTitle(const std::vector<LegendEntry>& legend) {
  size_t longest = 0;
  for (const LegendEntry& entry : legend) {
    longest = std::max(longest, NumCharacters(ShownText(entry.title)));
  }
  return static_cast<int>(longest);
}

}  // namespace

std::string ShownText(std::string_view text) {
  constexpr size_t kLongest = 60;
  std::string shown;
  size_t num_characters = 0;
  for (size_t i = 0; i < text.size(); ++num_characters) {
    const size_t size = CharacterSize(text, i);
    if (num_characters == kLongest - 1 && i + std::max<size_t>(size, 1) < text.size()) {
      return shown + "…";
    }
    const auto first = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F are controls too.
    const bool is_c1 = size == 2 && first == 0xc2 && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (size == 0) {
      shown += '?';
    } else if (first < 0x20 || first == 0x7f || is_c1) {
      shown += ' ';
    } else {
      shown += text.substr(i, size);
    }
    i += std::max<size_t>(size, 1);
  }
  return shown;
}

std::string GnuplotString(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : ShownText(text)) {
    quoted += letter;
    if (letter == '\'') quoted += letter;
  }
  return quoted + "'";
}

int PlotBlocks::Add(std::string_view comment, const std::vector<Stroke>& strokes) {
  std::string lines;
  for (const Stroke& stroke : strokes) {
    if (!lines.empty()) lines += '\n';
    for (const CurvePoint& point : stroke)
      lines += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
  }
  return AddLines(comment, lines);
}

int PlotBlocks::AddLines(std::string_view comment, std::string_view lines) {
  if (!text_.empty()) text_ += "\n\n";
  text_ += fmt::format("# {}\n{}", ShownText(comment), lines);
  return num_blocks_++;
}

int LegendWidth_px(const std::vector<LegendEntry>& legend, int plot_px) {
  if (legend.empty()) return kRight_px;
  constexpr int kSample_px = 80;
  constexpr int kCharacter_px = 8;
  const int rows = LegendRows(plot_px);
  const int columns = (static_cast<int>(legend.size()) + rows - 1) / rows;
  return columns * (kSample_px + kCharacter_px * LongestTitle(legend)) + kRight_px;
}

std::string ScriptHead(const std::string& name, const Canvas& canvas) {
  // A PNG has twice the pixels, for print.
  const std::string terminal =
      canvas.png ? fmt::format(
                       "pngcairo size {},{} noenhanced font 'Helvetica,12' fontscale 2 linewidth 2 "
                       "pointscale 2 background '#ffffff'",
                       2 * canvas.width_px, 2 * canvas.height_px)
                 : fmt::format(
                       "svg size {},{} dynamic noenhanced font 'Helvetica,15' "
                       "background '#ffffff' name 'shoal'",
                       canvas.width_px, canvas.height_px);
  return fmt::format(
      "# {0}, drawn by shoal. Draw it again, in this folder: gnuplot {0}.gp\n"
      "set encoding utf8\n"
      "set terminal {1}\n"
      "set output '../{0}.{2}'\n"
      "set border 3 lc rgb '#404040'\n"
      "set tics nomirror out\n"
      "set grid lc rgb '#e4e4e4' lt 1 lw 0.7\n",
      name, terminal, canvas.png ? "png" : "svg");
}

std::string LegendPlace(const Canvas& canvas, int width_px, int plot_px) {
  return fmt::format(
      "set key at screen {:.4f}, screen {:.4f} left top Left reverse samplen 2 width 1 "
      "spacing 1.1 maxrows {} noenhanced\n",
      Share(canvas.width_px - width_px + kRight_px / 2, canvas.width_px),
      1 - Share(kTop_px, canvas.height_px), LegendRows(plot_px));
}

std::string LegendItems(const std::vector<LegendEntry>& legend) {
  std::string items;
  for (const LegendEntry& entry : legend) {
    items +=
        fmt::format(", \\\n  keyentry with {} title {}", entry.style, GnuplotString(entry.title));
  }
  return items;
}

std::string StackedScript(const std::string& name, const std::string& title,
                          const std::string& x_label, double first_s, double last_s,
                          const std::vector<Panel>& panels, const std::vector<LegendEntry>& legend,
                          bool png) {
  const int num_panels = static_cast<int>(panels.size());
  const int panel_px = num_panels == 1 ? 400 : 230;
  const int legend_px = LegendWidth_px(legend, panel_px);
  constexpr int kWidth_px = 1000;
  constexpr int kLeast_px = 600;  // Of the panels and what is left of them.
  const Canvas canvas{
      .png = png,
      .width_px = std::max(kWidth_px, kLeast_px + legend_px),
      .height_px = kTop_px + kBottom_px + num_panels * panel_px + (num_panels - 1) * kBetween_px};
  const double span_s = std::max(last_s - first_s, 1e-3);
  std::string script = ScriptHead(name, canvas);
  script += fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset xrange [{:.9g}:{:.9g}]\n"
      "set ylabel offset 1,0\nset multiplot\nset title {}\n",
      Share(kLeft_px, canvas.width_px), 1 - Share(legend_px, canvas.width_px), first_s,
      first_s + span_s, GnuplotString(title));
  script += LegendPlace(canvas, legend_px, panel_px);
  int top_px = kTop_px;
  for (int i = 0; i < num_panels; ++i) {
    const Panel& panel = panels[static_cast<size_t>(i)];
    const bool is_last = i + 1 == num_panels;
    script +=
        fmt::format("\nset tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset ylabel {}\n",
                    1 - Share(top_px, canvas.height_px),
                    1 - Share(top_px + panel_px, canvas.height_px), GnuplotString(panel.y_label));
    script += is_last ? fmt::format("set format x '%g'\nset xlabel {}\n", GnuplotString(x_label))
                      : std::string("set format x ''\n");
    for (const std::string& line : panel.settings) script += line + "\n";
    script += fmt::format("plot {}{}\n", fmt::join(panel.items, ", \\\n  "),
                          i == 0 ? LegendItems(legend) : "");
    if (i == 0) script += "unset title\nunset key\n";
    top_px += panel_px + kBetween_px;
  }
  return script + "unset multiplot\n";
}

}  // namespace shoal
